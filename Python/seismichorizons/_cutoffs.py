# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Where horizons meet faults."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._data import Data, Progress, call, loops, snake
from ._horizon import Floats, Horizon
from ._lines import Lines, lines_of
from ._mesh import Mesh
from ._stack import named_horizons
from ._stages import Faults, by_fault, given_options
from ._units import height


@dataclasses.dataclass(eq=False, repr=False)
class Profile:
    """Values along a cutoff, as arrays with one entry for each of its points.

    Attributes
    ----------
    along : float64 array
        Distance along strike.
    throw, heave : float64 arrays
        Height of the footwall cutoff above the hanging-wall cutoff, and their distance in map view across strike;
        negative at reverse faults.
    spread : float64 array
        Standard deviation of the height due to noise; nan where it is interpolated.
    guessed : uint8 array
        0 near picks, 1 extrapolated, 2 interpolated along the fault.
    """

    along: Floats
    throw: Floats
    heave: Floats
    spread: Floats
    guessed: NDArray[np.uint8]


@dataclasses.dataclass(eq=False, repr=False)
class Diagram:
    """The layers that meet across a fault, as quadrangles on the fault plane.

    Attributes
    ----------
    corners : float64 array of shape (n, 4, 2)
        Distance along strike, and z upwards.
    footwall, hanging_wall : list of str
        The layer on each wall, such as "Top to Base".
    """

    corners: Floats
    footwall: list[str]
    hanging_wall: list[str]


@dataclasses.dataclass(eq=False, repr=False)
class Cutoffs:
    """The lines where horizons meet faults, from `cutoffs`.

    Attributes
    ----------
    names : list of str
        Names of the faults.
    lines : dict of Lines by horizon
        The cutoffs, named after their fault, with the sticks "footwall" and "hanging wall".
    profiles : dict of lists of Profile by horizon
        One profile for each line.
    polygons : dict of Lines by horizon
        Fault polygons, which outline the heave.
    faults : dict of Mesh by fault
        The fault surfaces that were used.
    diagrams : dict of Diagram by fault
    figures : dict of arrays
        One value for each fault and horizon that it cuts: fault, horizon, throw_mean, heave_mean, largest_gap, guessed
        and so on.
    areas : dict of arrays
        One value for each pair of layers that meet: fault, footwall, hanging_wall, area.
    vertical_unit : str
    """

    names: list[str]
    lines: dict[str, Lines]
    profiles: dict[str, list[Profile]]
    polygons: dict[str, Lines]
    faults: dict[str, Mesh]
    diagrams: dict[str, Diagram]
    figures: dict[str, Any]
    areas: dict[str, Any]
    vertical_unit: str = ""

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        return "Cutoffs: " + ", ".join("%s at %s (mean throw %.4g%s)" % (horizon, fault, throw, unit) for fault, horizon, throw in zip(
            self.figures["fault"], self.figures["horizon"], self.figures["throw_mean"]))


