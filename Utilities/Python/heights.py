# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights that are given in a unit, for horizons whose z may be in another one: numbers with an attribute `unit`."""

import re

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray

from .stage import HorizonError

# What units measure, and the size of each.
UNITS = {"ms": ("time", 0.001), "s": ("time", 1.0), "m": ("length", 1.0), "ft": ("length", 0.3048)}
# The array of a result with the unit that heights were given in, and the figures that are told in it. All are stored in
# vertical indices.
NOTED_UNIT = "HeightUnit"
FIGURES = ("LargestError", "MeanError", "LargestLoopError", "OutlineHeightDeviation", "ChosenMaximumError",
           "ChosenDistanceThreshold", "SpikeThreshold", "FaultNoise", "SmallestFaultThrow")


class Height(float):
    """A number with the unit that stands behind it in a text, as "2 ms"; without one it counts vertical indices. Raises
    ValueError."""

    def __new__(cls, text):
        found = re.fullmatch(r"\s*(\S+?)\s*(%s|)\s*" % "|".join(UNITS), str(text))
        try:
            height = super().__new__(cls, found.group(1))
        except (AttributeError, ValueError):
            raise ValueError("'%s', expected a number, or one with a unit, as '2 ms' (%s)" % (text, ", ".join(UNITS))) from None
        height.unit = found.group(2)
        return height

    @classmethod
    def of(cls, number, unit):
        height = cls(repr(float(number)))
        height.unit = unit
        return height

    def __str__(self):
        return "%g %s" % (self, self.unit)


def unit_of(horizon, name="VerticalUnit"):
    """The unit of z, or that of another array, by the field data; empty where it is not known."""
    data = horizon.GetFieldData().GetAbstractArray(name)
    return data.GetValue(0) if data is not None and data.GetNumberOfValues() else ""


def step_of(horizon):
    """How much z changes from one vertical index to the next, without its sign; None where that is not known."""
    matrix = horizon.GetFieldData().GetArray("LatticeToWorld")
    return abs(vtk_to_numpy(matrix).ravel()[10]) or None if matrix is not None and matrix.GetNumberOfValues() == 16 else None


def note_unit(data, unit):
    """Keeps the unit that heights were given in with a result; none where it is empty."""
    data.GetFieldData().RemoveArray(NOTED_UNIT)
    if unit:
        text = vtkStringArray()
        text.SetName(NOTED_UNIT)
        text.InsertNextValue(unit)
        data.GetFieldData().AddArray(text)


def per_index(horizon, unit):
    """How much of a unit a vertical index is. Where the unit of z is not known, it is taken to be this one."""
    own = unit_of(horizon)
    factor = UNITS[own][1] / UNITS[unit][1] if own in UNITS and unit in UNITS else 1.0
    return factor * (step_of(horizon) or 1.0)


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
