# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoTIFF, a value at the centre of each cell on a lattice that may be rotated, and lines in formats of maps, by GDAL if it is
installed."""

from __future__ import annotations

import pathlib
import uuid
from typing import Any

import numpy as np

from . import _core
from ._data import Data, Progress, text

BEGINNINGS = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")  # of TIFF
NULL = 1e30
POSITIVE_OF_BAND = "positive"  # metadata: up or down, as in netCDF conventions; not set for elevations
LINES = (".gpkg", ".shp", ".geojson")
WRITTEN_LINES = ".gpkg"
# Attributes: the fault, the number of the line in it, and where z increases to.
FAULT, STICK, POSITIVE = "Fault", "Stick", "Positive"
FAULT_NAMES = ("fault", "fault_name", "faultname", "name")


def _load(path: pathlib.Path) -> tuple[Any, Any, Any]:
    try:
        from osgeo import gdal, ogr, osr
    except ImportError:
        raise ImportError("%s: GeoTIFF and maps of lines need GDAL for Python, expected the package python3-gdal or the like" % path.name) from None
    for module in (gdal, ogr, osr):
        module.UseExceptions()
    return gdal, ogr, osr


def _system_name(system: Any) -> str:
    if system is None:
        return ""
    authority = system.GetAuthorityCode(None)
    return "EPSG:%s" % authority if authority else str(system.GetName())


def _take_bytes(gdal: Any, place: str) -> bytes:
    """The bytes of a file in memory."""
    stream = gdal.VSIFOpenL(place, "rb")
    content = bytes(gdal.VSIFReadL(1, gdal.VSIStatL(place).size, stream))
    gdal.VSIFCloseL(stream)
    return content


# ---- GeoTIFF ----------------------------------------------------------------------------------------------------------
def read_image(path: pathlib.Path) -> tuple[dict[str, Any], dict[str, Any]]:
    """x, y and z of the first band, and origin, column_step, row_step, direction and coordinate_system."""
    gdal, _, _ = _load(path)
    try:
        file = gdal.Open(str(path))
        transform: Any = file.GetGeoTransform(can_return_null=True)
        band = file.GetRasterBand(1)
        values, null = band.ReadAsArray().astype(float), band.GetNoDataValue()
        system = _system_name(file.GetSpatialRef())
    except RuntimeError as error:
        raise ValueError("%s: GDAL cannot read it: %s" % (path.name, error)) from None
    if transform is None:
        raise ValueError("%s: an image without coordinates, expected a GeoTIFF with a transform" % path.name)
    if file.RasterCount != 1 or values.ndim != 2:
        raise ValueError("%s: %d bands, expected one of heights" % (path.name, file.RasterCount))
    is_value = np.isfinite(values) & (True if null is None else values != null)
    j, i = np.nonzero(is_value)
    if not len(i):
        raise ValueError("%s: no points, expected those of a horizon" % path)
    x, dx, rx, y, dy, ry = transform
    x, y = x + (i + 0.5) * dx + (j + 0.5) * rx, y + (i + 0.5) * dy + (j + 0.5) * ry
    is_down = str(band.GetMetadataItem(POSITIVE_OF_BAND)).lower() == "down"
    return {"x": x, "y": y, "z": values[is_value]}, {
        "origin": (x[0], y[0]), "column_step": (dx, dy), "row_step": (rx, ry), "direction": "down" if is_down else "up",
        "coordinate_system": system}


def image(data: Data, path: pathlib.Path, direction: str, progress: Progress | None) -> tuple[bytes, list[str]]:
    """The bytes of a file with z of points, or of a mesh at the columns that it covers; and warnings."""
    gdal, _, osr = _load(path)
    step_x, row_x, _, x, step_y, row_y, _, y = np.ravel(data["field_data"]["LatticeToWorld"])[:8].tolist()
    columns, rows = np.ravel(data["field_data"]["LatticeDimensions"])[:2].tolist()
    column, heights = _core.sample(data, -1 if direction == "down" else 1, progress)
    values = np.full((rows, columns), NULL)
    values[column[:, 1], column[:, 0]] = heights
    place = "/vsimem/%s.tif" % uuid.uuid4().hex
    try:
        file = gdal.GetDriverByName("GTiff").Create(place, columns, rows, 1, gdal.GDT_Float64, ["COMPRESS=DEFLATE"])
        # The lattice origin is the centre of the first cell, a GDAL transform starts at its corner.
        file.SetGeoTransform((x - (step_x + row_x) / 2.0, step_x, row_x, y - (step_y + row_y) / 2.0, step_y, row_y))
        file.GetRasterBand(1).SetNoDataValue(NULL)
        file.GetRasterBand(1).SetMetadataItem(POSITIVE_OF_BAND, direction)
        file.GetRasterBand(1).WriteArray(values)
        warnings = _set_system(file, text(data["field_data"], "CoordinateSystem"), osr)
        file.FlushCache()
        del file
        return _take_bytes(gdal, place), warnings
    except RuntimeError as error:
        raise ValueError("%s cannot be written: %s" % (path.name, error)) from None
    finally:
        gdal.Unlink(place)


def _set_system(file: Any, name: str, osr: Any) -> list[str]:
    """Sets the coordinate system of a file. Returns warnings."""
    if not name:
        return ["no coordinate system; CoordinateSystem says which, as EPSG:23031"]
    system = osr.SpatialReference()
    try:
        system.SetFromUserInput(name)
        file.SetSpatialRef(system)
    except RuntimeError:
        return ["the coordinate system %s is unknown to GDAL: set CoordinateSystem, for example to EPSG:23031" % name]
    return []


# ---- Lines ------------------------------------------------------------------------------------------------------------
def _places(geometry: Any) -> list[Any]:
    """The points of each line and ring."""
    if geometry.GetGeometryCount():
        return [places for n in range(geometry.GetGeometryCount()) for places in _places(geometry.GetGeometryRef(n))]
    points = np.array(geometry.GetPoints() or np.zeros((0, 3)), float)
    return [np.column_stack((points, np.zeros((len(points), 3 - points.shape[1]))))] if len(points) > 1 else []


def read_lines(path: pathlib.Path, direction: str) -> dict[str, Any]:
    """Names, sticks, lines with z upwards, direction and coordinate system of the lines and polygons of a map."""
    _, ogr, _ = _load(path)
    names: list[str] = []
    sticks: list[str] = []
    lines: list[Any] = []
    ways: list[str] = []  # where z of each line increases to
    system = ""
    try:
        file = ogr.Open(str(path))
        if file is None:
            raise ValueError("%s: GDAL cannot read it, expected a map of lines" % path)
        for layer in file:
            fields = {field.GetName().lower(): field.GetName() for field in layer.schema}
            name = next((fields[word] for word in FAULT_NAMES if word in fields), None)
            system = _system_name(layer.GetSpatialRef()) or system
            for feature in layer:
                own = direction or (POSITIVE.lower() in fields and feature.GetField(fields[POSITIVE.lower()])) or ""
                for places in _places(feature.GetGeometryRef()) if feature.GetGeometryRef() is not None else ():
                    names.append(str(feature.GetField(name) or "") if name else "")
                    sticks.append(str(feature.GetField(fields["stick"]) or "") if "stick" in fields else "")
                    lines.append(places)
                    ways.append(own)
    except RuntimeError as error:
        raise ValueError("%s: GDAL cannot read it: %s" % (path, error)) from None
    if not lines:
        raise ValueError("%s: no lines, expected lines or polygons of faults" % path)
    z = np.concatenate(lines)[:, 2]
    ways = [way or ("up" if z.max() <= 0.0 > z.min() else "down") for way in ways]
    lines = [places * (1.0, 1.0, -1.0 if way == "down" else 1.0) for places, way in zip(lines, ways)]
    return {"names": names, "sticks": sticks, "lines": lines, "direction": ways[0], "coordinate_system": system}


def map_of_lines(lines: Any, path: pathlib.Path, direction: str) -> bytes:
    """The bytes of a GeoPackage with a line for each of Lines."""
    gdal, ogr, osr = _load(path)

    system = osr.SpatialReference()
    try:
        system.SetFromUserInput(lines.coordinate_system) if lines.coordinate_system else None
    except RuntimeError:
        raise ValueError("%s: the coordinate system %s is unknown to GDAL, expected one such as EPSG:23031" % (path, lines.coordinate_system)) from None
    place = "/vsimem/%s.gpkg" % uuid.uuid4().hex
    try:
        file = ogr.GetDriverByName("GPKG").CreateDataSource(place)
        layer = file.CreateLayer("faults", system if lines.coordinate_system else None, ogr.wkbLineString25D)
        for name in (FAULT, STICK, POSITIVE):
            layer.CreateField(ogr.FieldDefn(name, ogr.OFTString))
        layer.StartTransaction()
        for fault, stick, points in zip(lines.names, lines.sticks, lines.lines):
            feature, geometry = ogr.Feature(layer.GetLayerDefn()), ogr.Geometry(ogr.wkbLineString25D)
            for x, y, z in points.tolist():
                geometry.AddPoint(x, y, z if direction == "up" else -z)
            feature.SetGeometry(geometry)
            for name, value in ((FAULT, fault), (STICK, stick), (POSITIVE, direction)):
                feature.SetField(name, value)
            layer.CreateFeature(feature)
        layer.CommitTransaction()
        del layer, file
        return _take_bytes(gdal, place)
    except RuntimeError as error:
        raise ValueError("%s cannot be written: %s" % (path.name, error)) from None
    finally:
        gdal.Unlink(place)
