# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from arrays of numpy, and from surfaces of xtgeo and xarray, which are known by their attributes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection, vtkPolyData

from . import calls
from .reading import list_horizons
from .stage import make

STEP_TOLERANCE = 1e-4  # of a step, by which coordinates of a grid may differ: those of single precision do


def horizon(z: Any, origin: Sequence[float] | None = None, spacing: Sequence[float] | None = None, azimuth: float | None = None,
            nodata: float | Sequence[float] | None = None, **keywords: Any) -> vtkPolyData:
    """A horizon from heights on a grid.

    Parameters
    ----------
    z : array of shape (rows, columns), RegularSurface of xtgeo or DataArray of xarray
        time, depth or elevation; nan, masked cells and `nodata` are left out. A surface of xtgeo, or a DataArray with
        coordinates, knows its own place.
    origin : (x, y), optional
        the place of z[0, 0]; 0, 0 by default. World units.
    spacing : (column, row), optional
        the distances from a column to the next, and from a row to the next; 1, 1 by default. World units.
    azimuth : float, optional
        the direction in which columns follow each other, in degrees clockwise from north; 90 by default, which is along
        x. Rows follow each other 90 degrees anticlockwise from there.
    nodata : float or list of float, optional
        numbers that stand for no value.
    **keywords
        properties of HorizonFromPoints: `vertical_direction` ("Down", the default, for time and depth, "Up" for
        elevations), `vertical_unit` ("ms", "s", "m" or "ft"), `vertical_step`, `coordinate_system` and the like.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData where PyVista is imported
        a point for each column with a value, on the lattice of the whole array. World z is negative where z counts
        downwards.

    Raises
    ------
    ValueError
        z of another shape, without a value, or on coordinates that are no grid.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> top = sh.horizon(np.full((20, 30), 1000.0), origin=(5e5, 6e6), spacing=(25, 25), vertical_unit="ms")
    >>> top.GetNumberOfPoints()
    600
    """
    if hasattr(z, "xori") and hasattr(z, "rotation"):
        _require_none("a surface of xtgeo", origin=origin, spacing=spacing, azimuth=azimuth)
        values, origin, column_step, row_step = _of_xtgeo(z)
    elif hasattr(z, "dims") and hasattr(z, "coords"):
        _require_none("a DataArray", origin=origin, spacing=spacing, azimuth=azimuth)
        values, origin, column_step, row_step = _of_xarray(z)
        nodata = z.attrs.get("_FillValue", z.attrs.get("nodata")) if nodata is None else nodata
    else:
        values, column_step, row_step = np.ma.masked_invalid(z), *_steps(spacing, azimuth)
        origin = (0.0, 0.0) if origin is None else origin
    if values.ndim != 2:
        raise ValueError("z of shape %s, expected (rows, columns); horizon_from_points makes horizons of n x 3 points"
                         % (values.shape,))
    return _on_lattice(values, np.asarray(origin, dtype=float)[:2], column_step, row_step, nodata, keywords)


def _on_lattice(values, origin, column_step, row_step, nodata, keywords):
    """The horizon of an array with its place."""
    heights = np.ma.filled(np.ma.masked_invalid(values.astype(float)), np.nan)
    heights[np.isin(heights, [] if nodata is None else nodata)] = np.nan
    rows, columns = np.isfinite(heights).nonzero()
    if not rows.size:
        raise ValueError("z without a single value, expected some that are not nan, masked or nodata")
    places = origin + np.outer(columns, column_step) + np.outer(rows, row_step)
    lattice = {"lattice_source": "OriginAndSteps", "origin": tuple(origin), "column_step": tuple(column_step),
               "row_step": tuple(row_step)}
    made = horizon_from_points(np.column_stack((places, heights[rows, columns])), **{**lattice, **keywords})
    if not lattice.keys() & keywords.keys():
        for data in made.values() if isinstance(made, dict) else [made]:
            _widen(data, values.shape, origin)
    return made


def _widen(data, shape, origin):
    """Gives a horizon the lattice of the whole array that it comes from, in place of that of its points."""
    size, to_world = (vtk_to_numpy(data.GetFieldData().GetArray(name)).reshape(-1) for name in ("LatticeDimensions", "LatticeToWorld"))
    matrix = to_world.reshape(4, 4)
    first = np.linalg.solve(matrix[:2, :2], matrix[:2, 3] - origin)
    vtk_to_numpy(data.GetPointData().GetArray("Column"))[:] += np.rint(first).astype(int)
    matrix[:2, 3] = origin
    size[:2] = shape[::-1]


