#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the pictures of the gallery: ParaView's window after File > Open, filters and Apply, with default parameters unless
a scene sets them. Each scene runs in a process of its own.

    Utilities/with-xvfb.sh window_pictures.py PARAVIEW BIN DATA FOLDER [SCENE ...]

PARAVIEW is the program, BIN the folder with generate_cube, DATA the folder with real horizons (CONTRIBUTING.md). Needs
PV_PLUGIN_PATH, the package seismichorizons in PYTHONPATH, and xdotool and ImageMagick.
"""

import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import time

import fault_pictures

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "Testing" / "Gui"))
import window  # noqa: E402

SIZE = (1600, 1000)
EDGES = (292, 294, 296, 298, 300)  # possible positions of the right edge of the panel
EDGE = 420  # wanted position of the edge
QUIET = 350  # vertical position at which only the edge can be dragged
COLORS = 128  # keeps pictures small
LONGEST = 60  # seconds to wait for the window
TURNS = 200  # runs of a waiting macro, between which the window responds to the mouse
AFTERWARDS = 5  # runs before the picture, so that drawing is complete

WAIT = """import os, time
if not os.path.exists("ready"):
    time.sleep(0.1)
"""
PAUSE = """import time
time.sleep(0.3)
"""
PICTURE = """import subprocess
subprocess.run(["import", "-window", "root", "-crop", "%dx%d+0+0", "+repage", "picture.png"], check=True)
""" % SIZE


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def write_picks(source, path, first, unit):
    """Writes picks of the Penobscot survey, with bins of 25 by 12 m, as exported by an interpretation program."""
    turn = math.radians(7.0)
    lines = [line.split() for line in source.read_text().splitlines() if not line.startswith("#")][1:]
    with path.open("w") as picks:
        picks.write("Inline Crossline X Y TWT_ms\n")
        for i, j, z in lines:
            crossline, inline = int(i) + first[0], int(j) + first[1]
            across, along = 25.0 * (crossline - 1000), 12.0 * (inline - 1000)
            picks.write("%d %d %.2f %.2f %.2f\n" % (
                inline, crossline, 732000 + across * math.cos(turn) - along * math.sin(turn),
                4894000 + across * math.sin(turn) + along * math.cos(turn), float(z) * unit))


def write_geotiff(source, path):
    """Writes elevations in metres, 30 m apart."""
    lines = [line.split() for line in source.read_text().splitlines() if not line.startswith("#")]
    columns, rows = int(lines[0][0]), int(lines[0][1])
    values = [-9999.0] * (columns * rows)
    for i, j, z in lines[1:]:
        values[(rows - 1 - int(j)) * columns + int(i)] = float(z)
    pixels = struct.pack("<%df" % len(values), *values)
    scale, corner = struct.pack("<3d", 30, 30, 0), struct.pack("<6d", 0, 0, 0, 557820, 5108010 + 30 * rows, 0)
    entries = [(256, 4, 1, columns), (257, 4, 1, rows), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 8),
               (277, 3, 1, 1), (278, 4, 1, rows), (279, 4, 1, len(pixels)), (339, 3, 1, 3),
               (33550, 12, 3, 8 + len(pixels)), (33922, 12, 6, 8 + len(pixels) + len(scale)),
               (42113, 2, 6, 8 + len(pixels) + len(scale) + len(corner))]
    data = pixels + scale + corner + b"-9999\0"
    table = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *entry) for entry in entries) + bytes(4)
    path.write_bytes(struct.pack("<2sHI", b"II", 42, 8 + len(data)) + data + table)


def opened(name, several=True):
    return lambda events, files: (events.open(files / name, several_readers=several), events.apply())


def stage(name):
    return lambda events, files: (events.filter(name), events.apply())


def closed(events, files):
    events.filter("HorizonSurface")
    events.set_number("MaximumError", "1.5", "DoubleLineEdit0")
    events.set_check("CloseFaults", True)
    events.apply()


def measured(events, files):
    events.filter("HorizonSurfaceDistance")
    events.choose_input("Mesh", "HorizonB.dat")
    events.apply()


def survey_axes(events, files):
    events.add(window.WINDOW + "/HorizonToolBar/SurveyAxes", "set_boolean", "true")


B = opened("HorizonB.dat")
OUTLINED = [B, stage("HorizonExteriorBoundary")]
SIMPLIFIED = OUTLINED + [stage("HorizonBoundarySimplification")]
ROUGH = SIMPLIFIED + [stage("HorizonRoughSimplification")]
ELABORATE = ROUGH + [stage("HorizonElaborateSimplification")]
SCENES = {
    "points": [B, opened("SeaBed.dat")],
    "elevation": [opened("StHelens.tif"), stage("HorizonFromImage"), stage("HorizonSurface")],
    "seismic_line": [opened("penobscot_xl1155.sgy"), stage("SeismicReflectionExtraction")],
    "seismic_cube": [opened("cube.sgy")],
    "reflections": [opened("cube.sgy"), stage("SeismicReflectionExtraction")],
    "despiking": [B, stage("HorizonDespiking")],
    "faults": [B, stage("HorizonFaults")],
    "cutoffs": [opened("faulted.vsm", False), stage("HorizonFaults"), stage("HorizonCutoffs")],
    "hole_filling": [B, stage("HorizonDespiking"), stage("HorizonHoleFilling")],
    "boundary": OUTLINED,
    "boundary_simplification": SIMPLIFIED,
    "rough": ROUGH,
    "elaborate": ELABORATE,
    "triangulation": ELABORATE + [stage("HorizonTriangulation")],
    "decimation": SIMPLIFIED + [stage("HorizonDecimation")],
    "surface": [B, stage("HorizonSurface")],
    "contours": [B, stage("HorizonSurface"), stage("HorizonContours")],
    "closed_faults": [opened("faulted.vsm", False), stage("HorizonFaults"), closed],
    "distance": [B, stage("HorizonSurface"), measured],
    "exaggeration": [opened("SeaBed.dat"), stage("HorizonSurface"), survey_axes],
}


def find_window():
    """Returns the main window; ParaView has other windows, which are small or hidden."""
    end = time.monotonic() + LONGEST
    while time.monotonic() < end:
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^ParaView"], capture_output=True, text=True)
        if found.stdout.split():
            return found.stdout.split()[-1]
        time.sleep(0.5)
    sys.exit("window_pictures: no window of ParaView")


def arrange(folder):
    """Resizes the window and drags the edge of the panel, which is at one of a few positions; a drag beside the edge has no
    effect. The first events wait meanwhile."""
    run("xdotool", "windowmove", find_window(), 0, 0, "windowsize", find_window(), *SIZE)
    time.sleep(4.0)
    for place in EDGES:
        run("xdotool", "mousemove", place, QUIET, "sleep", 0.3, "mousedown", 1, "sleep", 0.3, "mousemove", place + 20, QUIET,
            "sleep", 0.3, "mousemove", EDGE, QUIET, "sleep", 0.3, "mouseup", 1, "mousemove", *SIZE)
    (folder / "ready").touch()


def take(paraview, name, files, folder):
    """Takes the picture of a scene, in its folder."""
    events = window.Events()
    for _ in range(TURNS):
        events.macro("Wait")
    for step in SCENES[name]:
        step(events, files)
    for _ in range(AFTERWARDS):
        events.macro("Pause")
    events.macro("Picture")
    other = threading.Thread(target=arrange, args=[folder])
    other.start()
    window.play(paraview, events, folder)
    other.join()
    return folder / "picture.png"


def main():
    paraview, programs, data, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
    with tempfile.TemporaryDirectory() as temporary:
        files = pathlib.Path(temporary)
        macros = files / "macros"  # without those of tests, as the window shows their names
        macros.mkdir()
        (macros / "Wait.py").write_text(WAIT)
        (macros / "Pause.py").write_text(PAUSE)
        (macros / "Picture.py").write_text(PICTURE)
        window.MACROS = macros
        fault_pictures.write(files / "faulted.vsm")
        run(programs / "generate_cube", files / "cube.sgy")
        shutil.copy(data / "segy" / "penobscot_xl1155.sgy", files)
        write_picks(data / "penobscot" / "horizon_b.ijz", files / "HorizonB.dat", (1009, 1003), 1.0)
        write_picks(data / "penobscot" / "seabed.ijz", files / "SeaBed.dat", (1000, 1000), 4.0)
        write_geotiff(data / "st_helens" / "horizon.ijz", files / "StHelens.tif")
        for name in sys.argv[5:] or SCENES:
            picture = take(paraview, name, files, window.new_folder(files / name))
            path = folder / ("Gallery" + "".join(word.capitalize() for word in name.split("_")) + ".png")
            run("convert", picture, "-dither", "None", "-colors", COLORS, "-strip", "-define", "png:compression-level=9", path)


if __name__ == "__main__":
    main()
