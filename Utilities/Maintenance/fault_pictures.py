#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on faults: a faulted horizon with the lines found, and its meshes without and with cuts,
which are closed in the second one.

    fault_pictures.py FOLDER

Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys
import tempfile

import numpy as np

from seismichorizons import pictures
from seismichorizons.pipeline import read_first, surface
from seismichorizons.stage import make, update

SIZE = (150, 110)
PANEL_SIZE = (440, 360)
CLOSED_SIZE = (660, 480)
LARGEST_ERROR = 1.5


def heights():
    """A fold with two tapered faults, the second of which ends inside at both ends; whole vertical indices."""
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    fold = 60.0 + 9.0 * np.sin(x / 26.0) + 7.0 * np.cos((x + 2.0 * y) / 45.0)
    first = 20.0 * np.clip(y / 45.0, 0.25, 1.0) * (x > 55.0 + 0.35 * y + 4.0 * np.sin(y / 14.0))
    along = (x - 78.0) / 58.0
    taper = np.where(np.abs(2.0 * along - 1.0) < 1.0, 1.0 - (2.0 * along - 1.0) ** 2, 0.0)
    second = 14.0 * taper * (y < 30.0 + 0.3 * (x - 78.0) + 3.0 * np.sin(x / 9.0))
    noise = np.random.default_rng(5).normal(0.0, 0.3, x.shape)
    return np.rint(fold + first + second + noise).astype(int)


def write(path):
    """All columns have a point but for a ragged margin."""
    x, y = np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1]))
    from_middle = np.hypot((x - 75.0) / 75.0, (y - 55.0) / 55.0)
    is_there = from_middle < 0.98 + 0.12 * np.sin(5.0 * np.arctan2(y - 55.0, x - 75.0))
    lines = ["%d 1 1 1 %d" % (height, height) if there else "" for height, there
             in zip(heights().ravel(), is_there.ravel())]
    path.write_text("%d %d 200\n%s\n" % (*SIZE, "\n".join(lines)))


def draw_closed(cut, within):
    """The mesh with its faults open, and closed."""
    closed, _ = surface(cut, largest_error=LARGEST_ERROR, CloseFaults=True)
    walls = closed.GetFieldData().GetArray("FaultTriangleCount").GetValue(0)
    row = [pictures.Panel("Open", "%d triangles" % within.GetNumberOfPolys(), within, pictures.MESH),
           pictures.Panel("Closed", "%d more" % walls, closed, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=CLOSED_SIZE), pathlib.Path(sys.argv[1]) / "ClosedFaults.png")


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "faulted.vsm"
        write(path)
        points = read_first(path)
    faults = make("vtkHorizonFaults")
    faults.SetInputDataObject(0, points)
    update(faults)
    cut, lines = faults.GetOutputDataObject(0), faults.GetOutputDataObject(1)
    without, _ = surface(points, largest_error=LARGEST_ERROR)
    within, _ = surface(cut, largest_error=LARGEST_ERROR)
    row = [pictures.Panel("Fault lines", "%d lines, %d cut links" % (
               lines.GetNumberOfCells(), cut.GetFieldData().GetArray("CutLinks").GetNumberOfTuples()),
               lines, pictures.FAULTS, points),
           pictures.Panel("Not cut", "%d triangles" % without.GetNumberOfPolys(), without, pictures.MESH),
           pictures.Panel("Cut", "%d triangles" % within.GetNumberOfPolys(), within, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=PANEL_SIZE), pathlib.Path(sys.argv[1]) / "Faults.png")
    draw_closed(cut, within)


if __name__ == "__main__":
    main()
