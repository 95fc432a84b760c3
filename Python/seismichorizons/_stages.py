# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Stages: functions from horizons to horizons and meshes."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._data import Data, Progress, call, give_triangles, take_attributes, warn, warn_all
from ._horizon import Horizon, horizon_of
from ._lines import Lines, lines_of
from ._mesh import Mesh, mesh_of
from ._units import height



def require_horizon(horizon: Any, stage: str) -> None:
    if not isinstance(horizon, Horizon):
        raise TypeError("%s of %s, expected a Horizon: horizon(data) makes one, read(path) reads some" % (
            stage, type(horizon).__name__))
    if not len(horizon):
        raise ValueError("%s without points, expected some" % horizon.name)


def _count(name: str, number: Any) -> int:
    if int(number) != number or number < 1:
        raise ValueError("%s %s, expected a whole number, at least 1" % (name, number))
    return int(number)


def given_options(**options: Any) -> dict[str, Any]:
    """Options that have a value."""
    return {name: value for name, value in options.items() if value is not None}


@dataclasses.dataclass(eq=False, repr=False)
class Faults:
    """Faults of a horizon, from `faults`.

    Attributes
    ----------
    links : int32 array of shape (n, 3)
        Column, row and side (0 east, 1 north) of each link between neighbouring columns that a fault cuts.
    lines : int32 array of n
        Number of the fault line of each link.
    names : list of str
        Fault of each line; "fault 1" and so on for unnamed faults.
    throws : float64 array of n
        z on the far side of each link (east or north) minus z on the near side; nan without a nearby point.
    noise : float
        Standard deviation of differences between neighbouring columns, in the unit of z.
    smallest_throw : float
        Throw that a fault must reach somewhere, in the unit of z.
    traces : Lines
        Fault lines on the horizon, half way between columns, with the names of supplied faults.
    surfaces : dict of Mesh
        Surface of each fault, by name, if sticks were supplied.
    horizon : Horizon
        The horizon without points inside fault polygons.
    """

    links: NDArray[np.int32]
    lines: NDArray[np.int32]
    names: list[str]
    throws: NDArray[np.float64]
    noise: float
    smallest_throw: float
    traces: Lines
    horizon: Horizon
    surfaces: dict[str, Mesh] = dataclasses.field(default_factory=dict)
    vertical_unit: str = ""

    def __len__(self) -> int:
        return int(self.lines.max(initial=-1)) + 1

    def __repr__(self) -> str:
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        known = np.abs(self.throws[np.isfinite(self.throws)])
        return "Faults: %d line%s, %d links cut, throws up to %.4g%s, noise %.3g%s" % (
            len(self), "s" * (len(self) != 1), len(self.links), known.max(initial=0.0), unit, self.noise, unit)


def links_of(given: Faults | None) -> Any:
    if given is not None and not isinstance(given, Faults):
        raise TypeError("faults of %s, expected Faults: faults(horizon) finds them" % type(given).__name__)
    return None if given is None else np.ascontiguousarray(given.links, np.int32)