def horizon_from_points(points: Any, name: str | None = None, **keywords: Any) -> vtkPolyData | dict[str, vtkPolyData]:
    """A horizon from points, whose lattice is found.

    Parameters
    ----------
    points : array of shape (n, 3)
        x, y and z, which counts downwards unless `vertical_direction` is "Up"; points with nan are left out.
    name : str, optional
        what errors call it.
    **keywords
        properties of HorizonFromPoints. `gridding="Plate"` makes a horizon of points that stand on no lattice;
        `stray_picks="LeaveOut"` leaves out those that are off it; `lattice_source="OriginAndSteps"` with `origin`,
        `column_step` and `row_step` gives the lattice.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData where PyVista is imported
        with `duplicate_policy="Sheets"` a dict of names and horizons, one for each sheet.

    Raises
    ------
    ValueError
        points of another shape, or that stand on no lattice.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> x, y = np.meshgrid(25.0 * np.arange(30), 25.0 * np.arange(20))
    >>> top = sh.horizon_from_points(np.column_stack((x.ravel(), y.ravel(), 1000.0 + 0.01 * x.ravel())))
    >>> sh.details(top).lattice_dimensions[:2].tolist()
    [30, 20]
    """
    data = _points_of(points)
    source = make("vtkHorizonFromPoints")
    calls.set_keywords(source, keywords)
    source.SetInputDataObject(data)
    calls.run(source, name or "horizon")
    found = list_horizons(source.GetOutputDataObject(0))
    if source.GetDuplicatePolicy() != source.Sheets:
        return calls.wrap(found[0][1])
    base = found[0][0]
    return {(name or base) + sheet[len(base):]: calls.wrap(data) for sheet, data in found}


def _points_of(points):
    places = np.asarray(points, dtype=float)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError("points of shape %s, expected (n, 3): x, y and z; horizon makes horizons of grids"
                         % (places.shape,))
    places = places[np.isfinite(places).all(axis=1)]
    if not len(places):
        raise ValueError("no points, expected some that are not nan")
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    return data


def collect_picks(picks):
    """The picks of horizons, by their names where there are some, as one dataset."""
    if not isinstance(picks, Mapping):
        return picks if isinstance(picks, vtkPolyData) else _points_of(picks)
    blocks = vtkPartitionedDataSetCollection()
    for number, (name, points) in enumerate(picks.items()):
        blocks.SetPartition(number, 0, points if isinstance(points, vtkPolyData) else _points_of(points))
        blocks.GetMetaData(number).Set(blocks.NAME(), str(name))
    return blocks


def _require_none(what, **given):
    names = [name for name, value in given.items() if value is not None]
    if names:
        raise ValueError("%s for %s, which has a place of its own, expected none" % (" and ".join(names), what))


def _steps(spacing, azimuth):
    """From a column to the next, and from a row to the next."""
    direction = math.radians(90.0 - (90.0 if azimuth is None else azimuth))
    column, row = (1.0, 1.0) if spacing is None else spacing
    return (column * np.array((math.cos(direction), math.sin(direction))),
            row * np.array((-math.sin(direction), math.cos(direction))))


def _of_xtgeo(surface):
    """Values as (rows, columns), origin and steps. Those of xtgeo are (columns, rows)."""
    angle = math.radians(surface.rotation)
    column = np.array((math.cos(angle), math.sin(angle)))
    row = np.array((-math.sin(angle), math.cos(angle))) * surface.yflip
    return (np.ma.masked_invalid(surface.values).T, (surface.xori, surface.yori), surface.xinc * column,
            surface.yinc * row)


def _of_xarray(array):
    """The same of an array with coordinates along its last two dimensions."""
    if len(array.dims) != 2:
        raise ValueError("a DataArray of dimensions %s, expected two: those of y and x, in this order"
                         % ", ".join(map(str, array.dims)))
    y, x = (_axis(array, name) for name in array.dims)
    return np.ma.masked_invalid(array.values), (x[0], y[0]), np.array((x[1], 0.0)), np.array((0.0, y[1]))


def _axis(array, name):
    """The first coordinate and the step of a dimension. Raises ValueError."""
    if name not in array.coords:
        raise ValueError("a DataArray without coordinates along %s, expected those of x and y; horizon(array.values, "
                         "origin=, spacing=) takes them" % name)
    values = np.asarray(array.coords[name], dtype=float)
    steps = np.diff(values)
    if not len(steps) or not steps[0] or abs(steps - steps.mean()).max() > STEP_TOLERANCE * abs(steps.mean()):
        raise ValueError("coordinates along %s with unequal steps or none, expected equal ones; horizon_from_points with "
                         "gridding=\"Plate\" takes any" % name)
    return values[0], (values[-1] - values[0]) / len(steps)
