# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The steps that both tutorials describe in the window, on the data that they make, write the files that they name. Where real
horizons are at hand, second inputs are chosen for these, too.

Arguments: ParaView, the folder with generate_cube, the pages, the folder of real horizons, which may be empty, and one for files.
"""

import os
import pathlib
import re
import subprocess
import sys

import seismichorizons as package
import window

PAPER = window.FIELDS + "ProxyPanel/"


def make_data(page, programs, folder):
    """Runs those commands of a page that make data."""
    environment = dict(os.environ, PATH="%s:%s" % (programs, os.environ["PATH"]))
    for block in re.findall(r"^```sh\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL):
        commands = "\n".join(line for line in block.splitlines() if not line.startswith("horizon-mesh"))
        subprocess.run(["sh", "-e", "-c", commands], cwd=folder, env=environment, check=True)


def select(events, number):
    """A source, from 0 in the order of the pipeline browser."""
    events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/0|0/%d|0" % number)


def choose(events, name, text):
    events.add(PAPER + name + "/ComboBox", "set_string", text)


def from_picks(events, folder):
    events.open(folder / "dome.dat", several_readers=True)
    events.apply()
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteResults")
    events.save_data(folder / "dome.ts")
    select(events, 0)
    events.filter("HorizonSurfaceDistance")
    events.choose_input("Mesh", "HorizonSurface1:Mesh")
    events.apply()
    events.macro("NoteResults")


def from_cube(events, folder):
    events.open(folder / "cube.sgy", several_readers=True)
    events.apply()
    events.filter("SeismicReflectionExtraction")
    choose(events, "Polarity", "Positive")
    events.set_number("LargestNumber", "20")
    events.apply()
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteResults")
    events.save_data(folder / "cube.ts")


def from_nine_picks(events, folder):
    events.open(folder / "faulted.sgy", several_readers=True)
    events.apply()
    events.open(folder / "tops.dat", several_readers=True)
    choose(events, "LatticeSource", "No Lattice")
    events.apply()
    select(events, 0)
    events.filter("SeismicReflectionExtraction")
    events.choose_input("Guides", "tops.dat")
    events.apply()
    events.macro("NoteResults")
    events.save_data(folder / "faulted.irap")


def write_picks(source, path, first):
    """Real picks in columns of the lattice, with bins of 25 by 12 m."""
    lines = [line.split() for line in source.read_text().splitlines() if not line.startswith("#")][1:]
    path.write_text("Inline Crossline X Y TWT_ms\n" + "".join(
        "%d %d %d %d %s\n" % (first[1] + int(j), first[0] + int(i), 25 * (first[0] + int(i)), 12 * (first[1] + int(j)), z)
        for i, j, z in lines), encoding="ascii")


def on_real_horizons(events, folder):
    for name in ("SeaBed.dat", "HorizonB.dat"):
        events.open(folder / name, several_readers=True)
        events.apply()
    events.filter("HorizonThickness")
    events.choose_input("Other", "SeaBed.dat")
    events.apply()
    events.macro("NoteResults")
    events.open(folder / "lines.pl")
    events.apply()
    select(events, 1)
    events.filter("HorizonFaults")
    events.choose_input("FaultLines", "lines.pl")
    events.set_check("Detect", False)
    events.apply()
    events.macro("NoteResults")


def check_real(paraview, real, folder):
    write_picks(real / "seabed.ijz", folder / "SeaBed.dat", (1000, 1000))
    write_picks(real / "horizon_b.ijz", folder / "HorizonB.dat", (1009, 1003))
    (horizon,) = package.read(folder / "HorizonB.dat").values()
    faults = package.faults(horizon, 20.0)
    package.write(faults.traces, folder / "lines.pl")
    thickness, cut = play(paraview, folder, on_real_horizons)
    assert "mean thickness" in thickness, thickness
    assert "\n  links cut " in cut, cut


def play(paraview, folder, action):
    events = window.Events()
    action(events, folder)
    return [note["told"] for note in window.play(paraview, events, window.new_folder(folder / action.__name__))]


def main(paraview, programs, pages, real, folder):
    for page in ("TutorialPicks.md", "TutorialCube.md"):
        make_data(pathlib.Path(pages) / page, programs, folder)
    meshed, measured = play(paraview, folder, from_picks)
    assert "\n  triangles " in meshed and "\n  largest vertical error " in meshed and "largest distance" in measured, (meshed, measured)
    triangles = (folder / "dome.ts").read_text(encoding="utf-8").count("\nTRGL ")
    assert triangles == int(re.search(r"triangles (\d+)", meshed)[1]), meshed
    (meshed,) = play(paraview, folder, from_cube)
    surfaces = (folder / "cube.ts").read_text(encoding="utf-8").count("GOCAD TSurf")
    assert 10 < surfaces <= 20 and meshed.startswith("%d horizons: " % surfaces), meshed
    (found,) = play(paraview, folder, from_nine_picks)
    (grid,) = package.read(folder / "faulted.irap").values()
    assert "Top" in found and len(grid.z) > 1000, found
    if real and (pathlib.Path(real) / "penobscot").is_dir():
        check_real(paraview, pathlib.Path(real) / "penobscot", folder)


if __name__ == "__main__":
    main(*sys.argv[1:5], window.new_folder(sys.argv[5]))
