# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stages: functions from horizons to horizons and meshes."""

from __future__ import annotations

import dataclasses
import warnings
from collections.abc import Callable, Mapping
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._horizon import Horizon
from ._mesh import Ledger, Mesh
from ._units import height

Progress = Callable[[float], Any]


def _require(horizon: Any, stage: str) -> None:
    if not isinstance(horizon, Horizon):
        raise TypeError("%s of %s, expected a Horizon: horizon(data) makes one, read(path) reads some" % (
            stage, type(horizon).__name__))
    if not len(horizon):
        raise ValueError("%s without points, expected some" % horizon.name)


def _split(horizon: Horizon) -> tuple[list[str], list[Any]]:
    """Names and values of the attributes that are numbers with fractions, which are averaged."""
    names = [name for name, values in horizon.attributes.items() if values.dtype.kind == "f"]
    return names, [np.ascontiguousarray(horizon.attributes[name], np.float64) for name in names]


def _count(name: str, number: Any) -> int:
    if int(number) != number or number < 1:
        raise ValueError("%s %s, expected a whole number, at least 1" % (name, number))
    return int(number)


@dataclasses.dataclass(eq=False, repr=False)
class Faults:
    """Faults of a horizon, as `faults` finds them.

    Attributes
    ----------
    links : int32 array of shape (n, 3)
        Column, row and side (0 east, 1 north) of each link between neighbours that a fault cuts.
    lines : int32 array of n
        Number of the line of each link.
    throws : float64 array of n
        z beyond each link, to the east or north, minus z before it; nan without a point nearby.
    noise : float
        Standard deviation of differences between neighbours, in the unit of z.
    smallest_throw : float
        That a fault reaches somewhere, in the unit of z.
    """

    links: NDArray[np.int32]
    lines: NDArray[np.int32]
    throws: NDArray[np.float64]
    noise: float
    smallest_throw: float
    vertical_unit: str = ""

    def __len__(self) -> int:
        return int(self.lines.max(initial=-1)) + 1

    def __repr__(self) -> str:
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        known = np.abs(self.throws[np.isfinite(self.throws)])
        return "Faults: %d lines, %d links cut, throws up to %.4g%s, noise %.3g%s" % (
            len(self), len(self.links), known.max(initial=0.0), unit, self.noise, unit)


def _links(given: Faults | None) -> Any:
    if given is not None and not isinstance(given, Faults):
        raise TypeError("faults of %s, expected Faults: faults(horizon) finds them" % type(given).__name__)
    return None if given is None else np.ascontiguousarray(given.links, np.int32)


def faults(horizon: Horizon, smallest_throw: float | str | None = None, *, noise: float | str | None = None, smallest_extent: int = 20,
           smallest_branch: int = 10, largest_gap: int = 5, largest_ramp: int = 7, join_through_holes: bool = True,
           progress: Progress | None = None) -> Faults:
    """Finds faults in the heights of a horizon.

    Parameters
    ----------
    horizon : Horizon
    smallest_throw : float or str, optional
        The throw that a fault must reach somewhere, in the unit of z or with a unit; by default eight times the noise of
        heights.
    noise : float or str, optional
        Standard deviation of differences between neighbours; measured by default.
    smallest_extent : int
        The least extent of a fault, in columns.
    smallest_branch : int
        Branches of fewer links are dropped.
    largest_gap : int
        Missing columns in a row that faults are followed across.
    largest_ramp : int
        Faults may bend the surface over this number of columns; 0 finds steps alone.
    join_through_holes : bool
        Joins lines that end at a hole and point to each other.
    progress : callable, optional

    Returns
    -------
    Faults

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.where(np.arange(80) < 40, 1000.0, 1030.0) + np.zeros((60, 1))
    >>> found = sh.faults(sh.horizon(z, spacing=(25, 25)), 10.0)
    >>> len(found), len(found.links), float(found.throws.min())
    (1, 60, 30.0)
    """
    _require(horizon, "fault detection")
    step = abs(horizon.lattice.vertical_step)
    options: dict[str, Any] = {"smallest_extent": int(smallest_extent), "smallest_branch": int(smallest_branch), "largest_gap": int(largest_gap),
                               "largest_ramp": int(largest_ramp), "join_through_holes": bool(join_through_holes)}
    for name, given in (("smallest_throw", smallest_throw), ("noise", noise)):
        if given is not None:
            options[name] = height(name, given, horizon.vertical_unit) / step
    made = _core.faults(horizon._core(), options, progress)
    return Faults(made["links"], made["lines"], made["throws"] * horizon.lattice.vertical_step, made["noise"] * step,
                  made["smallest_throw"] * step, horizon.vertical_unit)


