#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the pictures of the gallery from the real window of ParaView, a process for each.

    Utilities/with-xvfb.sh window_pictures.py PARAVIEW BIN FOLDER [SCENE ...]

PARAVIEW is the program, BIN the folder with generate_cube. Needs PV_PLUGIN_PATH, the package seismichorizons in
PYTHONPATH, and xdotool and ImageMagick.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

import fault_pictures

HERE = pathlib.Path(__file__).resolve().parent
SAMPLE = HERE.parents[1] / "Data" / "sample.vsm"
SCENES = ("points seismic_cube reflections despiking faults hole_filling boundary boundary_simplification rough elaborate "
          "triangulation decimation surface closed_faults distance exaggeration").split()
SIZE = (1400, 900)
EDGES = (294, 296, 298, 300)  # where the right edge of the panel may be
EDGE = 380  # where it is to be
QUIET = 350  # down there nothing can be dragged but the edge
COLORS = 128  # keeps pictures small
LONGEST = 60  # seconds until a scene has to be there


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def find_window():
    """The main window: ParaView has others that are small, or not shown yet."""
    end = time.monotonic() + LONGEST
    while time.monotonic() < end:
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^ParaView"], capture_output=True, text=True)
        if found.stdout.split():
            return found.stdout.split()[-1]
        time.sleep(0.5)
    sys.exit("window_pictures: no window of ParaView")


def widen_panel():
    """Drags its edge, which is at one of a few places; beside it the drag does nothing."""
    for place in EDGES:
        run("xdotool", "mousemove", place, QUIET, "sleep", 0.3, "mousedown", 1, "sleep", 0.3, "mousemove", place + 20, QUIET,
            "sleep", 0.3, "mousemove", EDGE, QUIET, "sleep", 0.3, "mouseup", 1, "mousemove", *SIZE)


def take(path):
    """The screen, once it stays as it is."""
    before = None
    end = time.monotonic() + LONGEST
    while time.monotonic() < end:
        time.sleep(2.0)
        run("import", "-window", "root", "-crop", "%dx%d+0+0" % SIZE, "+repage", path)
        now = run("identify", "-format", "%#", path)
        if now == before:
            break
        before = now
    run("convert", path, "-dither", "None", "-colors", COLORS, "-strip", "-define", "png:compression-level=9", path)


def picture(paraview, scene, files, home, path):
    environment = dict(os.environ, SCENE=scene, HOME=str(home), XDG_CONFIG_HOME=str(home), XDG_RUNTIME_DIR=str(home),
                       **{name: str(file) for name, file in files.items()})
    script = HERE / "window_scenes.py"
    program = subprocess.Popen([paraview, "--dr", "--script=%s" % script], env=environment)
    try:
        window = find_window()
        run("xdotool", "windowmove", window, 0, 0, "windowsize", window, *SIZE)
        time.sleep(4.0)
        widen_panel()
        take(path)
    finally:
        program.kill()
        program.wait()


def main():
    paraview, programs, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    with tempfile.TemporaryDirectory() as temporary:
        home = pathlib.Path(temporary)
        home.chmod(0o700)
        files = {"SAMPLE": SAMPLE, "FAULTED": home / "faulted.vsm", "CUBE": home / "cube.sgy"}
        fault_pictures.write(files["FAULTED"])
        run(programs / "generate_cube", files["CUBE"])
        for scene in sys.argv[4:] or SCENES:
            name = "Gallery" + "".join(word.capitalize() for word in scene.split("_")) + ".png"
            picture(paraview, scene, files, home, folder / name)


if __name__ == "__main__":
    main()
