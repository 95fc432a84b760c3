# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangles of a mesh: triangles of its surface, and triangles that close its faults, which do not belong to the
surface and are excluded from all figures."""

import numpy as np

from .data import count_lines, count_polygons


def of_surface(mesh):
    """Returns the corners of the surface triangles as (n, 3) point numbers."""
    marks = _marks(mesh)
    return _corners(mesh) if marks is None else _corners(mesh)[~marks]


def at_faults(mesh):
    """Returns the corners of the triangles that close faults."""
    marks = _marks(mesh)
    return np.zeros((0, 3), dtype=np.int64) if marks is None else _corners(mesh)[marks]


def count_surface(mesh):
    return count_polygons(mesh) - count_at_faults(mesh)


def count_at_faults(mesh):
    marks = _marks(mesh)
    return 0 if marks is None else int(np.count_nonzero(marks))


def values_on_surface(mesh, name):
    """Returns the values of a cell array on the surface triangles, or None if there is no such array."""
    values = _values(mesh, name)
    marks = _marks(mesh)
    return values if values is None or marks is None else values[~marks]


def _corners(mesh):
    return mesh["polygons"][1].astype(np.int64, copy=False).reshape(-1, 3)


def _values(mesh, name):
    """Returns the values of all triangles, which come last among the cells."""
    return mesh["cell_data"][name][count_lines(mesh):] if name in mesh["cell_data"] else None


def _marks(mesh):
    """Returns whether each triangle closes a fault, or None if none does."""
    values = _values(mesh, "Fault")
    return None if values is None or not values.any() else values != 0
