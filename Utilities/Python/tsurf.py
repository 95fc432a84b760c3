# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons resampled from GOCAD triangle surfaces: their heights at the columns of a lattice, either given or along x and y
with about 16 columns for each vertex. A surface with two heights at one position is rejected, and the error of a mesh is
measured from the original triangles."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import heights, overlay, triangles
from .sampling import sample
from .stage import HorizonError, make, update

READER = "vtkGOCADTSurfReader"
SOURCE = "vtkHorizonFromPoints"
COLUMNS_OF_VERTEX = 16.0  # more columns than vertices, so that triangles keep their shape
# Largest effects of rounding in the file: on heights as a fraction of the extent along z, on overlaps along x and y.
SAME_HEIGHT = 1e-4
SLIVER = 1e-6
NOTABLE_PART = 0.001  # smallest difference in area that is reported, as a fraction


def open_file(reader, path, left_out=None, origin=None, column_step=None, row_step=None):
    """Returns the source of the horizons of a file, given its reader; its `surfaces` are the original triangles by name,
    and its `direction` says where z increases to.
    Raises HorizonError if no surface has triangles, or if a surface has two heights at one position or covers no column;
    with a list `left_out`, that message is appended to it and the other surfaces are processed."""
    update(reader, "%s: reading" % path.name)
    output = reader.GetOutputDataObject(0)
    meshes = [(output.GetMetaData(n).Get(output.NAME()), output.GetPartition(n, 0))
              for n in range(output.GetNumberOfPartitionedDataSets())]
    meshes = [(name, mesh) for name, mesh in meshes if mesh is not None and mesh.GetNumberOfPolys()]
    if not meshes:
        raise HorizonError("%s: surfaces without triangles, expected triangles to mesh anew" % path)
    steps = np.column_stack((column_step, row_step)) if column_step and row_step else _step(meshes) * np.eye(2)
    data = meshes[0][1].GetFieldData()
    sign = 1.0 if data.GetArray("VerticalDirection").GetValue(0) > 0 else -1.0
    found = {}
    for name, mesh in meshes:
        try:
            _require_height_field(mesh, sign, "%s: %s" % (path, name))
            found[name] = _sample(mesh, steps, origin, sign, path)
        except HorizonError as error:
            if left_out is None or name == meshes[-1][0] and not found:
                raise
            left_out.append("%s; it is left out" % error)
    points = vtkPolyData()
    points.SetPoints(vtkPoints())
    places = np.concatenate(list(found.values())) * (1.0, 1.0, sign)
    points.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    names = vtkStringArray()
    names.SetName("Name")
    for name, places_of_one in found.items():
        for _ in range(len(places_of_one)):
            names.InsertNextValue(name)
    points.GetPointData().AddArray(names)
    source = make(SOURCE, LatticeSource="OriginAndSteps", Origin=places[0, :2], ColumnStep=steps[:, 0],
                  RowStep=steps[:, 1], VerticalDirection="Up" if sign > 0.0 else "Down")
    source.SetInputDataObject(points)
    for name in ("VerticalUnit", "VerticalDomain", "HorizontalUnit", "CoordinateSystem"):
        if data.GetAbstractArray(name):
            getattr(source, "Set" + name)(data.GetAbstractArray(name).GetValue(0))
    source.surfaces = {name: mesh for name, mesh in meshes if name in found}
    source.direction = reader.GetDescription()
    return source


def account(result, surface, unit=""):
    """Measures the vertical distance between a mesh and the original triangles in both directions, which becomes its
    largest error. Warns if it exceeds the error at the columns of the lattice, if the areas differ, or if the number of
    triangles has increased. Errors in warnings have the given unit, or by default that of z."""
    mesh = result.data["mesh"]
    own, other = _corners(surface), _corners(mesh)
    if not len(other):
        return
    own, other = (overlay.turned_left(_wide(corners, overlay.doubled_areas(corners), 0.0)) for corners in (own, other))
    gap, place, shared = 0.0, None, 0.0
    for pairs in overlay.pairs(own, other):
        common = overlay.Common(own[pairs[:, 0]], other[pairs[:, 1]])
        shared += common.areas.sum()
        gaps = common.gaps()
        if gaps.max() > gap:
            gap, place = gaps.max(), common.places.reshape(-1, 2)[gaps.argmax()]
    data = mesh.GetFieldData()
    error = data.GetArray("LargestError")
    if error is not None:
        step = abs(data.GetArray("LatticeToWorld").GetComponent(0, 10))
        of_loops = data.GetArray("LargestLoopError")
        of_columns = step * max(array.GetValue(0) for array in (error, of_loops) if array is not None)
        error.SetValue(0, gap / step)
        if gap > 1.1 * of_columns + SLIVER * np.ptp(own[:, :, 2]):
            unit = unit or heights.unit_of(mesh) or "in z"
            told = [heights.per_index(mesh, unit) / step * error for error in (gap, of_columns)]
            result.warnings.append(
                "%s: error %.4g %s at x %.10g, y %.10g of the file's triangles, and %.4g at the columns of the lattice: shorter "
                "--column-step and --row-step come closer" % (result.name, told[0], unit, *place, told[1]))
    areas = [0.5 * overlay.doubled_areas(corners).sum() for corners in (own, other)]
    result.warnings += ["%s: %.2g %% of the area of the file's triangles %s" % (result.name, 100.0 * part, what)
                        for part, what in zip((np.array(areas) - shared) / areas[0], ("is left out", "is covered beyond them"))
                        if part > NOTABLE_PART]
    after, before = triangles.count_surface(mesh), surface.GetNumberOfPolys()
    if after > before:
        result.warnings.append("%s: %d triangles, and %d in the file: a larger error or cell size makes fewer" % (
            result.name, after, before))


