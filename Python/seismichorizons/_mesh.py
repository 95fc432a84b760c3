# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes of horizons, and the account of their columns."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._data import Data, give_attributes, loops, snake, survey, unmarked
from ._horizon import Floats, Lattice, WithAttributes, _poly_data, label_map


@dataclasses.dataclass(frozen=True)
class Ledger:
    """Account of the columns of a mesh: each column belongs to one entry.

    Attributes
    ----------
    known : int
        Columns under the mesh with a given z.
    filled, bridged, extrapolated : int
        Columns under the mesh with a computed z: filled between known columns before meshing, spanned only by
        triangles, or extrapolated beyond known columns.
    left_out : int
        Columns with a given z that the mesh does not cover.
    column_area : float
        Area of a column.
    """

    known: int = 0
    filled: int = 0
    bridged: int = 0
    extrapolated: int = 0
    left_out: int = 0
    column_area: float = 1.0

    @property
    def covered(self) -> int:
        """Columns under the mesh."""
        return self.known + self.filled + self.bridged + self.extrapolated

    def __repr__(self) -> str:
        parts = (("filled", self.filled, self.covered), ("bridged", self.bridged, self.covered), ("extrapolated", self.extrapolated, self.covered),
                 ("of the points left out", self.left_out, self.known + self.left_out))
        shares = ("%.3g %% %s" % (100.0 * number / whole, name) for name, number, whole in parts if number)
        return "{:,} columns covered".format(self.covered) + "".join(", " + share for share in shares)


@dataclasses.dataclass(eq=False, repr=False)
class Mesh(WithAttributes):
    """A triangle mesh of a horizon, from `surface` or `read_mesh`, or points with outlines that are not yet meshed.

    Attributes
    ----------
    name : str
    points : float64 array of shape (n, 3)
        x, y and z in world coordinates, with z upwards.
    triangles : int32 array of shape (m, 3)
        Points of each triangle, counter-clockwise as seen from above.
    attributes : dict of arrays of n
        Attributes of the horizon, also available as `mesh["name"]`: the mean over the points that a vertex represents,
        or for whole numbers the value of the nearest point.
    errors : float64 array of m
        Largest vertical distance of horizon points from each triangle, in the unit of z; nan if not measured.
    quality : float32 array of m
        Shape of each triangle in map view, from 0 to 1 for equal edges.
    outlines : list of int32 arrays
        Points of each closed outline, including those of holes, with the surface to the right.
    patches : int32 array of n
        Number of the connected patch of each point.
    counts : int64 array of n
        Number of horizon points that each vertex represents.
    columns : int32 array of shape (n, 2)
        Column and row of each point on the lattice; -1 for the mean of several points.
    largest_error, mean_error : float
        Vertical distances of horizon points from the mesh, in the unit of z; the largest includes points on outlines. nan
        if not measured.
    details : dict
        Other figures: chosen parameters, deviations of outlines, smallest angle in degrees.
    ledger : Ledger
    lattice : Lattice, or None for a mesh of a file
    direction, vertical_unit, vertical_domain, horizontal_unit, coordinate_system
        As in the horizon.
    """

    name: str
    points: Floats
    triangles: NDArray[np.int32]
    attributes: dict[str, NDArray[Any]]
    errors: Floats
    quality: NDArray[np.float32]
    outlines: list[NDArray[np.int32]]
    patches: NDArray[np.int32]
    counts: NDArray[np.int64]
    columns: NDArray[np.int32]
    largest_error: float
    mean_error: float
    details: dict[str, Any]
    ledger: Ledger
    lattice: Lattice | None
    direction: str = "down"
    vertical_unit: str = ""
    vertical_domain: str = ""
    horizontal_unit: str = ""
    coordinate_system: str = ""
    _core: Data = dataclasses.field(default_factory=dict)

    def _data(self) -> Data:
        """Data for the core, with places and attributes as they are now."""
        if len(self._core["places"]) != len(self.points):
            raise ValueError("%s: %d points, expected %d as the mesh was made with" % (
                self.name, len(self.points), len(self._core["places"])))
        return {**self._core, "places": np.ascontiguousarray(self.points, np.float64),
                "point_data": {**self._core["point_data"], **give_attributes(self.attributes)}}

    def _data_of_vtk(self) -> Data:
        """Data with attributes by their names."""
        return unmarked(self._data())

    def _data_of_file(self) -> Data:
        """Data with the attributes of a file."""
        numbers = {name: np.ascontiguousarray(values, np.float64) for name, values in self.attributes.items() if values.dtype.kind in "iuf"}
        return {**self._data(), "point_data": numbers, "cell_data": {}}

    def __len__(self) -> int:
        return len(self.triangles)

    def __repr__(self) -> str:
        unit = " " + self.vertical_unit if self.vertical_unit else ""
        mean = "" if np.isnan(self.mean_error) else ", mean %.4g%s" % (self.mean_error, unit)
        error = ", largest error %.4g%s%s" % (self.largest_error, unit, mean)
        return "Mesh %s: {:,} points, {:,} triangles%s%s".format(len(self.points), len(self.triangles)) % (
            self.name, "" if np.isnan(self.largest_error) else error, "; %r" % self.ledger if self.ledger.covered else "")

    @property
    def z(self) -> Floats:
        """z of each point as in the horizon, in its direction."""
        return self.points[:, 2] if self.direction == "up" else -self.points[:, 2]

    def to_vtk(self) -> Any:
        """Returns a vtkPolyData of triangles, with z upwards."""
        return _poly_data(self.points, self.attributes, self.triangles)

    def to_pyvista(self) -> Any:
        """Returns a pyvista.PolyData of triangles, with z upwards."""
        import pyvista

        return pyvista.wrap(self.to_vtk())

    def to_trimesh(self) -> Any:
        """Returns a trimesh.Trimesh, with z upwards."""
        import trimesh

        return trimesh.Trimesh(self.points, self.triangles, process=False)

    def plot(self, axes: Any = None, **keywords: Any) -> Any:
        """Draws the triangles, coloured by z, as a map with matplotlib. Keywords are passed to `tripcolor`. Returns the
        axes."""
        import matplotlib.pyplot

        axes = matplotlib.pyplot.subplots()[1] if axes is None else axes
        colours = {"cmap": "viridis_r" if self.direction == "down" else "viridis", "edgecolors": "k", "linewidth": 0.2}
        drawn = axes.tripcolor(self.points[:, 0], self.points[:, 1], self.triangles,
                               facecolors=self.z[self.triangles].mean(axis=1), **{**colours, **keywords})
        label_map(axes, drawn, self)
        return axes


