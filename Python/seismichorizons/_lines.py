# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines in space, as traces, polygons and sticks of faults."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from . import _core, _gdal
from ._data import Data, Progress, give_lines, give_survey, in_keywords, loops, nulls_of, require_file, survey
from ._horizon import Floats


@dataclasses.dataclass(eq=False, repr=False)
class Lines:
    """Lines in space, such as fault traces, polygons and sticks, or contours.

    Attributes
    ----------
    names : list of str
        The fault of each line, or the level of a contour; empty where unknown.
    lines : list of float64 arrays of shape (n, 3)
        x, y and z in world coordinates, with z upwards. Closed if the last point equals the first.
    sticks : list of str
        The stick number of each line in its fault; empty where unknown. For cutoffs the wall, "footwall" or "hanging
        wall".
    taken : tuple of str
        How each file was interpreted.
    direction : "down" or "up"
        Direction in which z increases in the files.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str
        Empty where unknown.
    """

    names: list[str]
    lines: list[Floats]
    sticks: list[str] = dataclasses.field(default_factory=list)
    taken: tuple[str, ...] = ()
    direction: str = "down"
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""

    def __post_init__(self) -> None:
        for what, texts in (("names", self.names), ("sticks", self.sticks or self.names)):
            if len(texts) != len(self.lines):
                raise ValueError("%d %s of %d lines, expected one for each" % (len(texts), what, len(self.lines)))
        self.sticks = list(self.sticks) or [""] * len(self.names)

    @staticmethod
    def of(data: Data, **more: Any) -> Lines:
        """Lines from data of the core."""
        lines = [data["places"][line] for line in loops(data["lines"], False)]
        cells, fields = data["cell_data"], data["field_data"]
        own: dict[str, Any] = {"direction": "up" if fields["VerticalDirection"][0] > 0 else "down", **survey(fields), **more}
        return Lines(cells.get("FaultName", [""] * len(lines)), lines, cells.get("FaultStick", []), **own)

    def __len__(self) -> int:
        return len(self.lines)

    def __iter__(self) -> Iterator[Floats]:
        return iter(self.lines)

    def __repr__(self) -> str:
        names = len(set(self.names) - {""})
        return "Lines: %d%s, %d points" % (len(self), " of %d name%s" % (names, "s" * (names > 1)) if names else "", sum(map(len, self.lines)))

    def _data(self) -> Data:
        numbers = np.cumsum([0, *map(len, self.lines)])
        return {"places": np.ascontiguousarray(np.concatenate([np.zeros((0, 3)), *self.lines]), np.float64),
                "lines": give_lines([np.arange(first, last) for first, last in zip(numbers, numbers[1:])]),
                "cell_data": {"FaultName": list(self.names), "FaultStick": list(self.sticks)}, "field_data": give_survey(self)}

    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with Fault, Stick, Line, X, Y and Z, with z upwards."""
        import pandas

        sizes = list(map(len, self.lines))
        x, y, z = np.concatenate([np.zeros((0, 3)), *self.lines]).T
        return pandas.DataFrame({"Fault": np.repeat(self.names, sizes), "Stick": np.repeat(self.sticks, sizes),
                                 "Line": np.repeat(np.arange(len(self)), sizes), "X": x, "Y": y, "Z": z})

    def to_geodataframe(self) -> Any:
        """Returns a geopandas GeoDataFrame of lines, with z upwards."""
        import geopandas
        import shapely

        return geopandas.GeoDataFrame({"Fault": self.names, "Stick": self.sticks}, geometry=[shapely.LineString(line) for line in self.lines],
                                      crs=self.coordinate_system or None)


def lines_of(given: Any, fault: str = "") -> Lines:
    """Lines from Lines, several of these, or arrays; these are sticks of a fault, given by name, or each a fault. Raises TypeError
    and ValueError."""
    if isinstance(given, Lines):
        return given
    if isinstance(given, (str, os.PathLike)):
        return read_faults(given)
    lines: list[Lines]
    if hasattr(given, "geometry") and hasattr(given, "iterrows"):
        return _of_geopandas(given)
    if not isinstance(given, Sequence) or isinstance(given, str):
        raise TypeError("lines of %s, expected Lines, or a list of these or of arrays: read_faults(path) reads some" % type(given).__name__)
    if given and all(isinstance(one, (str, os.PathLike)) for one in given):
        return read_faults(list(given))
    if given and all(isinstance(one, Lines) for one in given):
        lines = list(given)
        return dataclasses.replace(lines[0], names=[name for one in lines for name in one.names], lines=[line for one in lines for line in one],
                                   sticks=[stick for one in lines for stick in one.sticks],
                                   taken=tuple(text for one in lines for text in one.taken))
    arrays = [np.asarray(one, np.float64) for one in given]
    for number, array in enumerate(arrays):
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError("line %d of shape %s, expected (points, 3), or 2 for traces on the map" % (number, array.shape))
    numbers = [str(number + 1) for number in range(len(arrays))]
    return Lines([fault or number for number in numbers],
                 [np.column_stack((array, np.zeros((len(array), 3 - array.shape[1])))) for array in arrays], numbers)


def _of_geopandas(frame: Any) -> Lines:
    """Lines of a GeoDataFrame, with the names of its column Fault or name."""
    columns = {str(column).lower(): column for column in frame.columns}
    name, stick = (next((columns[word] for word in words if word in columns), None) for words in (_gdal.FAULT_NAMES, ("stick",)))
    names, sticks, lines = [], [], []
    for _, row in frame.iterrows():
        for part in getattr(row.geometry, "geoms", [row.geometry]):
            points = np.asarray(getattr(part, "exterior", part).coords, float)
            names.append(str(row[name]) if name is not None else "")
            sticks.append(str(row[stick]) if stick is not None else "")
            lines.append(np.column_stack((points, np.zeros((len(points), 3 - points.shape[1])))))
    return Lines(names, lines, sticks, direction="up", coordinate_system=str(frame.crs or ""))


def read_faults(path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, columns: str | Sequence[str] = "",
                nodata: str | float | Sequence[float] | None = None, header_lines: int = 0, direction: str = "",
                progress: Progress | None = None) -> Lines:
    """Reads fault traces, polygons or sticks.

    Parameters
    ----------
    path : str or path, or a list of these
        Tables of points with columns for faults and sticks, GOCAD PLines, ZMAP and CPS-3 lines, IRAP polygons, and
        sticks of Charisma and IESX, recognised by content; GeoPackage, shapefiles and GeoJSON by extension, with GDAL.
        Of several files, unnamed lines are named after their file.
    columns : str or list of str, optional
        Columns of a table, as "X Y Z Fault Stick Node", if they are not recognised.
    nodata : number, list of numbers, or str, optional
        Values that mark missing z; such points are left out.
    header_lines : int
        Lines to skip at the beginning of a file.
    direction : "down" or "up", optional
        Direction in which z increases, if the file does not state it.
    progress : callable, optional

    Returns
    -------
    Lines
        `taken` describes how each file was interpreted.

    Raises
    ------
    ValueError
        If a file violates its format; the message gives the file and line.
    FileNotFoundError
    """
    paths = [pathlib.Path(one) for one in ([path] if isinstance(path, (str, os.PathLike)) else path)]
    for one in paths:
        require_file(one)
    maps = [one for one in paths if one.suffix.lower() in _gdal.LINES]
    if maps and len(paths) > 1:
        return lines_of([read_faults(one, columns=columns, nodata=nodata, header_lines=header_lines, direction=direction, progress=progress)
                         for one in paths])
    if maps:
        found = Lines(**_gdal.read_lines(maps[0], direction))
        z = -np.concatenate(found.lines)[:, 2] if found.direction == "down" else np.concatenate(found.lines)[:, 2]
        return dataclasses.replace(found, taken=("%s: %d lines, z %.7g to %.7g %s" % (maps[0].name, len(found), z.min(), z.max(), found.direction),))
    options = {"columns": columns if isinstance(columns, str) else " ".join(columns), "nulls": nulls_of(nodata), "header_lines": int(header_lines)}
    try:
        data, description = _core.read_fault_lines(list(map(str, paths)), options, direction, progress)
    except ValueError as error:
        raise ValueError(in_keywords(str(error))) from None
    return Lines.of(data, taken=tuple(description.splitlines()))
