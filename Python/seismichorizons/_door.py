# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from arrays, tables and objects of other packages, which are known by their attributes: none is imported."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._data import Progress, in_keywords
from ._horizon import Horizon
from ._made import framing, horizons, placement

STEP_TOLERANCE = 1e-4  # Fraction of a step by which coordinates of grids may be off, as in single precision.
SINGLE_PRECISION = 2.0**-24  # Relative rounding: values of nodata are compared in single precision.
X, Y = ("x", "easting", "eastings", "cdp_x", "lon", "longitude"), ("y", "northing", "northings", "cdp_y", "lat", "latitude")
INLINE, CROSSLINE = ("inline", "iline", "il"), ("crossline", "xline", "xl")
PLACES = ("x", "y", "inline", "crossline", "z")


def horizon(data: Any = None, y: Any = None, z: Any = None, *, grid: Any = None, points: Any = None, name: str = "",
            attributes: Mapping[str, Any] | None = None, columns: Mapping[str, str] | None = None,
            origin: Sequence[float] | None = None, spacing: Sequence[float] | None = None, azimuth: float | None = None,
            column_step: Sequence[float] | None = None, row_step: Sequence[float] | None = None,
            nodata: float | Sequence[float] | None = None, duplicates: str = "strongest", gridding: str = "",
            leave_out_strays: bool = False, vertical_step: float | None = None, direction: str = "", vertical_unit: str = "",
            vertical_domain: str = "", horizontal_unit: str = "", coordinate_system: str = "",
            progress: Progress | None = None) -> Any:
    """Makes a horizon from arrays, tables, or objects of other packages.

    Parameters
    ----------
    data : any, optional
        One of: heights of shape (rows, columns), also masked or with nan; x, with `y` and `z`; a DataFrame or
        GeoDataFrame with recognisable column names; a DataArray or Dataset of xarray or rioxarray with recognisable
        dimension names; an open rasterio dataset; a surface, points or polygons of xtgeo; an image, a structured grid
        or points of PyVista or VTK.
    y, z : array, optional
        With x as the first argument: vectors, or grids such as those of `numpy.meshgrid`.
    grid : array of shape (rows, columns), optional
        Heights, instead of `data`; needed for a grid of three columns, which would be read as points.
    points : array of shape (n, 3), optional
        Instead of `data`: x, y and z.
    name : str, optional
        By default the name of the data, or "horizon".
    attributes : dict of arrays, optional
        Other values, in the shape of the heights.
    columns : dict, optional
        Columns of a table whose names are not recognised: {"z": "TWT", "x": "E"}. "horizon" is the column of horizon
        names.
    origin : (x, y), optional
        Position of row 0, column 0 of an array of heights; for points, of the lattice, together with both steps.
    spacing : (column, row), optional
        Distances between columns and between rows of an array of heights; (1, 1) by default.
    azimuth : float, optional
        Direction in which column numbers increase, in degrees clockwise from north; 90 by default. Row numbers increase
        to its left.
    column_step, row_step : (x, y), optional
        Steps to the next column and row, instead of spacing and azimuth.
    nodata : float or list of float, optional
        Values that mark missing z.
    duplicates, gridding, leave_out_strays
        As in `read`, for points.
    vertical_step : float, optional
        z between vertical indices; by default derived from the heights.
    direction : "down" or "up", optional
        Direction in which z increases, if the data do not state it. By default upwards if no z is above 0 and one is
        below, as for depths below sea level in negative numbers, or if the data come from PyVista or VTK; otherwise
        downwards, as for time and depth.
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str, optional
    progress : callable, optional
        Called with the fraction done; an exception in it stops the work.

    Returns
    -------
    Horizon
        `taken` describes how the data were interpreted. A dict of horizons by name if a table names several, or with
        duplicates="sheets".

    Raises
    ------
    ValueError
        If points are on no lattice, or if data are ambiguous; the message names the keyword to set.
    TypeError

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> sh.horizon(np.full((20, 30), 1000.0), origin=(5e5, 6e6), spacing=(25, 25), vertical_unit="ms")
    Horizon horizon: 30 columns x 20 rows, 25 x 25 apart, 600 of 600 known, time 1000 to 1000 ms
    >>> x, y = np.meshgrid(25.0 * np.arange(30), 25.0 * np.arange(20))
    >>> sh.horizon(x, y, 1000.0 + 0.01 * x, name="Top", direction="up").lattice.shape
    (20, 30)
    """
    place = {"origin": origin, "spacing": spacing, "azimuth": azimuth, "column_step": column_step, "row_step": row_step}
    where = framing(vertical_step, direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system)
    given = _Given(attributes, nodata, place, columns)
    taken = [item is not None for item in (data, grid, points)]
    if sum(taken) != 1:
        raise TypeError("%d of data, grid and points, expected one of them" % sum(taken))
    if (y is None) != (z is None):
        raise TypeError("only x and %s, expected x, y and z" % ("z" if y is None else "y"))
    arrays = (given.xyz(data, y, z) if z is not None else given.grid(grid) if grid is not None
              else given.points(points) if points is not None else given.recognize(data))
    name = name or given.name or "horizon"
    options = placement(duplicates, gridding, leave_out_strays, **given.lattice)  # type: ignore[arg-type]
    survey = tuple(own or found for own, found in zip(where[2], given.survey))
    try:
        made = horizons(_core.place_points(arrays, given.attributes, given.names or [name], options, where[0],
                                           where[1] or given.direction, survey, progress), name, given.description)
    except ValueError as error:
        raise ValueError("%s: %s" % (name, in_keywords(str(error)))) from None
    for one in made.values():
        if given.dropped:
            reason = "without z" if given.shape else "without a place"
            one.left_out[reason] = one.left_out.get(reason, 0) + given.dropped
        if given.shape and not gridding:
            _widen(one, given.shape, given.lattice["origin"])
        given.restore(one)
        if given.direction and not direction:
            one.taken = (*one.taken[:-1], "z increases %swards, as %s" % (one.direction, given.reason))
    return made if len(made) > 1 or duplicates == "sheets" or given.names else next(iter(made.values()))


