# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights with a unit, converted to the unit of z of a horizon: numbers with an attribute `unit`."""

import re

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray

from .stage import HorizonError

# Quantity and size in SI units of each unit.
UNITS = {"ms": ("time", 0.001), "s": ("time", 1.0), "m": ("length", 1.0), "ft": ("length", 0.3048)}
# The array of a result with the unit of the given heights, and the figures reported in it; all are stored in vertical indices.
NOTED_UNIT = "HeightUnit"
FIGURES = ("LargestError", "MeanError", "LargestLoopError", "OutlineHeightDeviation", "ChosenMaximumError",
           "HeightNoise", "HeightRounding", "ChosenDistanceThreshold", "SpikeThreshold", "FaultNoise", "SmallestFaultThrow")


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


def unit_of(horizon, name="VerticalUnit"):
    """Returns the unit of z, or another unit, from the field data; empty if unknown."""
    data = horizon.GetFieldData().GetAbstractArray(name)
    return data.GetValue(0) if data is not None and data.GetNumberOfValues() else ""


def step_of(horizon):
    """Returns the absolute change of z per vertical index; None if unknown."""
    matrix = horizon.GetFieldData().GetArray("LatticeToWorld")
    return abs(vtk_to_numpy(matrix).ravel()[10]) or None if matrix is not None and matrix.GetNumberOfValues() == 16 else None


def noise_of(mesh):
    """Returns what the automatic error of a mesh is six times of, as ("noise" or "rounding", in vertical indices), or None if
    the error was given."""
    arrays = ((word, mesh.GetFieldData().GetArray("Height" + word.capitalize())) for word in ("noise", "rounding"))
    return next(((word, array.GetValue(0)) for word, array in arrays if array is not None), None)


def note_unit(data, unit):
    """Stores the unit of the given heights with a result, unless it is empty."""
    data.GetFieldData().RemoveArray(NOTED_UNIT)
    if unit:
        text = vtkStringArray()
        text.SetName(NOTED_UNIT)
        text.InsertNextValue(unit)
        data.GetFieldData().AddArray(text)


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
