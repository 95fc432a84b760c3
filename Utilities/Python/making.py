# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from NumPy arrays, xtgeo surfaces, xarray arrays and pandas tables; the types are recognized by their
attributes."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (vtkImageData, vtkPartitionedDataSetCollection, vtkPointSet, vtkPolyData,
                                           vtkTable)

from . import calls
from .reading import list_horizons
from .stage import make

STEP_TOLERANCE = 1e-4  # fraction of a step by which grid coordinates may deviate, for single precision
SINGLE_PRECISION = 2.0**-24  # relative rounding; nulls are stored in single precision, as IsNullValue in Common/Survey
# Names of xarray dimensions and coordinates, in lower case.
X, Y = ("x", "easting", "eastings", "cdp_x", "lon", "longitude"), ("y", "northing", "northings", "cdp_y", "lat", "latitude")
INLINE, CROSSLINE = ("inline", "iline", "il"), ("crossline", "xline", "xl")


def horizon(z: Any, origin: Sequence[float] | None = None, spacing: Sequence[float] | None = None,
            azimuth: float | None = None, nodata: float | Sequence[float] | None = None, **keywords: Any) -> vtkPolyData:
    """Makes a horizon from heights on a grid.

    Parameters
    ----------
    z : array of shape (rows, columns), xtgeo RegularSurface, xarray DataArray or vtkImageData
        Time, depth or elevation; nan, masked cells and `nodata` are left out. An xtgeo surface, an image and a DataArray
        with coordinates have a position of their own. The dimensions of a DataArray are x and y, or inline and crossline;
        they are recognized by name, in either order. Inlines and crosslines may have the coordinates cdp_x and cdp_y.
    origin : (x, y), optional
        Position of z[0, 0] in world units; (0, 0) by default.
    spacing : (column, row), optional
        Distance between adjacent columns and between adjacent rows in world units; (1, 1) by default.
    azimuth : float, optional
        Direction of increasing column number, in degrees clockwise from north; 90 by default, along x. The direction of
        increasing row number is 90 degrees anticlockwise from it.
    nodata : float or list of float, optional
        Values that mean "no data", compared in single precision.
    **keywords
        Properties of HorizonFromPoints, such as `vertical_direction` ("Down" for time and depth, "Up" for elevations; by
        default "Up" if no z is positive, otherwise "Down"), `vertical_unit` ("ms", "s", "m" or "ft"), `vertical_step` or
        `coordinate_system`.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData if PyVista is imported
        A point for each column with a value, on the lattice of the whole array. World z is negative if z increases
        downwards.

    Raises
    ------
    ValueError
        If z has another shape or no value, or if its coordinates do not form a grid.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> top = sh.horizon(np.full((20, 30), 1000.0), origin=(5e5, 6e6), spacing=(25, 25), vertical_unit="ms")
    >>> top.GetNumberOfPoints()
    600
    """
    for what, is_one in (("an image", isinstance(z, vtkImageData)), ("a surface of xtgeo", hasattr(z, "xori")),
                         ("a DataArray", hasattr(z, "dims"))):
        if is_one:
            _require_none(what, origin=origin, spacing=spacing, azimuth=azimuth)
    if isinstance(z, vtkImageData):
        return _run("vtkHorizonFromImage", z, None, keywords)
    if hasattr(z, "xori"):
        return _on_grid(*_of_xtgeo(z), nodata, keywords)
    if hasattr(z, "dims"):
        z = _only_variable(z)
        nodata = z.attrs.get("_FillValue", z.attrs.get("nodata")) if nodata is None else nodata
        dims = _dimensions(z)
        if dims[0] in INLINE:
            lines = _lines_of(z, dims, nodata)
            return _count_nulls(horizon_from_points(lines, **keywords), np.size(z.values) - lines.GetNumberOfRows())
        return _on_grid(*_of_xarray(z, dims), nodata, keywords)
    origin = (0.0, 0.0) if origin is None else origin
    return _on_grid(np.ma.masked_invalid(z), origin, *_steps(spacing, azimuth), nodata, keywords)


