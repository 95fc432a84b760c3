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

from . import _core
from ._data import SURVEY, Data, Progress, give_lines, in_keywords, loops, nulls_of, require_file, snake, survey
from ._horizon import Floats, Horizon


@dataclasses.dataclass(eq=False, repr=False)
class Lines:
    """Lines in space.

    Attributes
    ----------
    names : list of str
        The fault of each line; empty where unknown.
    lines : list of float64 arrays of shape (n, 3)
        x, y and z of the world, z upwards; closed where the last point is the first.
    sticks : list of str
        The number of each line in its fault. Without any, the last word of a name is the number.
    taken : tuple of str
        What each file was taken for.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str
        Empty where unknown.
    """

    names: list[str]
    lines: list[Floats]
    sticks: list[str] = dataclasses.field(default_factory=list)
    taken: tuple[str, ...] = ()
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""

    @staticmethod
    def of(names: list[str], data: Data, horizon: Horizon | None = None, **more: Any) -> Lines:
        """Lines from data of the core, of a horizon or with a survey of their own."""
        lines = [data["places"][line] for line in loops(data["lines"], False)]
        own = survey(data["field_data"]) if horizon is None else {
            name: getattr(horizon, name) for name in map(snake, SURVEY)}
        return Lines(names, lines, **own, **more)

    def __len__(self) -> int:
        return len(self.lines)

    def __iter__(self) -> Iterator[Floats]:
        return iter(self.lines)

    def __repr__(self) -> str:
        faults = len(set(self.names) - {""}) if self.sticks else 0
        return "Lines: %s%d, of %d points" % ("%d faults, " % faults if faults else "", len(self), sum(map(len, self.lines)))

    def _names_and_sticks(self) -> list[tuple[str, str]]:
        if self.sticks:
            return list(zip(self.names, self.sticks))
        return [(name[:blank], name[blank + 1:]) if blank > 0 else (name, "") for name in self.names for blank in [name.rfind(" ")]]

    def _data(self) -> Data:
        numbers = np.cumsum([0, *map(len, self.lines)])
        return {"places": np.ascontiguousarray(np.concatenate([np.zeros((0, 3)), *self.lines]), np.float64),
                "lines": give_lines([np.arange(first, last) for first, last in zip(numbers, numbers[1:])]),
                "cell_data": {"FaultName": list(self.names), **({"FaultStick": list(self.sticks)} if self.sticks else {})}}

    def to_dataframe(self) -> Any:
        """A pandas DataFrame with Name, Line, X, Y, Z; z is upwards."""
        import pandas

        sizes = list(map(len, self.lines))
        x, y, z = np.concatenate([np.zeros((0, 3)), *self.lines]).T
        return pandas.DataFrame({"Name": np.repeat(self.names, sizes), "Line": np.repeat(np.arange(len(self)), sizes), "X": x, "Y": y, "Z": z})

    def to_geodataframe(self) -> Any:
        """A geopandas GeoDataFrame of lines; z is upwards."""
        import geopandas
        import shapely

        return geopandas.GeoDataFrame({"name": self.names}, geometry=[shapely.LineString(line) for line in self.lines],
                                      crs=self.coordinate_system or None)


def lines_of(given: Any, fault: str = "") -> Lines:
    """Lines from Lines, several of these, or arrays; these are sticks of a fault, given by name, or each a fault. Raises TypeError
    and ValueError."""
    if isinstance(given, Lines):
        return given
    if isinstance(given, (str, os.PathLike)):
        return read_faults(given)
    lines: list[Lines]
    if hasattr(given, "geometry") and hasattr(given, "iterrows"):  # geopandas
        given = [np.asarray(part.coords, float) for shape in given.geometry for part in getattr(shape, "geoms", [shape])]
    if not isinstance(given, Sequence) or isinstance(given, str):
        raise TypeError("lines of %s, expected Lines, or a list of these or of arrays: read_faults(path) reads some" % type(given).__name__)
    if given and all(isinstance(one, (str, os.PathLike)) for one in given):
        return read_faults(list(given))
    if given and all(isinstance(one, Lines) for one in given):
        lines = list(given)
        faults, sticks = zip(*(pair for one in lines for pair in one._names_and_sticks()))
        return dataclasses.replace(lines[0], names=list(faults), lines=[line for one in lines for line in one], sticks=list(sticks),
                                   taken=tuple(text for one in lines for text in one.taken))
    arrays = [np.asarray(one, np.float64) for one in given]
    for number, array in enumerate(arrays):
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError("line %d of shape %s, expected (points, 3), or 2 for traces on the map" % (number, array.shape))
    names = ["%s %d" % (fault, number + 1) if fault else "%d 1" % (number + 1) for number in range(len(arrays))]
    return Lines(names,
                 [np.column_stack((array, np.zeros((len(array), 3 - array.shape[1])))) for array in arrays])


def read_faults(path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]], *, columns: str | Sequence[str] = "",
                nodata: str | float | Sequence[float] | None = None, header_lines: int = 0, direction: str = "",
                progress: Progress | None = None) -> Lines:
    """Reads traces, polygons or sticks of faults.

    Parameters
    ----------
    path : str or path, or a list of these
        Tables of points with columns of faults and sticks, GOCAD PLines, ZMAP and CPS-3 lines, polygons of IRAP, sticks of Charisma
        and IESX; by content. Lines without a name get that of their file if there are several.
    columns : str or list of str, optional
        What the columns of a table are, as "X Y Z Fault Stick Node", where they are not found.
    nodata : number, list of numbers, or str, optional
        Values that mean no z; such points are left out.
    header_lines : int
        Lines to skip at the beginning of a file.
    direction : "down" or "up", optional
        Where z increases to, if the file does not say it.
    progress : callable, optional

    Returns
    -------
    Lines
        `taken` says what each file was taken for.

    Raises
    ------
    ValueError
        With the file and the line, if a file violates its format.
    FileNotFoundError
    """
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    for one in paths:
        require_file(pathlib.Path(one))
    options = {"columns": columns if isinstance(columns, str) else " ".join(columns), "nulls": nulls_of(nodata), "header_lines": int(header_lines)}
    try:
        data, description = _core.read_fault_lines(list(map(str, paths)), options, direction, progress)
    except ValueError as error:
        raise ValueError(in_keywords(str(error))) from None
    none = [""] * (len(data["lines"][0]) - 1)
    return Lines.of(data["cell_data"].get("FaultName", none), data, sticks=data["cell_data"].get("FaultStick", []),
                    taken=tuple(description.splitlines()))
