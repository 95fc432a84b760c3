#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on the triangulation: maps of how triangles are found and taken off.

    triangulation_pictures.py GENERATOR FOLDER

GENERATOR is the program generate_horizons. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

from collections import namedtuple
import math
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

import seismichorizons as sh
from seismichorizons import pictures

from generated import apply, make_surface

SURFACE = ("--size", "50", "40", "16", "--horizons", "1", "--holes", "0", "--islands", "0", "--dropouts", "0.02")
STAR = ("--size", "70", "56", "16", "--horizons", "1", "--holes", "0", "--islands", "0", "--squareness", "-1")

SMOOTHING = 2  # pictures are drawn so many times larger, and shrunk
PANEL_SIZE = (400, 330)
TITLE_HEIGHT = 52
LEGEND_HEIGHT = 38
FRAME = 8  # free pixels around a map
MARGIN = 1.08

# Voxels by their dilatation, and those that were looked into otherwise.
DILATATIONS = {0: ("1f6fb2", "on the perpendicular bisector"),
               1: ("8cc3e6", "on its dilatations"),
               -1: ("fbdfb0", "in the box of the edge, squares around it, or the circle of a candidate")}
POINT = "4a5561"
BACKGROUND = "f6f7f9"
BOUNDARY = "c61c29"
MESH = "5b6b7d"
MESH_OPACITY = 0.17
MESH_EDGE = "8b97a4"
LAST = "c61c29"
EDGE = "10161d"

# A map: title, caption, the actors from the lowest to the highest, and the box that it shows (x0, x1, y0, y1).
Map = namedtuple("Map", "title caption actors box")


def rgb(color):
    return tuple(int(color[i:i + 2], 16) / 255.0 for i in (0, 2, 4))


def in_plan(data):
    return vtk_to_numpy(data.GetPoints().GetData())[:, :2]


def cells_of(cells):
    """The points of each cell."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    points = vtk_to_numpy(cells.GetConnectivityArray())
    return [points[first:last] for first, last in zip(offsets[:-1], offsets[1:])]


def flat_actor(places, color, **cells):
    """Verts, lines or polys over places in plan, in one colour."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([places, np.zeros(len(places))]), deep=True))
    data.SetPoints(points)
    for kind, list_of_cells in cells.items():
        array = vtkCellArray()
        for cell in list_of_cells:
            array.InsertNextCell(len(cell), [int(point) for point in cell])
        getattr(data, "Set" + kind)(array)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*rgb(color))
    actor.GetProperty().LightingOff()
    return actor


def dots(places, color, size):
    actor = flat_actor(places, color, Verts=[[n] for n in range(len(places))])
    actor.GetProperty().SetPointSize(SMOOTHING * size)
    actor.GetProperty().RenderPointsAsSpheresOn()
    return actor


def strokes(places, lines, color, width):
    actor = flat_actor(places, color, Lines=lines)
    actor.GetProperty().SetLineWidth(SMOOTHING * width)
    return actor


def outlines(data, width):
    return strokes(in_plan(data), cells_of(data.GetLines()), BOUNDARY, width)


def edges_of(polygons):
    return [[*polygon, polygon[0]] for polygon in polygons]


def mesh_actors(data, width):
    """Triangles through which what lies below can be seen, and their edges."""
    triangles = cells_of(data.GetPolys())
    faces = flat_actor(in_plan(data), MESH, Polys=triangles)
    faces.GetProperty().SetOpacity(MESH_OPACITY)
    return [faces, strokes(in_plan(data), edges_of(triangles), MESH_EDGE, width)]


def voxel_actors(search, width):
    """The voxels that were looked into, those of the circle lowest: they may have been looked into before."""
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
    """Dashes from the middle of the edge to its left, as far as the edge is long."""
    across = np.array([a[1] - b[1], b[0] - a[0]])
    places = [(a + b) / 2.0 + across * n / 16.0 for n in range(16)]
    return strokes(places, [(n, n + 1) for n in range(0, 15, 2)], EDGE, width)


def last_triangle(mesh):
    """The edge that the search began with, and the third point."""
    return in_plan(mesh)[cells_of(mesh.GetPolys())[-1]]


def search_actors(mesh, search, size):
    """The voxels of the last triangle, the triangles so far over them, and then what shows how it was found."""
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
    algorithm = sh.vtkHorizonTriangulation()
    mesh = apply(algorithm, data, MaximumNumberOfTriangles=triangles, SearchStrategy=strategy)
    return mesh, algorithm.GetOutputDataObject(1)


def fit(places):
    """The box around places that has the proportions of a map."""
    low, high = places.min(axis=0), places.max(axis=0)
    width, height = PANEL_SIZE[0] - 2 * FRAME, PANEL_SIZE[1] - TITLE_HEIGHT - FRAME
    extent = MARGIN * (high - low)
    extent = np.maximum(extent, [extent[1] * width / height, extent[0] * height / width])
    (x0, y0), (x1, y1) = (low + high - extent) / 2.0, (low + high + extent) / 2.0
    return (x0, x1, y0, y1)


def text_actor(text, x, y, size, bold=False, chip=None):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(SMOOTHING * x, SMOOTHING * y)
    style = actor.GetTextProperty()
    style.SetFontSize(SMOOTHING * size)
    style.SetBold(bold)
    style.SetColor(*pictures.TEXT_COLOR)
    if chip:
        style.SetBackgroundColor(*rgb(chip))
        style.SetBackgroundOpacity(1.0)
    return actor


def viewport(pixels, size):
    x0, y0, width, height = pixels
    return (x0 / size[0], y0 / size[1], (x0 + width) / size[0], (y0 + height) / size[1])


