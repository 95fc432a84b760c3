# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cubes from arrays, and what their amplitudes are at horizons."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._cube import Cube, require_unit
from ._door import CROSSLINE, INLINE, STEP_TOLERANCE
from ._horizon import Floats, Horizon, Lattice
from ._made import framing
from ._stages import require_horizon
from ._units import UNITS, height

Lines = tuple[float, float, float, float]
BLOCK = 1 << 20  # Samples that are worked on at a time.
NEAR = 1e-3  # Distance from a column, in columns, within which a place is on it.
FIGURES = ("RmsAmplitude", "MeanAmplitude", "LargestAmplitude", "SmallestAmplitude")


# ---- Cubes from arrays ------------------------------------------------------------------------------------------------
def cube(values: Any, lattice: Lattice | None = None, *, corners: Sequence[Sequence[float]] | None = None, lines: Lines | None = None,
         first_z: float | None = None, vertical_step: float | None = None, nodata: float | None = None, name: str = "cube", direction: str = "down",
         vertical_unit: str = "", vertical_domain: str = "", horizontal_unit: str = "", coordinate_system: str = "") -> Cube:
    """Makes a cube from an array, such as one from a reader of another format.

    Parameters
    ----------
    values : array or xarray.DataArray of shape (inlines, crosslines, samples)
        May be memory-mapped: it is copied once, on first use. nan and masked values are missing samples. A DataArray
        may have its dimensions in any order (inline, crossline and a third one, with lines and z as coordinates), and
        positions in the coordinates cdp_x and cdp_y.
    lattice : Lattice, optional
        Lattice of the traces.
    corners : three or four of (x, y), optional
        Instead of a lattice: x and y of the traces at the first inline and crossline, at the last inline and first
        crossline, at the first inline and last crossline and, as a check, at the last inline and crossline.
    lines : (first inline, inline step, first crossline, crossline step), optional
        Line numbers, with `corners`.
    first_z, vertical_step : float, optional
        z of the first sample, and z between samples; by default from the lattice or the coordinates.
    nodata : float, optional
        Value that marks a missing sample.
    name : str
    direction : "down" or "up"
        Direction in which the sample number increases.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str, optional

    Returns
    -------
    Cube

    Raises
    ------
    ValueError
        If positions are not on a lattice or have another shape, or samples have no constant step.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> values = np.zeros((20, 30, 100), np.float32)
    >>> sh.cube(values, corners=[(5e5, 6e6), (5e5, 6.0019e6), (5.00725e5, 6e6)], vertical_step=4.0, vertical_unit="ms")
    Cube cube: 30 columns x 20 rows, 25 x 100 apart, 100 samples from 0 to 396 ms
    """
    if hasattr(values, "dims"):
        values, found = _of_xarray(values, lattice is not None or corners is not None)
        lattice, vertical_unit = lattice or found.get("lattice"), vertical_unit or found["vertical_unit"]
        lines, first_z = lines or found.get("lines"), found.get("first_z") if first_z is None else first_z
        vertical_step = found.get("vertical_step") if vertical_step is None else vertical_step
    if np.ndim(values) != 3:
        raise ValueError("values of %d axes, expected (inlines, crosslines, samples)" % np.ndim(values))
    if (lattice is None) == (corners is None):
        raise ValueError("%s, expected one of lattice and corners" % ("no lattice" if lattice is None else "lattice and corners"))
    rows, columns, samples = values.shape
    if lattice is None:
        if vertical_step is None:
            raise ValueError("corners without vertical_step, expected z between samples")
        lattice = _of_corners((rows, columns), np.asarray(corners, float), lines)
    framing(vertical_step, direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system)
    lattice = dataclasses.replace(lattice, indices=samples, first_z=lattice.first_z if first_z is None else float(first_z),
                                  vertical_step=lattice.vertical_step if vertical_step is None else float(vertical_step))
    known = ~np.ma.getmaskarray(values) if np.ma.isMaskedArray(values) else None
    values = np.asarray(values)
    if values.dtype.kind not in "iuf":
        raise ValueError("values of type %s, expected numbers" % values.dtype)
    if nodata is not None:
        known = (values != nodata) if known is None else known & (values != nodata)
    domain = vertical_domain or UNITS.get(vertical_unit, ("", 0.0))[0].replace("length", "depth")
    return Cube(values, lattice, known, name=name, direction=direction or "down", vertical_unit=vertical_unit, vertical_domain=domain,
                horizontal_unit=horizontal_unit, coordinate_system=coordinate_system)


