# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Maps: horizons in plan view as dots, lines and faces on top of each other, in rows of titled maps above a legend."""

from collections import namedtuple

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from seismichorizons_command import pictures

SMOOTHING = 2  # pictures are drawn larger by this factor, and then shrunk
PANEL_SIZE = (400, 330)
TITLE_HEIGHT = 52
LEGEND_HEIGHT = 38
FRAME = 8  # margin of a map in pixels
MARGIN = 1.08
BACKGROUND = "f6f7f9"

# A map: title, caption, actors from bottom to top, and the box shown (x0, x1, y0, y1).
Map = namedtuple("Map", "title caption actors box")


def in_plan(data):
    return vtk_to_numpy(data.GetPoints().GetData())[:, :2]


def cells_of(cells):
    """Returns the points of each cell."""
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    points = vtk_to_numpy(cells.GetConnectivityArray())
    return [points[first:last] for first, last in zip(offsets[:-1], offsets[1:])]


def flat_actor(places, color, **cells):
    """Returns an actor of verts, lines or polys in plan view, in one colour."""
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
    actor.GetProperty().SetColor(*pictures.rgb(color))
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


def edges_of(polygons):
    return [[*polygon, polygon[0]] for polygon in polygons]


def fit(places):
    """Returns the box around positions with the proportions of a map."""
    low, high = places.min(axis=0), places.max(axis=0)
    width, height = PANEL_SIZE[0] - 2 * FRAME, PANEL_SIZE[1] - TITLE_HEIGHT - FRAME
    extent = MARGIN * (high - low)
    extent = np.maximum(extent, [extent[1] * width / height, extent[0] * height / width])
    (x0, y0), (x1, y1) = (low + high - extent) / 2.0, (low + high + extent) / 2.0
    return (x0, x1, y0, y1)


def text_actor(text, size, x, y, bold=False):
    return pictures.text_actor(text, SMOOTHING * size, (SMOOTHING * x, SMOOTHING * y), bold)


def chip_actor(color, x, y):
    """Returns a small box of one colour."""
    actor = text_actor("      ", 12, x, y)
    actor.GetTextProperty().SetBackgroundColor(*pictures.rgb(color))
    actor.GetTextProperty().SetBackgroundOpacity(1.0)
    return actor


def viewport(pixels, size):
    x0, y0, width, height = pixels
    return (x0 / size[0], y0 / size[1], (x0 + width) / size[0], (y0 + height) / size[1])


def map_renderers(panel, pixels, size):
    """Returns a white renderer with the text, and a renderer for the map on top of it."""
    x0, y0, width, height = pixels
    text = vtkRenderer()
    text.SetBackground(1.0, 1.0, 1.0)
    text.SetViewport(*viewport(pixels, size))
    text.AddViewProp(text_actor(panel.title, 16, 12, height - 28, bold=True))
    text.AddViewProp(text_actor(panel.caption, 12, 12, height - 45))
    plan = vtkRenderer()
    plan.SetViewport(*viewport((x0 + FRAME, y0 + FRAME, width - 2 * FRAME, height - TITLE_HEIGHT - FRAME), size))
    plan.SetBackground(*pictures.rgb(BACKGROUND))
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
    """Returns a renderer of colour chips with their meaning."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(*viewport((0, 0, size[0], LEGEND_HEIGHT), size))
    x = 12
    for color, meaning in legend:
        renderer.AddViewProp(chip_actor(color, x, 11))
        renderer.AddViewProp(text_actor(meaning, 12, x + 28, 11))
        x += 28 + 6 * len(meaning) + 24
    return renderer


def draw(rows, legend=()):
    """Draws rows of maps above a legend, a list of colours and meanings, and returns vtkImageData."""
    legend_height = LEGEND_HEIGHT if legend else 0
    size = (PANEL_SIZE[0] * max(len(row) for row in rows), PANEL_SIZE[1] * len(rows) + legend_height)
    renderers = [legend_renderer(legend, size)] if legend else []
    for number, row in enumerate(rows):
        y0 = legend_height + (len(rows) - 1 - number) * PANEL_SIZE[1]
        for column, panel in enumerate(row):
            renderers.extend(map_renderers(panel, (column * PANEL_SIZE[0], y0, *PANEL_SIZE), size))
    shrink = vtkImageShrink3D()
    shrink.SetInputData(pictures.render(renderers, (SMOOTHING * size[0], SMOOTHING * size[1])))
    shrink.SetShrinkFactors(SMOOTHING, SMOOTHING, 1)
    shrink.AveragingOn()
    shrink.Update()
    return shrink.GetOutput()
