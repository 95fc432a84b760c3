# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights that are given in a unit, for horizons whose z may be in another one: numbers with an attribute `unit`."""

import re

from vtkmodules.util.numpy_support import vtk_to_numpy

from .stage import HorizonError

# What units measure, and the size of each.
UNITS = {"ms": ("time", 0.001), "s": ("time", 1.0), "m": ("length", 1.0), "ft": ("length", 0.3048)}


class Height(float):
    """A number with the unit that stands behind it in a text, as "2 ms"; without one it counts vertical indices. Raises
    ValueError."""

    def __new__(cls, text):
        found = re.fullmatch(r"\s*(\S+?)\s*(%s|)\s*" % "|".join(UNITS), text)
        try:
            height = super().__new__(cls, found.group(1))
        except (AttributeError, ValueError):
            raise ValueError("'%s', expected a number, or one with a unit, as '2 ms' (%s)" % (text, ", ".join(UNITS))) from None
        height.unit = found.group(2)
        return height

    def __str__(self):
        return "%g %s" % (self, self.unit)


def unit_of(horizon):
    """The unit of z, by the field data; empty where it is not known."""
    data = horizon.GetFieldData().GetAbstractArray("VerticalUnit")
    return data.GetValue(0) if data is not None and data.GetNumberOfValues() else ""


def step_of(horizon):
    """How much z changes from one vertical index to the next, without its sign; None where that is not known."""
    matrix = horizon.GetFieldData().GetArray("LatticeToWorld")
    return abs(vtk_to_numpy(matrix).ravel()[10]) or None if matrix is not None and matrix.GetNumberOfValues() == 16 else None


def in_unit_of(properties, horizon):
    """Properties with heights in the unit of z of a horizon. One whose unit is not known is taken to be in theirs. Raises
    HorizonError."""
    return {name: _convert(value, unit_of(horizon)) if getattr(value, "unit", "") else value
            for name, value in properties.items()}


def _convert(height, unit):
    if unit in ("", height.unit):
        return float(height)
    measure, size = UNITS.get(unit, (None, None))
    own_measure, own_size = UNITS[height.unit]
    if measure != own_measure:
        raise HorizonError("%s for z in %s, expected %s (--vertical-unit says what z is in)" % (
            height, unit, " or ".join(name for name in UNITS if UNITS[name][0] == measure) or "a number without unit"))
    return height * own_size / size
