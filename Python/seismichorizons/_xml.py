# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of VTK, .vtp and .vtu, with all arrays. Binary data are in base64, as appended data fail in readers of VTK up to 9.2
with a recent Expat library."""

from __future__ import annotations

import base64
import zlib
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._data import Data

BLOCK = 1 << 20  # bytes that are compressed together
LEVEL = 5  # of VTK
TYPES = {"f4": "Float32", "f8": "Float64", "i1": "Int8", "u1": "UInt8", "i2": "Int16", "u2": "UInt16", "i4": "Int32", "u4": "UInt32",
         "i8": "Int64", "u8": "UInt64"}


def poly_data(data: Data) -> bytes:
    """The content of a .vtp file with the points, lines, polygons and arrays of data of the core."""
    size = len(data["places"])
    none = (np.zeros(1, np.int64), np.zeros(0, np.int64))
    cells = {"Lines": data.get("lines", none), "Polys": data.get("polygons", none)}
    own = np.arange(size, dtype=np.int64)
    has_cells = any(len(offsets) > 1 for offsets, _ in cells.values())
    vertices = (np.append(own, size), own) if data.get("has_vertices") or not has_cells else none
    cells = {"Verts": vertices, "Lines": cells["Lines"], "Strips": none, "Polys": cells["Polys"]}
    counts = "".join(' NumberOf%s="%d"' % (name, max(0, len(offsets) - 1)) for name, (offsets, _) in cells.items())
    parts = [_points(data["places"]), *(_cells(name, *given) for name, given in cells.items())]
    return _file("PolyData", data, counts, size, parts)


def unstructured_grid(data: Data) -> bytes:
    """The content of a .vtu file with the cells and arrays of layers of the core."""
    offsets, corners = data["cells"]
    types = np.asarray(data["types"], np.uint8)
    parts = [_points(data["places"]), "<Cells>%s%s%s</Cells>" % (
        _array(corners, "connectivity"), _array(offsets[1:], "offsets"), _array(types, "types"))]
    return _file("UnstructuredGrid", data, ' NumberOfCells="%d"' % len(types), len(data["places"]), parts)


def _file(kind: str, data: Data, counts: str, size: int, parts: Iterable[str]) -> bytes:
    fields = "".join(_array(values, name, True) for name, values in data["field_data"].items())
    return "".join((
        '<?xml version="1.0"?>\n<VTKFile type="%s" version="1.0" byte_order="LittleEndian" header_type="UInt64" '
        'compressor="vtkZLibDataCompressor">\n<%s>\n<FieldData>\n%s</FieldData>\n<Piece NumberOfPoints="%d"%s>\n' % (
            kind, kind, fields, size, counts),
        _attributes("PointData", data["point_data"]), _attributes("CellData", data.get("cell_data", {})), *parts,
        "</Piece>\n</%s>\n</VTKFile>\n" % kind)).encode()


def _attributes(name: str, arrays: Data) -> str:
    return "<%s>\n%s</%s>\n" % (name, "".join(_array(values, own) for own, values in arrays.items()), name)


def _points(places: NDArray[Any]) -> str:
    return "<Points>\n%s</Points>\n" % _array(places, "Points")


def _cells(name: str, offsets: NDArray[Any], points: NDArray[Any]) -> str:
    return "<%s>\n%s%s</%s>\n" % (name, _array(points, "connectivity"), _array(offsets[1:], "offsets"), name)


def _array(values: Any, name: str, with_size: bool = False) -> str:
    """An array, or a list of texts."""
    if isinstance(values, list):
        content = np.frombuffer("".join(text + "\0" for text in values).encode(), np.uint8)
        kind, components = "String", 1
    else:
        content = np.ascontiguousarray(values, values.dtype.newbyteorder("<"))
        kind, components = TYPES[content.dtype.str[1:]], 1 if values.ndim == 1 else values.shape[1]
    size = ' NumberOfTuples="%d"' % len(values) if with_size or kind == "String" else ""
    return '<DataArray type="%s" Name="%s" NumberOfComponents="%d"%s format="binary">\n%s\n</DataArray>\n' % (
        kind, _escaped(name), components, size, _encoded(content))


def _encoded(content: NDArray[Any]) -> str:
    """Compressed blocks behind their number, size and the sizes of the compressed ones, in base64."""
    octets = content.tobytes()
    blocks = [zlib.compress(octets[first:first + BLOCK], LEVEL) for first in range(0, len(octets), BLOCK)]
    header = np.array([len(blocks), BLOCK, len(octets) % BLOCK, *map(len, blocks)], "<u8")
    return base64.b64encode(header.tobytes()).decode() + base64.b64encode(b"".join(blocks)).decode()


def _escaped(name: str) -> str:
    for sign, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        name = name.replace(sign, entity)
    return name
