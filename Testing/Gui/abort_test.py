# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A filter is stopped in the middle of its work in the window, by the Escape key and by the button beside the progress bar:
nothing is there then, the panel says so, the input is shown still, and there is no error; the window goes on, and Apply gives the whole result, with the same parameters and with
others. Progress is told by the name of the filter.

Arguments: ParaView, the generator of horizons, and a folder. The variable POINTS of the environment makes it larger.
"""

import json
import os
import shutil
import subprocess
import sys
import threading
import time

from seismichorizons import vtk as sh

import window

POINTS = os.environ.get("POINTS", "4000000")
ERRORS = (-1.0, 1.5)  # the default, automatic, and another


class Progress:
    """What the macro WatchProgress has written so far."""

    def __init__(self, folder):
        self.path = folder / "progress.txt"

    def runs(self):
        """The percentages of the filter in each of its runs."""
        runs = []
        text = self.path.read_text(encoding="utf-8") if self.path.exists() else ""
        for line in text.splitlines(keepends=True):
            told = json.loads(line) if line.endswith("\n") else ["", 0]
            if told is None:
                runs.append([])
            elif told[0] == "vtkHorizonSurface":
                runs[-1].append(told[1])
        return runs

    def wait(self, run):
        """Until a run has done a third."""
        while True:
            runs = self.runs()
            if len(runs) > run and runs[run] and max(runs[run]) >= 33:
                return
            time.sleep(0.02)


def xdotool(*arguments):
    return subprocess.run(["xdotool", *arguments], check=True, stdout=subprocess.PIPE, text=True).stdout


def list_clicks():
    """Every few pixels of the line at the bottom of the window, from the right: the button is somewhere there, and nothing
    else of the window may answer. Left of the button there is nothing that could, once the filter has stopped."""
    window_id = xdotool("search", "--onlyvisible", "--name", "^ParaView").split()[0]
    geometry = dict(line.split("=") for line in xdotool("getwindowgeometry", "--shell", window_id).split())
    left, top, width, height = (int(geometry[name]) for name in ("X", "Y", "WIDTH", "HEIGHT"))
    clicks = []
    for x in range(left + width - 5, left, -10):
        clicks += ["mousemove", str(x), str(top + height - 14), "mousedown", "1", "mouseup", "1"]
    return clicks


def stop_runs(progress):
    """Stops the first by the key, and the second by the button."""
    progress.wait(0)
    xdotool("key", "Escape")
    clicks = list_clicks()
    progress.wait(1)
    xdotool(*clicks)


def count_expected(path, error):
    """Points and cells of the meshes by the classes alone."""
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(str(path))
    surface = sh.vtkHorizonSurface()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetMaximumError(error)
    surface.Update()
    output = surface.GetOutputDataObject(0)
    return output.GetNumberOfElements(output.POINT), output.GetNumberOfElements(output.CELL)


def play(paraview, folder, path):
    """Applies four times: the first two are stopped, the last is with another error."""
    events = window.Events()
    events.open(path)
    events.apply()
    events.filter("HorizonSurface")
    for error in (None, None, None, ERRORS[1]):
        if error:
            events.set_number("MaximumError", error, widget="DoubleLineEdit0")
        events.macro("WatchProgress")
        events.apply()
        events.macro("Note")
        events.macro("NoteView")
    progress = Progress(folder)
    threading.Thread(target=stop_runs, args=(progress,), daemon=True).start()
    return window.play(paraview, events, folder), progress.runs()


def main():
    paraview, generator, folder = sys.argv[1:4]
    if not shutil.which("xdotool"):
        sys.exit("xdotool (package xdotool) is not installed, which types and clicks")
    folder = window.new_folder(folder)
    path = folder / "large.vsm"
    subprocess.run([generator, "--points", POINTS, path], check=True, stdout=subprocess.PIPE)
    notes, runs = play(paraview, folder, path)
    views = notes[1::2]
    notes = notes[0::2]
    for view in views[:2]:
        assert [entry[0] for entry in view["shown"]] == ["HorizonSurface", "VerneySparseMatrixReader"], view
        assert view["results"] == ["stopped before the end: nothing was made\n"], view
        assert view["contours"][0].endswith(", one of 3 columns and rows shown"), view
    for view in views[2:]:
        assert [entry[:2] for entry in view["shown"]] == [["HorizonSurface", "Depth"]], view
    for note in notes[:2]:
        assert note["name"] == "HorizonSurface" and (note["points"], note["cells"]) == (0, 0), note
    for note, error in zip(notes[2:], ERRORS):
        assert (note["points"], note["cells"]) == count_expected(path, error) and note["shown"], note
    for stopped in runs[:2]:
        assert 33 <= max(part for part in stopped if part < 100) < 95, runs  # it may end in how the bar is put back
    for whole in runs[2:]:
        assert len(set(whole)) >= 3 and max(whole) > 60 and whole == sorted(whole), runs


main()