def faults(horizon: Horizon, smallest_throw: float | str | None = None, *, noise: float | str | None = None, smallest_extent: int = 20,
           smallest_branch: int = 10, largest_gap: int = 5, largest_ramp: int = 7, join_through_holes: bool = True,
           lines: Any = None, are_sticks: bool | None = None, extend_sticks: bool = False, polygons: str = "blank", detect: bool | None = None,
           progress: Progress | None = None) -> Faults:
    """Detects faults in a horizon, or uses fault lines that you supply.

    Parameters
    ----------
    horizon : Horizon
    smallest_throw : float or str, optional
        Throw that a fault must reach somewhere, in the unit of z or with a unit; the fault is followed down to half of
        this. By default eight times the noise.
    noise : float or str, optional
        Standard deviation of noise in height differences between neighbouring columns; measured by default.
    smallest_extent : int
        Smallest extent of a fault, in columns along either axis.
    smallest_branch : int
        Branches with fewer faulted links are dropped.
    largest_gap : int
        Largest number of consecutive missing columns that a fault may cross.
    largest_ramp : int
        Widest ramp to treat as a fault, cut in the middle, in columns; 0: steps only.
    join_through_holes : bool
        Joins fault lines across a hole if they point towards each other and have similar throws.
    lines : Lines, list of Lines, or list of arrays of shape (n, 3), optional
        Fault traces, polygons or sticks in the coordinates of the horizon, as from `read_faults`.
    are_sticks : bool, optional
        Treats the lines as sticks down the fault plane, not as traces in map view. Arrays are sticks of one fault. By
        default they are traces, and lines that look like sticks are refused.
    extend_sticks : bool
        Extends stick surfaces at both ends by the last stick spacing.
    polygons : "blank", "cut" or "leave"
        Points inside fault polygons are dropped ("blank") or remain as islands ("cut"); with "leave", polygons have no
        effect.
    detect : bool, optional
        Detects faults in the heights; by default only without lines.
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
    require_horizon(horizon, "fault detection")
    if isinstance(smallest_throw, Lines):
        raise TypeError("fault lines as smallest_throw, expected a height: faults(horizon, lines=...)")
    of_fault = None if lines is None else lines_of(lines, "Fault" if are_sticks else "")
    if of_fault is not None and are_sticks is None and _look_like_sticks(of_fault):
        raise ValueError("lines that look like fault sticks, expected are_sticks=True for these, or False for traces in map view")
    given = None if of_fault is None else _core.GivenFaults(of_fault._data())
    options = {"smallest_extent": int(smallest_extent), "smallest_branch": int(smallest_branch), "largest_gap": int(largest_gap),
               "largest_ramp": int(largest_ramp), "join_through_holes": bool(join_through_holes), "are_sticks": bool(are_sticks and lines is not None),
               "extend_sticks": bool(extend_sticks), "polygons": polygons, "detect": lines is None if detect is None else bool(detect),
               "throw_unit": "world"}
    for name, value in (("smallest_throw", smallest_throw), ("noise", noise)):
        if value is not None:
            options[name] = height(name, value, horizon.vertical_unit)
    cut, traces, surfaces = call(horizon.name, _core.faults, horizon._data(), given, options, progress)
    warn_all(horizon.name, given.warnings() if given else [])
    step, fields = abs(horizon.lattice.vertical_step), cut["field_data"]
    noise_found, least = (float(fields[name][0]) * step if name in fields else np.nan for name in ("FaultNoise", "SmallestFaultThrow"))
    return Faults(fields["FaultedLinks"], fields["FaultLine"], fields["FaultNames"], fields["FaultThrow"] * horizon.lattice.vertical_step, noise_found, least,
                  Lines.of(traces), _changed(horizon, cut), by_fault(surfaces), horizon.vertical_unit)


def _look_like_sticks(lines: Lines) -> bool:
    """Whether three lines or more of a named fault go down, and cover little of its length in map view."""
    for fault in set(lines.names) - {""}:
        own = [line for line, name in zip(lines.lines, lines.names) if name == fault and len(line) > 1]
        if len(own) < 3 or not np.isfinite(np.concatenate(own)).all():
            continue  # What is not finite is refused where lines are read.
        places = np.concatenate(own)[:, :2]
        along = np.linalg.svd(places - places.mean(axis=0), full_matrices=False)[2][0]
        go_down = [np.ptp(line[:, 2]) > 0.0 and abs(np.sign(np.diff(line[:, 2])).sum()) == len(line) - 1 for line in own]
        covered = sum(np.ptp(line[:, :2] @ along) for line in own)
        if sum(go_down) > 0.5 * len(own) and covered < 0.5 * np.ptp(places @ along):
            return True
    return False


def contours(surface: Horizon | Mesh, interval: float | str | None = None, *, faults: Faults | None = None,
             progress: Progress | None = None) -> Lines:
    """Contours a horizon or a mesh, at multiples of an interval.

    Parameters
    ----------
    surface : Horizon or Mesh
        The contours of a mesh are smoother. Horizon points are connected between neighbouring columns.
    interval : float or str, optional
        In the unit of z or with a unit; by default a round interval that gives about twelve levels.
    faults : Faults, optional
        Faults at which a horizon is open; meshes are open at their own faults.
    progress : callable, optional

    Returns
    -------
    Lines
        Named after their levels. Closed contours end with their first point, and the higher side is to the left.

    Raises
    ------
    ValueError
        If the interval gives more than 10,000 levels.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> found = sh.contours(sh.horizon(1000.0 + np.arange(30) + np.zeros((20, 1)), spacing=(25, 25)), 10.0)
    >>> found.names
    ['1020', '1010', '1000']
    """
    if not isinstance(surface, (Horizon, Mesh)):
        raise TypeError("contours of %s, expected a Horizon or a Mesh" % type(surface).__name__)
    chosen = 0.0 if interval is None else height("interval", interval, surface.vertical_unit)
    if faults is not None and not isinstance(surface, Horizon):
        raise TypeError("contours of a Mesh with faults, expected them where the mesh is made: surface(horizon, faults=faults)")
    given = surface._data(links_of(faults)) if isinstance(surface, Horizon) else surface._data()
    (lines,) = call(surface.name, _core.contours, given, chosen, progress)
    lines["cell_data"]["FaultName"] = lines["cell_data"]["Label"]
    return Lines.of(lines)


def by_fault(surfaces: Data) -> dict[str, Mesh]:
    """A mesh for each fault."""
    corners = np.asarray(surfaces["polygons"][1]).reshape(-1, 3)
    names, meshes = np.array(surfaces["cell_data"].get("FaultName", []), object), {}
    for name in dict.fromkeys(names):
        points, own = np.unique(corners[names == name], return_inverse=True)
        meshes[name] = mesh_of(name, {**surfaces, "places": surfaces["places"][points], "polygons": give_triangles(own.reshape(-1, 3)),
                                      "point_data": {}, "cell_data": {}}, {}, surfaces["field_data"], None)
    return meshes


@overload
def surface(horizon: Horizon, largest_error: float | str | None = ..., **options: Any) -> Mesh: ...
@overload
def surface(horizon: Mapping[str, Horizon], largest_error: float | str | None = ..., **options: Any) -> dict[str, Mesh]: ...


def surface(horizon: Any, largest_error: float | str | None = None, *, triangles: int | None = None,  # type: ignore[misc]
            smallest_angle: float = 2.0, edge_length: float = 0.0, edge_growth: float = 0.0, effort: str = "best", fit_heights: bool = True, crossing_tolerance: str = "same",
            radius: int | None = None,
            keep_holes: bool = True, smallest_hole_size: int | None = None, minimum_patch_size: int = 1,
            outline_tolerance: float | None = None, distance_threshold: float | str | None = None, faults: Faults | None = None,
            close_faults: bool = False, progress: Progress | None = None) -> Any:
    """Makes a mesh with few triangles within a given error.

    Parameters
    ----------
    horizon : Horizon, or dict of horizons
    largest_error : float or str, optional
        Largest vertical distance of horizon points from the mesh, in the unit of z or with a unit, as "2 ms"; by
        default six times the noise.
    triangles : int, optional
        Largest number of triangles, instead of an error.
    smallest_angle : float
        Smallest angle in map view that optimisation may create, in degrees, from 0 to 60.
    edge_length : float
        Longest inner edge of even, near-equilateral triangles, in columns, at least 4; 0: off.
    edge_growth : float
        Growth of edges with distance from outlines and faults, from at most three columns up to `edge_length`, from 0
        to 1; 0: `edge_length` everywhere.
    effort : "best" or "fast"
        "best" needs at most half as many points as "fast", and two to four times the time.
    fit_heights : bool
        Fits heights of inner vertices to nearby points, which needs fewer vertices; otherwise vertices are points of
        the horizon.
    crossing_tolerance : "same", "twice" or "unbounded"
        Vertical error of inner edges between columns: the same as at points, twice that, or unbounded, which permits
        spikes between columns.
    radius : int, optional
        Largest hop of outlines along each axis, in columns; by default chosen from the spacing of points.
    keep_holes : bool
        Keeps holes open unless they are too small.
    smallest_hole_size : int, optional
        Holes with fewer columns strictly inside are closed; by default chosen from radius and outline tolerance.
    minimum_patch_size : int
        Patches with fewer points are dropped.
    outline_tolerance : float, optional
        Largest distance in map view of a dropped point from its outline, in columns; by default the error, at most 0.75.
    distance_threshold : float or str, optional
        Largest vertical distance of a dropped point from its outline, in the unit of z or with a unit; by default the
        error. If this and `outline_tolerance` are 0, tiles fit at straight borders.
    faults : Faults, optional
        Faults that split the surface, from `faults`.
    close_faults : bool
        Closes cracks at faults with steep triangles.
    progress : callable, optional
        Called with the fraction done; an exception in it stops the work.

    Returns
    -------
    Mesh, or dict of meshes

    Raises
    ------
    ValueError
        If an option is out of range, or the outlines already need more triangles.

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
        given = dict(triangles=triangles, smallest_angle=smallest_angle, edge_length=edge_length, edge_growth=edge_growth,
                     effort=effort, fit_heights=fit_heights,
                     crossing_tolerance=crossing_tolerance, radius=radius,
                     keep_holes=keep_holes, smallest_hole_size=smallest_hole_size, minimum_patch_size=minimum_patch_size,
                     outline_tolerance=outline_tolerance, distance_threshold=distance_threshold, faults=faults,
                     close_faults=close_faults, progress=progress)
        return {name: surface(one, largest_error, **given) for name, one in horizon.items()}
    require_horizon(horizon, "a surface")
    if largest_error is not None and triangles is not None:
        raise ValueError("largest_error and triangles, expected one of them")
    options = given_options(
        smallest_angle=float(smallest_angle), edge_length=float(edge_length), edge_growth=float(edge_growth), effort=effort,
        fit_heights=bool(fit_heights), keep_holes=bool(keep_holes),
        crossing_tolerance=crossing_tolerance,
        minimum_patch_size=_count("minimum_patch_size", minimum_patch_size), close_faults=bool(close_faults), error_unit="world",
        radius=None if radius is None else _count("radius", radius),
        smallest_hole_size=None if smallest_hole_size is None else _count("smallest_hole_size", smallest_hole_size),
        outline_tolerance=None if outline_tolerance is None else float(outline_tolerance),
        distance_threshold=None if distance_threshold is None else
        height("distance_threshold", distance_threshold, horizon.vertical_unit) / abs(horizon.lattice.vertical_step),
        maximum_number_of_triangles=None if triangles is None else _count("triangles", triangles),
        maximum_error=None if largest_error is None else height("largest_error", largest_error, horizon.vertical_unit))
    given = horizon._data(links_of(faults))
    data, _ = call(horizon.name, _core.surface, given, options, progress)
    mesh = mesh_of(horizon.name, data, take_attributes(data["point_data"], horizon.attributes), given["field_data"], horizon.lattice)
    if mesh.ledger.left_out > 0.001 * max(1, mesh.ledger.covered):
        way = "" if outline_tolerance == 0 else "; outline_tolerance=0 keeps outlines as they are"
        warn(horizon.name, str(mesh.ledger) + way)
    return mesh


