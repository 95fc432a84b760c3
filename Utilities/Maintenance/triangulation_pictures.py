#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on the triangulation: maps of how triangles are found and removed.

    triangulation_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import math
import pathlib
import sys

import numpy as np
from seismichorizons.vtk import (apply, vtkHorizonBoundarySimplification, vtkHorizonElaborateSimplification,
                                 vtkHorizonExteriorBoundary, vtkHorizonTriangulation)
from seismichorizons_command import pictures
from vtkmodules.util.numpy_support import vtk_to_numpy

from generated import make_surface
from maps import Map, cells_of, dots, draw, edges_of, fit, flat_actor, in_plan, strokes

SURFACE = ("--size", "50", "40", "16", "--horizons", "1", "--holes", "0", "--islands", "0", "--dropouts", "0.02")
STAR = ("--size", "70", "56", "16", "--horizons", "1", "--holes", "0", "--islands", "0", "--squareness", "-1")

STRATEGIES = (("VoxelTraversal", "Voxel traversal"), ("Compactness", "Compactness"))

# Colours of voxels by dilatation, and of voxels searched otherwise.
DILATATIONS = {0: ("1f6fb2", "on the perpendicular bisector"),
               1: ("8cc3e6", "on its dilatations"),
               -1: ("fbdfb0", "in the box of the edge, squares around it, or the circle of a candidate")}
POINT = "4a5561"
BOUNDARY = "c61c29"
MESH = "5b6b7d"
MESH_OPACITY = 0.17
MESH_EDGE = "8b97a4"
LAST = "c61c29"
EDGE = "10161d"


def outlines(data, width):
    return strokes(in_plan(data), cells_of(data.GetLines()), BOUNDARY, width)


def mesh_actors(data, width):
    """Returns translucent triangles and their edges."""
    triangles = cells_of(data.GetPolys())
    faces = flat_actor(in_plan(data), MESH, Polys=triangles)
    faces.GetProperty().SetOpacity(MESH_OPACITY)
    return [faces, strokes(in_plan(data), edges_of(triangles), MESH_EDGE, width)]


def voxel_actors(search, width):
    """Returns the searched voxels; voxels of the circle are drawn first, because others may have been searched before."""
    dilatations = np.minimum(vtk_to_numpy(search.GetCellData().GetArray("Dilatation")), 1)
    squares = cells_of(search.GetPolys())
    actors = []
    for value in sorted(set(dilatations), key=lambda dilatation: (dilatation >= 0, -dilatation)):
        chosen = [square for square, dilatation in zip(squares, dilatations) if dilatation == value]
        actors.append(flat_actor(in_plan(search), DILATATIONS[value][0], Polys=chosen))
        actors.append(strokes(in_plan(search), edges_of(chosen), "ffffff", width))
    return actors


def circle_through(a, b, c):
    (bx, by), (cx, cy) = b - a, c - a
    area = 2.0 * (bx * cy - by * cx)
    x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / area
    y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / area
    return a + np.array([x, y]), math.hypot(x, y)


def circle_actor(a, b, c, width):
    center, radius = circle_through(a, b, c)
    angles = np.linspace(0.0, 2.0 * math.pi, 121)
    places = center + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    return strokes(places, [range(len(places))], EDGE, width)


def bisector_actor(a, b, width):
    """Returns a dashed line from the middle of the edge to its left, as long as the edge."""
    across = np.array([a[1] - b[1], b[0] - a[0]])
    places = [(a + b) / 2.0 + across * n / 16.0 for n in range(16)]
    return strokes(places, [(n, n + 1) for n in range(0, 15, 2)], EDGE, width)


def last_triangle(mesh):
    """Returns the edge at which the search began, and the third point."""
    return in_plan(mesh)[cells_of(mesh.GetPolys())[-1]]


def search_actors(mesh, search, size):
    """Returns the voxels of the last triangle, the triangles found so far, and the construction of the last one."""
    places = in_plan(mesh)
    a, b, c = corners = last_triangle(mesh)
    return [
        *voxel_actors(search, 0.25 * size),
        *mesh_actors(mesh, 0.22 * size),
        outlines(mesh, 0.45 * size),
        circle_actor(a, b, c, 0.25 * size),
        bisector_actor(a, b, 0.35 * size),
        dots(places, POINT, size),
        strokes(corners, [(1, 2, 0)], LAST, 0.6 * size),
        strokes(corners, [(0, 1)], EDGE, 0.9 * size),
        dots(corners[2:], LAST, 1.8 * size)]


def stop_after(data, triangles, strategy):
    algorithm = vtkHorizonTriangulation()
    mesh = apply(algorithm, data, MaximumNumberOfTriangles=triangles, SearchStrategy=strategy)
    return mesh, algorithm.GetOutputDataObject(1)


def close_up(title, strategy, data, triangles):
    mesh, search = stop_after(data, triangles, strategy)
    # Both strategies find the same triangle; the larger search sets the scale for both.
    walks = [in_plan(stop_after(data, triangles, each)[1]) for each, _ in STRATEGIES]
    seen = np.vstack([*walks, last_triangle(mesh)])
    caption = "triangle %d: %d voxels looked into" % (triangles, search.GetNumberOfPolys())
    return Map(title, caption, search_actors(mesh, search, 5.0), fit(seen))


def growth(title, data, size, triangles):
    mesh, search = stop_after(data, triangles, "VoxelTraversal")
    return Map(title, "after %d triangles" % triangles, search_actors(mesh, search, size), fit(in_plan(data)))


def hull(title, data, **limits):
    mesh = apply(vtkHorizonTriangulation(), data, ConvexHull=True, **limits)
    actors = [*mesh_actors(mesh, 0.8), outlines(mesh, 1.6), dots(in_plan(mesh), POINT, 2.6)]
    return Map(title, "%d triangles" % mesh.GetNumberOfPolys(), actors, fit(in_plan(mesh)))


def simplify(outlined, cell_size):
    straight = apply(vtkHorizonBoundarySimplification(), outlined, OutlineTolerance=0.7)
    return apply(vtkHorizonElaborateSimplification(), straight, FlatnessThreshold=0.06, CellSize=cell_size)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    full = apply(vtkHorizonExteriorBoundary(), make_surface(generator, SURFACE))
    thinned = simplify(full, 8)
    folder.mkdir(parents=True, exist_ok=True)
    moments = (("full lattice", full, 445), ("simplified", thinned, 81), ("simplified", thinned, 21))
    walks = [[close_up("%s, %s" % (name, where), strategy, data, triangles) for where, data, triangles in moments]
             for strategy, name in STRATEGIES]
    pictures.write(draw(walks, list(DILATATIONS.values())), folder / "TriangulationSearch.png")
    fronts = [[growth("Full lattice", full, 2.0, triangles) for triangles in (100, 600, 1200)],
              [growth("Simplified", thinned, 3.0, triangles) for triangles in (25, 81, 163)]]
    pictures.write(draw(fronts, list(DILATATIONS.values())), folder / "TriangulationGrowth.png")
    star = simplify(apply(vtkHorizonExteriorBoundary(), make_surface(generator, STAR)), 4)
    hulls = [hull("Convex hull", star), hull("Angle up to 120 degrees", star, MaximumBoundaryAngle=120.0),
             hull("Edges up to 6 columns", star, MaximumBoundaryEdgeLength=6.0)]
    pictures.write(draw([hulls]), folder / "TriangulationHull.png")


main()