def _widen(made: Horizon, shape: tuple[int, int], origin: Sequence[float]) -> None:
    """Gives a horizon the lattice of the whole array that it is of, not of its points alone."""
    lattice = made.lattice
    steps = np.column_stack((lattice.column_step, lattice.row_step))
    first = np.rint(np.linalg.solve(steps, np.subtract(lattice.origin, origin))).astype(np.int32)
    made.columns = made.columns + first
    made.taken = (made.taken[0], *made.taken[-1:])  # The rest is of the lattice of the points.
    made.lattice = dataclasses.replace(lattice, shape=shape, origin=(float(origin[0]), float(origin[1])))


def _floats(values: Any, what: str) -> Any:
    """A vector of float64 in which masked and missing values are nan. Raises ValueError."""
    try:
        if hasattr(values, "isna"):  # pandas, whose missing values may be objects
            values = values.to_numpy(dtype=np.float64, na_value=np.nan)
        array: NDArray[Any] = np.ma.asarray(values)
        if array.dtype.kind not in "iufbO" or (array.dtype.kind == "b" and what in ("heights", "z")):
            raise ValueError
        array = np.ma.filled(array.astype(np.float64), np.nan)
    except (TypeError, ValueError):
        raise ValueError("%s of type %s, expected numbers" % (what, getattr(values, "dtype", type(values).__name__))) from None
    return np.ascontiguousarray(array)