def fill_holes(horizon: Horizon, largest_hole_size: int = 2500, *, method: str = "automatic", rim_smoothing: float = 1.0,
               rim_width: int = 3, extrapolation_distance: int = 0, faults: Faults | None = None,
               progress: Progress | None = None) -> Horizon:
    """Fills holes with a smooth continuation of the surrounding surface.

    Parameters
    ----------
    horizon : Horizon
    largest_hole_size : int
        Holes with more columns stay open.
    method : "automatic", "plate" or "membrane"
        "plate" continues the slope and curvature of the rim; "membrane" stays between the heights of the rim;
        "automatic" is a plate with smoothing and width chosen from the roughness.
    rim_smoothing : float
        Smoothing of rim noise by a plate. 0: none, for clean data; 1: for autotracked picks; 16: for noise above half a
        vertical index. "automatic" chooses it.
    rim_width : int
        Width of the rim that a plate continues, in columns. Noisy data need more.
    extrapolation_distance : int
        Also fills columns up to this far outside the horizon, within the survey.
    faults : Faults, optional
        Faults; each side of a fault is filled independently.
    progress : callable, optional

    Returns
    -------
    Horizon
        With the new points at the end, marked in `filled`. Fractional attributes are interpolated; others have the
        value of the nearest point.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> z[8:11, 10:14] = np.nan
    >>> int(sh.fill_holes(sh.horizon(z)).filled.sum())
    12
    """
    require_horizon(horizon, "filling")
    options = {"method": method, "largest_hole_size": _count("largest_hole_size", largest_hole_size), "rim_smoothing": float(rim_smoothing),
               "rim_width": int(rim_width), "extrapolation_distance": int(extrapolation_distance)}
    (data,) = call(horizon.name, _core.fill_holes, horizon._data(links_of(faults)), options, progress)
    return _changed(horizon, data)