@overload
def surface(horizon: Horizon, largest_error: float | str | None = ..., **options: Any) -> Mesh: ...
@overload
def surface(horizon: Mapping[str, Horizon], largest_error: float | str | None = ..., **options: Any) -> dict[str, Mesh]: ...


def surface(horizon: Any, largest_error: float | str | None = None, *, triangles: int | None = None,
            smallest_angle: float = 2.0, effort: str = "best", fit_heights: bool = True, radius: int | None = None,
            hole_boundaries: bool = True, smallest_hole_size: int | None = None, minimum_patch_size: int = 1,
            outline_tolerance: float | None = None, faults: Faults | None = None,
            progress: Progress | None = None) -> Any:
    """Makes a mesh of few triangles within an error.

    Parameters
    ----------
    horizon : Horizon, or dict of horizons
    largest_error : float or str, optional
        The largest vertical distance of a point of the horizon from the mesh: in the unit of z, or with a unit, as "2 ms".
        By default six times the noise of the heights.
    triangles : int, optional
        The largest number of triangles, in place of an error.
    smallest_angle : float
        No change makes a smaller angle in plan, in degrees, from 0 to 60.
    effort : "best" or "fast"
        "fast" takes about a third of the time, for some more triangles.
    fit_heights : bool
        Lets inner points leave the heights of their columns, which needs fewer of them.
    radius : int, optional
        The largest gap between neighbouring points of a patch, in columns; by default the least for nearly all gaps.
    hole_boundaries : bool
        Keeps holes open.
    smallest_hole_size : int, optional
        Smaller holes, in columns, are closed.
    minimum_patch_size : int
        Patches of fewer points are left out.
    outline_tolerance : float, optional
        The largest move of outlines on the map, in columns; at most 0.75 by default.
    faults : Faults, optional
        Where the surface is cut open: `faults` finds them.
    progress : callable, optional
        Gets the fraction that is done; what it raises stops the work.

    Returns
    -------
    Mesh, or dict of meshes

    Raises
    ------
    ValueError
        For options out of range, and if outlines alone need more triangles.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> x, y = np.meshgrid(np.arange(60), np.arange(40))
    >>> top = sh.horizon(1500 + 20 * np.sin(x / 12) * np.cos(y / 9), spacing=(25, 25), vertical_unit="ms")
    >>> mesh = sh.surface(top, "1 ms")
    >>> mesh.largest_error <= 1.0, len(mesh) < 500
    (True, True)
    """
    if isinstance(horizon, Mapping):
        given = dict(triangles=triangles, smallest_angle=smallest_angle, effort=effort, fit_heights=fit_heights, radius=radius,
                     hole_boundaries=hole_boundaries, smallest_hole_size=smallest_hole_size, minimum_patch_size=minimum_patch_size,
                     outline_tolerance=outline_tolerance, faults=faults, progress=progress)
        return {name: surface(one, largest_error, **given) for name, one in horizon.items()}
    _require(horizon, "a surface")
    if largest_error is not None and triangles is not None:
        raise ValueError("largest_error and triangles, expected one of them")
    if effort not in ("best", "fast"):
        raise ValueError("effort '%s', expected best or fast" % effort)
    step = abs(horizon.lattice.vertical_step)
    options: dict[str, Any] = {
        "smallest_angle": float(smallest_angle), "fast": effort == "fast", "fit_heights": fit_heights,
        "hole_boundaries": hole_boundaries, "minimum_patch_size": _count("minimum_patch_size", minimum_patch_size)}
    for name, number in (("radius", radius), ("smallest_hole_size", smallest_hole_size)):
        if number is not None:
            options[name] = _count(name, number)
    if outline_tolerance is not None:
        options["outline_tolerance"] = float(outline_tolerance)
    noise = {}
    core = horizon._core()
    if triangles is not None:
        options.update(maximum_number_of_triangles=_count("triangles", triangles), maximum_error=0.0)
    elif largest_error is not None:
        options["maximum_error"] = height("largest_error", largest_error, horizon.vertical_unit) / step
    else:
        options["maximum_error"], deviation, is_rounding = _core.noise(core)
        noise = {"height_rounding" if is_rounding else "height_noise": deviation * step}
    names, values = _split(horizon)
    links = _links(faults)
    made = _core.surface(core, horizon.filled, values, links, options, progress)
    figures = made["figures"]
    for name in ("largest_error", "mean_error", "largest_loop_error", "chosen_maximum_error"):
        figures[name] *= step
    figures["largest_inner_error"] = figures["largest_error"]  # without points on outlines
    figures["largest_error"] = max(figures["largest_error"], figures["largest_loop_error"])
    attributes = dict(zip(names, made["averages"]))
    sources = made["sources"]
    ledger = Ledger(*made["ledger"], abs(np.linalg.det((horizon.lattice.column_step, horizon.lattice.row_step))))
    mesh = Mesh(
        name=horizon.name, points=made["vertices"], triangles=made["triangles"],
        attributes={name: attributes[name].astype(given.dtype) if name in attributes else given[sources]
                    for name, given in horizon.attributes.items()},
        errors=made["errors"] * step, quality=made["quality"], outlines=made["outlines"], patches=made["patches"],
        counts=made["counts"], columns=made["columns"], largest_error=figures.pop("largest_error"),
        mean_error=figures.pop("mean_error"), details={**figures, **noise}, ledger=ledger,
        **{name: getattr(horizon, name) for name in (
            "lattice", "direction", "vertical_unit", "vertical_domain", "horizontal_unit", "coordinate_system")})
    if ledger.left_out > 0.001 * max(1, ledger.covered):
        warnings.warn("%s: %s" % (horizon.name, ledger), stacklevel=2)
    return mesh


