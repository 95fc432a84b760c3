#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on the exterior boundary.

    boundary_pictures.py SAMPLE FOLDER

SAMPLE is a .vsm file. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from seismichorizons import vtk as sh
from seismichorizons_command import pictures
from seismichorizons_command.pipeline import read_first
from seismichorizons.vtk import apply

PANEL_SIZE = (420, 340)


def ragged(data):
    """Makes a corner of a horizon with less than half of its points, as left by automatic tracking in noise."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for number in range(data.GetNumberOfPoints()):
        i, j, k = data.GetPoint(number)
        # Any hash works that is the same on all machines.
        noise = (int(i) * 73856093 ^ int(j) * 19349663) * 2654435761 % 2**32 / 2**32
        if 30 <= i < 80 and 25 <= j < 65 and noise < 0.45:
            points.InsertNextPoint(i, j, k)
    part = vtkPolyData()
    part.SetPoints(points)
    vertices = vtkCellArray()
    for number in range(points.GetNumberOfPoints()):
        vertices.InsertNextCell(1, [number])
    part.SetVerts(vertices)
    part.SetFieldData(data.GetFieldData())
    return part


def outline_panel(data, rule, radius, holes):
    outline = apply(sh.vtkHorizonExteriorBoundary(), data, Radius=radius, GrowthStrategy=rule, HoleBoundaries=holes,
                    SmallestHoleSize=2)
    counts = [int(outline.GetFieldData().GetArray(name).GetTuple1(0)) for name in ("NumberOfPatches", "NumberOfHoles")]
    points = outline.GetLines().GetNumberOfConnectivityIds() - outline.GetNumberOfLines()
    caption = "%d patches, %d boundary points" % (counts[0], points)
    if holes:
        caption = "%d patches, %d holes, %d boundary points" % (*counts, points)
    return pictures.Panel("%s, radius %d" % (rule, radius), caption, outline, pictures.OUTLINE, data)


def main():
    sample, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
    data = read_first(sample)
    for name, horizon, holes in (("Radius", ragged(data), False), ("Holes", data, True)):
        rows = [[outline_panel(horizon, rule, radius, holes) for radius in (1, 2, 3)]
                for rule in ("Distance", "Clockwise")]
        pictures.write(pictures.draw(rows, panel_size=PANEL_SIZE), folder / ("Boundary%s.png" % name))


if __name__ == "__main__":
    main()
