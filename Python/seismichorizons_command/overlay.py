# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Intersects two sets of triangles in map view: their common area and their vertical distance. The distance is largest at a
corner of the intersection of two triangles, so the result is exact up to rounding.

Triangles are arrays of shape (n, 3, 3): triangle, corner, coordinate.
"""

import numpy as np

CHUNK = 1 << 16  # pairs of triangles at a time
BEGIN, END = np.array([0, 1, 2]), np.array([1, 2, 0])  # corners of the edges of a triangle
EXACT = 1e-12  # fraction of an edge below which a piece is empty


def doubled_areas(triangles):
    """Returns twice the areas in map view, positive for anticlockwise corners."""
    a, b, c = (triangles[:, corner, :2] for corner in range(3))
    return _cross(b - a, c - a)


def turned_left(triangles):
    """Returns the triangles with anticlockwise corners in map view."""
    return np.where((doubled_areas(triangles) < 0.0)[:, None, None], triangles[:, ::-1], triangles)


def pairs(first, second=None):
    """Yields pairs of triangles whose bounding boxes touch in map view, in batches, as arrays with two columns of numbers.
    Without a second set, pairs of the first set, each once.

    Boxes are sorted into square cells at least as large as the boxes, so that a mixture of small and large boxes stays
    efficient: each box is looked up in the cells of its own size and of all larger sizes.
    """
    own = second is None
    sets = [_Cells(first), _Cells(first if own else second)]
    for level in sorted(set(sets[0].levels) | set(sets[1].levels)):
        coarse, fine = (sets[0].at(level), sets[1].up_to(level))
        yield from _joined(*sets, coarse, fine, level, own)
        if not own:
            coarse, fine = (sets[1].at(level), sets[0].below(level))
            yield from (found[:, ::-1] for found in _joined(sets[1], sets[0], coarse, fine, level, False))


class _Cells:
    """Bounding boxes of triangles and their levels; the cells of level n are 2^n wide."""

    def __init__(self, triangles):
        self.low, self.high = triangles[:, :, :2].min(axis=1), triangles[:, :, :2].max(axis=1)
        extent = np.maximum((self.high - self.low).max(axis=1), np.finfo(float).tiny)
        self.levels = np.frexp(extent)[1]

    def at(self, level):
        return np.flatnonzero(self.levels == level)

    def up_to(self, level):
        return np.flatnonzero(self.levels <= level)

    def below(self, level):
        return np.flatnonzero(self.levels < level)

    def entries(self, numbers, level):
        """Returns the cells of boxes, at most four each: the number of the box and the column and row of the cell."""
        low, high = (np.floor(np.ldexp(side[numbers], -level)).astype(np.int64) for side in (self.low, self.high))
        found = [(number, low + step) for step in ((0, 0), (1, 0), (0, 1), (1, 1))
                 for number in [np.flatnonzero((low + step <= high).all(axis=1))]]
        return (np.concatenate([numbers[number] for number, _ in found]),
                np.concatenate([cells[number] for number, cells in found]))


def _joined(coarse_set, fine_set, coarse, fine, level, own):
    """Yields pairs of boxes that touch, as (coarse, fine), only in their first common cell, so that each pair occurs once."""
    if not len(coarse) or not len(fine):
        return
    (numbers, cells), (others, other_cells) = coarse_set.entries(coarse, level), fine_set.entries(fine, level)
    columns = np.concatenate((cells, other_cells))
    width = np.ptp(columns[:, 1]) + 1
    keys, other_keys = (np.dot(part - columns.min(axis=0), (width, 1)) for part in (cells, other_cells))
    order = np.argsort(keys, kind="stable")
    numbers, keys = numbers[order], keys[order]
    begin, end = np.searchsorted(keys, other_keys, "left"), np.searchsorted(keys, other_keys, "right")
    ends = np.cumsum(end - begin)
    start = 0
    while start < len(others):
        done = ends[start - 1] if start else 0
        stop = max(start + 1, int(np.searchsorted(ends, done + CHUNK, "right")))
        counts = (end - begin)[start:stop]
        fine_of = np.repeat(np.arange(start, stop), counts)
        within = np.arange(len(fine_of)) - np.repeat(np.cumsum(counts) - counts, counts)
        a, b = numbers[begin[fine_of] + within], others[fine_of]
        low = np.maximum(coarse_set.low[a], fine_set.low[b])
        touch = (low <= np.minimum(coarse_set.high[a], fine_set.high[b])).all(axis=1)
        touch &= (np.floor(np.ldexp(low, -level)).astype(np.int64) == other_cells[fine_of]).all(axis=1)
        if own:
            touch &= (a < b) | (fine_set.levels[b] < level)
        start = stop
        if touch.any():
            yield np.stack((a[touch], b[touch]), axis=1)


def widths(a, b):
    """Returns a lower bound of the width of the intersection of pairs of anticlockwise triangles, across an edge; negative
    if they are separate."""
    least = np.full(len(a), np.inf)
    for one, other in ((a, b), (b, a)):
        for begin, end in zip(BEGIN, END):
            edge = one[:, end, :2] - one[:, begin, :2]
            inside = _cross(edge[:, None], other[:, :, :2] - one[:, None, begin, :2]).max(axis=1)
            least = np.minimum(least, inside / np.hypot(*edge.T))
    return least


class Common:
    """The intersection of pairs of anticlockwise triangles in map view: `areas`, and for each pair the corners as `places`
    (x and y) with both `heights`, nan for unused corners."""

    def __init__(self, a, b):
        ends = [_clipped(a, b, True), _clipped(b, a, False)]
        self.places = np.concatenate([place for one in ends for place in one[:2]], axis=1)
        own = [np.concatenate([height for height in one[2:4]], axis=1) for one in ends]
        other = [np.concatenate([height for height in one[4:6]], axis=1) for one in ends]
        self.heights = np.stack((np.concatenate((own[0], other[1]), axis=1),
                                 np.concatenate((other[0], own[1]), axis=1)), axis=2)
        base = a[:, :1, :2]
        self.areas = 0.5 * sum(np.nansum(_cross(one[0] - base, one[1] - base), axis=1) for one in ends)

    def gaps(self):
        """Returns the vertical distance at each corner, -1 for unused corners."""
        return np.nan_to_num(np.abs(self.heights[:, :, 0] - self.heights[:, :, 1]), nan=-1.0)


def _clipped(one, other, is_closed):
    """Clips the edges of triangles by other triangles: ends in map view, their heights, and the heights of the other
    triangle there; nan for edges outside. Edges on an edge of the other triangle are included only if `is_closed`."""
    begin, end = one[:, BEGIN], one[:, END]
    first, last = np.zeros(begin.shape[:2]), np.ones(begin.shape[:2])
    for corner, following in zip(BEGIN, END):
        edge = (other[:, following, :2] - other[:, corner, :2])[:, None]
        at_begin, at_end = (_cross(edge, part[:, :, :2] - other[:, None, corner, :2]) for part in (begin, end))
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = at_begin / (at_begin - at_end)
        first = np.where((at_begin < 0.0) & (at_end > 0.0), np.maximum(first, crossing), first)
        last = np.where((at_begin > 0.0) & (at_end < 0.0), np.minimum(last, crossing), last)
        beside = (at_begin <= 0.0) & (at_end <= 0.0)
        along = (at_begin == 0.0) & (at_end == 0.0) & is_closed & (_dot(edge, (end - begin)[:, :, :2]) > 0.0)
        last = np.where(beside & ~along, -1.0, last)
    first = np.where(last - first > EXACT, first, np.nan)
    places = [begin + part[:, :, None] * (end - begin) for part in (first, np.where(np.isnan(first), np.nan, last))]
    return (*(place[:, :, :2] for place in places), *(place[:, :, 2] for place in places),
            *(_plane_heights(other, place[:, :, :2]) for place in places))


def _plane_heights(triangles, places):
    """Heights of the planes of triangles at positions."""
    origin = triangles[:, :1]
    (u, v) = (triangles[:, corner] - triangles[:, 0] for corner in (1, 2))
    offset = places - origin[:, :, :2]
    area = _cross(u[:, :2], v[:, :2])[:, None]
    along_u, along_v = _cross(offset, v[:, None, :2]) / area, _cross(u[:, None, :2], offset) / area
    return origin[:, :, 2] + along_u * u[:, None, 2] + along_v * v[:, None, 2]


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _dot(a, b):
    return (a * b).sum(axis=-1)
