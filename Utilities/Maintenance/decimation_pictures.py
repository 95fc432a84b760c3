#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture of the page on the decimation: a horizon within one, a half and a quarter of a voxel.

    decimation_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

from seismichorizons.vtk import (apply, vtkHorizonBoundarySimplification, vtkHorizonDecimation,
                                 vtkHorizonExteriorBoundary, vtkHorizonSurfaceDistance, vtkHorizonTriangulation)
from seismichorizons_command import pictures
from seismichorizons_command.data import from_vtk

from generated import make_surface

SURFACE = ("--size", "150", "120", "40", "--horizons", "1", "--holes", "2", "--islands", "0", "--dropouts", "0.005")
ERRORS = (1.0, 0.5, 0.25)


def decimate(outlined, error):
    straight = apply(vtkHorizonBoundarySimplification(), outlined, Method="FewestPoints", DistanceThreshold=error,
                     OutlineTolerance=error)
    return apply(vtkHorizonDecimation(), straight, MaximumError=error)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    surface = make_surface(generator, SURFACE, ZFrom="RealZ")
    outlined = apply(vtkHorizonExteriorBoundary(), surface, HoleBoundaries=True, SmallestHoleSize=9)
    full = apply(vtkHorizonTriangulation(), outlined)
    meshes = [decimate(outlined, error) for error in ERRORS]
    shown = [pictures.Panel("Largest error %g" % error, "{:,} triangles".format(mesh.GetNumberOfPolys()), from_vtk(mesh),
                            pictures.MESH) for error, mesh in zip(ERRORS, meshes)]
    distances = []
    for error, mesh in zip(ERRORS, meshes):
        measured = from_vtk(apply(vtkHorizonSurfaceDistance(), full, mesh))
        mean = mesh.GetFieldData().GetArray("MeanError").GetValue(0)
        distances.append(pictures.Panel("", "mean error %.2g" % mean, measured, pictures.DISTANCE))
    folder.mkdir(parents=True, exist_ok=True)
    pictures.write(pictures.draw([shown, distances]), folder / "DecimationErrors.png")


main()
