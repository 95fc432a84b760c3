#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on faults: a faulted horizon with the lines found; its meshes without and with cuts, which
are closed in the second one; and horizons cut by the surface between fault sticks.

    fault_pictures.py FOLDER

Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from seismichorizons_command import pictures
from seismichorizons_command.pipeline import read_first, surface
from seismichorizons.vtk import make, update

SIZE = (150, 110)
PANEL_SIZE = (440, 360)
CLOSED_SIZE = (660, 480)
LARGEST_ERROR = 1.5


def heights():
    """Returns a fold with two tapered faults, the second with both tips inside, in whole vertical indices."""
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    fold = 60.0 + 9.0 * np.sin(x / 26.0) + 7.0 * np.cos((x + 2.0 * y) / 45.0)
    first = 20.0 * np.clip(y / 45.0, 0.25, 1.0) * (x > 55.0 + 0.35 * y + 4.0 * np.sin(y / 14.0))
    along = (x - 78.0) / 58.0
    taper = np.where(np.abs(2.0 * along - 1.0) < 1.0, 1.0 - (2.0 * along - 1.0) ** 2, 0.0)
    second = 14.0 * taper * (y < 30.0 + 0.3 * (x - 78.0) + 3.0 * np.sin(x / 9.0))
    noise = np.random.default_rng(5).normal(0.0, 0.3, x.shape)
    return np.rint(fold + first + second + noise).astype(int)


def write(path):
    """Writes a horizon with a point in all columns except a ragged margin."""
    x, y = np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1]))
    from_middle = np.hypot((x - 75.0) / 75.0, (y - 55.0) / 55.0)
    is_there = from_middle < 0.98 + 0.12 * np.sin(5.0 * np.arctan2(y - 55.0, x - 75.0))
    lines = ["%d 1 1 1 %d" % (height, height) if there else "" for height, there
             in zip(heights().ravel(), is_there.ravel())]
    path.write_text("%d %d 200\n%s\n" % (*SIZE, "\n".join(lines)))


def draw_closed(cut, within):
    """Draws the mesh with its faults open, and closed."""
    closed, _ = surface(cut, largest_error=LARGEST_ERROR, CloseFaults=True)
    walls = closed.GetFieldData().GetArray("FaultTriangleCount").GetValue(0)
    row = [pictures.Panel("Open", "%d triangles" % within.GetNumberOfPolys(), within, pictures.MESH),
           pictures.Panel("Closed", "%d more" % walls, closed, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=CLOSED_SIZE), pathlib.Path(sys.argv[1]) / "ClosedFaults.png")


def fault_x(y, depth):
    """Returns x of a curved fault that dips towards larger x."""
    return 48.0 + 0.3 * y + 6.0 * np.sin(y / 16.0) + 0.45 * depth


def make_sticks():
    """Returns sticks on every eleventh row in random order; one ends early."""
    rows = np.random.default_rng(3).permutation(np.arange(-2, SIZE[1] + 10, 11))
    points, lines = vtkPoints(), vtkCellArray()
    for row in rows:
        lines.InsertNextCell(3)
        for depth in (-6.0, 20.0, 34.0 if row == 53 else 62.0):
            lines.InsertCellPoint(points.InsertNextPoint(fault_x(row, depth), row, -depth))
    sticks = vtkPolyData()
    sticks.SetPoints(points)
    sticks.SetLines(lines)
    return sticks


def draw_surfaces():
    """Draws two horizons, the surface of a fault between its sticks, and both together."""
    sticks, together, faults = make_sticks(), vtkAppendPolyData(), make("vtkHorizonFaults")
    faults.SetInputDataObject(1, sticks)
    faults.DetectOff()
    faults.SetLineTypeToSticks()
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    for depth in (10.0, 40.0):
        fold = 3.0 * np.sin(x / 26.0) + 2.0 * np.cos((x + 2.0 * y) / 45.0)
        z = -(depth + fold + 9.0 * (x > fault_x(y, depth + fold + 4.5)))
        source = make("vtkHorizonFromPoints", VerticalDirection="Up")
        cloud = vtkPolyData()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(np.stack([x, y, z], -1).reshape(-1, 3), deep=True))
        cloud.SetPoints(places)
        source.SetInputDataObject(0, cloud)
        update(source)
        faults.SetInputDataObject(0, source.GetOutputDataObject(0))
        update(faults)
        mesh, _ = surface(faults.GetOutputDataObject(0).GetPartition(0, 0), largest_error=LARGEST_ERROR / 3.0)
        together.AddInputData(with_fault(mesh, 0))
    sheet = vtkPolyData()
    sheet.DeepCopy(faults.GetOutputDataObject(2).GetPartition(0, 0))
    lines = vtkPolyData()
    lines.SetPoints(sticks.GetPoints())
    lines.SetLines(sticks.GetLines())
    throws = numpy_to_vtk(np.ones(sticks.GetNumberOfPoints()), deep=True)
    throws.SetName("Throw")
    lines.GetPointData().AddArray(throws)
    together.AddInputData(with_fault(sheet, 1))
    together.Update()
    row = [pictures.Panel("Sticks", "%d, in no order" % sticks.GetNumberOfLines(), lines, pictures.FAULTS, together.GetOutput()),
           pictures.Panel("Their surface", "cuts two horizons", together.GetOutput(), pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=CLOSED_SIZE), pathlib.Path(sys.argv[1]) / "FaultSurfaces.png")


def with_fault(mesh, value):
    """Returns the triangles alone, marked as belonging to a fault or not."""
    triangles = vtkPolyData()
    triangles.SetPoints(mesh.GetPoints())
    triangles.SetPolys(mesh.GetPolys())
    marks = numpy_to_vtk(np.full(mesh.GetNumberOfPolys(), value, dtype=np.uint8), deep=True)
    marks.SetName("Fault")
    triangles.GetCellData().AddArray(marks)
    return triangles


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
    row = [pictures.Panel("Fault lines", "%d lines, %d faulted links" % (
               lines.GetNumberOfCells(), cut.GetFieldData().GetArray("FaultedLinks").GetNumberOfTuples()),
               lines, pictures.FAULTS, points),
           pictures.Panel("Not cut", "%d triangles" % without.GetNumberOfPolys(), without, pictures.MESH),
           pictures.Panel("Cut", "%d triangles" % within.GetNumberOfPolys(), within, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=PANEL_SIZE), pathlib.Path(sys.argv[1]) / "Faults.png")
    draw_closed(cut, within)
    draw_surfaces()


if __name__ == "__main__":
    main()