def _of_corners(shape: tuple[int, int], corners: Floats, lines: Lines | None) -> Lattice:
    if corners.shape not in ((3, 2), (4, 2)) or not np.isfinite(corners).all():
        raise ValueError("corners of shape %s, expected three or four of (x, y)" % (corners.shape,))
    rows, columns = shape
    row, column = (corners[1] - corners[0]) / max(1, rows - 1), (corners[2] - corners[0]) / max(1, columns - 1)
    off = np.linalg.norm(corners[1] + corners[2] - corners[0] - corners[3]) if len(corners) == 4 else 0.0
    if off > 0.1 * min(np.linalg.norm(row), np.linalg.norm(column)):
        raise ValueError("a fourth corner %.6g from where the others have it, expected less than a tenth of a step" % off)
    if not abs(row[0] * column[1] - row[1] * column[0]) > 0.0:
        raise ValueError("corners %s on one line, expected some that span a lattice" % corners.tolist())
    return _lattice(shape, corners[0], column, row, lines)


def _lattice(shape: tuple[int, int], origin: Floats, column_step: Floats, row_step: Floats, lines: Lines | None) -> Lattice:
    places = [(float(x), float(y)) for x, y in (origin, column_step, row_step)]
    return Lattice(shape, places[0], places[1], places[2], lines=lines)


def _of_xarray(array: Any, has_lattice: bool) -> tuple[Any, dict[str, Any]]:
    """Values by inlines, crosslines and samples, and what coordinates say. Raises ValueError."""
    known = {str(dim).lower(): dim for dim in array.dims}
    pair = [next((known[name] for name in names if name in known), None) for names in (INLINE, CROSSLINE)]
    if len(known) != 3 or None in pair:
        raise ValueError("dimensions %s, expected inline, crossline and that of samples" % ", ".join(map(str, array.dims)))
    array = array.transpose(*pair, next(dim for dim in array.dims if dim not in pair))
    steps = [_steps(array, dim) for dim in array.dims]
    found: dict[str, Any] = {"vertical_unit": ""}
    if None not in steps[:2]:
        found["lines"] = (*steps[0], *steps[1])  # type: ignore[misc]
    if steps[2] is not None:
        units = str(array[array.dims[2]].attrs.get("units", ""))
        found.update(first_z=steps[2][0], vertical_step=steps[2][1], vertical_unit=units if units in UNITS else "")
    if not has_lattice:
        missing = [name for name in ("cdp_x", "cdp_y") if name not in array.coords]
        if missing:
            raise ValueError("no coordinates %s, expected these, or lattice or corners" % " and ".join(missing))
        found["lattice"] = _of_places(array, [array.coords[name].transpose(*array.dims[:2]).values for name in ("cdp_x", "cdp_y")], found.get("lines"))
    return array.values, found


def _steps(array: Any, dim: Any) -> tuple[float, float] | None:
    """First value and step of a coordinate, or None without one. Raises ValueError for other ones."""
    if dim not in array.coords:
        return None
    values = np.asarray(array[dim].values, float)
    step = float((values[-1] - values[0]) / max(1, len(values) - 1)) or 1.0
    if np.abs(values - (values[0] + step * np.arange(len(values)))).max() > STEP_TOLERANCE * abs(step):
        raise ValueError("coordinates %s without equal steps, expected those of a cube" % dim)
    return float(values[0]), step