def _changed(horizon: Horizon, data: Any, attributes: Mapping[str, NDArray[Any]] = {}, **more: Any) -> Horizon:
    """The horizon with the points of data, and more attributes."""
    return dataclasses.replace(
        horizon, columns=data["point_data"]["Column"], z=horizon.sign * data["places"][:, 2], filled=data["point_data"].get("Filled"),
        attributes={**take_attributes(data["point_data"], horizon.attributes), **attributes}, **more)


def despike(horizon: Horizon, threshold: float | str | None = None, *, radius: int = 2, spur_width: int = 0,
            progress: Progress | None = None) -> Horizon:
    """Removes spikes: points far above or below the points around them.

    Parameters
    ----------
    horizon : Horizon
    threshold : float or str, optional
        Points farther above or below the surface through their neighbours are spikes; in the unit of z or with a unit.
        By default four times the noise.
    radius : int
        Reach of the neighbourhood along each axis, in columns; 2 means 5 by 5 columns.
    spur_width : int
        Widest strips and spurs to remove, in columns; 0: none.
    progress : callable, optional

    Returns
    -------
    Horizon
        `left_out` gives the numbers of spikes and of points on spurs.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> z[5, 5] = 1100.0
    >>> sh.despike(sh.horizon(z), 10.0).left_out["spikes"]
    1
    """
    require_horizon(horizon, "despiking")
    options = {"radius": int(radius), "spur_width": int(spur_width), "threshold_unit": "world",
               "threshold": 0.0 if threshold is None else height("threshold", threshold, horizon.vertical_unit)}
    (data,) = call(horizon.name, _core.despike, horizon._data(), options, progress)
    if not len(data["places"]):
        raise ValueError("%s: all points are spikes or on spurs, expected some that stay" % horizon.name)
    spikes, spurs = (int(data["field_data"][name][0]) for name in ("NumberOfSpikes", "NumberOfSpurPoints"))
    return _changed(horizon, data, left_out={**horizon.left_out, "spikes": spikes, "points on spurs": spurs})


