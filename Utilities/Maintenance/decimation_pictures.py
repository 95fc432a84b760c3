#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on the decimation: a horizon within one, a half and a quarter of a voxel; and eight single
columns, with and without a bound where edges cross lines between columns.

    decimation_pictures.py GENERATOR FOLDER
    decimation_pictures.py HORIZON.ijz FOLDER   even meshes of a part of horizon B of Penobscot: EvenMeshes.png

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH; even meshes
need the program convert.
"""

import pathlib
import subprocess
import sys

import numpy as np
import seismichorizons as sh
from seismichorizons.vtk import (apply, vtkHorizonBoundarySimplification, vtkHorizonDecimation,
                                 vtkHorizonExteriorBoundary, vtkHorizonSurfaceDistance, vtkHorizonTriangulation)
from seismichorizons_command import pictures
from seismichorizons_command.data import from_vtk

from generated import make_surface

SURFACE = ("--size", "150", "120", "40", "--horizons", "1", "--holes", "2", "--islands", "0", "--dropouts", "0.005")
ERRORS = (1.0, 0.5, 0.25)
WINDOW = ((150, 260), (20, 115))  # lines i and j of the part that even meshes show
EVEN = {"Few triangles": {}, "EdgeLength 10": {"edge_length": 10.0},
        "EdgeLength 25, EdgeGrowth 0.3": {"edge_length": 25.0, "edge_growth": 0.3}}
EVEN_ERROR = 5.0
EVEN_SIZE = (420, 340)


def decimate(outlined, error):
    straight = apply(vtkHorizonBoundarySimplification(), outlined, Method="FewestPoints", DistanceThreshold=error,
                     OutlineTolerance=error)
    return apply(vtkHorizonDecimation(), straight, MaximumError=error)


def draw_crossings(path):
    row, column = np.mgrid[0:22, 0:28]
    z = 100.0 + 1.5 * np.sin(column / 7.0) * np.cos(row / 6.0)
    z[(row % 2 == 1) & (row > 2) & (row < 18) & (3 * (row - 1) == 2 * column)] += 7.0
    horizon = sh.horizon(z, vertical_step=1.0, direction="up")
    shown = []
    for tolerance in ("same", "unbounded"):
        mesh = sh.surface(horizon, 1.0, crossing_tolerance=tolerance)
        shown.append(pictures.Panel(tolerance.capitalize(), "{} triangles".format(len(mesh)), from_vtk(mesh.to_vtk()), pictures.MESH))
    pictures.write(pictures.draw([shown]), path)


def draw_even(path, folder):
    values = np.loadtxt(path, skiprows=sum(line.startswith("#") for line in open(path, encoding="utf-8")) + 1)
    (i_low, i_high), (j_low, j_high) = WINDOW
    values = values[(values[:, 0] >= i_low) & (values[:, 0] < i_high) & (values[:, 1] >= j_low) & (values[:, 1] < j_high)]
    heights = np.full((j_high - j_low, i_high - i_low), np.nan)
    heights[values[:, 1].astype(int) - j_low, values[:, 0].astype(int) - i_low] = values[:, 2]
    horizon = sh.horizon(heights, vertical_unit="ms", direction="down")
    panels = []
    for title, options in EVEN.items():
        mesh = sh.surface(horizon, EVEN_ERROR, **options)
        caption = "{:,} triangles, smallest angle {:.0f} degrees".format(len(mesh), mesh.details["smallest_angle"])
        panels.append(pictures.Panel(title, caption, from_vtk(mesh.to_vtk()), pictures.MESH))
    picture = folder / "EvenMeshes.png"
    pictures.write(pictures.draw([panels], panel_size=EVEN_SIZE), picture)
    subprocess.run(["convert", picture, "-dither", "None", "-colors", "64", "-strip", "-define", "png:compression-level=9",
                    picture], check=True)


def main():
    if sys.argv[1].endswith(".ijz"):
        draw_even(sys.argv[1], pathlib.Path(sys.argv[2]))
        return
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    surface = make_surface(generator, SURFACE, ZFrom="RealZ")
    outlined = apply(vtkHorizonExteriorBoundary(), surface, KeepHoles=True, SmallestHoleSize=9)
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
    draw_crossings(folder / "DecimationCrossings.png")


main()