# Figures in vertical indices.
HEIGHTS = ("LargestError", "MeanError", "LargestEdgeError", "LargestLoopError", "OutlineHeightDeviation", "ChosenMaximumError",
           "ChosenDistanceThreshold", "HeightNoise", "HeightRounding")


def mesh_of(name: str, data: Data, attributes: dict[str, NDArray[Any]], before: Data, lattice: Lattice | None) -> Mesh:
    """A mesh from data of the core. `before` are the field data of the input, to which stages add figures."""
    points, cells, fields = data["point_data"], data["cell_data"], data["field_data"]
    size, first = len(data["places"]), max(0, len(data["lines"][0]) - 1)
    step = 1.0 if lattice is None else abs(lattice.vertical_step)
    triangles = data["polygons"][1].astype(np.int32, copy=False).reshape(-1, 3)

    def of_points(key: str, dtype: Any, otherwise: int, *shape: int) -> NDArray[Any]:
        return points[key].astype(dtype, copy=False) if key in points else np.full((size, *shape), otherwise, dtype)

    def of_triangles(key: str, dtype: Any) -> NDArray[Any]:
        return cells[key][first:].astype(dtype, copy=False) if key in cells else np.full(len(triangles), np.nan, dtype)

    details = {snake(key): values.item() * (step if key in HEIGHTS else 1) for key, values in fields.items()
               if not isinstance(values, list) and values.size == 1 and key != "VerticalDirection" and values is not before.get(key)}
    inner = details.pop("largest_error", np.nan)
    area = 1.0 if lattice is None else abs(float(np.linalg.det((lattice.column_step, lattice.row_step))))
    known, filled, bridged, extrapolated, left_out = fields["LedgerColumns"].ravel().tolist() if "LedgerColumns" in fields else (0,) * 5
    ledger = Ledger(known, filled, bridged, extrapolated, left_out, area)
    return Mesh(
        name=name, points=data["places"], triangles=triangles, attributes=attributes, errors=of_triangles("Error", np.float64) * step,
        quality=of_triangles("Quality", np.float32), outlines=loops(data["lines"]), patches=of_points("PatchId", np.int32, 0),
        counts=of_points("PointCount", np.int64, 1), columns=of_points("Column", np.int32, -1, 2),
        largest_error=max(inner, details.get("largest_loop_error", 0.0)), mean_error=details.pop("mean_error", np.nan),
        details={**details, "largest_inner_error": inner} if np.isfinite(inner) else details, ledger=ledger, lattice=lattice,
        direction="up" if fields["VerticalDirection"][0] > 0 else "down", _core=data, **survey(fields))
