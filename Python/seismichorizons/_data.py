# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of the core: dictionaries of arrays, as C++ has them (Documentation/DataModel.md)."""

from __future__ import annotations

import pathlib
import re
import sys
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Data = dict[str, Any]
Progress = Callable[[float], Any]

# Names of attributes begin with this, so that none is taken for an array of the core.
MARK = ":"


def snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def give(values: NDArray[Any]) -> Any:
    """An array as the core takes it: numbers of up to 64 bits, or a list of texts."""
    if values.dtype.kind in "UOS":
        return [str(value) for value in values]
    if values.dtype.kind in "mM":
        return np.ascontiguousarray(values).view(np.int64)
    if values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):
        return np.ascontiguousarray(values, np.float64)
    return np.ascontiguousarray(values)


def take(values: Any, dtype: np.dtype[Any]) -> NDArray[Any]:
    """The inverse of `give`; numbers that the core averaged have the type of the given ones."""
    if isinstance(values, list):
        return np.array(values, dtype)
    taken: NDArray[Any] = values.view(dtype) if dtype.kind in "mM" else values.astype(dtype, copy=False)
    return taken


def give_attributes(attributes: Mapping[str, NDArray[Any]]) -> Data:
    return {MARK + name: give(values) for name, values in attributes.items()}


def unmarked(data: Data) -> Data:
    """Data with attributes by their names; those of the core come first."""
    points = data["point_data"]
    own = {name: values for name, values in points.items() if not name.startswith(MARK)}
    return {**data, "point_data": {**{name.removeprefix(MARK): values for name, values in points.items()}, **own}}


def take_attributes(arrays: Data, given: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Attributes that the core has kept, with the types that they were given with."""
    return {name: take(arrays[MARK + name], values.dtype) for name, values in given.items() if MARK + name in arrays}


def loops(cells: tuple[NDArray[Any], NDArray[Any]], is_closed: bool = True) -> list[NDArray[np.int32]]:
    """The points of each line; those of closed ones once."""
    offsets, points = cells
    lines = np.split(points.astype(np.int32), offsets[1:-1].astype(int)) if len(offsets) > 1 else []
    return [line[:-1] if is_closed else line for line in lines]


def give_lines(lines: list[NDArray[Any]]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    offsets = np.concatenate(([0], np.cumsum([len(line) for line in lines]))).astype(np.int64)
    return offsets, np.concatenate([np.zeros(0, np.int64), *lines]).astype(np.int64)


def give_triangles(triangles: NDArray[Any]) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    return np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int32), np.ascontiguousarray(triangles, np.int32).ravel()


def text(fields: Data, name: str) -> str:
    return fields[name][0] if name in fields else ""


# Field data of units and the coordinate system.
SURVEY = ("VerticalUnit", "VerticalDomain", "HorizontalUnit", "CoordinateSystem")


def survey(fields: Data) -> dict[str, str]:
    """Units and coordinate system, as keywords of horizons and meshes."""
    return {snake(name): text(fields, name) for name in SURVEY}


def give_survey(of: Any) -> Data:
    texts = {name: getattr(of, snake(name)) for name in SURVEY}
    return {"VerticalDirection": np.array([1 if of.direction == "up" else -1], np.int32),
            **{name: [value] for name, value in texts.items() if value}}


# The core speaks of properties and their values.
WORDS = {"VerticalDirection": "direction", "StrayPicks LeaveOut": "leave_out_strays=True", "StrayPicks": "leave_out_strays",
         "LatticeSource OriginAndSteps": "origin=, column_step= and row_step=", "NoLattice": "extract(cube, path)", "DuplicatePolicy": "duplicates",
         "LatticeTolerance": "tolerance", "NullValues": "nodata", "Gridding": "gridding=\"plate\"", "Columns": "columns", "the Fault Lines Reader": "read_faults(path)",
         "HeaderLines": "header_lines", "Where ": "where ", "Topmost": "topmost", "Lowest": "lowest", "Sheets": "sheets", "Mean": "mean",
         "VerticalStep": "vertical_step", "ColumnStep": "column_step", "RowStep": "row_step", "Origin ": "origin ",
         "MinimumPatchSize": "minimum_patch_size", "UpperWins": "upper_wins", "LowerWins": "lower_wins",
         "Domain EachLayer": "domain=\"each_layer\"", "EachLayer": "each_layer", "Missing Interpolate": "missing=\"interpolate\"",
         "Missing Follow": "missing=\"follow\"", "Common": "common", "Horizon From Points": "horizon(data, gridding=\"plate\")",
         "Order AsGiven": "order=\"as_given\"", "Horizon Exterior Boundary": "exterior_boundary(horizon)", "Horizon Layers": "layers(horizons)"}

WORDS |= {"InlineRange": "inlines", "CrosslineRange": "crosslines", "DelayPolicy": "delays", **{name: snake(name) for name in (
    "InlineByte", "CrosslineByte", "XByte", "YByte", "SampleFormat", "NumberOfSamples", "SampleRange", "IgnoreIncompleteTrace", "VerticalUnit",
    "HorizontalUnit")}}


def in_keywords(message: str) -> str:
    """A message of the core with keywords in place of properties."""
    for word, keyword in WORDS.items():
        message = message.replace(word, keyword)
    if "points on one line" in message or "positions, all on one line" in message or "positions of picks on one line" in message:
        message += "; origin=, column_step= and row_step= give it"
    return message.replace("direction Up", "direction=\"up\"").replace("direction Down", "direction=\"down\"").replace(
        "Down confirms", "direction=\"down\" confirms")


def nulls_of(nodata: str | float | Sequence[float] | None) -> str:
    """Numbers that mean no value, as text."""
    return nodata if isinstance(nodata, str) else " ".join(map(repr, map(float, np.ravel([] if nodata is None else nodata))))


def stem(path: pathlib.Path) -> str:
    """The name of a file without its extension, and that of gzip."""
    return (path.with_suffix("") if path.suffix.lower() == ".gz" else path).stem


def require_file(path: pathlib.Path) -> None:
    """Raises FileNotFoundError, or OSError for a folder and for what opening could wait for, such as a pipe."""
    if not path.exists():
        raise FileNotFoundError("%s: %s" % (path, "a link to a file that does not exist" if path.is_symlink() else "no such file"))
    if not path.is_file():
        raise OSError("%s: %s" % (path, "a directory, expected a file" if path.is_dir() else "a special file, expected a regular one"))


def warn(subject: object, message: str) -> None:
    """A warning at the line that called the package."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn("%s: %s" % (subject, message), stacklevel=level)


def warn_all(subject: object, messages: list[str]) -> None:
    """The warnings of the core, in keywords."""
    for message in filter(None, messages):
        warn(subject, in_keywords(message))


def call(name: str, stage: Callable[..., tuple[Any, list[str]]], *arguments: Any) -> Any:
    """The outputs of a stage of the core. Its warnings, and errors, name the horizon."""
    try:
        outputs, messages = stage(*arguments)
    except ValueError as error:
        raise ValueError("%s: %s" % (name, in_keywords(str(error)))) from None
    warn_all(name, messages)
    return outputs
