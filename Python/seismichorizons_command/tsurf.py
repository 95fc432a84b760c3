# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons resampled from GOCAD triangle surfaces: their heights at the columns of a lattice, either given or along x and y
with about 16 columns for each vertex. A surface with two heights at one position is rejected, and the error of a mesh is
measured from the original triangles."""

import math

import numpy as np
from seismichorizons import _core
from seismichorizons._data import SURVEY

from . import core, data, heights, overlay, triangles
from .core import HorizonError
from .progress import file_work

COLUMNS_OF_VERTEX = 16.0  # more columns than vertices, so that triangles keep their shape
# Largest effects of rounding in the file: on heights as a fraction of the extent along z, on overlaps along x and y.
SAME_HEIGHT = 1e-4
SLIVER = 1e-6
NOTABLE_PART = 0.001  # smallest difference in area that is reported, as a fraction


def sample_file(path, horizons, left_out, properties):
    """Returns for a file: x, y and z of the columns of each horizon, by name; the triangles, by name; where z increases to, in
    words; and the properties that place the columns. Raises HorizonError if no surface has triangles, or if a surface has two
    heights at one position or covers no column; with a list `left_out`, that message is appended to it and the other surfaces
    are processed."""
    from . import reading  # which needs this module

    with core.errors("%s: " % path):
        meshes, sense = core.run(_core.read_tsurfs, str(path), label="%s: reading" % path.name, work=file_work(path))
    chosen = reading.choose([name for name, _ in meshes], horizons, path)
    meshes = [meshes[place] for place in chosen if data.count_polygons(meshes[place][1])]
    if not meshes:
        raise HorizonError("%s: surfaces without triangles, expected triangles to mesh anew" % path)
    column_step, row_step = properties.get("ColumnStep"), properties.get("RowStep")
    steps = np.column_stack((column_step, row_step)) if column_step and row_step else _step(meshes) * np.eye(2)
    sign = 1.0 if data.vertical_direction(meshes[0][1]) > 0 else -1.0
    found = {}
    for name, mesh in meshes:
        try:
            _require_height_field(mesh, sign, "%s: %s" % (path, name))
            found[name] = _sample(mesh, steps, properties.get("Origin"), sign, "%s: %s" % (path, name))
        except HorizonError as error:
            if left_out is None or name == meshes[-1][0] and not found:
                raise
            left_out.append("%s; it is left out" % error)
    first = next(iter(found.values()))
    own = {"Origin": (first["x"][0], first["y"][0]), "ColumnStep": steps[:, 0], "RowStep": steps[:, 1],
           "VerticalDirection": "Up" if sign > 0.0 else "Down"}
    texts = {name: data.text(meshes[0][1], name) for name in SURVEY}
    own.update({name: text for name, text in texts.items() if text and name not in properties})
    return found, {name: mesh for name, mesh in meshes if name in found}, sense, own


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
    error = data.value(mesh, "LargestError")
    if error is not None:
        step = heights.step_of(mesh)
        of_columns = step * max(error, data.value(mesh, "LargestLoopError") or 0.0)
        result.data["mesh"] = data.with_fields(mesh, {"LargestError": np.array([gap / step])})
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
    after, before = triangles.count_surface(mesh), data.count_polygons(surface)
    if after > before:
        result.warnings.append("%s: %d triangles, and %d in the file: a larger error or cell size makes fewer" % (
            result.name, after, before))


def _corners(mesh):
    """Returns the positions of the corners of triangles."""
    return mesh["places"].astype(float)[triangles.of_surface(mesh)]


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
        raise HorizonError("%s: z %.7g and %.7g at x %.10g, y %.10g, expected one z at each position: a closed body, a fold "
                           "or a wall is not a horizon" % (what, *(sign * z for z in both), x, y))


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
    step = math.sqrt(area / COLUMNS_OF_VERTEX / sum(data.count_points(mesh) for _, mesh in meshes)) or 1.0
    unit = 10.0 ** math.floor(math.log10(step))
    return min((unit * factor for factor in (1.0, 2.0, 5.0, 10.0)), key=lambda size: abs(math.log(size / step)))


def _sample(mesh, steps, origin, sign, what):
    """Returns x, y and z of the columns that triangles cover."""
    corners = np.array([(x, y) for x in data.bounds(mesh)[:2] for y in data.bounds(mesh)[2:4]])
    origin = np.zeros(2) if origin is None else np.array(origin[:2])
    columns = np.linalg.solve(steps, (corners - origin).T)
    first, last = np.floor(columns.min(axis=1)), np.ceil(columns.max(axis=1))
    to_world = np.eye(4)
    to_world[:2, :2] = steps
    to_world[2, 2] = sign
    to_world[:2, 3] = origin + steps @ first
    on_lattice = data.with_fields(mesh, {"LatticeToWorld": to_world.ravel(),
                                         "LatticeDimensions": np.array([*(last - first + 1), 1], np.int32)})
    with core.errors("%s: " % what):
        column, z = core.run(_core.sample, on_lattice, int(sign))
    x, y = to_world[:2, :2] @ column.T + to_world[:2, 3:]
    return {"x": x, "y": y, "z": z}
