# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from triangle surfaces of GOCAD, which are meshed anew: their heights at the columns of a lattice, one that is
given, or one along x and y with about 16 columns for each vertex."""

import math
import pathlib
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .stage import HorizonError, make, update

READER = "vtkGOCADTSurfReader"
SOURCE = "vtkHorizonFromPoints"
COLUMNS_OF_VERTEX = 16.0  # triangles are larger than columns, and keep their shape


def open_file(path, origin=None, column_step=None, row_step=None):
    """The source of the horizons of a file. Raises HorizonError where no surface has triangles."""
    reader = make(READER, FileName=str(path))
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
    found = [_sample(mesh, steps, origin, sign, path) for _, mesh in meshes]
    points = vtkPolyData()
    points.SetPoints(vtkPoints())
    places = np.concatenate(found) * (1.0, 1.0, sign)
    points.GetPoints().SetData(numpy_to_vtk(places, deep=True))
    names = vtkStringArray()
    names.SetName("Name")
    for (name, _), places_of_one in zip(meshes, found):
        for _ in range(len(places_of_one)):
            names.InsertNextValue(name)
    points.GetPointData().AddArray(names)
    source = make(SOURCE, LatticeSource="OriginAndSteps", Origin=places[0, :2], ColumnStep=steps[:, 0],
                  RowStep=steps[:, 1], VerticalDirection="Up" if sign > 0.0 else "Down")
    source.SetInputDataObject(points)
    for name in ("VerticalUnit", "VerticalDomain", "HorizontalUnit", "CoordinateSystem"):
        if data.GetAbstractArray(name):
            getattr(source, "Set" + name)(data.GetAbstractArray(name).GetValue(0))
    return source


def _step(meshes):
    """A step of 1, 2 or 5 times a power of ten that makes about so many columns for each vertex."""
    area = sum((b[1] - b[0]) * (b[3] - b[2]) for b in (mesh.GetBounds() for _, mesh in meshes))
    step = math.sqrt(area / COLUMNS_OF_VERTEX / sum(mesh.GetNumberOfPoints() for _, mesh in meshes)) or 1.0
    unit = 10.0 ** math.floor(math.log10(step))
    return min((unit * factor for factor in (1.0, 2.0, 5.0, 10.0)), key=lambda size: abs(math.log(size / step)))


def _sample(mesh, steps, origin, sign, path):
    """World places of the columns that triangles cover, by the writer of grids."""
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
    with tempfile.TemporaryDirectory() as folder:
        grid = pathlib.Path(folder) / "sampled.irap"
        writer = make("vtkHorizonGridWriter", FileName=str(grid))
        writer.SetInputDataObject(0, sampled)
        update(writer, "%s: sampling" % path.name)
        reader = make("vtkHorizonGridReader", FileName=str(grid), VerticalDirection="Up" if sign > 0.0 else "Down")
        update(reader)
        points = reader.GetOutputDataObject(0).GetPartition(0, 0)
        if points is None or not points.GetNumberOfPoints():
            raise HorizonError("%s: no column under its triangles, expected some: give shorter --column-step and --row-step, or "
                               "is it a steep fault?" % path)
        return vtk_to_numpy(points.GetPoints().GetData()).copy()
