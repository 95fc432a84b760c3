# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Second inputs are chosen in the panel, before the first Apply, or by selecting two sources: thickness, distance, guides and
fault lines. The panel tells what the classes give.

Arguments: ParaView, the generator of cubes, and a folder for files.
"""

import pathlib
import subprocess
import sys

import seismichorizons.vtk as sh
import window

FOUND = window.FIELDS + "ProxyPanel/Description/Description"
# A line across a survey of 29 by 39 bins of 25.
LINE = "362.5 -9.0 0\n362.5 990.0 0\n999.0 999.0 999.0\n"
# A fault across the same survey.
STICKS = """GOCAD PLine 1
HEADER {
name:F1
}
GOCAD_ORIGINAL_COORDINATE_SYSTEM
ZPOSITIVE Depth
END_ORIGINAL_COORDINATE_SYSTEM
""" + "".join("ILINE\nVRTX %d 330 %g 900\nVRTX %d 390 %g 1200\nSEG %d %d\n" % (n, y, n + 1, y, n, n + 1) for n, y in ((1, 0.0), (3, 500.0), (5, 990.0))) + "END\n"
# On both sides of the fault of a cube.
TOPS = """Horizon  X         Y          Z
Top      604964.1  6080030.1  201
Top      604891.5  6080305.8  196
Top      604534.2  6080474.7  187
Top      605230.3  6080818.9  218
Top      605161.1  6081038.8  216
"""


def picks(z, slope):
    return "Inline Crossline X Y Z\n" + "".join("%d %d %d %d %g\n" % (10 + row, 20 + column, 25 * column, 25 * row, z + slope * row * column)
                             for row in range(40) for column in range(30))


def browser(events, place):
    """Selects a source."""
    events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", place)


def opened(events, path):
    events.open(path, several_readers=True)
    events.apply()


def read(path):
    reader = sh.vtkHorizonTextReader()
    reader.AddFileName(str(path))
    return reader


def thickness(events, top, base):
    """From two files to a thickness in five clicks, whether both are selected or one is chosen."""
    expected = sh.vtkHorizonThickness()
    readers = read(base), read(top)
    for port, reader in enumerate(readers):
        expected.SetInputConnection(port, reader.GetOutputPort())
    expected.Update()
    assert "mean thickness" in expected.GetResults()
    opened(events, top)
    opened(events, base)
    events.filter("HorizonThickness")
    events.choose_input("Other", top.name)
    events.apply()
    events.check_results(expected.GetResults())
    browser(events, "/0|0/1|0")
    events.macro("SelectReaders")
    events.filter("HorizonThickness")
    events.apply()
    events.check_results(expected.GetResults())


def mended(events, top, base):
    """Without the other horizon, the one at hand stays in sight; with it, the thickness takes its place."""
    opened(events, top)
    opened(events, base)
    events.filter("HorizonThickness")
    events.apply()
    events.macro("NoteView")
    events.choose_input("Other", top.name)
    events.apply()
    events.macro("NoteView")


def distance(events, top):
    """In either order."""
    reader, surface, expected = read(top), sh.vtkHorizonSurface(), sh.vtkHorizonSurfaceDistance()
    surface.SetInputConnection(reader.GetOutputPort())
    expected.SetInputConnection(0, reader.GetOutputPort())
    expected.SetInputConnection(1, surface.GetOutputPort())
    expected.Update()
    assert "largest distance" in expected.GetResults()
    opened(events, top)
    events.filter("HorizonSurface")
    events.apply()
    events.filter("HorizonSurfaceDistance")
    events.choose_input("Mesh", top.name)
    events.apply()
    events.check_results(expected.GetResults())
    browser(events, "/0|0/0|0")
    events.filter("HorizonSurfaceDistance")
    events.choose_input("Mesh", "HorizonSurface1:Mesh")
    events.apply()
    events.check_results(expected.GetResults())


def found(cube, tops):
    """What the extraction tells."""
    reader, extraction, guides = sh.vtkSEGYCubeReader(), sh.vtkSeismicReflectionExtraction(), sh.vtkHorizonTextReader()
    reader.AddFileName(str(cube))
    extraction.SetInputConnection(reader.GetOutputPort())
    if tops:
        guides.AddFileName(str(tops))
        guides.SetLatticeSourceToNoLattice()
        extraction.SetGuidesConnection(guides.GetOutputPort())
    extraction.Update()
    return extraction.GetDescription()


def follow(events, cube, tops):
    """A guided extraction, whose guides are chosen before the first Apply."""
    events.open(cube, several_readers=True)
    events.apply()
    events.open(tops, several_readers=True)
    events.add(window.FIELDS + "ProxyPanel/LatticeSource/ComboBox", "set_string", "No Lattice")
    events.apply()
    browser(events, "/0|0/0|0")
    events.filter("SeismicReflectionExtraction")
    events.choose_input("Guides", tops.name)
    events.apply()


def guides(events, cube, tops):
    """From a cube and picks to a guided horizon, without a run that has no guides; then without guides. The panel tells what the
    last run found."""
    follow(events, cube, tops)
    events.macro("NoteResults")
    events.check(FOUND, "plainText", found(cube, tops))
    events.choose_input("Guides", "(none)")
    events.apply()
    events.check(FOUND, "plainText", found(cube, None))


def guided_mesh(events, cube, tops):
    """The extraction is still selected once it has its guides."""
    follow(events, cube, tops)
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteResults")


def seismic_line(events, path):
    """A line is shown as its outline, but its traces go into the extraction."""
    events.open(path, several_readers=True)
    events.apply()
    events.filter("SeismicReflectionExtraction")
    events.apply()
    events.macro("NoteResults")


def faults(events, top, line):
    opened(events, top)
    events.open(line)
    events.apply()
    browser(events, "/0|0/0|0")
    events.filter("HorizonFaults")
    events.choose_input("FaultLines", line.name)
    events.apply()
    events.macro("NoteResults")


def cutoffs(events, top, sticks):
    """Of a horizon at sticks, which are chosen before the first Apply."""
    reader, lines, expected = read(top), sh.vtkFaultLinesReader(), sh.vtkHorizonCutoffs()
    lines.AddFileName(str(sticks))
    expected.SetInputConnection(0, reader.GetOutputPort())
    expected.SetFaultsConnection(lines.GetOutputPort())
    expected.Update()
    assert "F1\n  " in expected.GetResults(), expected.GetResults()
    events.open(sticks)
    events.apply()
    opened(events, top)
    events.filter("HorizonCutoffs")
    events.choose_input("Faults", sticks.name)
    events.apply()
    events.check_results(expected.GetResults())


def play(paraview, folder, action, *arguments, error=None):
    events = window.Events()
    action(events, *arguments)
    return window.play(paraview, events, window.new_folder(folder / action.__name__), error=error)


def main(paraview, generator, folder):
    top, base, line, cube, tops = (folder / name for name in ("top.dat", "base.dat", "fault.pol", "cube.sgy", "tops.dat"))
    top.write_text(picks(1000, 0.05), encoding="utf-8")
    base.write_text(picks(1060, 0.07), encoding="utf-8")
    line.write_text(LINE, encoding="utf-8")
    tops.write_text(TOPS, encoding="utf-8")
    subprocess.run([generator, "--hard", "--seed", "4", "--noise", "0.2", str(cube)], check=True)
    play(paraview, folder, thickness, top, base)
    failed, done = play(paraview, folder, mended, top, base, error="expected one as the input Other")
    shown = [sorted(one[0] for one in note["shown"]) for note in (failed, done)]
    assert shown == [["HorizonTextReader", "HorizonTextReader", "HorizonThickness"], ["HorizonTextReader", "HorizonThickness"]], shown
    play(paraview, folder, distance, top)
    (note,) = play(paraview, folder, guides, cube, tops)
    assert note["array"] == "Confidence" and "\nTop: " in note["told"], note
    section = folder / "line.sgy"
    subprocess.run([generator, "--size", "90", "1", "200", str(section)], check=True)
    (note,) = play(paraview, folder, seismic_line, section)
    assert "surfaces of" in note["told"], note
    (meshed,) = play(paraview, folder, guided_mesh, cube, tops)
    assert "triangles" in meshed["told"], meshed
    (note,) = play(paraview, folder, faults, top, line)
    assert "fault lines 1\n" in note["told"], note
    sticks = folder / "sticks.pl"
    sticks.write_text(STICKS, encoding="utf-8")
    play(paraview, folder, cutoffs, top, sticks)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], window.new_folder(sys.argv[3]))