def _of_places(array: Any, places: list[Any], lines: Lines | None) -> Lattice:
    """The lattice of least squares of x and y. Raises ValueError for others, as from bent lines."""
    row, column = np.indices(array.shape[:2])
    given = np.column_stack([np.asarray(axis, float).ravel() for axis in places])
    has_place = np.isfinite(given).all(axis=1)
    index = np.column_stack((np.ones(row.size), column.ravel(), row.ravel()))
    (origin, column_step, row_step), _, rank, _ = np.linalg.lstsq(index[has_place], given[has_place], rcond=None)
    off = np.abs(index[has_place] @ (origin, column_step, row_step) - given[has_place]).max(initial=0.0)
    if rank < 3 or off > 0.5 * max(np.linalg.norm(column_step), np.linalg.norm(row_step)):
        raise ValueError("cdp_x and cdp_y up to %.6g from a lattice, expected less than half a step: lattice or corners give another" % off)
    return _lattice(array.shape[:2], origin, column_step, row_step, lines)


# ---- Amplitudes of horizons -------------------------------------------------------------------------------------------
def amplitudes(cube: Cube, horizon: Horizon, base: Horizon | None = None, *, above: float | str = 0.0, below: float | str = 0.0) -> Horizon:
    """Adds amplitudes of a cube at a horizon and, if requested, statistics in a window around it or down to another
    horizon.

    Parameters
    ----------
    cube : Cube
    horizon : Horizon
        On the lattice of the cube or on another one; amplitudes between traces are interpolated linearly from the four
        around.
    base : Horizon, optional
        Lower end of the window: a horizon below, on the same lattice.
    above, below : float or str
        How far the window extends above the horizon, and below it or below the base; in the unit of z or with a unit.

    Returns
    -------
    Horizon
        With the attribute CubeAmplitude, interpolated linearly between samples, and with a window also RmsAmplitude,
        MeanAmplitude, LargestAmplitude and SmallestAmplitude of its samples. nan where the cube has no sample or a
        horizon has no point.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> values = np.zeros((20, 30, 100)) + np.arange(100)
    >>> cube = sh.cube(values, sh.Lattice((20, 30), vertical_step=4.0), vertical_unit="ms")
    >>> top = sh.amplitudes(cube, sh.horizon(np.full((20, 30), 202.0), vertical_unit="ms"), above="8 ms", below="8 ms")
    >>> float(top["CubeAmplitude"][0]), float(top["SmallestAmplitude"][0]), float(top["LargestAmplitude"][0])
    (50.5, 49.0, 52.0)
    """
    if not isinstance(cube, Cube):
        raise TypeError("amplitudes of %s, expected a Cube: read_cube(path) and cube(array) make one" % type(cube).__name__)
    if cube._file is not None:
        raise ValueError("amplitudes of %s, whose samples are in its file, expected them in memory: read_cube(path) without load=False" % cube.name)
    require_horizon(horizon, "amplitudes")
    for one in (horizon, *([] if base is None else [base])):
        require_unit(one, cube)
    reach = [height(name, value, horizon.vertical_unit) for name, value in (("above", above), ("below", below))]
    z = horizon.z if horizon.sign == cube.sign else -horizon.z
    end = z if base is None else _z_at(base, horizon) * (horizon.sign * cube.sign)
    down = -cube.sign
    window = [(edge - cube.lattice.first_z) / cube.lattice.vertical_step for edge in (z - down * reach[0], end + down * reach[1])]
    first, last = window if down * cube.lattice.vertical_step > 0.0 else window[::-1]
    place = (z - cube.lattice.first_z) / cube.lattice.vertical_step
    has_window = base is not None or sum(reach) > 0.0
    names = ("CubeAmplitude", *(FIGURES if has_window else ()))
    made = {name: np.full(len(horizon), np.nan) for name in names}
    column, row = np.linalg.solve(np.column_stack((cube.lattice.column_step, cube.lattice.row_step)),
                                  np.subtract((horizon.x, horizon.y), np.reshape(cube.lattice.origin, (2, 1))))
    for part, start, traces in _blocks(cube, column, row, np.fmin(first, place), np.fmax(last, place)):
        made[names[0]][part] = _between_samples(traces, place[part] - start)
        if has_window:
            for name, figures in zip(FIGURES, _figures(traces, first[part] - start, last[part] - start)):
                made[name][part] = figures
    return dataclasses.replace(horizon, attributes={**horizon.attributes, **made})


