# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangles of a mesh: those of its surface, and those that close its faults, which are no part of the surface and
which no figure counts."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray


def of_surface(mesh):
    """The corners of the triangles of the surface, as (n, 3) numbers of points."""
    marks = _marks(mesh)
    return _corners(mesh) if marks is None else _corners(mesh)[~marks]


def at_faults(mesh):
    """The same of the triangles that close faults."""
    marks = _marks(mesh)
    return np.zeros((0, 3), dtype=np.int64) if marks is None else _corners(mesh)[marks]


def count_surface(mesh):
    return mesh.GetNumberOfPolys() - count_at_faults(mesh)


def count_at_faults(mesh):
    marks = _marks(mesh)
    return 0 if marks is None else int(np.count_nonzero(marks))


def values_on_surface(mesh, name):
    """What an array of the cells has for each triangle of the surface, or None where there is no such array."""
    values = _values(mesh, name)
    marks = _marks(mesh)
    return values if values is None or marks is None else values[~marks]


def cells_of(corners):
    """Triangles by the numbers of their corners."""
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(3 * np.arange(len(corners) + 1, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    return cells


def _corners(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def _values(mesh, name):
    """Of all triangles, which come last among the cells."""
    array = mesh.GetCellData().GetArray(name)
    if array is None:
        return None
    values = vtk_to_numpy(array)
    return values[len(values) - mesh.GetNumberOfPolys():]


def _marks(mesh):
    """For each triangle whether it closes a fault, or None where none does."""
    values = _values(mesh, "Fault")
    return None if values is None or not values.any() else values != 0
