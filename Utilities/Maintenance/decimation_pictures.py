#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture of the page on the decimation: a horizon within one, a half and a quarter of a voxel.

    decimation_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

from seismichorizons import vtk as sh
from seismichorizons_command import pictures
from seismichorizons.vtk import apply

from generated import make_surface

SURFACE = ("--size", "150", "120", "40", "--horizons", "1", "--holes", "2", "--islands", "0", "--dropouts", "0.005")
ERRORS = (1.0, 0.5, 0.25)


def decimate(outlined, error):
    straight = apply(sh.vtkHorizonBoundarySimplification(), outlined, Method="FewestPoints", DistanceThreshold=error,
                     OutlineTolerance=error)
    return apply(sh.vtkHorizonDecimation(), straight, MaximumError=error)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    surface = make_surface(generator, SURFACE, ZFrom="RealZ")
    outlined = apply(sh.vtkHorizonExteriorBoundary(), surface, HoleBoundaries=True, SmallestHoleSize=9)
    full = apply(sh.vtkHorizonTriangulation(), outlined)
    meshes = [decimate(outlined, error) for error in ERRORS]
    shown = [pictures.Panel("Largest error %g" % error, "{:,} triangles".format(mesh.GetNumberOfPolys()), mesh,
                            pictures.MESH) for error, mesh in zip(ERRORS, meshes)]
    distances = []
    for error, mesh in zip(ERRORS, meshes):
        meter = sh.vtkHorizonSurfaceDistance()
        apply(meter, full, mesh)
        mean = mesh.GetFieldData().GetArray("MeanError").GetValue(0)
        distances.append(pictures.Panel("", "mean error %.2g" % mean, meter.GetOutputDataObject(0), pictures.DISTANCE))
    folder.mkdir(parents=True, exist_ok=True)
    pictures.write(pictures.draw([shown, distances]), folder / "DecimationErrors.png")


main()
