# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines in formats of maps, by GDAL if it is installed."""

from __future__ import annotations

import pathlib
import uuid
from typing import Any

import numpy as np

READ = (".gpkg", ".shp", ".geojson")
WRITTEN = ".gpkg"
# Attributes: the fault, the number of the line in it, and where z increases to.
FAULT, STICK, POSITIVE = "Fault", "Stick", "Positive"
FAULT_NAMES = ("fault", "fault_name", "faultname", "name")


def _load(path: pathlib.Path) -> tuple[Any, Any]:
    try:
        from osgeo import ogr, osr
    except ImportError:
        raise ImportError("%s: maps of lines need GDAL for Python, expected the package python3-gdal or the like" % path.name) from None
    ogr.UseExceptions()
    osr.UseExceptions()
    return ogr, osr


def _places(geometry: Any) -> list[Any]:
    """The points of each line and ring."""
    if geometry.GetGeometryCount():
        return [places for n in range(geometry.GetGeometryCount()) for places in _places(geometry.GetGeometryRef(n))]
    points = np.array(geometry.GetPoints() or [], float).reshape(geometry.GetPointCount(), -1)
    return [np.column_stack((points, np.zeros((len(points), 3 - points.shape[1]))))] if len(points) > 1 else []


def read(path: pathlib.Path, direction: str) -> dict[str, Any]:
    """Names, sticks, lines with z upwards, direction and coordinate system of the lines and polygons of a map."""
    ogr, _ = _load(path)
    names, sticks, lines, system, found = [], [], [], "", direction
    try:
        file = ogr.Open(str(path))
        for layer in file:
            fields = {field.GetName().lower(): field.GetName() for field in layer.schema}
            name = next((fields[word] for word in FAULT_NAMES if word in fields), None)
            given = layer.GetSpatialRef()
            if given is not None:
                system = "EPSG:%s" % given.GetAuthorityCode(None) if given.GetAuthorityCode(None) else given.GetName()
            for feature in layer:
                found = found or (POSITIVE.lower() in fields and feature.GetField(fields[POSITIVE.lower()])) or ""
                for places in _places(feature.GetGeometryRef()) if feature.GetGeometryRef() is not None else ():
                    names.append(str(feature.GetField(name) or "") if name else "")
                    sticks.append(str(feature.GetField(fields["stick"]) or "") if "stick" in fields else "")
                    lines.append(places)
    except RuntimeError as error:
        raise ValueError("%s: GDAL cannot read it: %s" % (path, error)) from None
    if not lines:
        raise ValueError("%s: no lines, expected lines or polygons of faults" % path)
    z = np.concatenate(lines)[:, 2]
    found = found or ("up" if z.max() <= 0.0 > z.min() else "down")
    if found == "down":
        lines = [places * (1.0, 1.0, -1.0) for places in lines]
    return {"names": names, "sticks": sticks, "lines": lines, "direction": found, "coordinate_system": system}


def content(lines: Any, path: pathlib.Path, direction: str) -> bytes:
    """The bytes of a GeoPackage with a line for each of Lines."""
    ogr, osr = _load(path)
    from osgeo import gdal

    system = osr.SpatialReference()
    try:
        system.SetFromUserInput(lines.coordinate_system) if lines.coordinate_system else None
    except RuntimeError:
        raise ValueError("%s: the coordinate system %s is none that GDAL knows, expected one as EPSG:23031" % (path, lines.coordinate_system)) from None
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
        stream = gdal.VSIFOpenL(place, "rb")
        read_back = bytes(gdal.VSIFReadL(1, gdal.VSIStatL(place).size, stream))
        gdal.VSIFCloseL(stream)
    except RuntimeError as error:
        raise ValueError("%s cannot be written: %s" % (path.name, error)) from None
    finally:
        gdal.Unlink(place)
    return read_back
