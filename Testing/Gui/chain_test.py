# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a file to a mesh and its distances in the window, by single stages: horizons chosen from the list, parameters typed,
undo and redo, states, data saved and a trace recorded. All give the mesh that the classes make, byte by byte.

Arguments: ParaView, pvpython, the folder of the data, and one for files.
"""

import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from seismichorizons import vtk as sh

import window

CHOSEN = ["Horizon 1", "Horizon 3"]
STAGES = ["HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonRoughSimplification", "HorizonTriangulation"]
SETTINGS = {"HorizonRoughSimplification": ("CellSize", 4)}
# What prepares horizons, and cells graded by curvature.
OTHER_STAGES = ["HorizonDespiking", "HorizonFaults", "HorizonHoleFilling", "HorizonExteriorBoundary",
                "HorizonBoundarySimplification", "HorizonElaborateSimplification", "HorizonTriangulation"]
OTHER_SETTINGS = {"HorizonDespiking": ("NeighborhoodRadius", 3), "HorizonElaborateSimplification": ("CellSize", 6)}
# What a session of its own makes of the trace and of the state.
AGAIN = """
from paraview import simple
exec(open("trace.py").read())
simple.SaveData("traced.ts", proxy=simple.FindSource("HorizonTriangulation1"))
simple.Disconnect()
simple.Connect()
simple.LoadState("before.pvsm")
simple.SaveData("loaded.ts", proxy=simple.FindSource("HorizonTriangulation1"))
simple.Disconnect()
"""


def write_expected(sample, path, stages, settings):
    """The mesh by the classes alone."""
    stage = sh.vtkVerneySparseMatrixReader()
    stage.SetFileName(str(sample))
    stage.SetHorizonStatus("Horizon 2", 0)
    for name in stages:
        following = getattr(sh, "vtk" + name)()
        following.SetInputConnection(stage.GetOutputPort())
        if name in settings:
            setting, value = settings[name]
            getattr(following, "Set" + setting)(value)
        stage = following
    writer = sh.vtkGOCADTSurfWriter()
    writer.SetInputConnection(stage.GetOutputPort())
    writer.SetFileName(str(path))
    assert writer.Write() == 1
    return path.read_bytes()


def in_state(path):
    """The sources of a state file by kind, and whether the convex hull is triangulated."""
    state = ElementTree.parse(path).getroot()
    listed = {item.get("id") for collection in state.iter("ProxyCollection") if collection.get("name") == "sources"
              for item in collection}
    # Readers that were chosen by what is in the file say so in their names.
    kinds = [proxy.get("type").replace("ByContent", "") for proxy in state.iter("Proxy") if proxy.get("id") in listed]
    hulls = [prop.find("Element").get("value") for prop in state.iter("Property") if prop.get("name") == "ConvexHull"]
    return sorted(kinds), hulls


def add_stages(events, sample, stages, settings):
    events.open(sample)
    events.choose_horizon(1, False)
    events.apply()
    for name in stages:
        events.filter(name)
        if name in settings:
            events.set_number(*settings[name])
        events.apply()


def play_others(paraview, sample, folder):
    """Despiking, faults, hole filling and cells graded by curvature give what the classes give."""
    events = window.Events()
    add_stages(events, sample, OTHER_STAGES, OTHER_SETTINGS)
    events.save_data(folder / "others.ts")
    events.macro("Note")
    (mesh,) = window.play(paraview, events, folder)
    assert mesh["name"] == "HorizonTriangulation" and mesh["shown"] and mesh["cells"] > 1000, mesh
    expected = write_expected(sample, folder / "others-expected.ts", OTHER_STAGES, OTHER_SETTINGS)
    assert (folder / "others.ts").read_bytes() == expected


def play(paraview, sample, folder):
    events = window.Events()
    events.macro("TraceStart")
    add_stages(events, sample, STAGES, SETTINGS)
    events.macro("TraceStop")
    events.macro("Note")
    events.save_data(folder / "mesh.ts")
    events.set_check("ConvexHull", True)
    events.apply()
    events.save_state(folder / "changed.pvsm")
    events.undo(1)
    events.save_state(folder / "before.pvsm")
    events.filter("HorizonSurfaceDistance")
    events.choose_input("Mesh", sample.name)
    events.apply()
    events.undo(2)  # Apply, and the filter; no further than to the last macro
    events.save_state(folder / "undone.pvsm")
    events.redo(2)
    events.save_state(folder / "redone.pvsm")
    events.macro("Note")
    return window.play(paraview, events, folder)


def play_results(paraview, sample, folder):
    """The panel tells what the run tells that is shown: after each Apply, after undo, and for each file of a series."""
    reader, surface = sh.vtkVerneySparseMatrixReader(), sh.vtkHorizonSurface()
    reader.SetFileName(str(sample))
    surface.SetInputConnection(reader.GetOutputPort())
    told = {}
    events = window.Events()
    events.open(sample)
    events.apply()
    events.filter("HorizonSurface")
    for error in (0.75, 4, 2):
        events.set_number("MaximumError", error, "DoubleLineEdit0")
        events.apply()
        surface.SetMaximumError(error)
        surface.Update()
        told[error] = surface.GetResults()
        events.check_results(told[error])
    assert len(set(told.values())) == 3, told
    events.undo(1)
    events.check_results(told[4])
    window.play(paraview, events, folder)


def main():
    paraview, pvpython, data, folder = sys.argv[1:5]
    folder = window.new_folder(folder)
    sample = pathlib.Path(data).resolve() / "blobs.vsm"
    mesh, distance = play(paraview, sample, folder)
    assert mesh["name"] == "HorizonTriangulation" and mesh["shown"] and mesh["cells"] > 1000, mesh
    assert distance["name"] == "HorizonSurfaceDistance" and distance["shown"], distance
    assert distance["cells"] == mesh["cells"], (distance, mesh)  # the output that is shown: the mesh, in colours

    whole = ["VerneySparseMatrixReader", *STAGES]
    for name, kinds, hull in (("changed", whole, "1"), ("before", whole, "0"), ("undone", whole, "0"),
                              ("redone", [*whole, "HorizonSurfaceDistance"], "0")):
        assert in_state(folder / (name + ".pvsm")) == (sorted(kinds), [hull]), (name, in_state(folder / (name + ".pvsm")))

    expected = write_expected(sample, folder / "expected.ts", STAGES, SETTINGS)
    assert (folder / "mesh.ts").read_bytes() == expected
    script = folder / "again.py"
    script.write_text(AGAIN, encoding="utf-8")
    subprocess.run([pvpython, script], cwd=folder, check=True, timeout=60)
    for name in ("traced.ts", "loaded.ts"):
        assert (folder / name).read_bytes() == expected, name
    play_results(paraview, sample, window.new_folder(folder / "results"))
    play_others(paraview, sample, window.new_folder(folder / "others"))


main()
