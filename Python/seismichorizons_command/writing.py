# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Results as files: meshes, points, cells of layers, and tables of figures.

Each format has one writer, shared with ParaView. A file is written under a temporary name, checked and renamed; if that
fails, an existing file is unchanged.
"""

import csv
import io

from seismichorizons import Lines, _core, _files, _gdal, _xml

from . import core, data
from .core import HorizonError

MESH_FORMATS = ("vtp", "ts", "stl", "ply", "obj", "dxf")
GRID_FORMATS = ("irap", "gri", "zmap", "cps3", "grd", "asc", "tif")  # GeoTIFF is written by GDAL.
POINT_FORMATS = {"dat": "text", "vsm": "vsm"}
FAULT_LINES = {"fault_lines": "faults"}  # ends of names, and their stages
CUTOFF_LINES = {"cutoffs": "cutoffs", "fault_polygons": "polygons"}  # the same, of cutoffs
LAYER_FORMATS = ("msh", "inp", "disv")  # for cells of layers, in addition to .vtu
FORMULA_SIGNS = ("=", "+", "-", "@", "\t", "\r")  # first characters of formulas in spreadsheets


def is_of_points(form, grids_of_meshes=False):
    """Whether a format has the points of a horizon, and not its mesh."""
    return form in POINT_FORMATS or form in GRID_FORMATS and not grids_of_meshes


def write(result, path, grids_of_meshes=False, direction=""):
    """Writes a result (pipeline.Result) in the format of the file extension: its mesh, or the points from which the mesh
    was made. Returns warnings. Raises HorizonError."""
    is_mesh = not is_of_points(path.suffix[1:], grids_of_meshes)
    return write_data(result.data["mesh"] if is_mesh else prepared(result), path, result.name, direction)


def prepared(result):
    """Returns the points from which a mesh was made."""
    return next(result.data[name] for name in ("filled", "torn", "despiked", "points") if name in result.data)


def write_data(given, path, name, direction=""):
    """Writes a mesh or the points of a horizon, with a name, in the format of the file extension. z increases in a direction,
    or as in the input. Returns warnings. Raises HorizonError."""
    form = path.suffix[1:]
    if form == "tif":
        direction = direction or ("down" if data.vertical_direction(given) < 0 else "up")
        with core.errors():
            content, warnings = core.run(lambda progress: _gdal.image(given, path, direction, progress), label="%s: writing" % path.name)
        write_file(content, path)
        return [warning.replace("CoordinateSystem", "--coordinate-system") for warning in warnings]
    if form == "vtp":
        write_file(_xml.poly_data(given), path)
        return []
    way = {"sense": direction, "is_down": direction == "down"} if direction else {}
    return _run(path, _core.write, POINT_FORMATS.get(form, form), [(name, given)], {"arrays": "picks", **way})


def write_fault_lines(lines, path, direction=""):
    """Writes fault lines or cutoffs, unless there are none. Raises HorizonError."""
    if data.count_lines(lines):
        _run(path, lambda place, given, progress: _files.write(given, place, direction=direction, progress=progress), Lines.of(lines))


def write_cells(grid, path):
    """Writes cells of layers in the format of the file extension. Returns warnings. Raises HorizonError."""
    if path.suffix == ".vtu":
        write_file(_xml.unstructured_grid(grid), path)
        return []
    return _run(path, _core.write_layers, grid) or []


def write_sealed(surfaces, path):
    """Writes a sealed model in the format of the file extension. Raises HorizonError."""
    if path.suffix == ".vtp":
        write_file(_xml.poly_data(surfaces), path)
    else:
        _run(path, _core.write_sealed, surfaces)


def _run(path, function, *arguments):
    """Writes a file and returns warnings. Errors name the file without its folder, which may be a temporary one. Raises
    HorizonError, which says "cannot be written" for errors of the file system."""
    require_writable(path)
    label = "%s: writing" % path.name
    try:
        return core.run(lambda *given: _as_own(function, *given), str(path), *arguments, label=label)
    except _DiskError as error:
        raise HorizonError("%s cannot be written: %s" % (path.name, str(error).replace("%s: " % path, "", 1))) from None
    except HorizonError as error:
        raise HorizonError("%s: %s" % (path.name, str(error).replace("%s: " % path, "", 1))) from None


class _DiskError(HorizonError):
    """An error of the file system."""


def _as_own(function, *arguments):
    try:
        return function(*arguments)
    except OSError as error:
        raise _DiskError(str(error)) from None


def write_tables(tables, path):
    """Writes tables with the same columns as one file of comma-separated values. Raises HorizonError."""
    text = io.StringIO()
    writer = csv.writer(text)
    for number, table in enumerate(tables):
        if number == 0:
            writer.writerow(table)
        writer.writerows([_cell(value) for value in row] for row in zip(*map(list, table.values())))
    write_file(text.getvalue().encode(), path)


def _cell(value):
    """Returns the text of a value, quoted if a spreadsheet would interpret it as a formula."""
    if isinstance(value, str):
        return "'" + value if value.startswith(FORMULA_SIGNS) else value
    return repr(float(value)) if isinstance(value, float) else str(value)


def write_file(content, path):
    """Writes bytes under a temporary name and renames the file when it is complete. A device is written to directly. Raises
    HorizonError."""
    require_writable(path)
    try:
        _core.write_contents(str(path), [("", content)])
    except OSError as error:
        raise HorizonError("%s cannot be written: %s" % (path.name, error)) from None


def require_writable(path):
    """Raises HorizonError if a file would replace a folder, or if opening it may block forever."""
    if path.is_dir():
        raise HorizonError("%s cannot be written: it is a folder" % path)
    if path.is_fifo() or path.is_socket():
        raise HorizonError("%s cannot be written: a pipe or socket, expected a file" % path)