def _on_grid(values, origin, column_step, row_step, nodata, keywords):
    if values.ndim != 2:
        raise ValueError("z of shape %s, expected (rows, columns); horizon_from_points makes horizons of n x 3 points"
                         % (values.shape,))
    return _on_lattice(values, np.asarray(origin, dtype=float)[:2], column_step, row_step, nodata, keywords)


def _on_lattice(values, origin, column_step, row_step, nodata, keywords):
    """Makes the horizon of an array with a known position."""
    heights = np.ma.filled(np.ma.masked_invalid(values.astype(float)), np.nan)
    _drop(heights, nodata)
    rows, columns = np.isfinite(heights).nonzero()
    if not rows.size:
        raise ValueError("z without a single value, expected some that are not nan, masked or nodata")
    places = origin + np.outer(columns, column_step) + np.outer(rows, row_step)
    lattice = {"lattice_source": "OriginAndSteps", "origin": tuple(origin), "column_step": tuple(column_step),
               "row_step": tuple(row_step)}
    made = horizon_from_points(np.column_stack((places, heights[rows, columns])), **{**lattice, **keywords})
    _count_nulls(made, heights.size - len(rows))
    if not lattice.keys() & keywords.keys():
        for data in made.values() if isinstance(made, dict) else [made]:
            _widen(data, values.shape, origin)
    return made


def _widen(data, shape, origin):
    """Replaces the lattice of a horizon's points with the lattice of the whole array."""
    size, to_world = (vtk_to_numpy(data.GetFieldData().GetArray(name)).reshape(-1)
                      for name in ("LatticeDimensions", "LatticeToWorld"))
    matrix = to_world.reshape(4, 4)
    first = np.linalg.solve(matrix[:2, :2], matrix[:2, 3] - origin)
    vtk_to_numpy(data.GetPointData().GetArray("Column"))[:] += np.rint(first).astype(int)
    matrix[:2, 3] = origin
    size[:2] = shape[::-1]


def horizon_from_points(points: Any, name: str | None = None, **keywords: Any) -> vtkPolyData | dict[str, vtkPolyData]:
    """Makes a horizon from points and finds their lattice.

    Parameters
    ----------
    points : array of shape (n, 3), pandas or geopandas DataFrame, vtkPolyData or vtkTable
        x, y and z; points with nan are left out and counted, but X and Y of a table must be finite. z increases
        downwards, as time and depth do, unless no z is positive or `vertical_direction` is "Up". The columns of a
        DataFrame or table are named X, Y, Z or Inline, Crossline, Z, in any order; other numeric columns become
        attributes.
    name : str, optional
        Name of the horizon in error messages.
    **keywords
        Properties of HorizonFromPoints. `gridding="Plate"` grids points that are not on a lattice,
        `stray_picks="LeaveOut"` leaves out points off the lattice, and `lattice_source="OriginAndSteps"` with `origin`,
        `column_step` and `row_step` specifies the lattice.

    Returns
    -------
    vtkPolyData, or pyvista.PolyData if PyVista is imported
        The horizon. With `duplicate_policy="Sheets"`, or if a table names several horizons, a dict of horizons by name.

    Raises
    ------
    ValueError
        If the points have another shape or are not on a lattice.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> x, y = np.meshgrid(25.0 * np.arange(30), 25.0 * np.arange(20))
    >>> top = sh.horizon_from_points(np.column_stack((x.ravel(), y.ravel(), 1000.0 + 0.01 * x.ravel())))
    >>> sh.details(top).lattice_dimensions[:2].tolist()
    [30, 20]
    """
    data = points if isinstance(points, (vtkPointSet, vtkTable)) else _table_of(points)
    data = _points_of(points) if data is None else data
    made = _run("vtkHorizonFromPoints", data, name, keywords)
    if isinstance(data, vtkPolyData) and data is not points:
        return _count_nulls(made, len(points) - data.GetNumberOfPoints())
    return made


