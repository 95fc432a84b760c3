# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of the core: dictionaries of numpy arrays with the names of Documentation/DataModel.md. Points are `places`; lines
and polygons are offsets and points; arrays are `point_data`, `cell_data` (of lines, then polygons) and `field_data`."""

import numpy as np
from seismichorizons._data import loops


def empty():
    """Returns data without points."""
    none = (np.zeros(1, np.int64), np.zeros(0, np.int64))
    return {"places": np.zeros((0, 3)), "lines": none, "polygons": none, "point_data": {}, "cell_data": {}, "field_data": {}}


def count_points(data):
    return len(data["places"])


def count_lines(data):
    return max(0, len(data["lines"][0]) - 1) if "lines" in data else 0


def count_polygons(data):
    return max(0, len(data["polygons"][0]) - 1) if "polygons" in data else 0


def lines(data):
    """Returns the points of each line."""
    return loops(data["lines"], is_closed=False) if "lines" in data else []


def bounds(data):
    """Returns the least and largest x, y and z in turn."""
    places = data["places"]
    return np.column_stack((places.min(axis=0), places.max(axis=0))).ravel().tolist()


def values(data, name):
    """Returns all numbers of an array of the field data as a list; empty without it."""
    array = data["field_data"].get(name)
    return [] if array is None or isinstance(array, list) else array.ravel().tolist()


def value(data, name):
    """Returns the first number of an array of the field data; None without it."""
    return next(iter(values(data, name)), None)


def text(data, name):
    """Returns a text of the field data; empty without it."""
    texts = data["field_data"].get(name)
    return texts[0] if texts else ""


def with_fields(data, fields):
    """Returns data with more arrays in the field data."""
    return {**data, "field_data": {**data["field_data"], **fields}}


def vertical_direction(data):
    """Returns 1 if z of the file increases upwards, -1 if downwards, 0 if unknown."""
    return int(value(data, "VerticalDirection") or 0)


def to_vtk(data):
    """Returns a vtkPolyData; needs VTK."""
    from seismichorizons._horizon import add_arrays, fill_vtk, vtk_cells
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    made = vtkPolyData()
    size = count_points(data)
    vertices = fill_vtk(made, data["places"], np.arange(size + 1), np.arange(size))
    if data.get("has_vertices") or not count_lines(data) and not count_polygons(data):
        made.SetVerts(vertices)
    for set_cells, name, number in ((made.SetLines, "lines", count_lines(data)), (made.SetPolys, "polygons", count_polygons(data))):
        if number:
            set_cells(vtk_cells(*data[name]))
    add_arrays(made.GetPointData(), {name: array for name, array in data["point_data"].items() if not isinstance(array, list)})
    if not made.GetNumberOfVerts():
        add_arrays(made.GetCellData(), {name: array for name, array in data["cell_data"].items() if not isinstance(array, list)})
    return made


def from_vtk(given):
    """Returns the data of a vtkPolyData."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def arrays(attributes):
        found = [attributes.GetAbstractArray(number) for number in range(attributes.GetNumberOfArrays())]
        return {array.GetName(): vtk_to_numpy(array) if array.IsNumeric() else [
            array.GetValue(n) for n in range(array.GetNumberOfValues())] for array in found if array.GetName()}

    def cells(of):
        return (vtk_to_numpy(of.GetOffsetsArray()), vtk_to_numpy(of.GetConnectivityArray())) if of.GetNumberOfCells() else empty()["lines"]

    places = vtk_to_numpy(given.GetPoints().GetData()) if given.GetNumberOfPoints() else np.zeros((0, 3))
    return {"places": places, "has_vertices": given.GetNumberOfVerts() > 0, "lines": cells(given.GetLines()), "polygons": cells(given.GetPolys()),
            "point_data": arrays(given.GetPointData()), "cell_data": arrays(given.GetCellData()), "field_data": arrays(given.GetFieldData())}
