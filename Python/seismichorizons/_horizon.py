# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons and their lattices."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._data import Data, give_attributes, give_survey, survey, unmarked

Floats = NDArray[np.float64]
Pair = tuple[float, float]


@dataclasses.dataclass(frozen=True)
class Lattice:
    """The regular grid whose columns hold the points of a horizon.

    Attributes
    ----------
    shape : (rows, columns)
        Arrays from `Horizon.grid` have this shape.
    origin : (x, y)
        Position of row 0, column 0.
    column_step, row_step : (x, y)
        Steps to the next column and to the next row.
    first_z, vertical_step : float
        z of vertical index 0, and z between vertical indices, in the unit of z.
    indices : int
        Number of vertical indices.
    lines : (first inline, inline step, first crossline, crossline step) or None
        Rows are inlines, and columns are crosslines.
    """

    shape: tuple[int, int]
    origin: Pair = (0.0, 0.0)
    column_step: Pair = (1.0, 0.0)
    row_step: Pair = (0.0, 1.0)
    first_z: float = 0.0
    vertical_step: float = 1.0
    indices: int = 1
    lines: tuple[float, float, float, float] | None = None

    @property
    def spacing(self) -> Pair:
        """Lengths of the steps to the next column and to the next row."""
        return math.hypot(*self.column_step), math.hypot(*self.row_step)

    @property
    def azimuth(self) -> float:
        """Direction of increasing column number, in degrees clockwise from north."""
        return math.degrees(math.atan2(*self.column_step)) % 360.0

    def places(self, columns: Any, rows: Any) -> tuple[Any, Any]:
        """x and y at columns and rows, which may be fractional."""
        (ax, ay), (bx, by), (x, y) = self.column_step, self.row_step, self.origin
        return ax * columns + bx * rows + x, ay * columns + by * rows + y


class WithAttributes:
    """Gives attributes by name."""

    attributes: dict[str, NDArray[Any]]

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self.attributes:
            raise KeyError("no attribute %s, expected one of %s" % (name, ", ".join(self.attributes) or "none"))
        return self.attributes[name]


