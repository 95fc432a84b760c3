# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights as numbers, in the unit of z, or as texts with a unit such as "2 ms"."""

from __future__ import annotations

import math
import re

# Quantity and size in SI units.
UNITS = {"ms": ("time", 0.001), "s": ("time", 1.0), "m": ("length", 1.0), "ft": ("length", 0.3048)}


def height(name: str, given: float | str, unit: str) -> float:
    """Returns a height in a unit of z. Raises ValueError, with the name of the keyword, unless it is finite and at least 0."""
    number = _in_unit(name, given, unit)
    if not 0.0 <= number < math.inf:
        raise ValueError("%s %s, expected a finite number, at least 0" % (name, given))
    return number


def _in_unit(name: str, given: float | str, unit: str) -> float:
    found = re.fullmatch(r"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(\w*)\s*", given) if isinstance(given, str) else None
    if isinstance(given, str) and not found:
        raise ValueError("%s '%s', expected a number, or one with a unit, as '2 ms' (%s)" % (name, given, ", ".join(UNITS)))
    number, own = (float(found[1]), found[2]) if found else (float(given), "")
    if not own or own == unit:
        return number
    if own not in UNITS:
        raise ValueError("%s '%s', expected one of the units %s" % (name, given, ", ".join(UNITS)))
    if unit not in UNITS:
        raise ValueError("%s '%s' for a horizon %s, expected a number, or vertical_unit=\"%s\" where the horizon is made" % (
            name, given, "with z in " + unit if unit else "without a vertical unit", own))
    if UNITS[own][0] != UNITS[unit][0]:
        raise ValueError("%s '%s', a %s, for a horizon with z in %s" % (name, given, UNITS[own][0], unit))
    return number * UNITS[own][1] / UNITS[unit][1]
