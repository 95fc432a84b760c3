# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A filter is stopped in the middle of its work in the window: nothing is there then, and no error; the window goes on, and
Apply with another parameter gives the whole result. Progress is told by the name of the filter.

Arguments: ParaView, the generator of horizons, and a folder. The variable POINTS of the environment makes it larger.
"""

import json
import os
import subprocess
import sys

import seismichorizons as sh

import window

POINTS = os.environ.get("POINTS", "300000")
ERROR = 1.5


def count_expected(path):
    """Points and cells of the meshes by the classes alone."""
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(str(path))
    surface = sh.vtkHorizonSurface()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetMaximumError(ERROR)
    surface.Update()
    output = surface.GetOutputDataObject(0)
    return output.GetNumberOfElements(output.POINT), output.GetNumberOfElements(output.CELL)


def main():
    paraview, generator, folder = sys.argv[1:4]
    folder = window.new_folder(folder)
    path = folder / "large.vsm"
    subprocess.run([generator, "--points", POINTS, path], check=True, stdout=subprocess.PIPE)
    events = window.Events()
    events.open(path)
    events.apply()
    events.filter("HorizonSurface")
    events.macro("StopFilter")
    events.apply()
    events.macro("Note")
    events.macro("LetFilterRun")
    events.set_number("MaximumError", ERROR, widget="DoubleRangeWidget/DoubleLineEdit")
    events.apply()
    events.macro("Note")
    stopped, whole = window.play(paraview, events, folder)
    assert stopped["name"] == "HorizonSurface" and (stopped["points"], stopped["cells"]) == (0, 0), stopped
    assert (whole["points"], whole["cells"]) == count_expected(path) and whole["shown"], whole

    told = [json.loads(line) for line in (folder / "progress.txt").read_text(encoding="utf-8").splitlines()]
    runs = [[part for text, part in run if text == "vtkHorizonSurface"]
            for run in (told[:told.index(None)], told[told.index(None) + 1:])]
    assert len(set(runs[0])) >= 2 and max(part for part in runs[0] if part < 100) < 50, runs  # 100 is said at every end
    assert len(set(runs[1])) >= 3 and max(runs[1]) > 60 and runs[1] == sorted(runs[1]), runs


main()