def _corners(mesh):
    """Returns the positions of the corners of triangles."""
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)[triangles.of_surface(mesh)]


def _wide(corners, areas, least):
    """Returns the triangles wider than `least` in map view."""
    return corners[np.abs(areas) > least * _longest(corners)]


def _longest(corners):
    """Returns the length of the longest edge of each triangle in map view."""
    edges = corners[:, overlay.END, :2] - corners[:, overlay.BEGIN, :2]
    return np.hypot(edges[:, :, 0], edges[:, :, 1]).max(axis=1)


def _require_height_field(mesh, sign, what):
    """Raises HorizonError if a mesh has two heights at one position."""
    corners = _corners(mesh)
    found = _first_wall(corners) or _first_overlap(corners)
    if found:
        x, y, *both = found
        raise HorizonError("%s: z %.7g and %.7g at x %.10g, y %.10g, expected one z at each place: a closed body, a fold and a "
                           "wall are no horizon" % (what, *(sign * z for z in both), x, y))


def _tolerances(corners):
    """Returns the smallest width of an overlap, and the smallest distance between two heights."""
    extents = np.ptp(corners.reshape(-1, 3), axis=0)
    return SLIVER * math.hypot(*extents[:2]), SAME_HEIGHT * extents[2]


def _first_wall(corners):
    """Returns x, y and both z of the first triangle that has a height but no width in map view; None if there is none."""
    width, height = _tolerances(corners)
    thin = corners[np.abs(overlay.doubled_areas(corners)) <= width * _longest(corners)]
    if not len(thin):
        return None
    # Compares the height of the corner opposite the longest edge with the edge at the same position.
    edges = thin[:, overlay.END, :2] - thin[:, overlay.BEGIN, :2]
    longest = np.hypot(edges[:, :, 0], edges[:, :, 1]).argmax(axis=1)
    rows = np.arange(len(thin))
    begin, end, middle = (thin[rows, (longest + step) % 3] for step in (0, 1, 2))
    along = end[:, :2] - begin[:, :2]
    length = (along * along).sum(axis=1)
    part = ((middle - begin)[:, :2] * along).sum(axis=1) / np.where(length > 0.0, length, 1.0)
    opposite = begin[:, 2] + part * (end - begin)[:, 2]
    upright = length <= width * width
    low, high = (np.where(upright, side, z) for side, z in ((thin[:, :, 2].min(axis=1), middle[:, 2]),
                                                            (thin[:, :, 2].max(axis=1), opposite)))
    walls = np.flatnonzero(np.abs(high - low) > height)
    return (*middle[walls[0], :2], low[walls[0]], high[walls[0]]) if len(walls) else None


def _first_overlap(corners):
    """Returns x, y and both z of the first two triangles that overlap in map view at different heights; None if there are
    none."""
    width, height = _tolerances(corners)
    areas = overlay.doubled_areas(corners)
    wide = overlay.turned_left(_wide(corners, areas, width))
    for pairs in overlay.pairs(wide):
        pairs = pairs[overlay.widths(*wide[pairs.T]) > width]
        common = overlay.Common(*wide[pairs.T])
        apart = np.flatnonzero(common.gaps().max(axis=1, initial=0.0) > height)
        if len(apart):
            first = apart[np.lexsort(np.sort(pairs[apart], axis=1).T[::-1])[0]]
            return (*np.nanmean(common.places[first], axis=0), *np.nanmean(common.heights[first], axis=0))
    return None


def _step(meshes):
    """Returns a step of 1, 2 or 5 times a power of ten that gives about COLUMNS_OF_VERTEX columns for each vertex."""
    area = 0.5 * sum(np.abs(overlay.doubled_areas(_corners(mesh))).sum() for _, mesh in meshes)
    step = math.sqrt(area / COLUMNS_OF_VERTEX / sum(mesh.GetNumberOfPoints() for _, mesh in meshes)) or 1.0
    unit = 10.0 ** math.floor(math.log10(step))
    return min((unit * factor for factor in (1.0, 2.0, 5.0, 10.0)), key=lambda size: abs(math.log(size / step)))


def _sample(mesh, steps, origin, sign, path):
    """Returns world positions of the columns that triangles cover, from the grid writer."""
    corners = np.array([(x, y) for x in mesh.GetBounds()[:2] for y in mesh.GetBounds()[2:4]])
    origin = np.zeros(2) if origin is None else np.array(origin[:2])
    columns = np.linalg.solve(steps, (corners - origin).T)
    first, last = np.floor(columns.min(axis=1)), np.ceil(columns.max(axis=1))
    to_world = np.eye(4)
    to_world[:2, :2] = steps
    to_world[2, 2] = sign
    to_world[:2, 3] = origin + steps @ first
    sampled = vtkPolyData()
    sampled.ShallowCopy(mesh)
    for name, kind, values in (("LatticeToWorld", vtkDoubleArray, to_world.ravel()),
                               ("LatticeDimensions", vtkIntArray, [*(last - first + 1).astype(int), 1])):
        array = kind()
        array.SetName(name)
        array.SetNumberOfComponents(len(values))
        array.InsertNextTuple([float(value) for value in values])
        sampled.GetFieldData().AddArray(array)
    points = sample(sampled, "Up" if sign > 0.0 else "Down", path.name)
    return vtk_to_numpy(points.GetPoints().GetData())
