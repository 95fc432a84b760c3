# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from what the core gives, and the options that readers and `horizon` share."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from . import _core
from ._horizon import Horizon, Lattice
from ._units import UNITS

POLICIES = ("strongest", "topmost", "lowest", "mean", "sheets")


def placement(duplicates: str = "strongest", gridding: str = "", leave_out_strays: bool = False, tolerance: float = 0.1,
              **lattice: Any) -> dict[str, Any]:
    """The options of placing points on a lattice. Raises ValueError."""
    if duplicates not in POLICIES:
        raise ValueError("duplicates '%s', expected one of %s" % (duplicates, ", ".join(POLICIES)))
    if gridding not in ("", "plate", "nearest"):
        raise ValueError("gridding '%s', expected plate or nearest" % gridding)
    return {"duplicates": duplicates, "gridding": gridding, "leave_out_strays": bool(leave_out_strays),
            "tolerance": float(tolerance), **{name: tuple(map(float, value)) for name, value in lattice.items()}}


def framing(vertical_step: float | None, direction: str, vertical_unit: str, vertical_domain: str, horizontal_unit: str,
            coordinate_system: str) -> tuple[float, str, tuple[str, str, str, str]]:
    """The arguments of the core for the place of horizons. Raises ValueError."""
    if direction not in ("", "down", "up"):
        raise ValueError("direction '%s', expected down or up" % direction)
    if vertical_unit and not vertical_domain and _core.short_unit(vertical_unit) not in UNITS:
        raise ValueError("vertical_unit '%s', expected one of %s, or vertical_domain beside it" % (vertical_unit, ", ".join(UNITS)))
    if vertical_step is not None and not vertical_step > 0.0:
        raise ValueError("vertical_step %s, expected more than 0" % vertical_step)
    return (float(vertical_step or 0.0), direction, (vertical_unit, vertical_domain, horizontal_unit, str(coordinate_system or "")))


# The core speaks of properties and their values.
WORDS = {"VerticalDirection": "direction", "StrayPicks LeaveOut": "leave_out_strays=True", "StrayPicks": "leave_out_strays",
         "LatticeSource OriginAndSteps": "origin=, column_step= and row_step=", "DuplicatePolicy": "duplicates",
         "LatticeTolerance": "tolerance", "NullValues": "nodata", "Gridding": "gridding=\"plate\"", "Columns": "columns",
         "HeaderLines": "header_lines", "Topmost": "topmost", "Lowest": "lowest", "Sheets": "sheets", "Mean": "mean",
         "VerticalStep": "vertical_step", "ColumnStep": "column_step", "RowStep": "row_step", "Origin ": "origin "}


def in_keywords(text: str) -> str:
    """A message of the core with keywords in place of properties."""
    for word, keyword in WORDS.items():
        text = text.replace(word, keyword)
    if "points on one line" in text or "places on one line" in text or "places of picks on one line" in text:
        text += "; origin=, column_step= and row_step= give it"
    text = text.replace(": open it by the reader of GOCAD TSurf", ", which this package does not read")
    return text.replace("direction Up", "direction=\"up\"").replace("direction Down", "direction=\"down\"").replace("Down confirms", "direction=\"down\" confirms")


def horizons(found: tuple[Any, ...], fallback: str, first: str = "", file_name: str = "") -> dict[str, Horizon]:
    """Horizons by distinct names, from (list, description, warnings) of the core. `first` is the format of a file, whose name
    some programs write as that of the horizon."""
    given, description, messages = found
    for text in messages:
        warnings.warn("%s: %s" % (fallback, in_keywords(text)), stacklevel=4)
    lines = tuple(filter(None, (*first.split("\n"), *in_keywords(description).split("\n"))))
    made: dict[str, Horizon] = {}
    for one in given:
        base = name = one["name"] if one["name"] not in ("", file_name) else fallback
        number = 1
        while name in made:
            number += 1
            name = "%s %d" % (base, number)
        left_out = {"duplicates": one["duplicates"], "without z": one["without_z"]}
        columns, rows, indices = one["size"]
        filled = one["attributes"].pop("Filled", None)  # of gridding
        made[name] = Horizon(
            filled=None if filled is None else filled.astype(np.uint8), name=name, columns=one["columns"], z=one["z"], attributes=one["attributes"], direction="up" if one["is_up"] else "down",
            lattice=Lattice((rows, columns), one["origin"], one["column_step"], one["row_step"], one["first_z"], one["vertical_step"],
                            indices, one["lines"]),
            taken=lines, left_out={reason: number for reason, number in left_out.items() if number}, **one["survey"])
    return made
