# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The styles in which a panel shows a horizon: points, outlines, meshes and faults, with their colours."""

import math

import numpy as np
from seismichorizons._horizon import vtk_cells
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction, vtkPolyDataMapper

from . import data, triangles
from .colors import (FAULT_COLOR, FAULT_COLOR_BY_DISTANCE, LAYER_COLORS, LEVEL_COLORS, LOW_TO_HIGH, NEAR_TO_FAR, rgb)

POINTS = "points"
OUTLINE = "outline"
MESH = "mesh"
LEVELS = "levels"  # points coloured by the level of their cells
CELLS = "cells"  # cells of a simplification in map view, in the same colours

DISTANCE = "distance"  # the mesh coloured by its point data array Distance
FAULTS = "faults"  # lines coloured by the magnitude of their point data array Throw
BODIES = "bodies"  # closed surfaces coloured by their cell data array Layer
THICKNESS = "thickness"  # triangles of a plan in map view, coloured by their point data array Thickness

EXTERIOR_COLOR = (0.78, 0.11, 0.16)
HOLE_COLOR = (0.95, 0.55, 0.05)
PALE_COLOR = (0.72, 0.75, 0.79)
# Offset of lines towards the viewer, in steps of the depth buffer; a hundred correspond to a few pixels on a slope of 45
# degrees. VTK's slope-dependent offset leaves gaps in the edges, which also differ between versions.
EDGE_OFFSET = -100.0
OUTLINE_OFFSET = -800.0  # in front of the edges as well


def values(horizon, name):
    return horizon["point_data"][name]


def make_actors(frame, panel):
    actors = []
    if panel.behind is not None:
        actors.append(_plain_points(panel.behind, frame.point_size(), PALE_COLOR))
    if panel.style == POINTS:
        actors.append(_colored_points(frame, panel.horizon))
    elif panel.style == LEVELS:
        actors.append(_leveled_points(frame, panel.horizon))
    elif panel.style == CELLS:
        actors.append(_cells(frame, panel.horizon))
    elif panel.style == OUTLINE:
        actors.extend(_outline(panel.horizon, dots=True))
    elif panel.style == FAULTS:
        actors.append(_faults(panel.horizon))
    elif panel.style == BODIES:
        actors.append(_bodies(panel.horizon))
    elif panel.style == THICKNESS:
        actors.append(_thickness(frame, panel.horizon))
    else:
        actors.extend(_mesh(frame, panel.horizon, panel.style == DISTANCE))
    return actors


def _actor(shown):
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(shown)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def _part(horizon, verts=None, lines=None, polys=None):
    """Returns the points of a horizon with some cells, given as offsets and points, and without arrays."""
    part = vtkPolyData()
    part.SetPoints(vtkPoints())
    part.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(horizon["places"]), deep=True))
    for set_cells, cells in ((part.SetVerts, verts), (part.SetLines, lines), (part.SetPolys, polys)):
        if cells is not None:
            set_cells(vtk_cells(*cells))
    return part


def _vertices(points):
    return np.arange(len(points) + 1), np.asarray(points)


def _triangles(corners):
    return 3 * np.arange(len(corners) + 1), corners.ravel()


def _color_by(actor, values, stops):
    """Colours an actor by a point array, interpolated between stops of (value, colour)."""
    colors = vtkColorTransferFunction()
    for value, color in stops:
        colors.AddRGBPoint(value, *rgb(color))
    mapper = actor.GetMapper()
    mapper.GetInput().GetPointData().SetScalars(values)
    mapper.ScalarVisibilityOn()
    mapper.SetLookupTable(colors)
    mapper.UseLookupTableScalarRangeOn()


def _color_by_height(frame, actor):
    """Colours an actor by height, which every stage has."""
    heights = vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())[:, 2].copy()
    low, high = frame.color_range
    _color_by(actor, numpy_to_vtk(heights, deep=True), [
        (low + (high - low) * number / (len(LOW_TO_HIGH) - 1), color) for number, color in enumerate(LOW_TO_HIGH)])


def _color_by_array(frame, horizon, name, actor):
    low, high = frame.scale_ends
    _color_by(actor, numpy_to_vtk(np.ascontiguousarray(values(horizon, name)), deep=True),
              [(low + part * (high - low), color) for part, color in NEAR_TO_FAR])
    actor.GetMapper().InterpolateScalarsBeforeMappingOn()


def _plain_points(horizon, size, color):
    actor = _actor(_part(horizon, verts=_vertices(range(data.count_points(horizon)))))
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().LightingOff()
    return actor


def _colored_points(frame, horizon):
    size = frame.point_size()
    number = data.count_points(horizon)
    if number < frame.count:
        size = max(2.0, min(4.0, 0.6 * size * math.sqrt(frame.count / max(1, number))))
    actor = _plain_points(horizon, size, PALE_COLOR)
    if number:
        _color_by_height(frame, actor)
    return actor


def _color_by_level(actor, attributes, origins):
    """Colours an actor by the first component of CellOrigin."""
    levels = origins[:, 0]
    table = np.rint([[255.0 * part for part in rgb(color)] for color in LEVEL_COLORS]).astype(np.uint8)
    attributes.SetScalars(numpy_to_vtk(table[np.minimum(levels, len(LEVEL_COLORS) - 1)], deep=True))
    actor.GetMapper().ScalarVisibilityOn()
    return actor


def _leveled_points(frame, horizon):
    actor = _colored_points(frame, horizon)
    actor.GetMapper().SetLookupTable(None)
    return _color_by_level(actor, actor.GetMapper().GetInput().GetPointData(), values(horizon, "CellOrigin"))


