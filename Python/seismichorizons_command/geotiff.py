# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and writes horizons as GeoTIFF, by GDAL if it is installed: a value at the centre of each cell, on a lattice that
may be rotated."""

import uuid

import numpy as np
from seismichorizons import _core

from . import core, data
from .core import HorizonError

BEGINNINGS = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
NULL = 1e30
POSITIVE = "positive"  # band metadata: up or down, as in netCDF conventions; not set for elevations


def _load(path):
    """Loads GDAL with exceptions enabled. Raises HorizonError."""
    try:
        from osgeo import gdal, osr
    except ImportError:
        raise HorizonError("%s: GeoTIFF needs GDAL for Python, expected the package python3-gdal or the like"
                           % path.name) from None
    gdal.UseExceptions()
    osr.UseExceptions()
    return gdal, osr


def read(path):
    """Returns x, y and z of the single horizon of a file, its first band, and the properties that place it. Raises
    HorizonError."""
    gdal, osr = _load(path)
    try:
        file = gdal.Open(str(path))
        x, dx, rx, y, dy, ry = file.GetGeoTransform(can_return_null=True) or (None,) * 6
        values, null = file.GetRasterBand(1).ReadAsArray().astype(float), file.GetRasterBand(1).GetNoDataValue()
        system = file.GetSpatialRef()
    except RuntimeError as error:
        raise HorizonError("%s: GDAL cannot read it: %s" % (path.name, error)) from None
    if x is None:
        raise HorizonError("%s: a picture without places, expected a GeoTIFF with a transform" % path.name)
    if file.RasterCount != 1 or values.ndim != 2:
        raise HorizonError("%s: %d bands, expected one of heights" % (path.name, file.RasterCount))
    is_value = np.isfinite(values) & (True if null is None else values != null)
    j, i = np.nonzero(is_value)
    if not len(i):
        raise HorizonError("%s: no points, expected those of a horizon at least" % path)
    x, y = x + (i + 0.5) * dx + (j + 0.5) * rx, y + (i + 0.5) * dy + (j + 0.5) * ry
    is_down = str(file.GetRasterBand(1).GetMetadataItem(POSITIVE)).lower() == "down"
    properties = {"Origin": (x[0], y[0]), "ColumnStep": (dx, dy), "RowStep": (rx, ry), "VerticalDirection": "Down" if is_down else "Up"}
    if system is not None:
        authority = system.GetAuthorityCode(None)
        properties["CoordinateSystem"] = "EPSG:%s" % authority if authority else system.GetName()
    return {"x": x, "y": y, "z": values[is_value]}, properties


def make_content(mesh, path):
    """Returns the bytes of a file with the heights of a mesh on the columns that it covers, with z as in the original file
    of the horizon, and warnings. Raises HorizonError."""
    gdal, osr = _load(path)
    step_x, row_x, _, x, step_y, row_y, _, y = data.values(mesh, "LatticeToWorld")[:8]
    columns, rows = map(int, data.values(mesh, "LatticeDimensions")[:2])
    with core.errors("%s: " % path.name):
        column, heights = core.run(_core.sample, mesh, -1 if _counts_down(mesh) else 1, label="%s: writing" % path.name)
    values = np.full((rows, columns), NULL)
    values[column[:, 1], column[:, 0]] = heights
    place = "/vsimem/%s.tif" % uuid.uuid4().hex
    try:
        file = gdal.GetDriverByName("GTiff").Create(place, columns, rows, 1, gdal.GDT_Float64, ["COMPRESS=DEFLATE"])
        # The lattice origin is the centre of the first cell, a GDAL transform starts at its corner.
        file.SetGeoTransform((x - (step_x + row_x) / 2.0, step_x, row_x, y - (step_y + row_y) / 2.0, step_y, row_y))
        file.GetRasterBand(1).SetNoDataValue(NULL)
        file.GetRasterBand(1).SetMetadataItem(POSITIVE, "down" if _counts_down(mesh) else "up")
        file.GetRasterBand(1).WriteArray(values)
        warnings = _set_system(file, mesh, osr)
        file.FlushCache()
        del file
        stream = gdal.VSIFOpenL(place, "rb")
        content = bytes(gdal.VSIFReadL(1, gdal.VSIStatL(place).size, stream))
        gdal.VSIFCloseL(stream)
    except RuntimeError as error:
        raise HorizonError("%s cannot be written: %s" % (path.name, error)) from None
    finally:
        gdal.Unlink(place)
    return content, warnings


def _counts_down(mesh):
    """Whether z of the file that a mesh comes from, and therefore of the grid to write, increases downwards."""
    return data.vertical_direction(mesh) < 0


def _set_system(file, mesh, osr):
    """Sets the coordinate system of a file. Returns warnings."""
    name = data.text(mesh, "CoordinateSystem")
    if not name:
        return ["no coordinate system; --coordinate-system says which, as EPSG:23031"]
    system = osr.SpatialReference()
    try:
        system.SetFromUserInput(name)
        file.SetSpatialRef(system)
    except RuntimeError:
        return ["the coordinate system %s is none that GDAL knows; --coordinate-system says which, as EPSG:23031" %
                name]
    return []