@dataclasses.dataclass(eq=False, repr=False)
class Horizon(WithAttributes):
    """A horizon: heights at columns of a lattice, at most one per column. Made by `horizon` or `read`.

    Attributes
    ----------
    name : str
    columns : int32 array of shape (n, 2)
        Column and row of each point, sorted by row.
    z : float64 array of n
        Time, depth or elevation, in `vertical_unit`. It increases in `direction`.
    lattice : Lattice
    attributes : dict of arrays of n
        Other values at the points, also available as `horizon["name"]`.
    direction : "down" or "up"
    vertical_unit, vertical_domain, horizontal_unit, coordinate_system : str
        Empty where unknown.
    filled : uint8 array of n
        0 where z was given, 1 where it was interpolated between known points, 2 where it was extrapolated beyond them.
    taken : tuple of str
        How the input was interpreted, line by line.
    left_out : dict
        Number of input points left out, by reason.
    """

    name: str
    columns: NDArray[np.int32]
    z: Floats
    lattice: Lattice
    attributes: dict[str, NDArray[Any]] = dataclasses.field(default_factory=dict)
    direction: str = "down"
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""
    filled: NDArray[np.uint8] = None  # type: ignore[assignment]
    taken: tuple[str, ...] = ()
    left_out: dict[str, int] = dataclasses.field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.filled is None:
            self.filled = np.zeros(len(self.z), np.uint8)

    def __len__(self) -> int:
        return len(self.z)

    def __iter__(self) -> Iterator[str]:
        return iter(self.attributes)

    def __repr__(self) -> str:
        rows, columns = self.lattice.shape
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        what = "elevation" if self.direction == "up" and self.vertical_domain != "time" else self.vertical_domain or "z down"
        known = int((self.filled == 0).sum())
        step = "%.6g x %.6g%s" % (*self.lattice.spacing, " " + self.horizontal_unit if self.horizontal_unit else "")
        return "Horizon %s: %d columns x %d rows, %s apart, {:,} of {:,} known{}, %s %.6g to %.6g%s%s".format(
            known, rows * columns, ", {:,} filled".format(len(self) - known) if known < len(self) else "") % (
                self.name, columns, rows, step, what, self.z.min(), self.z.max(), unit,
                "; attributes " + ", ".join(self.attributes) if self.attributes else "")

    # ---- Places -----------------------------------------------------------------------------------------------------
    @property
    def x(self) -> Floats:
        x: Floats = self.lattice.places(*self.columns.T)[0]
        return x

    @property
    def y(self) -> Floats:
        y: Floats = self.lattice.places(*self.columns.T)[1]
        return y

    @property
    def inlines(self) -> Floats:
        """Inline of each point. Raises ValueError without line numbers."""
        first, step = self._lines()[:2]
        return first + step * self.columns[:, 1].astype(np.float64)

    @property
    def crosslines(self) -> Floats:
        """Crossline of each point. Raises ValueError without line numbers."""
        first, step = self._lines()[2:]
        return first + step * self.columns[:, 0].astype(np.float64)

    def _lines(self) -> tuple[float, float, float, float]:
        if self.lattice.lines is None:
            raise ValueError("%s has no line numbers" % self.name)
        return self.lattice.lines

    @property
    def sign(self) -> int:
        """1 if z increases upwards, otherwise -1."""
        return 1 if self.direction == "up" else -1

    def grid(self, values: str | NDArray[Any] | None = None) -> NDArray[Any]:
        """Returns values as a grid on the whole lattice.

        Parameters
        ----------
        values : str or array of n, optional
            Name of an attribute, or a number for each point; z by default.

        Returns
        -------
        array of shape (rows, columns)
            nan where the horizon has no point.
        """
        values = self.z if values is None else self[values] if isinstance(values, str) else values
        grid = np.full(self.lattice.shape, np.nan)
        grid[self.columns[:, 1], self.columns[:, 0]] = values
        return grid

    # ---- For the core -----------------------------------------------------------------------------------------------
    def _data(self, links: NDArray[np.int32] | None = None) -> Data:
        (ax, ay), (bx, by), (x, y) = self.lattice.column_step, self.lattice.row_step, self.lattice.origin
        rows, columns = self.lattice.shape
        to_world = (ax, bx, 0.0, x, ay, by, 0.0, y, 0.0, 0.0, self.sign * self.lattice.vertical_step,
                    self.sign * self.lattice.first_z, 0.0, 0.0, 0.0, 1.0)
        fields = {"LatticeDimensions": np.array([columns, rows, self.lattice.indices], np.int32),
                  "LatticeToWorld": np.array(to_world), **give_survey(self)}
        if self.lattice.lines is not None:
            fields["LineNumbers"] = np.array(self.lattice.lines)
        if links is not None and len(links):
            fields["FaultedLinks"] = links
        points = {"Column": np.ascontiguousarray(self.columns, np.int32), **give_attributes(self.attributes)}
        if self.filled.any():
            points["Filled"] = np.ascontiguousarray(self.filled, np.uint8)
        return {"places": np.column_stack((self.x, self.y, self.sign * self.z)), "point_data": points, "field_data": fields}

    def _data_of_vtk(self) -> Data:
        """Data with attributes by their names."""
        return unmarked(self._data())

    def _data_of_file(self) -> Data:
        """Data with the attributes of a file."""
        data = self._data()
        numbers = {name: np.ascontiguousarray(values, np.float64) for name, values in self.attributes.items() if values.dtype.kind in "iuf"}
        return {**data, "point_data": {**numbers, "Column": data["point_data"]["Column"]}}

    # ---- Objects of other packages ----------------------------------------------------------------------------------
    def to_dataframe(self) -> Any:
        """Returns a pandas DataFrame with X, Y, Z, line numbers if known, and attributes."""
        import pandas

        lines = {} if self.lattice.lines is None else {"Inline": self.inlines, "Crossline": self.crosslines}
        return pandas.DataFrame({"X": self.x, "Y": self.y, "Z": self.z, **lines, **self.attributes})

    def to_xarray(self) -> Any:
        """Returns an xarray Dataset with z and attributes on the lattice. x and y are coordinates of one dimension each
        where the lattice is parallel to the axes, otherwise of both."""
        import xarray

        rows, columns = self.lattice.shape
        is_along = self.lattice.column_step[1] == 0.0 and self.lattice.row_step[0] == 0.0
        if is_along:
            dims: tuple[str, ...] = ("y", "x")
            coords: dict[str, Any] = {"x": self.lattice.places(np.arange(columns), 0)[0],
                                      "y": self.lattice.places(0, np.arange(rows))[1]}
        else:
            x, y = self.lattice.places(np.arange(columns)[None], np.arange(rows)[:, None])
            dims, coords = ("row", "column"), {"x": (("row", "column"), x), "y": (("row", "column"), y)}
        arrays = {"z": self.grid(), **{name: self.grid(name) for name in self.attributes}}
        made = xarray.Dataset({name: (dims, values) for name, values in arrays.items()}, coords)
        made["z"].attrs.update({key: value for key, value in (
            ("units", self.vertical_unit), ("long_name", self.vertical_domain), ("positive", self.direction)) if value})
        return made

    def to_xtgeo(self, name: str | None = None) -> Any:
        """Returns an xtgeo RegularSurface of z, or of an attribute. Raises ValueError if the steps are not at right
        angles."""
        import xtgeo

        (ax, ay), (bx, by) = self.lattice.column_step, self.lattice.row_step
        dx, dy = self.lattice.spacing
        if abs(ax * bx + ay * by) > 1e-6 * dx * dy:
            raise ValueError("%s: steps (%g, %g) and (%g, %g), expected right angles for xtgeo" % (self.name, ax, ay, bx, by))
        rows, columns = self.lattice.shape
        return xtgeo.RegularSurface(
            ncol=columns, nrow=rows, xinc=dx, yinc=dy, xori=self.lattice.origin[0], yori=self.lattice.origin[1],
            rotation=round(math.degrees(math.atan2(ay, ax)) % 360.0, 10), yflip=1 if ax * by - ay * bx > 0.0 else -1,
            values=np.ma.masked_invalid(self.grid(name).T), name=name or self.name)

    def to_vtk(self) -> Any:
        """Returns a vtkPolyData of points, with z upwards."""
        return _poly_data(np.column_stack((self.x, self.y, self.sign * self.z)), self.attributes, None)

    def to_pyvista(self) -> Any:
        """Returns a pyvista.PolyData of points, with z upwards."""
        import pyvista

        return pyvista.wrap(self.to_vtk())

    def plot(self, name: str | None = None, axes: Any = None, **keywords: Any) -> Any:
        """Draws a map with matplotlib.

        Parameters
        ----------
        name : str, optional
            Name of an attribute; z by default.
        axes : matplotlib.axes.Axes, optional
            Axes to draw on; a new figure by default.
        **keywords
            Passed to `pcolormesh`.

        Returns
        -------
        matplotlib.axes.Axes
        """
        import matplotlib.pyplot

        axes = matplotlib.pyplot.subplots()[1] if axes is None else axes
        rows, columns = self.lattice.shape
        x, y = self.lattice.places(np.arange(columns + 1)[None] - 0.5, np.arange(rows + 1)[:, None] - 0.5)
        colours = {"cmap": "viridis_r" if name is None and self.direction == "down" else "viridis"}
        drawn = axes.pcolormesh(x, y, self.grid(name), **{**colours, **keywords})
        label_map(axes, drawn, self, name)
        return axes