def _count_nulls(made, number):
    """Adds dropped points to those of the first horizon."""
    data = next(iter(made.values())) if isinstance(made, dict) else made
    vtk_to_numpy(data.GetFieldData().GetArray("DroppedNulls"))[:] += number
    return made


def _run(source_class, data, name, keywords):
    source = make(source_class)
    calls.set_keywords(source, keywords)
    source.SetInputDataObject(data)
    calls.run(source, name or "horizon")
    found = list_horizons(source.GetOutputDataObject(0))
    has_sheets = hasattr(source, "GetDuplicatePolicy") and source.GetDuplicatePolicy() == source.Sheets
    if len(found) == 1 and not has_sheets:
        return calls.wrap(found[0][1])
    base = found[0][0]
    return {(name or base) + label[len(base):] if has_sheets else label: calls.wrap(data) for label, data in found}


def _points_of(points, counts_down=False):
    places = np.asarray(points, dtype=float)
    if places.ndim != 2 or places.shape[1] != 3:
        raise ValueError("points of shape %s, expected (n, 3): x, y and z; horizon makes horizons of grids"
                         % (places.shape,))
    places = places[np.isfinite(places).all(axis=1)]
    if not len(places):
        raise ValueError("no points, expected some that are not nan")
    if counts_down and places[:, 2].max() > 0.0:
        places = places * (1.0, 1.0, -1.0)
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    return data


def collect_picks(picks, counts_down=False):
    """Collects picks of one or more horizons in one dataset, by name if they have names. With `counts_down`, z of arrays
    increases downwards unless no z is positive, as in horizon_from_points."""
    def of(points):
        return points if isinstance(points, vtkPolyData) else _points_of(points, counts_down)

    if not isinstance(picks, Mapping):
        return of(picks)
    blocks = vtkPartitionedDataSetCollection()
    for number, (name, points) in enumerate(picks.items()):
        blocks.SetPartition(number, 0, of(points))
        blocks.GetMetaData(number).Set(blocks.NAME(), str(name))
    return blocks


def _require_none(what, **given):
    """Raises ValueError if a position is given for data that have their own."""
    names = [name for name, value in given.items() if value is not None]
    if names:
        raise ValueError("%s for %s, which has a place of its own, expected none" % (" and ".join(names), what))


def _steps(spacing, azimuth):
    """Returns the steps to the next column and to the next row."""
    direction = math.radians(90.0 - (90.0 if azimuth is None else azimuth))
    column, row = (1.0, 1.0) if spacing is None else spacing
    return (column * np.array((math.cos(direction), math.sin(direction))),
            row * np.array((-math.sin(direction), math.cos(direction))))


def _of_xtgeo(surface):
    """Returns values as (rows, columns), origin and steps; xtgeo orders values as (columns, rows)."""
    angle = math.radians(surface.rotation)
    column = np.array((math.cos(angle), math.sin(angle)))
    row = np.array((-math.sin(angle), math.cos(angle))) * surface.yflip
    return (np.ma.masked_invalid(surface.values).T, (surface.xori, surface.yori), surface.xinc * column,
            surface.yinc * row)


def _drop(heights, nodata):
    for null in np.ravel([] if nodata is None else nodata):
        heights[np.isclose(heights, null, rtol=SINGLE_PRECISION, atol=0.0)] = np.nan


def _table_of(frame):
    """Returns a table with the numeric columns of a DataFrame, or None if the columns have no names."""
    if not hasattr(frame, "columns") or not any(isinstance(name, str) for name in frame.columns):
        return None
    columns = {str(name): frame[name] for name in frame.columns}
    if hasattr(frame, "geometry"):
        columns.pop(frame.geometry.name)
        if not frame.geometry.has_z.all():
            raise ValueError("a GeoDataFrame of points without z, expected points with x, y and z: points_from_xy(x, y, z)")
        columns.update({"X": frame.geometry.x, "Y": frame.geometry.y, "Z": frame.geometry.z})
    return _make_table({name: np.asarray(column) for name, column in columns.items()})