def _cells(frame, cells):
    """Draws all cells at the same height, so that boxes appear as squares."""
    flat = {**cells, "places": np.column_stack((cells["places"][:, :2], np.full(data.count_points(cells), frame.low[2])))}
    actor = _actor(_part(flat, lines=cells["lines"]))
    actor.GetProperty().SetLineWidth(1.5)
    actor.GetProperty().LightingOff()
    return _color_by_level(actor, actor.GetMapper().GetInput().GetCellData(), cells["cell_data"]["CellOrigin"])


def _outline(horizon, dots=False):
    """Draws the outlines as lines in front of the surface; with `dots`, also their points."""
    line_actor = _actor(_part(horizon, lines=horizon["lines"]))
    loops = data.lines(horizon)
    kinds = horizon["point_data"].get("Boundary")
    is_hole = np.array([kinds is not None and kinds[loop[0]] == 2 for loop in loops], bool)[:, None]
    colors = np.where(is_hole, HOLE_COLOR, EXTERIOR_COLOR)
    line_actor.GetMapper().GetInput().GetCellData().SetScalars(numpy_to_vtk((255.0 * colors).astype(np.uint8), deep=True))
    line_actor.GetMapper().ScalarVisibilityOn()
    line_actor.GetProperty().SetLineWidth(1.5)
    actors = [line_actor]
    if dots:
        # Dots are separate vertices, because a horizon also has points that are on no line.
        points = horizon["lines"][1]
        dot_actor = _actor(_part(horizon, verts=_vertices(points)))
        dot_actor.GetProperty().SetPointSize(max(2.0, min(4.0, 1000.0 / max(1, len(points)))))
        dot_actor.GetProperty().SetColor(*(0.75 * c for c in EXTERIOR_COLOR))
        actors.append(dot_actor)
    for actor in actors:
        actor.GetProperty().LightingOff()
        _bring_forward(actor.GetMapper(), OUTLINE_OFFSET)
    return actors


def _faults(horizon):
    actor = _actor(_part(horizon, lines=horizon["lines"]))
    if not data.count_lines(horizon):
        return actor
    throws = np.abs(values(horizon, "Throw"))
    greatest = max(1e-9, np.nanmax(throws, initial=0.0))
    _color_by(actor, numpy_to_vtk(throws, deep=True), [(part * greatest, color) for part, color in NEAR_TO_FAR[1:]])
    actor.GetProperty().SetLineWidth(4.0)
    actor.GetProperty().LightingOff()
    _bring_forward(actor.GetMapper(), OUTLINE_OFFSET)
    return actor


def _bodies(horizon):
    actor = _actor(_part(horizon, polys=horizon["polygons"]))
    layers = horizon["cell_data"]["Layer"]
    table = np.rint([[255.0 * part for part in rgb(color)] for color in LAYER_COLORS]).astype(np.uint8)
    actor.GetMapper().GetInput().GetCellData().SetScalars(numpy_to_vtk(table[layers % len(LAYER_COLORS)], deep=True))
    actor.GetMapper().ScalarVisibilityOn()
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.2)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
    actor.GetProperty().SetLineWidth(0.6)
    return actor


def _thickness(frame, plan):
    actor = _actor(_part(plan, polys=plan["polygons"]))
    actor.GetProperty().LightingOff()
    _color_by_array(frame, plan, "Thickness", actor)
    return actor


def _bring_forward(mapper, offset):
    """Draws an actor in front of surfaces at the same depth, but behind surfaces that are clearly nearer."""
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, offset)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(offset)


def _fault_walls(horizon, color):
    """Draws the triangles that close faults in a separate colour and without the normals of the adjacent surface."""
    walls = _actor(_part(horizon, polys=_triangles(triangles.at_faults(horizon))))
    walls.GetProperty().SetColor(*rgb(color))
    walls.GetProperty().SetInterpolationToFlat()
    walls.GetProperty().SetAmbient(0.35)
    return walls


def _mesh(frame, horizon, by_distance=False):
    """Draws the shaded surface, the triangles that close faults, and the edges, which are fainter the more there are."""
    everything = _part(horizon, polys=horizon["polygons"])
    is_closed = triangles.count_at_faults(horizon) > 0
    normals = vtkPolyDataNormals()
    normals.SetInputData(
        _part(horizon, polys=_triangles(triangles.of_surface(horizon))) if is_closed else everything)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    shaded = _actor(normals.GetOutput())
    if by_distance:
        _color_by_array(frame, horizon, "Distance", shaded)
    elif data.count_points(horizon):
        _color_by_height(frame, shaded)
    shaded.GetProperty().SetAmbient(0.15)
    shaded.GetProperty().SetSpecular(0.12)
    shaded.GetProperty().SetSpecularPower(12.0)

    faces = [shaded]
    if is_closed:
        faces.append(_fault_walls(horizon, FAULT_COLOR_BY_DISTANCE if by_distance else FAULT_COLOR))
    if everything.GetNumberOfPolys() > frame.pixels():  # the edges would hide the surface
        return [*faces, *_outline(horizon)]
    edges = _actor(everything)
    edges.GetProperty().SetRepresentationToWireframe()
    edges.GetProperty().SetColor(0.05, 0.07, 0.10)
    edges.GetProperty().LightingOff()
    edges.GetProperty().SetOpacity(max(0.05, min(0.4, 1500.0 / max(1, everything.GetNumberOfPolys()))))
    _bring_forward(edges.GetMapper(), EDGE_OFFSET)
    return [*faces, edges, *_outline(horizon)]
