#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the way from a seismic cube to meshes: a section, the section with picks, surfaces and meshes in space.

    cube_pictures.py CUBE.sgy PICTURE.png      for Documentation/Pictures/CubeToMesh.png: the cube of
                                               generate_cube --noise 0.2 --folds 22 --spacing 36 --weakest 0.6 CUBE.sgy
    cube_pictures.py CUBE.sgy PICTURE.png TRUTH.txt   for Guides.png: the cube of
                                               generate_cube --wild --seed 2001 --noise 0.5 --mixed --truth TRUTH.txt CUBE.sgy

Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from seismichorizons_command import cubes, functions, pictures, reading
from seismichorizons_command.pipeline import surface

PANEL_SIZE = (480, 430)
HEIGHT = 0.55  # height of a section as a fraction of its length
LARGEST_NUMBER = 36
IN_SPACE = 12  # strongest surfaces only, because side lobes also form surfaces
LARGEST_ERROR = 0.75
COLORS = ("d62728", "1f77b4", "2ca02c", "9467bd", "ff7f0e", "17becf", "e377c2", "8c564b", "bcbd22", "3a5f8a")


def actor(data, color=None, lighting=False):
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    result = vtkActor()
    result.SetMapper(mapper)
    if color:
        mapper.ScalarVisibilityOff()
        result.GetProperty().SetColor(*pictures.rgb(color))
    result.GetProperty().SetLighting(lighting)
    return result


def section(cube, row):
    """Draws the amplitudes of an inline in grey."""
    extent = list(cube.GetExtent())
    extent[2:4] = row, row
    part = vtkExtractVOI()
    part.SetInputData(cube)
    part.SetVOI(extent)
    outside = vtkDataSetSurfaceFilter()
    outside.SetInputConnection(part.GetOutputPort())
    outside.Update()
    largest = np.percentile(np.abs(vtk_to_numpy(cube.GetPointData().GetScalars())), 99.7)
    grey = vtkLookupTable()
    grey.SetNumberOfTableValues(256)
    grey.SetHueRange(0.0, 0.0)
    grey.SetSaturationRange(0.0, 0.0)
    grey.SetValueRange(0.1, 1.0)
    grey.Build()
    result = actor(outside.GetOutput())
    result.GetMapper().SetLookupTable(grey)
    result.GetMapper().SetScalarRange(-largest, largest)
    return result


def is_on_row(points, row):
    """Returns which points are on an inline."""
    matrix = vtk_to_numpy(points.GetFieldData().GetArray("LatticeToWorld")).reshape(4, 4)
    places = vtk_to_numpy(points.GetPoints().GetData())
    lattice = np.column_stack([places, np.ones(len(places))]) @ np.linalg.inv(matrix).T
    return np.rint(lattice[:, 1]) == row


def strength(points):
    return abs(vtk_to_numpy(points.GetPointData().GetArray("Amplitude")).mean())


def picks_of(points, row):
    """Returns the picks on an inline."""
    dots = vtkPolyData()
    dots.SetPoints(points.GetPoints())
    vertices = vtkCellArray()
    for number in np.flatnonzero(is_on_row(points, row)):
        vertices.InsertNextCell(1, [int(number)])
    dots.SetVerts(vertices)
    return dots


def stroke(points, row, color, size=3.5):
    """Draws the picks on an inline over its amplitudes."""
    dots = actor(picks_of(points, row), color)
    dots.GetProperty().SetPointSize(size)
    dots.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    return dots


def view_of(cube):
    """Returns the vertical exaggeration of a section, and the unit vectors along and across inlines."""
    bounds = np.array(cube.GetBounds()).reshape(3, 2)
    length = np.hypot(*(bounds[:2, 1] - bounds[:2, 0]))
    matrix = vtk_to_numpy(cube.GetFieldData().GetArray("LatticeToWorld")).reshape(4, 4)
    along, across = (matrix[:3, n] / np.linalg.norm(matrix[:3, n]) for n in (0, 1))
    return HEIGHT * length / (bounds[2, 1] - bounds[2, 0]), along, across


def extract(path):
    """Returns the cube of a file and its strongest surfaces."""
    extraction = cubes.open_cube(path, LargestNumber=LARGEST_NUMBER)
    cubes.read(extraction, path)
    extraction.Update()
    return extraction.GetInputAlgorithm().GetOutput(), [points for _, points in reading.list_horizons(extraction.GetOutput())]


def place_camera(renderer, toward, scale):
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(*toward)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(scale)
    camera.SetWindowCenter(0.0, 0.08)  # slightly below the centre, for the text above


def panel(title, caption, actors, exaggeration, toward, zoom):
    renderer = vtkRenderer()
    renderer.SetBackground(0.90, 0.92, 0.95)
    renderer.SetBackground2(0.99, 0.99, 1.0)
    renderer.GradientBackgroundOn()
    for one in actors:
        one.SetScale(1.0, 1.0, exaggeration)
        renderer.AddActor(one)
    renderer.AddViewProp(pictures.text_actor(title, 17, (14, PANEL_SIZE[1] - 30), bold=True))
    renderer.AddViewProp(pictures.text_actor(caption, 13, (14, PANEL_SIZE[1] - 50)))
    place_camera(renderer, toward, zoom)
    return renderer


