#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the pages on the simplification of the inside.

    simplification_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

from seismichorizons.vtk import (apply, vtkHorizonBoundarySimplification, vtkHorizonElaborateSimplification,
                                 vtkHorizonExteriorBoundary, vtkHorizonRoughSimplification, vtkHorizonTriangulation)
from seismichorizons_command import pictures
from seismichorizons_command.data import from_vtk

from generated import make_surface

SURFACE = ("--size", "150", "120", "40", "--horizons", "1", "--holes", "2", "--islands", "0", "--dropouts", "0.005")


def panel(title, horizon, style, caption=None):
    return pictures.Panel(title, caption or "{:,} points".format(horizon.GetNumberOfPoints()), from_vtk(horizon), style)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    full = make_surface(generator, SURFACE)
    outlined = apply(vtkHorizonExteriorBoundary(), full)
    straight = apply(vtkHorizonBoundarySimplification(), outlined)
    rough = [apply(vtkHorizonRoughSimplification(), straight, CellSize=size) for size in (3, 6)]
    options = {"FlatnessThreshold": 0.03}
    elaborate = apply(vtkHorizonElaborateSimplification(), straight, **options)
    cells = apply(vtkHorizonElaborateSimplification(), straight, ShowCells=True, **options)
    mesh = apply(vtkHorizonTriangulation(), elaborate)
    levels = [
        panel("Cells", cells, pictures.CELLS, "8 lattice units blue, halved once green, ..."),
        panel("Points", elaborate, pictures.LEVELS),
        panel("Mesh", mesh, pictures.MESH, "{:,} triangles".format(mesh.GetNumberOfPolys()))]
    before = apply(vtkHorizonTriangulation(), outlined)
    meshes = [panel("Before", before, pictures.MESH)]
    for title, data in (("Rough, 3", rough[0]), ("Rough, 6", rough[1]), ("Elaborate", elaborate)):
        meshes.append(panel(title, apply(vtkHorizonTriangulation(), data), pictures.MESH))
    folder.mkdir(parents=True, exist_ok=True)
    pictures.write(pictures.draw([levels]), folder / "CellLevels.png")
    pictures.write(pictures.draw([meshes]), folder / "SimplificationBeforeAfter.png")


main()