class _Given:
    """What data say: arrays for the core, attributes, and where they stand."""

    def __init__(self, attributes: Mapping[str, Any] | None, nodata: Any, place: Mapping[str, Any], columns: Mapping[str, str] | None):
        self.name = ""
        self._attributes = dict(attributes or {})
        self._nodata = [] if nodata is None else list(np.ravel(nodata))
        self._place = {key: value for key, value in place.items() if value is not None}
        for key in self._place.keys() - {"azimuth"}:
            if np.shape(self._place[key]) != (2,):
                raise ValueError("%s %s, expected two numbers" % (key, self._place[key]))
        self._columns = dict(columns or {})
        self.attributes: dict[str, Any] = {}
        self._kinds: dict[str, Any] = {}  # of whole numbers
        self.lattice: dict[str, Sequence[float]] = {}
        self.names: list[str] = []
        self.shape: tuple[int, int] | None = None
        self.direction = ""
        self.reason = ""  # of the direction
        self.survey = ("", "", "", "")
        self.description = ""
        self.dropped = 0

    # ---- What it is -------------------------------------------------------------------------------------------------
    def recognize(self, data: Any) -> dict[str, Any]:
        """Arrays for the core. Raises TypeError and ValueError."""
        if isinstance(data, Horizon):
            raise TypeError("a Horizon, expected data to make one of")
        if hasattr(data, "GetClassName"):
            return self._of_vtk(data)
        if hasattr(data, "xori") and hasattr(data, "values"):
            return self._of_xtgeo(data)
        if hasattr(data, "get_dataframe"):
            return self._of_xtgeo_points(data)
        if hasattr(data, "data_vars") or (hasattr(data, "dims") and hasattr(data, "coords")):
            return self._of_xarray(data)
        if hasattr(data, "transform") and hasattr(data, "read") and hasattr(data, "count"):
            return self._of_rasterio(data)
        if hasattr(data, "columns") and hasattr(data, "iloc"):
            return self._of_table(data)
        if isinstance(data, Mapping):
            return self._of_columns({str(key): values for key, values in data.items()}, "a dict")
        if isinstance(data, (str, bytes)) or hasattr(data, "__fspath__"):
            raise TypeError("a file name, expected arrays: read(path) reads a file")
        array = _floats(data, "heights")
        if not array.size:
            raise ValueError("an array of shape %s, expected heights" % (array.shape,))
        if array.ndim == 2 and array.shape[1] == 3:
            raise ValueError("an array of shape %s, which may be x, y and z of points or a grid of 3 columns: horizon(points=...) or "
                             "horizon(grid=...) decides" % (array.shape,))
        return self.grid(array)

    def points(self, points: Any) -> dict[str, Any]:
        array = _floats(points, "points")
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError("points of shape %s, expected (n, 3): x, y and z; horizon(grid=...) takes grids" % (array.shape,))
        self.description = "%d points" % len(array)
        return self._points(*(np.ascontiguousarray(array[:, axis]) for axis in range(3)))

    def xyz(self, x: Any, y: Any, z: Any) -> dict[str, Any]:
        arrays = [_floats(values, what) for values, what in ((x, "x"), (y, "y"), (z, "z"))]
        shape = arrays[2].shape
        if arrays[0].shape != shape and len(shape) == 2 and (arrays[1].shape, arrays[0].shape) == ((shape[0],), (shape[1],)):
            arrays[:2] = np.meshgrid(arrays[0], arrays[1])
        if len({array.shape for array in arrays}) != 1:
            raise ValueError("x, y and z of shapes %s, %s and %s, expected equal ones" % tuple(array.shape for array in arrays))
        self.description = "x, y and z of shape %s" % (shape,)
        return self._points(*(np.ascontiguousarray(array.ravel()) for array in arrays))

    def grid(self, grid: Any) -> dict[str, Any]:
        heights = _floats(grid, "heights")
        if heights.ndim != 2:
            raise ValueError("heights of shape %s, expected (rows, columns); horizon(x, y, z) and horizon(points=...) take points"
                             % (heights.shape,))
        steps = self._steps()
        self.description = "an array of %d rows and %d columns" % heights.shape
        return self._on_grid(heights, self._place.get("origin", (0.0, 0.0)), *steps)

    def _steps(self) -> tuple[Any, Any]:
        given = {"column_step", "row_step"} & self._place.keys()
        if given:
            if len(given) == 1 or {"spacing", "azimuth"} & self._place.keys():
                raise ValueError("%s, expected column_step and row_step, or spacing and azimuth" % " and ".join(sorted(self._place)))
            return self._place["column_step"], self._place["row_step"]
        azimuth = self._place.get("azimuth", 90.0)
        if not math.isfinite(azimuth):
            raise ValueError("azimuth %s, expected a finite number" % azimuth)
        turn = math.radians(90.0 - azimuth)
        column, row = self._place.get("spacing", (1.0, 1.0))
        if not (math.isfinite(column) and math.isfinite(row) and column * row != 0.0):
            raise ValueError("spacing (%s, %s), expected finite numbers other than 0" % (column, row))
        cosine, sine = (round(f(turn), 15) for f in (math.cos, math.sin))
        return (column * cosine, column * sine), (-row * sine, row * cosine)

    # ---- Arrays for the core ----------------------------------------------------------------------------------------
    def _drop(self, z: Any) -> Any:
        for null in self._nodata:
            if np.isfinite(null):
                z = np.where(np.isclose(z, null, rtol=SINGLE_PRECISION, atol=0.0), np.nan, z)
        return z

    def _points(self, x: Any, y: Any, z: Any, **lines: Any) -> dict[str, Any]:
        if {"spacing", "azimuth"} & self._place.keys():
            raise ValueError("spacing or azimuth for points, expected origin, column_step and row_step, or none: points have places")
        if self._place:
            if len(self._place) < 3:
                raise ValueError("%s, expected origin, column_step and row_step" % " and ".join(sorted(self._place)))
            self.lattice = dict(self._place)
        arrays = {key: values for key, values in {"x": x, "y": y, **lines}.items() if values is not None}
        known = np.all([np.isfinite(values) for values in arrays.values()], axis=0)
        self.attributes = {key: np.ascontiguousarray(self._attribute(key, values, z.size)[known]) for key, values in self._attributes.items()}
        z = self._drop(np.where(np.isfinite(z), z, np.nan))
        self.dropped = int((~known).sum())
        return {key: np.ascontiguousarray(values[known]) for key, values in {**arrays, "z": z}.items()}

    def restore(self, made: Horizon) -> None:
        """Makes attributes that were whole numbers whole again."""
        for name, kind in self._kinds.items():
            values = made.attributes.get(name)
            if values is not None and np.isfinite(values).all() and (values == np.rint(values)).all():
                made.attributes[name] = values.astype(kind)

    def _attribute(self, name: str, values: Any, size: int) -> Any:
        kind = np.dtype(getattr(values, "dtype", float)) if isinstance(getattr(values, "dtype", None), np.dtype) else np.asarray(values).dtype
        if kind.kind in "iub":
            self._kinds[name] = kind
        values = _floats(values, "attribute " + name)
        if values.size != size:
            raise ValueError("attribute %s of shape %s, expected as many numbers as heights, %d" % (name, values.shape, size))
        return values.ravel()

    def _on_grid(self, heights: Any, origin: Any, column_step: Any, row_step: Any) -> dict[str, Any]:
        heights = self._drop(heights)
        rows, columns = np.isfinite(heights).nonzero()
        if not rows.size:
            raise ValueError("heights without a single value, expected some that are not nan, masked or nodata")
        origin = np.asarray(origin, float)[:2]
        self.shape = heights.shape
        self.lattice = {"origin": origin, "column_step": column_step, "row_step": row_step}
        self.dropped = heights.size - rows.size
        self.attributes = {key: np.ascontiguousarray(self._attribute(key, values, heights.size).reshape(heights.shape)[rows, columns])
                           for key, values in self._attributes.items()}
        places = origin + np.outer(columns, column_step) + np.outer(rows, row_step)
        return {"x": np.ascontiguousarray(places[:, 0]), "y": np.ascontiguousarray(places[:, 1]), "z": heights[rows, columns]}

    def _require_own_place(self, what: str) -> None:
        if self._place:
            raise ValueError("%s for %s, which has its own position, expected none" % (" and ".join(sorted(self._place)), what))

    # ---- Tables -----------------------------------------------------------------------------------------------------
    def _of_table(self, frame: Any) -> dict[str, Any]:
        if not all(isinstance(column, str) for column in frame.columns):
            raise ValueError("a table whose columns have no names, expected X, Y and Z, or Inline, Crossline and Z: "
                             "horizon(points=table.to_numpy()) takes x, y and z in this order")
        columns = {column: frame[column] for column in frame.columns}
        if hasattr(frame, "geometry"):
            points = frame.geometry
            if not (points.geom_type == "Point").all():
                raise ValueError("a GeoDataFrame of %s, expected points" % ", ".join(sorted(set(points.geom_type))))
            columns.pop(points.name)
            columns = {"X": points.x, "Y": points.y, **columns}
            if points.has_z.all():
                columns["Z"] = points.z
            if frame.crs is not None:
                self.survey = ("", "", "", frame.crs.to_string())
        return self._of_columns(columns, "a table")

    def _of_columns(self, columns: dict[str, Any], what: str) -> dict[str, Any]:
        """Arrays of named columns. Names that `columns=` gives come first, then names as in text files."""
        unknown = [name for name in self._columns.values() if name not in columns]
        if unknown:
            raise ValueError("columns %s, expected some of %s" % (", ".join(unknown), ", ".join(columns)))
        roles: dict[str, str] = {role.lower(): name for role, name in self._columns.items()}
        candidates: list[str] = []
        for name in columns:
            role = _core.role_of(name).lower()
            if name in roles.values():
                continue
            if role == "z":
                candidates.append(name)
            elif role in ("x", "y", "inline", "crossline"):
                roles.setdefault(role, name)
            elif role == "name":
                roles.setdefault("horizon", name)
        if "z" not in roles and candidates:
            roles["z"] = candidates[_core.choose_z(candidates, "columns={\"z\": \"%s\"} decides" % candidates[0])]
        if "z" not in roles or not ({"x", "y"} <= roles.keys() or {"inline", "crossline"} <= roles.keys()):
            raise ValueError("%s with the columns %s, expected X, Y and Z, or Inline, Crossline and Z: columns={\"z\": ...} says what they are" % (
                what, ", ".join(columns)))
        if _core.is_elevation(roles["z"]):
            self.direction, self.reason = "up", "%s is an elevation" % roles["z"]
        ignored = []
        for name in columns:
            if name in roles.values():
                continue
            try:
                _floats(columns[name], name)
            except ValueError:
                ignored.append(name)
            else:
                self._attributes.setdefault(name, columns[name])
        unit = re.search(r"[\s_(\[]+(ms|s|m|ft)[)\]]*$", roles["z"])
        self.survey = (unit[1] if unit else "", *self.survey[1:])
        self.description = "%s: %s" % (what, ", ".join("%s is %s" % (roles[role], role) for role in (*PLACES, "horizon") if role in roles))
        self.description += "; no numbers: %s" % ", ".join(ignored) if ignored else ""
        found = {role: _floats(columns[roles[role]], roles[role]).ravel() for role in PLACES if role in roles}
        names = np.asarray(columns[roles["horizon"]]).astype(str) if "horizon" in roles else None
        arrays = self._points(found.pop("x", None), found.pop("y", None), found.pop("z"), **found)
        if names is not None:
            unique, numbers = np.unique(names, return_inverse=True)
            self.names = [str(one) for one in unique]
            if self.dropped:
                raise ValueError("%d rows without coordinates in a table of several horizons, expected coordinates in each" % self.dropped)
            arrays["horizon"] = np.ascontiguousarray(numbers.ravel(), np.int32)
        return arrays

    # ---- xtgeo ------------------------------------------------------------------------------------------------------
    def _of_xtgeo(self, surface: Any) -> dict[str, Any]:
        self._require_own_place("a surface of xtgeo")
        self.name = surface.name if surface.name not in (None, "unknown") else ""
        angle = math.radians(surface.rotation)
        column = np.array((math.cos(angle), math.sin(angle))) * surface.xinc
        row = np.array((-math.sin(angle), math.cos(angle))) * surface.yinc * surface.yflip
        self.description = "a surface of xtgeo, %d x %d" % (surface.ncol, surface.nrow)
        return self._on_grid(_floats(np.ma.masked_invalid(surface.values).T, "values"), (surface.xori, surface.yori), column, row)

    def _of_xtgeo_points(self, points: Any) -> dict[str, Any]:
        names = {points.xname: "X", points.yname: "Y", points.zname: "Z"}
        frame = points.get_dataframe().rename(columns=names)
        return self._of_columns({column: frame[column] for column in frame.columns if column != getattr(points, "pname", None)}, "points of xtgeo")

    # ---- Rasters ----------------------------------------------------------------------------------------------------
    def _of_rasterio(self, raster: Any) -> dict[str, Any]:
        self._require_own_place("a raster")
        if raster.count != 1:
            raise ValueError("a raster of %d bands, expected one: horizon(grid=raster.read(1), ...) takes one of them" % raster.count)
        heights = _floats(raster.read(1, masked=True), "heights")
        move = raster.transform
        self.description = "a raster of %d x %d pixels, places at their middles" % (raster.width, raster.height)
        self.survey = ("", "", "", raster.crs.to_string() if raster.crs else "")
        return self._on_grid(heights, move * (0.5, 0.5), (move.a, move.d), (move.b, move.e))

    # ---- xarray -----------------------------------------------------------------------------------------------------
    def _of_xarray(self, data: Any) -> dict[str, Any]:
        self._require_own_place("data of xarray")
        array = data
        if hasattr(data, "data_vars"):
            names = [str(name) for name in data.data_vars if set(map(str.lower, map(str, data[name].dims))) & {*X, *Y, *INLINE, *CROSSLINE}]
            wanted = self._columns.get("z")
            heights = [wanted] if wanted else names if len(names) == 1 else [one for one in names if _core.role_of(one) == "Z"]
            if len(heights) != 1 or heights[0] not in names:
                raise ValueError("a Dataset of %s, which may all be heights: columns={\"z\": \"%s\"} decides" % (
                    ", ".join(names) or "no maps", names[0] if names else "..."))
            array = data[heights[0]]
            for name in names:
                if name != heights[0] and data[name].dims == array.dims and data[name].dtype.kind in "iuf":
                    self._attributes.setdefault(name, data[name].values)
        array = array.squeeze([dim for dim in array.dims if array.sizes[dim] == 1 and str(dim).lower() not in (*X, *Y, *INLINE, *CROSSLINE)])
        known = [str(dim).lower() for dim in array.dims]
        self._take_attributes(array)
        for rows, columns in ((Y, X), (INLINE, CROSSLINE)):
            found = [next((n for n, dim in enumerate(known) if dim in names), None) for names in (rows, columns)]
            if len(known) == 2 and None not in found:
                array = array.transpose(*(array.dims[n] for n in found))
                self._attributes = {key: np.asarray(values).T if found == [1, 0] and np.ndim(values) == 2 else values for key, values in self._attributes.items()}
                return self._of_lines(array) if rows is INLINE else self._of_axes(array)
        raise ValueError("dimensions %s, expected y and x, or inline and crossline" % ", ".join(map(str, array.dims)))

    def _take_attributes(self, array: Any) -> None:
        """What an array says of itself: no data, unit, direction, coordinate system."""
        notes = {**getattr(array, "encoding", {}), **array.attrs}
        for key in ("_FillValue", "nodata", "missing_value"):
            if not self._nodata and notes.get(key) is not None:
                self._nodata = [float(np.ravel(notes[key])[0])]
        self.direction = {"up": "up", "down": "down"}.get(str(notes.get("positive", "")).lower(), "")
        self.reason = "its attribute positive says"
        units = str(notes.get("units", ""))
        crs = getattr(getattr(array, "rio", None), "crs", None)
        self.survey = (units if units in ("ms", "s", "m", "ft") else "", "", "", crs.to_string() if crs else "")

    def _of_axes(self, array: Any) -> dict[str, Any]:
        origin, steps = [], []
        for dim in array.dims[::-1]:
            values = np.asarray(array[dim].values, float) if dim in array.coords else np.arange(array.sizes[dim], dtype=float)
            step = (values[-1] - values[0]) / (len(values) - 1) if len(values) > 1 else 1.0
            if step == 0.0 or np.abs(values - (values[0] + step * np.arange(len(values)))).max() > STEP_TOLERANCE * abs(step):
                raise ValueError("coordinates %s without equal steps, expected those of a grid: horizon(x, y, z) takes points" % dim)
            origin.append(values[0])
            steps.append(step)
        self.description = "an array of xarray by %s and %s" % array.dims
        return self._on_grid(_floats(array.values, "heights"), origin, (steps[0], 0.0), (0.0, steps[1]))

    def _of_lines(self, array: Any) -> dict[str, Any]:
        inlines, crosslines = (np.asarray(array[dim].values, float) if dim in array.coords else np.arange(array.sizes[dim], dtype=float)
                               for dim in array.dims)
        lines, cross = np.meshgrid(inlines, crosslines, indexing="ij")
        places = {}
        for names, key in ((("cdp_x", "x"), "x"), (("cdp_y", "y"), "y")):
            found = next((name for name in array.coords if str(name).lower() in names), None)
            if found is not None:
                places[key] = np.broadcast_to(array[found].transpose(*(d for d in array.dims if d in array[found].dims)).values, lines.shape)
        self.description = "an array of xarray by %s and %s" % array.dims
        ravel = {key: _floats(values, key).ravel() for key, values in places.items()}
        return self._points(ravel.get("x"), ravel.get("y"), _floats(array.values, "heights").ravel(), inline=lines.ravel(), crossline=cross.ravel())

    # ---- VTK and PyVista --------------------------------------------------------------------------------------------
    def _of_vtk(self, data: Any) -> dict[str, Any]:
        from vtkmodules.util.numpy_support import vtk_to_numpy

        self.direction, self.reason = "up", "in the world of VTK"
        fields = data.GetPointData()
        arrays = {fields.GetArrayName(n): vtk_to_numpy(fields.GetArray(n)) for n in range(fields.GetNumberOfArrays())
                  if fields.GetArray(n) and fields.GetArray(n).GetNumberOfComponents() == 1}
        if data.IsA("vtkImageData"):
            self._require_own_place("an image")
            columns, rows, layers = data.GetDimensions()
            if layers != 1:
                raise ValueError("an image of %d x %d x %d, expected one layer: extraction of horizons from cubes is another function"
                                 % (columns, rows, layers))
            wanted = self._columns.get("z") or (next(iter(arrays)) if len(arrays) == 1 else next((one for one in arrays if _core.role_of(one) == "Z"), None))
            if wanted not in arrays:
                raise ValueError("an image with the arrays %s, any of which may be z: columns={\"z\": ...} decides" % (", ".join(arrays) or "none"))
            self._attributes.update({key: values.reshape(rows, columns) for key, values in arrays.items() if key != wanted})
            matrix, spacing, origin = data.GetDirectionMatrix(), data.GetSpacing(), data.GetOrigin()
            steps = [tuple(matrix.GetElement(axis, n) * spacing[n] for axis in (0, 1)) for n in (0, 1)]
            self.description = "an image, z from %s" % wanted
            return self._on_grid(_floats(arrays[wanted].reshape(rows, columns), "heights"), origin, *steps)
        if not hasattr(data, "GetPoints") or data.GetPoints() is None:
            raise TypeError("a %s, expected an image, a structured grid or points" % data.GetClassName())
        if data.IsA("vtkPolyData") and data.GetNumberOfPolys():
            raise ValueError("a mesh of %d polygons, expected points: horizon(points=mesh.points) takes its vertices" % data.GetNumberOfPolys())
        self._attributes.update(arrays)
        places = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        self.description = "%d points of a %s" % (len(places), data.GetClassName())
        return self._points(*(np.ascontiguousarray(places[:, axis]) for axis in range(3)))
