# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the ledger of a result accounts for all columns of the horizon as it was read.

Nothing here is shared with what is checked: each column of the lattice is tested against each triangle, in whole numbers.
"""

import re

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

ENTRIES = ("Known", "Filled", "Bridged", "Extrapolated", "LeftOut")
PARTS = 1 << 20  # of a column


def is_warning(line):
    """Whether a line warns of the ledger, which most horizons give reason for."""
    return re.search(r": (of the covered area, |[0-9.]+ % of the points are left out)", str(line)) is not None


def ledger(data):
    """The entries as a dictionary; the areas are those of the columns."""
    fields = data.GetFieldData()
    columns, area = fields.GetArray("LedgerColumns"), fields.GetArray("LedgerArea")
    assert tuple(columns.GetComponentName(n) for n in range(5)) == ENTRIES
    matrix = vtk_to_numpy(fields.GetArray("LatticeToWorld")).reshape(4, 4)
    bin_area = abs(numpy.linalg.det(matrix[:2, :2]))
    numbers = vtk_to_numpy(columns)[0]
    assert numpy.allclose(vtk_to_numpy(area)[0], numbers * bin_area, rtol=1e-12, atol=0.0), "areas are not those of the columns"
    return dict(zip(ENTRIES, numbers.tolist()))


def places(data):
    """The points in plan, in columns."""
    if not data.GetNumberOfPoints():
        return numpy.zeros((0, 2))
    matrix = vtk_to_numpy(data.GetFieldData().GetArray("LatticeToWorld")).reshape(4, 4)
    world = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return numpy.linalg.solve(matrix[:3, :3], (world - matrix[:3, 3]).T).T[:, :2]


def columns_of(points):
    """The columns of points by their entry, as sets."""
    found = list(map(tuple, numpy.rint(places(points)).astype(int).tolist()))
    filled = points.GetPointData().GetArray("Filled")
    marks = numpy.zeros(len(found)) if filled is None else vtk_to_numpy(filled)
    return {entry: {column for column, mark in zip(found, marks) if mark == value}
            for value, entry in enumerate(("Known", "Filled", "Extrapolated"))}


def covered(mesh):
    """The columns in the triangles of the surface and on their sides."""
    fine = numpy.rint(places(mesh) * PARTS).astype(numpy.int64)
    found = set()
    polys = mesh.GetPolys()
    triangles = vtk_to_numpy(polys.GetConnectivityArray()).reshape(-1, 3)
    faults = mesh.GetCellData().GetArray("Fault")
    if faults is not None and len(triangles):
        triangles = triangles[vtk_to_numpy(faults)[-len(triangles):] == 0]
    for corners in fine[triangles]:
        least, greatest = -(-corners.min(axis=0) // PARTS), corners.max(axis=0) // PARTS
        i, j = numpy.meshgrid(*(numpy.arange(a, b + 1) for a, b in zip(least, greatest)), indexing="ij")
        sides = []
        for a, b in zip(corners, numpy.roll(corners, -1, axis=0)):
            sides.append((b[0] - a[0]) * (j * PARTS - a[1]) - (b[1] - a[1]) * (i * PARTS - a[0]))
        inside = (numpy.min(sides, axis=0) >= 0) | (numpy.max(sides, axis=0) <= 0)
        found.update(zip(i[inside].tolist(), j[inside].tolist()))
    return found


def expected_of_points(read, points):
    """The ledger of points, where these columns were read."""
    own = {entry: len(columns) for entry, columns in columns_of(points).items()}
    return {**own, "Bridged": 0, "LeftOut": len(read) - own["Known"]}


def expected_of_mesh(read, points, mesh):
    """The ledger of a mesh that was made of points."""
    there = covered(mesh)
    own = {entry: len(columns & there) for entry, columns in columns_of(points).items()}
    return {**own, "Bridged": len(there) - sum(own.values()), "LeftOut": len(read) - own["Known"]}