def fill_holes(horizon: Horizon, largest_hole_size: int = 2500, *, method: str = "automatic", rim_smoothing: float = 1.0,
               rim_width: int = 3, extrapolation_distance: int = 0, faults: Faults | None = None,
               progress: Progress | None = None) -> Horizon:
    """Computes heights in holes.

    Parameters
    ----------
    horizon : Horizon
    largest_hole_size : int
        Holes of more columns stay open.
    method : "automatic", "plate" or "membrane"
        A plate continues slopes, a membrane does not; "automatic" is a plate whose smoothing suits the noise.
    rim_smoothing : float
        How far a plate leaves the heights around a hole; 0 keeps them. "automatic" chooses it.
    rim_width : int
        Columns around a hole that a plate takes into account.
    extrapolation_distance : int
        Columns outside are computed within this number of steps.
    faults : Faults, optional
        Nothing is filled across these.
    progress : callable, optional

    Returns
    -------
    Horizon
        With the new points at the end; `filled` marks them. Numbers with fractions are interpolated, others are those of
        the nearest point.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> z[8:11, 10:14] = np.nan
    >>> int(sh.fill_holes(sh.horizon(z)).filled.sum())
    12
    """
    _require(horizon, "filling")
    if method not in ("automatic", "plate", "membrane"):
        raise ValueError("method '%s', expected automatic, plate or membrane" % method)
    names, values = _split(horizon)
    options = {"method": method, "largest_hole_size": _count("largest_hole_size", largest_hole_size), "rim_smoothing": float(rim_smoothing),
               "rim_width": int(rim_width), "extrapolation_distance": int(extrapolation_distance)}
    links = _links(faults)
    made = _core.fill_holes(horizon._core(), values, links, options, progress)
    new = dict(zip(names, made["attributes"]))
    nearest, marks = made["nearest"], np.ones(len(made["nearest"]), np.uint8)
    marks[made["first_outside"]:] = 2
    return dataclasses.replace(
        horizon, columns=np.concatenate((horizon.columns, made["columns"])), z=np.concatenate((horizon.z, horizon.sign * made["elevations"])),
        attributes={name: np.concatenate((given, new[name].astype(given.dtype) if name in new else given[nearest]))
                    for name, given in horizon.attributes.items()},
        filled=np.concatenate((horizon.filled, marks)))


def despike(horizon: Horizon, threshold: float | str | None = None, *, radius: int = 2, spur_width: int = 0,
            progress: Progress | None = None) -> Horizon:
    """Leaves out points far from the median around them.

    Parameters
    ----------
    horizon : Horizon
    threshold : float or str, optional
        The least distance of a spike, in the unit of z or with a unit; by default four times the noise.
    radius : int
        Points within this number of columns are around a point.
    spur_width : int
        Spurs of at most this width, in columns, are left out, too; 0 keeps them.
    progress : callable, optional

    Returns
    -------
    Horizon
        `left_out` has the numbers of spikes and of points on spurs.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> z[5, 5] = 1100.0
    >>> sh.despike(sh.horizon(z), 10.0).left_out["spikes"]
    1
    """
    _require(horizon, "despiking")
    least = 0.0 if threshold is None else height("threshold", threshold, horizon.vertical_unit) / abs(horizon.lattice.vertical_step)
    kinds, _ = _core.despike(horizon._core(), least, int(radius), int(spur_width), progress)
    kept = kinds == 0
    if not kept.any():
        raise ValueError("%s: all points are spikes or on spurs, expected some that stay" % horizon.name)
    return dataclasses.replace(
        horizon, columns=horizon.columns[kept], z=horizon.z[kept], filled=horizon.filled[kept],
        attributes={name: values[kept] for name, values in horizon.attributes.items()},
        left_out={**horizon.left_out, "spikes": int((kinds == 1).sum()), "points on spurs": int((kinds == 2).sum())})


