#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture of the page on hole filling: the largest hole of the sample before and after filling.

    hole_filling_pictures.py SAMPLE FOLDER

SAMPLE is a .vsm file. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkThresholdPoints

from seismichorizons import vtk as sh
from seismichorizons_command import pictures
from seismichorizons_command.pipeline import read_first
from seismichorizons.vtk import apply

PANEL_SIZE = (420, 340)
WINDOW = ((58.0, 106.0), (28.0, 70.0))  # columns and rows around the hole


def window(data):
    """Returns the points in the window."""
    x, y = vtk_to_numpy(data.GetPoints().GetData())[:, :2].T
    (left, right), (bottom, top) = WINDOW
    keep = numpy_to_vtk(((x >= left) & (x <= right) & (y >= bottom) & (y <= top)).astype(np.uint8), deep=True)
    keep.SetName("Keep")
    data.GetPointData().AddArray(keep)
    threshold = vtkThresholdPoints()
    threshold.SetInputData(data)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Keep")
    threshold.ThresholdByUpper(0.5)
    threshold.Update()
    inside = threshold.GetOutput()
    inside.GetPointData().RemoveArray("Keep")
    inside.GetFieldData().PassData(data.GetFieldData())
    return inside


def mesh(points):
    return apply(sh.vtkHorizonTriangulation(), apply(sh.vtkHorizonExteriorBoundary(), points))


def main():
    sample, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
    points = window(read_first(sample))
    panels = [pictures.Panel("Not filled", "the mesh closes holes with long triangles", mesh(points), pictures.MESH)]
    for method in ("Membrane", "Plate"):
        filled = apply(sh.vtkHorizonHoleFilling(), points, Method=method)
        caption = "%d new points" % (filled.GetNumberOfPoints() - points.GetNumberOfPoints())
        panels.append(pictures.Panel(method, caption, mesh(filled), pictures.MESH))
    pictures.write(pictures.draw([panels], panel_size=PANEL_SIZE), folder / "HoleFilling.png")


if __name__ == "__main__":
    main()