def _z_at(base: Horizon, horizon: Horizon) -> Floats:
    """z of a horizon at the points of another one, in its direction; nan where it has none. Raises ValueError."""
    a, b = base.lattice, horizon.lattice
    if a.shape != b.shape or not np.allclose((a.origin, a.column_step, a.row_step), (b.origin, b.column_step, b.row_step)):
        raise ValueError("%s on another lattice than %s, expected the same" % (base.name, horizon.name))
    z: Floats = base.grid()[horizon.columns[:, 1], horizon.columns[:, 0]] * (base.sign * horizon.sign)
    return z


def _blocks(cube: Cube, column: Floats, row: Floats, first: Floats, last: Floats) -> Iterator[tuple[Any, int, Floats]]:
    """Points in the cube by blocks: their numbers, the first sample, and samples of their traces, up to BLOCK at a time."""
    rows, columns, samples = np.shape(cube.values)
    column, row = (np.where(np.abs(axis - np.rint(axis)) < NEAR, np.rint(axis), axis) for axis in (column, row))
    inside = (column >= 0) & (column <= columns - 1) & (row >= 0) & (row <= rows - 1) & (last >= 0) & (first <= samples - 1)
    points = np.flatnonzero(inside & np.isfinite(first) & np.isfinite(last))
    size = max(1, BLOCK // samples)
    for part in (points[n:n + size] for n in range(0, len(points), size)):
        start = int(np.clip(np.floor(first[part].min()), 0, samples - 1))
        end = int(np.clip(np.ceil(last[part].max()), 0, samples - 1)) + 1
        yield part, start, _traces(cube, column[part], row[part], slice(start, end))


def _traces(cube: Cube, column: Floats, row: Floats, which: slice) -> Floats:
    """Samples of traces, interpolated between the four around; nan where one of these has none."""
    total = np.zeros((len(column), which.stop - which.start))
    left, low = np.floor(column).astype(int), np.floor(row).astype(int)
    for right, high in ((0, 0), (1, 0), (0, 1), (1, 1)):
        weight = (column - left if right else 1.0 - column + left) * (row - low if high else 1.0 - row + low)
        used = np.flatnonzero(weight)
        if len(used):
            corner = (low[used] + high, left[used] + right, which)
            found = np.asarray(cube.values[corner], np.float64)
            if cube.known is not None:
                found = np.where(cube.known[corner], found, np.nan)
            total[used] += weight[used, None] * found
    return total


def _between_samples(traces: Floats, place: Floats) -> Floats:
    below = np.clip(np.floor(place).astype(int), 0, traces.shape[1] - 1)
    next_one = np.minimum(below + (place > below), traces.shape[1] - 1)
    a, b = (np.take_along_axis(traces, index[:, None], 1)[:, 0] for index in (below, next_one))
    part = place - below
    return np.where((part >= 0.0) & (part <= next_one - below), a + part * np.where(part == 0.0, 0.0, b - a), np.nan)


def _figures(traces: Floats, first: Floats, last: Floats) -> tuple[NDArray[Any], ...]:
    """Root mean square, mean, largest and smallest of the samples within windows."""
    number = np.arange(traces.shape[1])
    used = (number >= first[:, None]) & (number <= last[:, None]) & np.isfinite(traces)
    count = used.sum(axis=1)
    values = np.where(used, traces, 0.0)
    with np.errstate(invalid="ignore"):  # 0 / 0 in empty windows
        mean, square = values.sum(axis=1) / count, (values**2).sum(axis=1) / count
    largest, smallest = (np.where(count > 0, of(np.where(used, traces, sign), axis=1), np.nan) for of, sign in ((np.max, -np.inf), (np.min, np.inf)))
    return np.sqrt(square), mean, largest, smallest
