# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a mesh keeps what the pages promise of its error, against all points of the horizon as it was read.

Nothing here is shared with what is checked: columns come from the world coordinates and the matrix LatticeToWorld,
triangles and outlines are walked anew, and all orientations are those of whole numbers.
"""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy


def lattice_points(data):
    """The places of points in lattice units."""
    matrix = vtk_to_numpy(data.GetFieldData().GetArray("LatticeToWorld")).reshape(4, 4)
    world = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return numpy.linalg.solve(matrix[:3, :3], (world - matrix[:3, 3]).T).T


def whole(places):
    """Places in plan as whole numbers."""
    columns = numpy.rint(places[:, :2])
    assert numpy.abs(places[:, :2] - columns).max(initial=0.0) < 1e-3, "a vertex is not on a column"
    return columns.astype(numpy.int64)


def cells(array, size):
    """The point ids of cells of one size, a row each."""
    connectivity = vtk_to_numpy(array.GetConnectivityArray())
    assert array.GetNumberOfCells() * size == connectivity.size, "cells of another size"
    return connectivity.reshape(-1, size)


def segments(lines):
    """The sides of closed polylines; that of a single point has no length."""
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    connectivity = vtk_to_numpy(lines.GetConnectivityArray())
    sides = numpy.stack([connectivity[:-1], connectivity[1:]], axis=1)
    inside = numpy.ones(len(sides), bool)
    inside[offsets[1:-1] - 1] = False
    return sides[inside]


def cross(a, b, c):
    """Twice the areas of triangles in plan, exactly."""
    return (b[..., 0] - a[..., 0]) * (c[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (c[..., 0] - a[..., 0])


class Heights:
    """The heights of a horizon by column."""

    def __init__(self, horizon):
        places = lattice_points(horizon)
        self.columns = whole(places)
        self.heights = places[:, 2]
        self.least = self.columns.min(axis=0)
        size = self.columns.max(axis=0) - self.least + 1
        self.numbers = numpy.full(size, -1, numpy.int64)
        self.numbers[tuple((self.columns - self.least).T)] = numpy.arange(len(places))
        assert (self.numbers >= 0).sum() == len(places), "two points in a column"

    def at(self, columns):
        """The points in columns, -1 where there is none."""
        shifted = columns - self.least
        inside = ((shifted >= 0) & (shifted < self.numbers.shape)).all(axis=-1)
        found = numpy.full(columns.shape[:-1], -1, numpy.int64)
        found[inside] = self.numbers[tuple(shifted[inside].T)]
        return found


def measure_columns(horizon, corners, heights, triangles):
    """For each point the largest vertical distance from the triangles over or beside it, nan where there is none."""
    errors = numpy.full(len(horizon.columns), numpy.nan)
    for triangle in triangles:
        a, b, c = corners[triangle]
        least = numpy.minimum(numpy.minimum(a, b), c)
        greatest = numpy.maximum(numpy.maximum(a, b), c)
        grid = numpy.stack(
            numpy.meshgrid(*(numpy.arange(low, high + 1) for low, high in zip(least, greatest)), indexing="ij"), axis=-1
        ).reshape(-1, 2)
        weights = numpy.stack([cross(b, c, grid), cross(c, a, grid), cross(a, b, grid)], axis=1)
        covered = (weights >= 0).all(axis=1)
        points = horizon.at(grid[covered])
        there = points >= 0
        points = points[there]
        area = cross(a, b, c)
        assert area > 0, "a triangle is not counter-clockwise"
        mesh = weights[covered][there] @ heights[triangle] / area
        errors[points] = numpy.fmax(errors[points], numpy.abs(mesh - horizon.heights[points]))
    return errors


def nearest_outline(places, heights, corners, corner_heights, sides, tolerance, error):
    """For each place the least distance in plan among the sides that are near enough in plan and in height, else inf."""
    best = numpy.full(len(places), numpy.inf)
    starts, ways = corners[sides[:, 0]].astype(float), (corners[sides[:, 1]] - corners[sides[:, 0]]).astype(float)
    lengths = (ways**2).sum(axis=1)
    low = numpy.minimum(corners[sides[:, 0]], corners[sides[:, 1]]) - tolerance - 1
    high = numpy.maximum(corners[sides[:, 0]], corners[sides[:, 1]]) + tolerance + 1
    for n, place in enumerate(places):
        near = ((low <= place) & (place <= high)).all(axis=1)
        way = place - starts[near]
        part = numpy.clip((way * ways[near]).sum(axis=1) / numpy.maximum(lengths[near], 1.0), 0.0, 1.0)
        plan = numpy.hypot(*(way - part[:, None] * ways[near]).T)
        ends = corner_heights[sides[near]]
        height = numpy.abs(ends[:, 0] + part * (ends[:, 1] - ends[:, 0]) - heights[n])
        fits = (plan <= tolerance + 1e-9) & (height <= error * (1 + 1e-9) + 1e-9)
        best[n] = plan[fits].min(initial=numpy.inf)
    return best


def on_sides(columns, corners, sides):
    """Which columns are on sides, without their ends."""
    found = numpy.zeros(len(columns), bool)
    order = numpy.lexsort((columns[:, 1], columns[:, 0]))
    ordered = columns[order]
    for a, b in zip(corners[sides[:, 0]], corners[sides[:, 1]]):
        low, high = min(a[0], b[0]), max(a[0], b[0])
        rows = slice(*numpy.searchsorted(ordered[:, 0], [low, high + 1]))
        here = ordered[rows]
        if here.size:
            along = ((here - a) * (b - a)).sum(axis=1)
            found[order[rows]] |= (cross(a, b, here) == 0) & (along > 0) & (along < ((b - a) ** 2).sum())
    return found


def faulted_links(data):
    """The links that faults cut: column and direction."""
    cuts = data.GetFieldData().GetArray("FaultedLinks")
    return set() if cuts is None else set(map(tuple, vtk_to_numpy(cuts).tolist()))


def measure_links(horizon, corners, heights, triangles, inside, cuts, dropped):
    """The largest vertical distances of sides of triangles from lines between neighbouring columns with points that no
    fault parts, with the columns: of inner sides from lines between columns inside, not both vertices; and of outlines
    from all, and of inner sides from lines to columns that are not inside, unless dropped points do not count; and as the
    first, also between two vertices."""
    edges = {}
    for triangle in triangles:
        for n in range(3):
            key = tuple(sorted((triangle[n], triangle[(n + 1) % 3])))
            edges[key] = edges.get(key, 0) + 1
    vertices = set(map(tuple, corners))
    largest = [(0.0, []), (0.0, []), (0.0, [])]
    for (one, other), count in edges.items():
        for axis in (0, 1):
            low, high = sorted((one, other), key=lambda point: corners[point][axis])
            start, end = corners[low], corners[high]
            lines = numpy.arange(start[axis] + 1, end[axis])
            if lines.size == 0:
                continue
            length = end[axis] - start[axis]
            numerator = (end[1 - axis] - start[1 - axis]) * (lines - start[axis])
            first = start[1 - axis] + numerator // length
            between = numerator % length != 0
            lines, first, rest = lines[between], first[between], (numerator % length)[between] / length
            left = numpy.empty((lines.size, 2), numpy.int64)
            left[:, axis], left[:, 1 - axis] = lines, first
            right = left.copy()
            right[:, 1 - axis] += 1
            points = horizon.at(left), horizon.at(right)
            for n in numpy.flatnonzero((points[0] >= 0) & (points[1] >= 0)):
                a, b = points[0][n], points[1][n]
                ends = [tuple(left[n]), tuple(right[n])]
                if (*left[n], 1 - axis) in cuts:
                    continue
                is_left = all(inside[point] or end in vertices for point, end in zip((a, b), ends))
                is_inner = count == 2 and is_left
                if not (is_left or dropped):
                    continue
                kinds = (1,) if not is_inner else (2,) if all(end in vertices for end in ends) else (0, 2)
                part = (lines[n] - start[axis]) / length
                mesh = heights[low] + part * (heights[high] - heights[low])
                line = horizon.heights[a] + rest[n] * (horizon.heights[b] - horizon.heights[a])
                for kind in kinds:
                    largest[kind] = max(largest[kind], (abs(mesh - line), ends))
    return largest


def smallest_angles(corners, triangles):
    """Of each triangle in plan, in degrees."""
    places = corners[triangles].astype(float)
    angles = []
    for first in range(3):
        one, other = (numpy.roll(places, -first, axis=1)[:, k] - places[:, first] for k in (1, 2))
        angles.append(numpy.arctan2(abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]), (one * other).sum(axis=1)))
    return numpy.degrees(numpy.min(angles, axis=0))


def value(mesh, name):
    return mesh.GetFieldData().GetArray(name).GetTuple1(0)


def check(horizon_data, mesh, error, tolerance, height_tolerance=None, *, in_stages=False):
    """The faults of a mesh, as texts. Errors in lattice units, the tolerance in columns. Stages one by one do not know
    any more what was dropped from outlines."""
    height_tolerance = error if height_tolerance is None else height_tolerance
    horizon = Heights(horizon_data)
    places = lattice_points(mesh)
    corners, heights = whole(places), places[:, 2]
    triangles = cells(mesh.GetPolys(), 3)
    sides = segments(mesh.GetLines())
    slack = 1e-9 * max(1.0, numpy.abs(horizon.heights).max())
    faults = []
    errors = measure_columns(horizon, corners, heights, triangles)
    covered = ~numpy.isnan(errors)
    # A point on an outline is on the rim of the mesh: there, as outside, the tolerances of outlines hold.
    on_outline = on_sides(horizon.columns, corners, sides)
    inside = covered & ~on_outline
    for point in numpy.flatnonzero(inside & (errors > error + slack)):
        faults.append(f"column {tuple(horizon.columns[point])} is {errors[point]:.4g} off, asked {error}")
    rest = numpy.flatnonzero(~inside)
    found = nearest_outline(
        horizon.columns[rest], horizon.heights[rest], corners, heights, sides, tolerance, height_tolerance)
    lost = rest[~numpy.isfinite(found)]
    if len(lost) != value(mesh, "DroppedSmallPatchPoints"):
        faults.append(f"{len(lost)} points far from the mesh, as {horizon.columns[lost[:3]].tolist()}")
    outside = int((found > 1e-9).sum()) - len(lost)
    if outside != value(mesh, "NumberOfOutsidePoints"):
        faults.append(f"{outside} points outside, told {value(mesh, 'NumberOfOutsidePoints')}")
    (off, columns), (beside, others), (farthest, between) = measure_links(
        horizon, corners, heights, triangles, inside, faulted_links(horizon_data), not in_stages)
    if off > error + slack:
        faults.append(f"a side is {off:.4g} off between columns {columns}, asked {error}")
    told = value(mesh, "LargestEdgeError")
    if not in_stages and abs(told - farthest) > slack:
        faults.append(f"a side is {farthest:.4g} off between columns {between}, told {told:.4g}")
    told = value(mesh, "LargestLoopError")
    if abs(told - max(beside, value(mesh, "OutlineHeightDeviation"))) > slack:
        faults.append(f"a side at outlines is {beside:.4g} off between columns {others}, told {told:.4g}")
    slivers = int((smallest_angles(corners, triangles) < 2).sum())  # the default of SmallestAngle
    if slivers != value(mesh, "SliverCount"):
        faults.append(f"{slivers} triangles with an angle below 2 degrees, told {value(mesh, 'SliverCount')}")
    told = value(mesh, "LargestError")
    largest = errors[inside if in_stages else covered].max(initial=0.0)
    if largest > told + slack or largest < told - slack or told > max(error, height_tolerance) + slack:
        faults.append(f"largest error {largest:.6g}, told {told:.6g}")
    return faults