def label_map(axes: Any, drawn: Any, data: Any, name: str | None = None) -> None:
    """The title of a map, its axes with the unit of x and y, and the bar of an attribute or of z."""
    z = " ".join(filter(None, (data.vertical_domain or "z", "(%s)" % data.vertical_unit if data.vertical_unit else "")))
    bar = axes.figure.colorbar(drawn, ax=axes, label=name or z)
    if name is None and data.direction == "down":
        bar.ax.invert_yaxis()
    unit = " (%s)" % data.horizontal_unit if data.horizontal_unit else ""
    axes.set(aspect="equal", title=data.name, xlabel="x" + unit, ylabel="y" + unit)
    axes.locator_params(nbins=5)


def horizon_of(name: str, data: Data, **more: Any) -> Horizon:
    """A horizon from data of the core, without attributes unless `more` has them."""
    points, fields = data["point_data"], data["field_data"]
    m = fields["LatticeToWorld"].ravel().tolist()
    columns, rows, indices = fields["LatticeDimensions"].ravel().tolist()
    sign = 1.0 if fields["VerticalDirection"][0] > 0 else -1.0
    lines = fields.get("LineNumbers")
    lattice = Lattice((rows, columns), (m[3], m[7]), (m[0], m[4]), (m[1], m[5]), sign * m[11], sign * m[10], indices,
                      None if lines is None else tuple(lines.ravel().tolist()))
    return Horizon(name=name, columns=points["Column"], z=sign * data["places"][:, 2], lattice=lattice,
                   direction="up" if sign > 0.0 else "down", **{"filled": points.get("Filled"), **survey(fields), **more})


def require_vtk() -> None:
    """Raises ImportError, with what to install."""
    try:
        import vtkmodules  # noqa: F401
    except ImportError:
        raise ImportError("no module vtkmodules, expected VTK: pip install vtk, or pyvista") from None


def fill_vtk(data: Any, points: Floats, offsets: NDArray[Any], corners: NDArray[Any]) -> Any:
    """Gives a vtkPointSet its points; returns a vtkCellArray."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints

    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(places)
    return vtk_cells(offsets, corners)


def vtk_cells(offsets: NDArray[Any], corners: NDArray[Any]) -> Any:
    """A vtkCellArray."""
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray

    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(np.int64), deep=True), numpy_to_vtkIdTypeArray(corners.astype(np.int64), deep=True))
    return cells


def add_arrays(attributes: Any, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Adds arrays to a vtkDataSetAttributes."""
    from vtkmodules.util.numpy_support import numpy_to_vtk

    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        attributes.AddArray(array)


def _poly_data(points: Floats, arrays: Mapping[str, NDArray[Any]], triangles: NDArray[Any] | None) -> Any:
    require_vtk()
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    data = vtkPolyData()
    corners = np.arange(len(points)) if triangles is None else triangles.ravel()
    cells = fill_vtk(data, points, np.arange(0, len(corners) + 1, 1 if triangles is None else 3), corners)
    (data.SetVerts if triangles is None else data.SetPolys)(cells)
    add_arrays(data.GetPointData(), arrays)
    return data