@dataclasses.dataclass(eq=False, repr=False)
class Thickness:
    """Thickness between two horizons, from `thickness`.

    Attributes
    ----------
    horizon : Horizon
        The top at columns with both horizons. The attribute Isochore is the vertical thickness and, where z has the
        unit of x and y, Isopach is the thickness perpendicular to the layer (nan where the dip is unknown), both in the
        unit of z and negative where the horizons cross.
    least, mean, largest : float
        Isochore.
    volume : float
        Sum over columns of area times isochore, with 0 where horizons cross. nan if z is time.
    columns, left_out, crossings : int
        Numbers of columns with both horizons, with only one, and with negative thickness.
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
        On lattices with the same steps and common columns; z has the same direction and unit.
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
        require_horizon(one, "thickness")
    if top.direction != base.direction:
        raise ValueError("%s and %s: z %s and %s, expected one direction" % (top.name, base.name, top.direction, base.direction))
    (data,) = call("%s and %s" % (top.name, base.name), _core.thickness, top._data(), base._data(), progress)
    fields, points = data["field_data"], data["point_data"]
    both = _changed(top, data, {name: points[name] for name in ("Isochore", "Isopach") if name in points})
    least, mean, largest, volume = (float(fields[name][0]) if name in fields else np.nan for name in (
        "IsochoreLeast", "IsochoreMean", "IsochoreLargest", "IsochoreVolume"))
    columns, *_, left_out = fields["LedgerColumns"].ravel().tolist()
    return Thickness(both, least, mean, largest, volume, columns, left_out, int(fields["IsochoreCrossings"][0]))
