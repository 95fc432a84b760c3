# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights with a unit, converted to the unit of z of a horizon: numbers with an attribute `unit`."""

import re

from . import data as core_data
from .core import HorizonError

# Quantity and size in SI units of each unit.
UNITS = {"ms": ("time", 0.001), "s": ("time", 1.0), "m": ("length", 1.0), "ft": ("length", 0.3048)}
# Figures in vertical indices.
FIGURES = ("LargestError", "MeanError", "LargestEdgeError", "LargestLoopError", "OutlineHeightDeviation",
           "ChosenMaximumError", "HeightNoise", "HeightRounding", "ChosenDistanceThreshold", "SpikeThreshold", "FaultNoise", "SmallestFaultThrow")


class Height(float):
    """A number with a unit, from a text such as "2 ms"; without a unit it is in vertical indices. Raises ValueError."""

    def __new__(cls, text):
        found = re.fullmatch(r"\s*(\S+?)\s*(%s|)\s*" % "|".join(UNITS), str(text))
        try:
            height = super().__new__(cls, found.group(1))
        except (AttributeError, ValueError):
            raise ValueError("'%s', expected a number, or one with a unit, as '2 ms' (%s)" % (
                text, ", ".join(UNITS))) from None
        height.unit = found.group(2)
        return height

    @classmethod
    def of(cls, number, unit):
        height = cls(repr(float(number)))
        height.unit = unit
        return height

    def __str__(self):
        return "%g %s" % (self, self.unit)


def unit_of(horizon):
    """Returns the unit of z from the field data; empty if unknown."""
    return core_data.text(horizon, "VerticalUnit")


def step_of(horizon):
    """Returns the absolute change of z per vertical index; None if unknown."""
    matrix = core_data.values(horizon, "LatticeToWorld")
    return abs(matrix[10]) or None if len(matrix) == 16 else None


def noise_of(mesh):
    """Returns what the automatic error of a mesh is six times of, as ("noise" or "rounding", in vertical indices), or None if
    the error was given."""
    found = ((word, core_data.value(mesh, "Height" + word.capitalize())) for word in ("noise", "rounding"))
    return next(((word, deviation) for word, deviation in found if deviation is not None), None)


def per_index(horizon, unit):
    """Returns the size of a vertical index in a unit. If the unit of z is unknown, z is assumed to be in this unit."""
    own = unit_of(horizon)
    factor = UNITS[own][1] / UNITS[unit][1] if own in UNITS and unit in UNITS else 1.0
    return factor * (step_of(horizon) or 1.0)


def in_unit_of(properties, horizon):
    """Returns properties with heights converted to the unit of z of a horizon. If that unit is unknown, z is assumed to be
    in the unit of the heights. Raises HorizonError."""
    return in_unit(properties, unit_of(horizon))


def in_unit(properties, unit):
    """Does the same for a unit of z."""
    return {name: _convert(value, unit) if getattr(value, "unit", "") else value for name, value in properties.items()}


def _convert(height, unit):
    if unit in ("", height.unit):
        return float(height)
    measure, size = UNITS.get(unit, (None, None))
    own_measure, own_size = UNITS[height.unit]
    if measure != own_measure:
        raise HorizonError("%s for z in %s, expected %s (--vertical-unit says what z is in)" % (
            height, unit, " or ".join(name for name in UNITS if UNITS[name][0] == measure) or "a number without unit"))
    return height * own_size / size
