# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from what the core gives, and the options that readers and `horizon` share."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._data import in_keywords, warn_all
from ._horizon import Horizon, horizon_of
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


# Arrays of the core that are no attributes.
OWN = ("Column", "SurfaceId", "VerticalIndex", "RealZ", "Filled")


def horizons(found: tuple[Any, ...], fallback: str, first: str = "", file_name: str = "") -> dict[str, Horizon]:
    """Horizons by distinct names, from (list, description, warnings) of the core. `first` is the format of a file, whose name
    some programs write as that of the horizon."""
    given, description, messages = found
    warn_all(fallback, messages)
    lines = tuple(filter(None, (*first.split("\n"), *in_keywords(description).split("\n"))))
    names = _core.make_distinct([fallback if own in ("", file_name) else own for own, _ in given])
    made: dict[str, Horizon] = {}
    for name, (_, data) in zip(names, given):
        left_out = {reason: int(data["field_data"][field][0]) for reason, field in (
            ("duplicates", "DroppedDuplicates"), ("without z", "DroppedNulls")) if field in data["field_data"]}
        filled = data["point_data"].pop("Filled", None)  # of gridding, as numbers with fractions
        made[name] = horizon_of(name, data, taken=lines, left_out={reason: number for reason, number in left_out.items() if number},
                                filled=None if filled is None else filled.astype(np.uint8),
                                attributes={key: values for key, values in data["point_data"].items() if key not in OWN})
    return made
