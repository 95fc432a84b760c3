# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes points that a script has made or fetched from elsewhere, in world coordinates and in any order.

    python3 own_points.py mesh.vtp

Runs in the system Python, which must find the package seismichorizons. Replace make_points by your arrays: the points
must lie on a lattice, which may be rotated; it is found automatically.
"""

import argparse
import math
import random

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from seismichorizons import pipeline, reading, vtkHorizonFromPoints
from seismichorizons.vtk import apply


def make_points():
    """Returns picks of a dome on a rotated survey of 25 m by 12.5 m, in random order, with a hole."""
    angle = math.radians(30)
    along, across = (np.array((math.cos(angle), math.sin(angle))), np.array((-math.sin(angle), math.cos(angle))))
    picks = []
    for i in range(80):
        for j in range(100):
            if (i - 30) ** 2 + (j - 60) ** 2 > 60:
                x, y = np.array((431000.0, 6348000.0)) + 25.0 * i * along + 12.5 * j * across
                picks.append((x, y, 1500.0 + 0.06 * ((i - 40) ** 2 + (j - 50) ** 2)))
    random.Random(1).shuffle(picks)
    return np.array(picks)


def as_poly_data(places):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def main():
    parser = argparse.ArgumentParser(prog="own_points", description=__doc__.splitlines()[0])
    parser.add_argument("mesh", metavar="MESH.vtp", help="the file to write")
    arguments = parser.parse_args()
    source = vtkHorizonFromPoints()
    source.SetVerticalStep(1.0)  # a vertical index is one metre, so errors are in metres
    apply(source, as_poly_data(make_points()))
    name, points = reading.list_horizons(source.GetOutputDataObject(0))[0]
    mesh, _ = pipeline.surface(points, largest_error=1.0)
    print("%s: %d points, %d triangles" % (name, points.GetNumberOfPoints(), mesh.GetNumberOfPolys()))
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(arguments.mesh)
    writer.SetInputData(mesh)
    writer.SetDataModeToBinary()  # some readers of VTK fail on appended data
    writer.Write()


main()
