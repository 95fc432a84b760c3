# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as files: meshes, points, cells of layers, and tables of figures.

Each format has one writer, shared with ParaView. A file is written under a temporary name, checked and renamed; if that
fails, an existing file is unchanged.
"""

import csv
import io
import os
import pathlib
import tempfile

from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection

from . import geotiff
from .stage import HorizonError, make, update_writer

MESH_WRITER, GRID_WRITER = "vtkHorizonMeshWriter", "vtkHorizonGridWriter"
MESH_FORMATS = {"vtp": MESH_WRITER, "ts": "vtkGOCADTSurfWriter", "stl": MESH_WRITER, "ply": MESH_WRITER,
                "obj": MESH_WRITER, "dxf": "vtkHorizonDXFWriter"}
# Grids of the columns that meshes cover; GeoTIFF is written by GDAL.
GRID_FORMATS = {"irap": GRID_WRITER, "gri": GRID_WRITER, "zmap": GRID_WRITER, "tif": None}
POINT_FORMATS = {"dat": "vtkHorizonTextWriter", "vsm": "vtkVerneySparseMatrixWriter"}
LAYER_FORMATS = ("msh", "inp", "disv")  # for cells of layers, in addition to .vtu
FORMATS = (*MESH_FORMATS, *GRID_FORMATS, *POINT_FORMATS, *LAYER_FORMATS)
WRITERS = {**MESH_FORMATS, **GRID_FORMATS, **POINT_FORMATS}
FORMULA_SIGNS = ("=", "+", "-", "@", "\t", "\r")  # first characters of formulas in spreadsheets


def write(result, path):
    """Writes a result (pipeline.Result) in the format of the file extension: its mesh, or the points from which the mesh
    was made. Returns warnings. Raises HorizonError."""
    return write_data(prepared(result) if path.suffix[1:] in POINT_FORMATS else result.data["mesh"], path, result.name)


def prepared(result):
    """Returns the points from which a mesh was made."""
    return next(result.data[name] for name in ("filled", "torn", "despiked", "points") if name in result.data)


def write_data(data, path, name):
    """Writes a mesh or the points of a horizon, with a name, in the format of the file extension. Returns warnings. Raises
    HorizonError."""
    form = path.suffix[1:]
    if form == "tif":
        content, warnings = geotiff.make_content(data, path)
        write_file(content, path)
        return warnings
    named = vtkPartitionedDataSetCollection()
    named.SetPartition(0, 0, data)
    named.GetMetaData(0).Set(named.NAME(), name)
    return _run(make(WRITERS[form]), named, path)


def write_cells(grid, path):
    """Writes cells of layers in the format of the file extension. Returns warnings. Raises HorizonError."""
    return _run(make("vtkHorizonLayersWriter"), grid, path)


def _run(writer, data, path):
    """Writes a file and returns warnings. Raises HorizonError."""
    warnings = []
    writer.SetInputDataObject(0, data)
    writer.SetFileName(str(path))
    update_writer(writer, path.name, warnings)
    return [text.replace("%s: " % path, "") for text in warnings]


def write_tables(tables, path):
    """Writes tables with the same columns as one file of comma-separated values. Raises HorizonError."""
    text = io.StringIO()
    writer = csv.writer(text)
    for number, table in enumerate(tables):
        columns = range(table.GetNumberOfColumns())
        if number == 0:
            writer.writerow([table.GetColumnName(column) for column in columns])
        for row in range(table.GetNumberOfRows()):
            writer.writerow([_cell(table.GetValue(row, column)) for column in columns])
    write_file(text.getvalue().encode(), path)


def _cell(value):
    """Returns the text of a value, quoted if a spreadsheet would interpret it as a formula."""
    if value.IsDouble():
        return repr(value.ToDouble())
    text = value.ToString()
    return "'" + text if value.IsString() and text.startswith(FORMULA_SIGNS) else text


def write_file(content, path):
    """Writes bytes under a temporary name and renames the file when it is complete. A device is written to directly. Raises
    HorizonError."""
    require_writable(path)
    path = pathlib.Path(os.path.realpath(path))
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(content)
            return
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=".", suffix=".part", delete=False) as file:
            try:
                file.write(content)
                file.close()
                os.chmod(file.name, path.stat().st_mode if path.exists() else 0o666 & ~_umask())
                os.replace(file.name, path)
            except BaseException:
                os.unlink(file.name)
                raise
    except OSError as error:
        raise HorizonError("%s cannot be written: %s" % (path.name, error.strerror)) from None


def require_writable(path):
    """Raises HorizonError if a file would replace a folder, or if opening it may block forever."""
    if path.is_dir():
        raise HorizonError("%s cannot be written: it is a folder" % path)
    if path.is_fifo() or path.is_socket():
        raise HorizonError("%s cannot be written: a pipe or socket, expected a file" % path)


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
