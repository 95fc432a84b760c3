# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What has to hold for every triangulated horizon, checked from its output alone."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def read(path):
    """The mesh of a file."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def blocks(collection):
    """The horizons of a composite dataset as a dictionary from name to polydata; empty ones are left out."""
    found = {}
    for number in range(collection.GetNumberOfPartitionedDataSets()):
        name = collection.GetMetaData(number).Get(collection.NAME())
        for part in range(collection.GetNumberOfPartitions(number)):
            horizon = collection.GetPartition(number, part)
            if horizon is not None and horizon.GetNumberOfPoints():
                assert name not in found, "two parts of %s" % name
                found[name] = horizon
    return found


def with_text(data, name, value):
    """A copy with a text of its survey."""
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    text = vtkStringArray()
    text.SetName(name)
    text.InsertNextValue(value)
    copy.GetFieldData().AddArray(text)
    return copy


def coordinates(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def array(mesh, name):
    data = mesh.GetPointData().GetArray(name)
    assert data is not None, "no point data array %s" % name
    return vtk_to_numpy(data)


def counts(mesh):
    """How many points of the input each point represents."""
    if mesh.GetPointData().HasArray("PointCount"):
        return array(mesh, "PointCount")
    return np.ones(mesh.GetNumberOfPoints(), dtype=np.int64)


def triangles(mesh):
    cells = mesh.GetPolys()
    if cells.GetNumberOfCells() == 0:
        return np.zeros((0, 3), dtype=np.int64)
    assert cells.GetMaxCellSize() == 3 and cells.GetNumberOfConnectivityIds() == 3 * cells.GetNumberOfCells()
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, 3).astype(np.int64)


def loops(mesh):
    """The outlines as arrays of point numbers, the first one not repeated at the end."""
    cells = mesh.GetLines()
    connectivity = vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64)
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    found = [connectivity[offsets[n]:offsets[n + 1]] for n in range(cells.GetNumberOfCells())]
    for loop in found:
        assert loop[0] == loop[-1], "an outline is not closed"
    return [loop[:-1] if len(loop) > 1 else loop for loop in found]


def _edges_of(corners):
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    return np.sort(edges, axis=1)


def _doubled_area(points, polygon):
    x, y = points[polygon, 0], points[polygon, 1]
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def check_mesh(mesh):
    """Checks one horizon and returns its number of triangles.

    That all triangles face up, that no edge has more than two of them, and that their areas sum to that within the
    outlines leaves no room for overlaps, gaps or triangles outside.
    """
    points, corners, patches = coordinates(mesh), triangles(mesh), array(mesh, "PatchId")
    points = points - points.mean(axis=0)  # areas far from the origin lose digits
    a, b, c = (points[corners[:, n], :2] for n in range(3))
    doubled = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    assert (doubled > 0).all(), "%d triangles do not face up" % (doubled <= 0).sum()
    within = sum(-_doubled_area(points, loop) for loop in loops(mesh))
    assert abs(doubled.sum() - within) <= 1e-9 * max(1.0, within), "area %g, expected %g" % (doubled.sum(), within)

    border = [np.column_stack([loop, np.roll(loop, -1)]) for loop in loops(mesh) if len(loop) > 1]
    border = np.sort(np.concatenate(border), axis=1) if border else np.zeros((0, 2), dtype=np.int64)
    edges, uses = np.unique(_edges_of(corners), axis=0, return_counts=True)
    assert (uses <= 2).all(), "an edge has more than two triangles"
    rim = edges[uses == 1]
    border_set = set(map(tuple, border))
    assert all(tuple(edge) in border_set for edge in rim), "the mesh ends at an edge that is no outline"

    all_edges = np.unique(np.concatenate([edges, border]), axis=0)
    assert (patches[all_edges[:, 0]] == patches[all_edges[:, 1]]).all(), "an edge joins two patches"
    for patch in np.unique(patches):
        vertices = (patches == patch).sum()
        sides = (patches[all_edges[:, 0]] == patch).sum()
        faces = (patches[corners[:, 0]] == patch).sum() if len(corners) else 0
        expected = 2 - sum(patches[loop[0]] == patch for loop in loops(mesh))  # an outline and its holes
        assert vertices - sides + faces == expected, "patch %d: %d - %d + %d, expected %d (Euler)" % (
            patch, vertices, sides, faces, expected)
    return len(corners)
