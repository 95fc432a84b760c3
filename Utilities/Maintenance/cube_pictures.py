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
import seismichorizons as sh
from seismichorizons_command import pictures
from seismichorizons_command.data import empty, to_vtk
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

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
    _, columns, samples = cube.values.shape
    x, y = cube.lattice.places(np.arange(columns), row)
    z = cube.sign * (cube.lattice.first_z + cube.lattice.vertical_step * np.arange(samples))
    places = np.stack(np.broadcast_arrays(x, y, z[:, None]), -1).reshape(-1, 3)
    corner = np.arange(len(places)).reshape(samples, columns)[:-1, :-1].ravel()
    corners = np.stack((corner, corner + 1, corner + columns + 1, corner + columns), -1).ravel()
    plane = to_vtk({**empty(), "places": places, "polygons": (np.arange(0, len(corners) + 1, 4), corners)})
    plane.GetPointData().SetScalars(numpy_to_vtk(cube.values[row].T.ravel(), deep=True))
    largest = np.percentile(np.abs(cube.values), 99.7)
    grey = vtkLookupTable()
    grey.SetNumberOfTableValues(256)
    grey.SetHueRange(0.0, 0.0)
    grey.SetSaturationRange(0.0, 0.0)
    grey.SetValueRange(0.1, 1.0)
    grey.Build()
    result = actor(plane)
    result.GetMapper().SetLookupTable(grey)
    result.GetMapper().SetScalarRange(-largest, largest)
    return result


def places_of(horizon):
    return np.column_stack((horizon.x, horizon.y, horizon.sign * horizon.z))


def stroke(places, color, size=3.5):
    """Draws picks over the amplitudes of their inline."""
    dots = actor(to_vtk({**empty(), "places": places}), color)
    dots.GetProperty().SetPointSize(size)
    dots.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    return dots


def stroke_on(row, horizon, color):
    return stroke(places_of(horizon)[horizon.columns[:, 1] == row], color)


def view_of(cube):
    """Returns the vertical exaggeration of a section, and the unit vectors along and across inlines."""
    rows, columns, samples = cube.values.shape
    lattice = cube.lattice
    corners = lattice.places(np.array([0, 0, columns - 1, columns - 1]), np.array([0, rows - 1, 0, rows - 1]))
    length = np.hypot(*np.ptp(corners, axis=1))
    along, across = (np.array([*step, 0.0]) / np.hypot(*step) for step in (lattice.column_step, lattice.row_step))
    return HEIGHT * length / (lattice.vertical_step * (samples - 1)), along, across


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


# Least and largest confidence, colour.
CONFIDENCE = ((0.9, 1.1, "3a7fb5"), (0.5, 0.9, "f5b041"), (0.0, 0.5, "c0172b"))


def confidence_strokes(horizon, chosen, lift=0.0):
    """Draws points of a guided horizon by confidence, and picks of the guide on top."""
    places, confidence, is_pick = places_of(horizon), horizon["Confidence"], horizon["Origin"] == 0
    strokes = [stroke(places[chosen & ~is_pick & (confidence >= low) & (confidence < high)], color) for low, high, color in CONFIDENCE]
    return [*strokes, stroke(places[chosen & is_pick] + [0.0, 0.0, lift], "101418", 8.0)]


def draw_guides(path, picture, truth):
    """Draws a section with the strongest surfaces and with the horizons of guides on reflectors, and the least certain of
    these in map view."""
    picks_of_each = 25
    cube = sh.read_cube(path)
    row = len(cube.values) // 2
    horizons = sh.extract(cube, largest_number=LARGEST_NUMBER).values()
    strokes = [stroke_on(row, horizon, COLORS[number % len(COLORS)]) for number, horizon in enumerate(horizons)]
    rows, draw, guides = np.loadtxt(truth, skiprows=1), np.random.default_rng(1), {}
    for reflector in np.unique(rows[:, 0]):
        own = draw.choice(rows[rows[:, 0] == reflector], picks_of_each)
        guides["Reflector %d" % reflector] = own[:, 3:6]
    found = sh.extract(cube, guides)
    guided = [drawn for horizon in found.values() for drawn in confidence_strokes(horizon, horizon.columns[:, 1] == row)]
    name, doubtful = min(found.items(), key=lambda item: item[1]["Confidence"].mean())
    exaggeration, _, across = view_of(cube)
    panels = [panel(title, caption, [section(cube, row), *dots], exaggeration, -across, 1.18) for title, caption, dots in (
        ("Without guides", "the %d strongest surfaces" % LARGEST_NUMBER, strokes),
        ("With guides", "confidence above 0.9 blue, above 0.5 orange, less red", guided))]
    panels.append(panel(name, "the least certain one in map view, picks black", confidence_strokes(doubtful, np.full(len(doubtful), True), 500.0),
                        1.0, np.array([0.0, -0.01, 1.0]), 1.05))
    for number, renderer in enumerate(panels):
        renderer.SetViewport(number / len(panels), 0.0, (number + 1) / len(panels), 1.0)
    pictures.write(pictures.render(panels, (len(panels) * PANEL_SIZE[0], PANEL_SIZE[1])), picture)


def main():
    path, picture = (pathlib.Path(argument) for argument in sys.argv[1:3])
    if len(sys.argv) > 3:
        draw_guides(path, picture, sys.argv[3])
        return
    cube = sh.read_cube(path)
    row = len(cube.values) // 2
    horizons = sorted(sh.extract(cube, largest_number=LARGEST_NUMBER).values(), reverse=True,
                      key=lambda horizon: abs(horizon["Amplitude"].mean()))
    exaggeration, along, across = view_of(cube)
    aside = 0.75 * along - across + [0.0, 0.0, 0.9]
    colored = [(horizon, COLORS[number % len(COLORS)]) for number, horizon in enumerate(horizons)]

    strokes = [stroke_on(row, horizon, color) for horizon, color in colored]
    clouds, meshes, triangles = [], [], 0
    for horizon, color in colored[:IN_SPACE]:
        cloud = actor(horizon.to_vtk(), color)
        cloud.GetProperty().SetPointSize(2.5)
        clouds.append(cloud)
        mesh = sh.surface(horizon, LARGEST_ERROR * cube.lattice.vertical_step)
        triangles += len(mesh)
        shaded = actor(mesh.to_vtk(), color, lighting=True)
        shaded.GetProperty().SetAmbient(0.35)
        shaded.GetProperty().SetDiffuse(0.75)
        shaded.GetProperty().EdgeVisibilityOn()
        shaded.GetProperty().SetEdgeColor(0.1, 0.1, 0.15)
        meshes.append(shaded)
    picked = sum(map(len, horizons[:IN_SPACE]))
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
