# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as files: meshes, and the figures of the error.

Most are made in memory, and written by Python: where a disk is full, VTK's writers of XML go on, and may crash.
"""

import csv
import io
import math

from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection, vtkPolyData
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

from . import geotiff
from .stage import HorizonError, make, update


# How far coordinates of a mesh may be off in single precision, as a part of a column step, without a word.
LARGEST_ROUNDING = 0.01
MESH_FORMATS = ("vtp", "ts", "stl", "ply", "obj", "dxf")
GRID_FORMATS = ("irap", "gri", "zmap", "tif")  # of meshes, by the columns that they cover
POINT_FORMATS = {"dat": "vtkHorizonTextWriter", "vsm": "vtkVerneySparseMatrixWriter"}
LAYER_FORMATS = ("msh", "inp", "disv")  # of cells of layers, which .vtu has as well
FORMATS = (*MESH_FORMATS, *GRID_FORMATS, *POINT_FORMATS, *LAYER_FORMATS)


def write(result, path):
    """Writes a result (pipeline.Result) in the format of the extension of its file: its mesh, or the points that the mesh
    was made of. Returns warnings. Raises HorizonError."""
    form = path.suffix[1:]
    if form not in POINT_FORMATS:
        return write_mesh(result.data["mesh"], path, result.name)
    write_points(prepared(result), path, result.name)
    return []


def prepared(result):
    """The points that a mesh was made of."""
    return next(result.data[name] for name in ("filled", "torn", "despiked", "points") if name in result.data)


def write_points(points, path, name):
    """Writes the points of a horizon in the format of the extension of its file, and returns warnings. Raises
    HorizonError."""
    return _run(make(POINT_FORMATS[path.suffix[1:]]), _named(points, name), path)


def write_mesh(mesh, path, name):
    """Writes a mesh in the format of the extension of its file, and returns warnings. Raises HorizonError."""
    form = path.suffix[1:]
    if form == "vtp":
        write_vtp(mesh, path)
        return []
    if form == "tif":
        return geotiff.write(mesh, path)
    writer, data = _make_writer(form, name, mesh)
    warnings = _run(writer, data, path)
    return _rounding_warnings(mesh) if form == "ply" else warnings


def _run(writer, data, path):
    """Writes a file, and returns warnings. Raises HorizonError."""
    warnings = []
    writer.SetInputDataObject(0, data)
    writer.SetFileName(str(path))
    try:
        update(writer, "%s: writing" % path.name, warnings)
    except HorizonError as error:  # names the file where it lies until it is complete
        raise HorizonError(str(error).replace(str(path), path.name)) from None
    if writer.GetErrorCode():
        reason = vtkErrorCode.GetStringFromErrorCode(writer.GetErrorCode())
        raise HorizonError("%s cannot be written: %s" % (path.name, reason))
    return [text.replace("%s: " % path, "") for text in warnings]


def write_vtp(mesh, path):
    """Writes a mesh as a file of VTK. Raises HorizonError."""
    _write_xml(vtkXMLPolyDataWriter(), mesh, path)


def _write_xml(writer, mesh, path):
    writer.WriteToOutputStringOn()
    writer.SetInputDataObject(0, mesh)
    # Not the default, which appends raw bytes: readers of VTK up to 9.2 stumble over them with a recent Expat library.
    writer.SetDataModeToBinary()
    update(writer, "%s: writing" % path.name)
    write_file(writer.GetOutputString().encode(), path)


def _make_writer(form, name, mesh):
    """A writer of a format, and its input. Raises HorizonError."""
    own = {"ts": "vtkGOCADTSurfWriter", "dxf": "vtkHorizonDXFWriter"}
    if form in own or form in GRID_FORMATS:
        return make(own.get(form, "vtkHorizonGridWriter")), _named(mesh, name)
    # Loads libraries that are not needed otherwise.
    from vtkmodules import vtkIOGeometry, vtkIOPLY

    writer = {"stl": vtkIOGeometry.vtkSTLWriter, "obj": vtkIOGeometry.vtkOBJWriter, "ply": vtkIOPLY.vtkPLYWriter}[form]()
    if form == "ply":
        writer.SetFileTypeToBinary()
    triangles = vtkPolyData()
    triangles.SetPoints(mesh.GetPoints())
    triangles.SetPolys(mesh.GetPolys())
    return writer, triangles


def _named(mesh, name):
    """A collection of one mesh, which has a name."""
    collection = vtkPartitionedDataSetCollection()
    collection.SetPartition(0, 0, mesh)
    collection.GetMetaData(0).Set(collection.NAME(), name)
    return collection


def _rounding_warnings(mesh):
    """VTK writes .ply in single precision, which is not enough for the coordinates of most surveys."""
    places = numpy_support.vtk_to_numpy(mesh.GetPoints().GetData())
    off = float(abs(places - places.astype("float32")).max(initial=0.0))
    matrix = mesh.GetFieldData().GetArray("LatticeToWorld")
    # Surfaces of faults have no columns: metres count.
    step = 1.0 if matrix is None else min(
        math.hypot(matrix.GetComponent(0, column), matrix.GetComponent(0, 4 + column)) for column in (0, 1))
    if off <= LARGEST_ROUNDING * step:
        return []
    return ["coordinates are rounded to single precision, by up to %.2g; other formats keep them" % off]


def write_cells(grid, path):
    """Writes cells of layers in the format of the extension of a file, and returns warnings. Raises HorizonError."""
    if path.suffix[1:] in LAYER_FORMATS:
        return _run(make("vtkHorizonLayersWriter"), grid, path)
    _write_xml(vtkXMLUnstructuredGridWriter(), grid, path)
    return []


def write_tables(tables, path):
    """Writes tables of the same columns as one file of comma-separated values. Raises HorizonError."""
    text = io.StringIO()
    writer = csv.writer(text)
    for number, table in enumerate(tables):
        columns = range(table.GetNumberOfColumns())
        if number == 0:
            writer.writerow([table.GetColumnName(column) for column in columns])
        for row in range(table.GetNumberOfRows()):
            values = [table.GetValue(row, column) for column in columns]
            writer.writerow([repr(v.ToDouble()) if v.IsDouble() else v.ToString() for v in values])
    write_file(text.getvalue().encode(), path)


def write_file(content, path):
    """Writes bytes. Raises HorizonError."""
    try:
        path.write_bytes(content)
    except OSError as error:
        raise HorizonError("%s cannot be written: %s" % (path.name, error.strerror)) from None
