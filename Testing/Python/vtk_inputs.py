# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the VTK classes take, made of arrays, and what they give as values of Python."""

import math
import re
import types

import numpy as np
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPartitionedDataSetCollection, vtkPolyData

MATRIX_SIZE = 16


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[a-z])(?=[0-9])", "_", name).lower()


def image_of(z, origin=(0.0, 0.0), spacing=(1.0, 1.0), azimuth=90.0):
    """A map whose array has this z by rows and columns. Columns run to the azimuth, and rows to the left of it."""
    image = vtkImageData()
    image.SetDimensions(*np.shape(z)[::-1], 1)
    image.SetOrigin(*origin[:2], 0.0)
    image.SetSpacing(*spacing, 1.0)
    angle = math.radians(90.0 - azimuth)
    cosine, sine = math.cos(angle), math.sin(angle)
    image.SetDirectionMatrix(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ravel(np.asarray(z, float)), deep=True))
    return image


def horizon(z, origin=(0.0, 0.0), spacing=(1.0, 1.0), azimuth=90.0, **properties):
    """The points of a horizon on the lattice of the whole array, without those that are nan. Properties are those of
    vtkHorizonFromImage."""
    made = sh.apply(sh.make("vtkHorizonFromImage", **properties), image_of(z, origin, spacing, azimuth))
    (points,) = sh.horizons_of(made).values()
    return points


def points_of(places):
    """Points of a dataset, at the places of an array of shape (n, 3)."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(places, dtype=float), deep=True))
    return data


def collect(horizons):
    """One dataset with several horizons, by their names."""
    blocks = vtkPartitionedDataSetCollection()
    for number, (name, points) in enumerate(horizons.items()):
        blocks.SetPartition(number, 0, points)
        blocks.GetMetaData(number).Set(blocks.NAME(), name)
    return blocks


def read(path, reader="vtkVerneySparseMatrixReader", **properties):
    """The horizons of a file, by their names."""
    return sh.horizons_of(sh.apply(sh.make(reader, FileName=str(path), **properties)))


def surface(points, **properties):
    """The mesh of a horizon. Properties are those of vtkHorizonSurface."""
    return sh.apply(sh.make("vtkHorizonSurface", **properties), points)


def thickness(*horizons):
    """The points of the first of two horizons, with the thickness between them."""
    return sh.apply(sh.make("vtkHorizonThickness"), *horizons)


def layers(horizons, **properties):
    """All that vtkHorizonLayers makes of horizons by name: cells, bodies and horizons by name, figures of each layer by
    name, and the curve of volumes by level."""
    maker = sh.make("vtkHorizonLayers", **properties)
    sh.apply(maker, collect(horizons))
    cells, bodies, meshes, table, curve = (maker.GetOutputDataObject(port) for port in range(5))
    figures = {table.GetValueByName(row, "Name").ToString(): types.SimpleNamespace(**{
        snake(table.GetColumnName(column)): _plain(table.GetValue(row, column)) for column in range(table.GetNumberOfColumns())})
        for row in range(table.GetNumberOfRows())}
    return types.SimpleNamespace(
        cells=cells, bodies=sh.horizons_of(bodies), horizons=sh.horizons_of(meshes), figures=figures,
        curve={curve.GetColumnName(column) if column else "contact": vtk_to_numpy(curve.GetColumn(column))
               for column in range(curve.GetNumberOfColumns())})


def crossings(horizons, **properties):
    """The horizons of vtkHorizonCrossings, by name."""
    return sh.horizons_of(sh.apply(sh.make("vtkHorizonCrossings", **properties), collect(horizons)))


def details(data):
    """The field data of a dataset as attributes. Named components are attributes in turn."""
    fields = data.GetFieldData()
    arrays = [fields.GetAbstractArray(number) for number in range(fields.GetNumberOfArrays())]
    return types.SimpleNamespace(**{snake(array.GetName()): _value(array) for array in arrays if (array.GetName() or "").isidentifier()})


def _value(array):
    if not array.IsNumeric():
        texts = [array.GetValue(number) for number in range(array.GetNumberOfValues())]
        return texts[0] if len(texts) == 1 else texts
    numbers = vtk_to_numpy(array)
    if array.HasAComponentName() and array.GetNumberOfTuples() == 1:
        return types.SimpleNamespace(**{snake(array.GetComponentName(n)): number.item() for n, number in enumerate(numbers[0])})
    if numbers.size == 1:
        return numbers.reshape(-1)[0].item()
    return numbers.reshape(4, 4).copy() if numbers.shape == (1, MATRIX_SIZE) else numbers.squeeze().copy()


def _plain(variant):
    return variant.ToString() if variant.IsString() else variant.ToDouble() if variant.IsDouble() else variant.ToInt()