def map_renderers(panel, pixels, size):
    """A white one with the text, and over it one for the map."""
    x0, y0, width, height = pixels
    text = vtkRenderer()
    text.SetBackground(1.0, 1.0, 1.0)
    text.SetViewport(*viewport(pixels, size))
    text.AddViewProp(text_actor(panel.title, 12, height - 28, 16, bold=True))
    text.AddViewProp(text_actor(panel.caption, 12, height - 45, 12))
    plan = vtkRenderer()
    plan.SetViewport(*viewport((x0 + FRAME, y0 + FRAME, width - 2 * FRAME, height - TITLE_HEIGHT - FRAME), size))
    plan.SetBackground(*rgb(BACKGROUND))
    for layer, actor in enumerate(panel.actors):
        actor.SetPosition(0.0, 0.0, float(layer))
        plan.AddActor(actor)
    x_low, x_high, y_low, y_high = panel.box
    camera = plan.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint((x_low + x_high) / 2.0, (y_low + y_high) / 2.0, 0.0)
    camera.SetPosition((x_low + x_high) / 2.0, (y_low + y_high) / 2.0, 100.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.SetParallelScale((y_high - y_low) / 2.0)
    camera.SetClippingRange(1.0, 200.0)
    return [text, plan]


def legend_renderer(legend, size):
    """Chips of colour with their meaning."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(*viewport((0, 0, size[0], LEGEND_HEIGHT), size))
    x = 12
    for color, meaning in legend:
        renderer.AddViewProp(text_actor("      ", x, 11, 12, chip=color))
        renderer.AddViewProp(text_actor(meaning, x + 28, 11, 12))
        x += 28 + 6 * len(meaning) + 24
    return renderer


def draw(rows, legend=()):
    """Rows of maps over a legend, a list of colours and meanings, as vtkImageData."""
    legend_height = LEGEND_HEIGHT if legend else 0
    size = (PANEL_SIZE[0] * max(len(row) for row in rows), PANEL_SIZE[1] * len(rows) + legend_height)
    renderers = [legend_renderer(legend, size)] if legend else []
    for number, row in enumerate(rows):
        y0 = legend_height + (len(rows) - 1 - number) * PANEL_SIZE[1]
        for column, panel in enumerate(row):
            renderers.extend(map_renderers(panel, (column * PANEL_SIZE[0], y0, *PANEL_SIZE), size))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SMOOTHING * size[0], SMOOTHING * size[1])
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grabber.GetOutputPort())
    shrink.SetShrinkFactors(SMOOTHING, SMOOTHING, 1)
    shrink.AveragingOn()
    shrink.Update()
    window.Finalize()
    return shrink.GetOutput()


STRATEGIES = ((sh.vtkHorizonTriangulation.VoxelTraversal, "Voxel traversal"),
              (sh.vtkHorizonTriangulation.Compactness, "Compactness"))


def close_up(title, strategy, data, triangles):
    mesh, search = stop_after(data, triangles, strategy)
    # Both strategies find the same triangle; the larger of their walks sets the scale for both.
    walks = [in_plan(stop_after(data, triangles, each)[1]) for each, _ in STRATEGIES]
    seen = np.vstack([*walks, last_triangle(mesh)])
    caption = "triangle %d: %d voxels looked into" % (triangles, search.GetNumberOfPolys())
    return Map(title, caption, search_actors(mesh, search, 5.0), fit(seen))


def growth(title, data, size, triangles):
    mesh, search = stop_after(data, triangles, sh.vtkHorizonTriangulation.VoxelTraversal)
    return Map(title, "after %d triangles" % triangles, search_actors(mesh, search, size), fit(in_plan(data)))


def hull(title, data, **limits):
    mesh = apply(sh.vtkHorizonTriangulation(), data, ConvexHull=True, **limits)
    actors = [*mesh_actors(mesh, 0.8), outlines(mesh, 1.6), dots(in_plan(mesh), POINT, 2.6)]
    return Map(title, "%d triangles" % mesh.GetNumberOfPolys(), actors, fit(in_plan(mesh)))


def simplify(outlined, cell_size):
    straight = apply(sh.vtkHorizonBoundarySimplification(), outlined, OutlineTolerance=0.7)
    return apply(sh.vtkHorizonElaborateSimplification(), straight, FlatnessThreshold=0.06, CellSize=cell_size)


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    full = apply(sh.vtkHorizonExteriorBoundary(), make_surface(generator, SURFACE))
    thinned = simplify(full, 8)
    folder.mkdir(parents=True, exist_ok=True)
    moments = (("full lattice", full, 445), ("simplified", thinned, 81), ("simplified", thinned, 21))
    walks = [[close_up("%s, %s" % (name, where), strategy, data, triangles) for where, data, triangles in moments]
             for strategy, name in STRATEGIES]
    pictures.write(draw(walks, list(DILATATIONS.values())), folder / "TriangulationSearch.png")
    fronts = [[growth("Full lattice", full, 2.0, triangles) for triangles in (100, 600, 1200)],
              [growth("Simplified", thinned, 3.0, triangles) for triangles in (25, 81, 163)]]
    pictures.write(draw(fronts, list(DILATATIONS.values())), folder / "TriangulationGrowth.png")
    star = simplify(apply(sh.vtkHorizonExteriorBoundary(), make_surface(generator, STAR)), 4)
    hulls = [hull("Convex hull", star), hull("Angle up to 120 degrees", star, MaximumBoundaryAngle=120.0),
             hull("Edges up to 6 columns", star, MaximumBoundaryEdgeLength=6.0)]
    pictures.write(draw([hulls]), folder / "TriangulationHull.png")


main()