def origin_strokes(points, row):
    """Draws the picks of a guided horizon on an inline: grown picks, taken surfaces, and picks of the guide on top."""
    strokes = []
    origins = vtk_to_numpy(points.GetPointData().GetArray("Origin"))
    places = vtk_to_numpy(points.GetPoints().GetData())
    for origin, color, size in ((2, "17a2e0", 3.5), (1, "ffb000", 3.5), (0, "e3123c", 9.0)):
        some = vtkPolyData()
        some.SetPoints(vtkPoints())
        some.GetPoints().SetData(numpy_to_vtk(places[origins == origin], deep=True))
        some.SetFieldData(points.GetFieldData())
        strokes.append(stroke(some, row, color, size))
    return strokes


def draw_guides(path, picture, truth):
    """Draws a section with the strongest surfaces, and with the horizons of guides on reflectors."""
    picks_of_each = 25
    cube, horizons = extract(path)
    row = cube.GetDimensions()[1] // 2
    strokes = [stroke(points, row, COLORS[number % len(COLORS)]) for number, points in enumerate(horizons)]
    rows, draw, guides = np.loadtxt(truth, skiprows=1), np.random.default_rng(1), {}
    for reflector in np.unique(rows[:, 0]):
        own = draw.choice(rows[rows[:, 0] == reflector], picks_of_each)
        guides["Reflector %d" % reflector] = own[:, 3:6] * [1.0, 1.0, -1.0]
    guided = []
    for points in functions.extract(cube, guides).values():
        guided += origin_strokes(points, row)
    exaggeration, _, across = view_of(cube)
    panels = [panel(title, caption, [section(cube, row), *dots], exaggeration, -across, 1.18) for title, caption, dots in (
        ("Without guides", "the %d strongest surfaces" % LARGEST_NUMBER, strokes),
        ("With guides", "picks red, parts yellow, grown blue", guided))]
    for number, renderer in enumerate(panels):
        renderer.SetViewport(0.5 * number, 0.0, 0.5 * number + 0.5, 1.0)
    pictures.write(pictures.render(panels, (2 * PANEL_SIZE[0], PANEL_SIZE[1])), picture)


def main():
    path, picture = (pathlib.Path(argument) for argument in sys.argv[1:3])
    if len(sys.argv) > 3:
        draw_guides(path, picture, sys.argv[3])
        return
    cube, horizons = extract(path)
    horizons.sort(key=strength, reverse=True)
    row = cube.GetDimensions()[1] // 2
    exaggeration, along, across = view_of(cube)
    aside = 0.75 * along - across + [0.0, 0.0, 0.9]
    colored = [(points, COLORS[number % len(COLORS)]) for number, points in enumerate(horizons)]

    strokes = [stroke(points, row, color) for points, color in colored]
    clouds, meshes, triangles = [], [], 0
    for points, color in colored[:IN_SPACE]:
        cloud = actor(points, color)
        cloud.GetProperty().SetPointSize(2.5)
        clouds.append(cloud)
        mesh, _ = surface(points, largest_error=LARGEST_ERROR)
        triangles += mesh.GetNumberOfPolys()
        only = vtkPolyData()
        only.SetPoints(mesh.GetPoints())
        only.SetPolys(mesh.GetPolys())
        shaded = actor(only, color, lighting=True)
        shaded.GetProperty().SetAmbient(0.35)
        shaded.GetProperty().SetDiffuse(0.75)
        shaded.GetProperty().EdgeVisibilityOn()
        shaded.GetProperty().SetEdgeColor(0.1, 0.1, 0.15)
        meshes.append(shaded)
    picked = sum(points.GetNumberOfPoints() for points in horizons[:IN_SPACE])
    renderers = [
        panel("Amplitudes", "an inline of the cube", [section(cube, row)], exaggeration, -across, 1.18),
        panel("Picks", "in the colours of their surfaces", [section(cube, row), *strokes], exaggeration, -across, 1.18),
        panel("Surfaces", "the %d strongest, %d picks" % (IN_SPACE, picked), clouds, exaggeration, aside, 1.12),
        panel("Meshes", "%d triangles, within %g samples" % (triangles, LARGEST_ERROR), meshes, exaggeration, aside, 1.12)]
    for number, renderer in enumerate(renderers):
        left, bottom = 0.5 * (number % 2), 0.5 * (1 - number // 2)
        renderer.SetViewport(left, bottom, left + 0.5, bottom + 0.5)
    pictures.write(pictures.render(renderers, (2 * PANEL_SIZE[0], 2 * PANEL_SIZE[1])), picture)


if __name__ == "__main__":
    main()