@dataclasses.dataclass(eq=False, repr=False)
class Thickness:
    """Thickness between two horizons, as `thickness` measures it.

    Attributes
    ----------
    horizon : Horizon
        The first one at columns with both, with the attributes Isochore (vertical) and Isopach (across the dip; nan where the
        dip is unknown), in the unit of z; negative where the horizons cross.
    least, mean, largest : float
        Of the isochore.
    volume : float
        Area of all columns times their isochore; crossings count as 0.
    columns, left_out, crossings : int
        Columns with both horizons, with one of them, and of negative thickness.
    """

    horizon: Horizon
    least: float
    mean: float
    largest: float
    volume: float
    columns: int
    left_out: int
    crossings: int

    def __repr__(self) -> str:
        unit = " " + self.horizon.vertical_unit if self.horizon.vertical_unit else ""
        return "Thickness {}: {:.4g} to {:.4g}{}, mean {:.4g}{}, over {:,} columns; {:,} with one horizon alone{}".format(
            self.horizon.name, self.least, self.largest, unit, self.mean, unit, self.columns, self.left_out,
            "; the horizons cross at {:,}".format(self.crossings) if self.crossings else "")


def thickness(top: Horizon, base: Horizon, *, progress: Progress | None = None) -> Thickness:
    """Measures the thickness between two horizons of one survey.

    Parameters
    ----------
    top, base : Horizon
        On lattices with the same steps and common columns, with z in the same direction and unit.
    progress : callable, optional

    Returns
    -------
    Thickness

    Raises
    ------
    ValueError
        If lattices, directions or units differ, or no column has both horizons.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> sh.thickness(sh.horizon(z, spacing=(25, 25)), sh.horizon(z + 40.0, spacing=(25, 25))).volume
    15000000.0
    """
    for one in (top, base):
        _require(one, "thickness")
    for what in ("direction", "vertical_unit", "horizontal_unit", "coordinate_system"):
        if getattr(top, what) != getattr(base, what):
            raise ValueError("%s and %s: %s %r and %r, expected equal ones" % (top.name, base.name, what, getattr(top, what), getattr(base, what)))
    steps, other = (np.column_stack((one.lattice.column_step, one.lattice.row_step)) for one in (top, base))
    size = max(base.lattice.shape) + max(top.lattice.shape)
    if np.abs(np.linalg.solve(steps, other) - np.eye(2)).max() * size > 0.1:
        raise ValueError("%s and %s: steps %s and %s, expected a common lattice" % (
            top.name, base.name, (top.lattice.column_step, top.lattice.row_step), (base.lattice.column_step, base.lattice.row_step)))
    shift = np.linalg.solve(steps, np.subtract(base.lattice.origin, top.lattice.origin))
    if np.abs(shift - np.rint(shift)).max() > 0.1:
        raise ValueError("%s and %s: columns %.2g and %.2g of a step apart, expected common columns" % (top.name, base.name, *(shift - np.rint(shift))))
    columns = base.columns + np.rint(shift).astype(np.int32)
    least = np.minimum(columns.min(axis=0), 0)
    most = np.maximum(columns.max(axis=0), np.subtract(top.lattice.shape[::-1], 1)) - least + 1
    own, elevations, (_, _, indices), to_world = top._core()
    lattice = (int(most[0]), int(most[1]), indices), to_world
    made = _core.thickness((own - least.astype(np.int32), elevations, *lattice),
                           (np.ascontiguousarray(columns - least, np.int32), base._core()[1], *lattice), progress)
    kept = np.isfinite(made["isochore"])
    both = dataclasses.replace(
        top, columns=top.columns[kept], z=top.z[kept], filled=top.filled[kept],
        attributes={**{name: values[kept] for name, values in top.attributes.items()},
                    "Isochore": made["isochore"][kept], "Isopach": made["isopach"][kept]})
    return Thickness(both, **{name: made[name] for name in ("least", "mean", "largest", "volume", "columns", "left_out", "crossings")})
