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
from ._data import Data, Progress, give_lines, in_keywords, loops, require_file, survey
from ._horizon import Floats, Horizon


@dataclasses.dataclass(eq=False, repr=False)
class Lines:
    """Lines in space.

    Attributes
    ----------
    names : list of str
        Of each line; sticks of one fault have its name and a number.
    lines : list of float64 arrays of shape (n, 3)
        x, y and z of the world, z upwards; closed where the last point is the first.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str
        Empty where unknown.
    """

    names: list[str]
    lines: list[Floats]
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""

    @staticmethod
    def of(names: list[str], data: Data, horizon: Horizon | None = None) -> Lines:
        """Lines from data of the core, of a horizon or with a survey of their own."""
        lines = [data["places"][line] for line in loops(data["lines"], False)]
        own = survey(data["field_data"]) if horizon is None else {
            name: getattr(horizon, name) for name in ("vertical_unit", "vertical_domain", "horizontal_unit", "coordinate_system")}
        return Lines(names, lines, **own)

    def __len__(self) -> int:
        return len(self.lines)

    def __iter__(self) -> Iterator[Floats]:
        return iter(self.lines)

    def __repr__(self) -> str:
        return "Lines: %d, of %d points" % (len(self), sum(map(len, self.lines)))

    def _data(self) -> Data:
        numbers = np.cumsum([0, *map(len, self.lines)])
        return {"places": np.ascontiguousarray(np.concatenate([np.zeros((0, 3)), *self.lines]), np.float64),
                "lines": give_lines([np.arange(first, last) for first, last in zip(numbers, numbers[1:])]),
                "cell_data": {"FaultName": list(self.names)}}

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
    lines: list[Lines]
    if hasattr(given, "geometry") and hasattr(given, "iterrows"):  # geopandas
        given = [np.asarray(part.coords, float) for shape in given.geometry for part in getattr(shape, "geoms", [shape])]
    if not isinstance(given, Sequence) or isinstance(given, str):
        raise TypeError("lines of %s, expected Lines, or a list of these or of arrays: read_faults(path) reads some" % type(given).__name__)
    if given and all(isinstance(one, Lines) for one in given):
        lines = list(given)
        return dataclasses.replace(lines[0], names=[name for one in lines for name in one.names], lines=[line for one in lines for line in one])
    arrays = [np.asarray(one, np.float64) for one in given]
    for number, array in enumerate(arrays):
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError("line %d of shape %s, expected (points, 3), or 2 for traces on the map" % (number, array.shape))
    names = ["%s %d" % (fault, number + 1) if fault else "%d 1" % (number + 1) for number in range(len(arrays))]
    return Lines(names,
                 [np.column_stack((array, np.zeros((len(array), 3 - array.shape[1])))) for array in arrays])


def read_faults(path: str | os.PathLike[str], *, direction: str = "", progress: Progress | None = None) -> Lines:
    """Reads traces, polygons or sticks of faults.

    Parameters
    ----------
    path : str or path
        GOCAD PLines, ZMAP and CPS-3 lines, Charisma sticks, and lines of x y z; by content.
    direction : "down" or "up", optional
        Where z increases to, if the file does not say it.
    progress : callable, optional

    Returns
    -------
    Lines

    Raises
    ------
    ValueError
        With the line, if the file violates its format.
    FileNotFoundError
    """
    require_file(pathlib.Path(path))
    try:
        data = _core.read_fault_lines(str(path), direction, progress)
    except ValueError as error:
        raise ValueError("%s: %s" % (path, in_keywords(str(error)))) from None
    return Lines.of(data["cell_data"].get("FaultName", [""] * (len(data["lines"][0]) - 1)), data)
