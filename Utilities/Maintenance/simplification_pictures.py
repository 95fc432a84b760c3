#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the pages on the simplification of the inside.

    simplification_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

from seismichorizons import vtk as sh
from seismichorizons_command import pictures
from seismichorizons.vtk import apply

from generated import make_surface

SURFACE = ("--size", "150", "120", "40", "--horizons", "1", "--holes", "2", "--islands", "0", "--dropouts", "0.005")


def panel(title, horizon, style, caption=None):
    return pictures.Panel(title, caption or "{:,} points".format(horizon.GetNumberOfPoints()), horizon, style)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    full = make_surface(generator, SURFACE)
    outlined = apply(sh.vtkHorizonExteriorBoundary(), full)
    straight = apply(sh.vtkHorizonBoundarySimplification(), outlined)
    rough = [apply(sh.vtkHorizonRoughSimplification(), straight, CellSize=size) for size in (3, 6)]
    options = {"FlatnessThreshold": 0.03}
    elaborate = apply(sh.vtkHorizonElaborateSimplification(), straight, **options)
    cells = apply(sh.vtkHorizonElaborateSimplification(), straight, ShowCells=True, **options)
    mesh = apply(sh.vtkHorizonTriangulation(), elaborate)
    levels = [
        panel("Cells", cells, pictures.CELLS, "8 lattice units blue, halved once green, ..."),
        panel("Points", elaborate, pictures.LEVELS),
        panel("Mesh", mesh, pictures.MESH, "{:,} triangles".format(mesh.GetNumberOfPolys()))]
    before = apply(sh.vtkHorizonTriangulation(), outlined)
    meshes = [panel("Before", before, pictures.MESH)]
    for title, data in (("Rough, 3", rough[0]), ("Rough, 6", rough[1]), ("Elaborate", elaborate)):
        meshes.append(panel(title, apply(sh.vtkHorizonTriangulation(), data), pictures.MESH))
    folder.mkdir(parents=True, exist_ok=True)
    pictures.write(pictures.draw([levels]), folder / "CellLevels.png")
    pictures.write(pictures.draw([meshes]), folder / "SimplificationBeforeAfter.png")


main()