def _make_table(columns):
    table = vtkTable()
    for name, values in columns.items():
        if values.dtype.kind in "iuf":
            array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
            array.SetName(name)
            table.AddColumn(array)
    return table


def _only_variable(array):
    """Returns the array of a Dataset with a single variable."""
    names = list(getattr(array, "data_vars", ())) or [None]
    if len(names) > 1:
        raise ValueError("a Dataset of %s, expected one variable: horizon(dataset[\"%s\"]) takes it"
                         % (", ".join(map(str, names)), names[0]))
    return array if names[0] is None else array[names[0]]


def _dimensions(array):
    """Returns the lower-case names of the dimensions y and x, or inline and crossline, of an array. Other dimensions must
    have length 1. Raises ValueError."""
    known = [str(name).lower() for name in array.dims]
    for rows, columns in ((Y, X), (INLINE, CROSSLINE)):
        found = [[name for name in known if name in names] for names in (rows, columns)]
        others = [length for name, length in zip(known, np.shape(array.values)) if [name] not in found]
        if [len(names) for names in found] == [1, 1] and all(length == 1 for length in others):
            return found[0][0], found[1][0]
    raise ValueError("a DataArray of dimensions %s, expected two, named x and y, or inline and crossline; "
                     "horizon(array.values, origin=, spacing=) takes rows along y"
                     % (", ".join(map(str, array.dims)) or "(none)"))


def _in_order(array, dims):
    """Returns the values of an array with the first of two dimensions first."""
    known = [str(name).lower() for name in array.dims]
    values = np.ma.masked_invalid(array.values)
    kept = sorted(known.index(name) for name in dims)
    values = values.reshape([values.shape[place] for place in kept])
    return values if known.index(dims[0]) < known.index(dims[1]) else values.T


def _of_xarray(array, dims):
    """Returns values, origin and steps of an array with coordinates along y and x."""
    y, x = (_axis(array, name) for name in dims)
    return _in_order(array, dims), (x[0], y[0]), np.array((x[1], 0.0)), np.array((0.0, y[1]))


def _lines_of(array, dims, nodata):
    """Returns the picks of an array along inlines and crosslines, with x and y if it has them."""
    heights = np.ma.filled(_in_order(array, dims).astype(float), np.nan)
    _drop(heights, nodata)
    inlines, crosslines = np.meshgrid(*(_coordinates(array, name) for name in dims), indexing="ij")
    columns = {"Inline": inlines, "Crossline": crosslines, "Z": heights}
    for name, names in (("X", X), ("Y", Y)):
        places = [array.coords[key] for key in array.coords if str(key).lower() in names]
        if places and len(places[0].dims) == 2:
            columns[name] = np.asarray(_in_order(places[0], dims), dtype=float)
    is_known = np.isfinite(heights)
    return _make_table({name: values[is_known] for name, values in columns.items()})


def _coordinates(array, name):
    """Returns the coordinates along a dimension, whose name is in lower case."""
    own = next(dim for dim in array.dims if str(dim).lower() == name)
    if own not in array.coords:
        raise ValueError("a DataArray without coordinates along %s, expected some; horizon(array.values, origin=, spacing=) "
                         "takes them" % own)
    return np.asarray(array.coords[own], dtype=float)


def _axis(array, name):
    """Returns the first coordinate and the step of a dimension. Raises ValueError."""
    values = _coordinates(array, name)
    steps = np.diff(values)
    if not len(steps) or not steps[0] or abs(steps - steps.mean()).max() > STEP_TOLERANCE * abs(steps.mean()):
        raise ValueError("coordinates along %s with unequal steps or none, expected equal ones; horizon_from_points with "
                         "gridding=\"Plate\" takes any" % name)
    return values[0], (values[-1] - values[0]) / len(steps)