def cutoffs(horizons: Mapping[str, Horizon] | Sequence[Horizon] | Horizon, faults: Any, *, dip: float = 0.0, drop_distance: float = 0.5,
            drop_noise: float = 4.0, largest_gap: float = 20.0, smallest_length: float = 5.0, largest_error: float | str | None = None,
            progress: Progress | None = None) -> Cutoffs:
    """Finds where horizons meet faults: cutoffs on both walls, throw and heave, fault polygons, and the layers that meet.

    Parameters
    ----------
    horizons : Horizon, or dict or list of Horizon
        All in the same vertical domain and unit.
    faults : Faults, dict of Faults by horizon, Lines, list of arrays, or dict of Mesh by fault
        Faults that cut the horizons, where supplied faults of the same name are one fault and detected faults are
        separate; or sticks, as from `read_faults`; or surfaces.
    dip : float
        Dip of faults that are known from one horizon only, towards the downthrown side, in degrees. 0 derives it from
        the gap between picks; without a gap, dip and heave are unknown.
    drop_distance : float
        Ignores picks closer to a fault than this, in columns.
    drop_noise : float
        Ignores picks near a fault that deviate by more than this many standard deviations of noise from those farther
        away; 0 uses all picks.
    largest_gap : float
        How far horizons are extrapolated to a fault, and interpolated along it, in columns.
    smallest_length : float
        Ignores places where a fault cuts a horizon over a shorter distance, in columns.
    largest_error : float or str, optional
        Largest vertical error of simplified lines, in the unit of z or with a unit; by default six times the noise of
        each horizon.
    progress : callable, optional

    Returns
    -------
    Cutoffs

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> x = np.arange(80) * 25.0 + np.zeros((60, 1))
    >>> z = np.where(x < 987.0, 1000.0, 1030.0)
    >>> stick = np.array([(970.0, -900.0), (1010.0, -1100.0)])
    >>> sticks = [np.column_stack((stick[:, 0], [y, y], stick[:, 1])) for y in (0.0, 700.0, 1475.0)]
    >>> sh.cutoffs({"Top": sh.horizon(z, spacing=(25, 25))}, sticks)
    Cutoffs: Top at Fault (mean throw 30)
    """
    given, blocks, named = faults_of(horizons, faults, "cutoffs")
    first = next(iter(given.values()), None)
    options = given_options(dip=float(dip), drop_distance=float(drop_distance), drop_noise=float(drop_noise), largest_gap=float(largest_gap),
                            smallest_length=float(smallest_length),
                            maximum_error=None if largest_error is None or first is None else height("largest_error", largest_error, first.vertical_unit))
    made = call("cutoffs", _core.cutoffs, named, blocks, options, progress)
    figures = {snake(name): values for name, values in made["figures"].items()}
    return Cutoffs(made["names"], _lines(given, made["cutoffs"]), {name: _profiles(data) for name, data in zip(given, made["cutoffs"])},
                   _lines(given, made["polygons"]), by_fault(made["faults"]),
                   _diagrams(made["names"], made["diagrams"]), figures,
                   {snake(name): values for name, values in made["areas"].items()}, first.vertical_unit if first else "")


def faults_of(horizons: Any, faults: Any, what: str) -> tuple[dict[str, Horizon], list[tuple[str, Data]], list[tuple[str, Data]]]:
    """The horizons by name; sticks or surfaces, none if the horizons are cut; and the data of horizons."""
    if isinstance(horizons, Horizon):
        horizons = [horizons]
    cuts: dict[str, Faults] | None = None
    if isinstance(faults, Faults):
        names = list(horizons) if isinstance(horizons, Mapping) else [one.name for one in horizons]
        if len(names) != 1:
            raise ValueError("faults of one horizon for %d, expected a dict of Faults by the names of the horizons" % len(names))
        cuts = {names[0]: faults}
    elif isinstance(faults, Mapping) and faults and all(isinstance(one, Faults) for one in faults.values()):
        cuts = dict(faults)
    given, named = named_horizons(horizons, what, cuts)
    for name, data in named:
        if cuts and name in cuts:
            data["field_data"] = {**data["field_data"], "FaultLine": cuts[name].lines, "FaultNames": list(cuts[name].names)}
    return given, [] if cuts else _blocks_of(faults), named


def _blocks_of(faults: Any) -> list[tuple[str, Data]]:
    """Sticks, or surfaces by name."""
    if isinstance(faults, Mapping):
        for name, mesh in faults.items():
            if not isinstance(mesh, Mesh):
                raise TypeError("fault %s of %s, expected a Mesh, or Faults for each horizon" % (name, type(mesh).__name__))
        return [(name, mesh._data()) for name, mesh in faults.items()]
    return [("", lines_of(faults, "Fault")._data())]


def _lines(given: Mapping[str, Horizon], made: Sequence[Data]) -> dict[str, Lines]:
    return {name: Lines.of(data) for name, data in zip(given, made)}


def _profiles(data: Data) -> list[Profile]:
    arrays = [data["point_data"][name] for name in ("Along", "Throw", "Heave", "Spread", "Guessed")]
    return [Profile(*(array[line] for array in arrays)) for line in loops(data["lines"], False)]


def _diagrams(names: Sequence[str], data: Data) -> dict[str, Diagram]:
    points = np.asarray(data["polygons"][1]).reshape(-1, 4)
    corners = np.stack([data["point_data"]["Along"][points], data["places"][points, 1]], 2)
    faults, walls = np.array(data["cell_data"]["FaultName"], object), [data["cell_data"][wall] for wall in ("Footwall", "HangingWall")]
    rows = {name: np.flatnonzero(faults == name) for name in names}
    return {name: Diagram(corners[own], *([wall[row] for row in own] for wall in walls)) for name, own in rows.items()}
