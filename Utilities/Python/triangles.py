# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangles of a mesh: triangles of its surface, and triangles that close its faults, which do not belong to the
surface and are excluded from all figures."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray


def of_surface(mesh):
    """Returns the corners of the surface triangles as (n, 3) point numbers."""
    marks = _marks(mesh)
    return _corners(mesh) if marks is None else _corners(mesh)[~marks]


def at_faults(mesh):
    """Returns the corners of the triangles that close faults."""
    marks = _marks(mesh)
    return np.zeros((0, 3), dtype=np.int64) if marks is None else _corners(mesh)[marks]


def count_surface(mesh):
    return mesh.GetNumberOfPolys() - count_at_faults(mesh)


def count_at_faults(mesh):
    marks = _marks(mesh)
    return 0 if marks is None else int(np.count_nonzero(marks))


def values_on_surface(mesh, name):
    """Returns the values of a cell array on the surface triangles, or None if there is no such array."""
    values = _values(mesh, name)
    marks = _marks(mesh)
    return values if values is None or marks is None else values[~marks]


def cells_of(corners):
    """Returns triangles given by the point numbers of their corners."""
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(3 * np.arange(len(corners) + 1, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64).ravel(), deep=True))
    return cells


def _corners(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def _values(mesh, name):
    """Returns the values of all triangles, which come last among the cells."""
    array = mesh.GetCellData().GetArray(name)
    if array is None:
        return None
    values = vtk_to_numpy(array)
    return values[len(values) - mesh.GetNumberOfPolys():]


def _marks(mesh):
    """Returns whether each triangle closes a fault, or None if none does."""
    values = _values(mesh, "Fault")
    return None if values is None or not values.any() else values != 0
