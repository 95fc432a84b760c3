# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers between horizons, horizons put in order, and the distance of meshes."""

from __future__ import annotations

import dataclasses
import functools
import os
import pathlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core, _xml
from ._data import Data, Progress, call, in_keywords, snake, take_attributes
from ._horizon import Floats, Horizon, add_arrays, fill_vtk, require_vtk
from ._mesh import Mesh, mesh_of
from ._stages import Faults, given_options, links_of, require_horizon
from ._units import height


@dataclasses.dataclass(eq=False, repr=False)
class Layers:
    """Volumes of the layers between horizons, from `layers`. Layers share points and have no gaps.

    Attributes
    ----------
    names : list of str
        Names of the layers, uppermost first, such as "Top to Base".
    points : float64 array of shape (n, 3)
        x, y and z in world coordinates, with z upwards.
    cells : dict of int64 arrays of shape (m, corners) by number of corners
        Tetrahedra (4), pyramids (5) and wedges (6), with corners in the order of VTK.
    layer, sublayer, thickness, volume : dict of arrays by number of corners
        Layer, sublayer, mean thickness and volume of each cell.
    bodies : dict of Mesh
        The closed surface of each layer, facing outwards.
    horizons : dict of Mesh
        The horizons on the common triangulation.
    figures : dict of arrays
        One value for each layer: volume, area, thickness_mean, crossings, volume_without and so on.
    curve : dict of arrays
        Volume of each layer above a level contact, for 101 heights (contact, z upwards).
    volume_unit : str
    """

    names: list[str]
    points: Floats
    cells: dict[int, NDArray[np.int64]]
    layer: dict[int, NDArray[np.int32]]
    sublayer: dict[int, NDArray[np.int32]]
    thickness: dict[int, Floats]
    volume: dict[int, Floats]
    bodies: dict[str, Mesh]
    horizons: dict[str, Mesh]
    figures: dict[str, Any]
    curve: dict[str, Floats]
    volume_unit: str
    _core: Data

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        unit = " " + self.volume_unit if self.volume_unit else ""
        return "Layers: %s; {:,} cells".format(sum(map(len, self.cells.values()))) % ", ".join(
            "%s %.6g%s" % (name, volume, unit) for name, volume in zip(self.names, self.figures["volume"]))

    def to_vtk(self) -> Any:
        """Returns a vtkUnstructuredGrid with the cell data Layer, Thickness and Volume, and z upwards."""
        require_vtk()
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

        grid = vtkUnstructuredGrid()
        offsets, corners = self._core["cells"]
        if _wedges_begin_below():
            wedges = offsets[:-1][self._core["types"] == _WEDGE, None]
            corners = corners.copy()
            corners[wedges + np.arange(6)] = corners[wedges + [3, 4, 5, 0, 1, 2]]
        grid.SetCells(numpy_to_vtk(self._core["types"], deep=True), fill_vtk(grid, self.points, offsets, corners))
        add_arrays(grid.GetCellData(), self._core["cell_data"])
        return grid

    def to_pyvista(self) -> Any:
        """Returns a pyvista.UnstructuredGrid with the cell data Layer, Thickness and Volume, and z upwards."""
        import pyvista

        return pyvista.wrap(self.to_vtk())

    @functools.cached_property
    def boundary(self) -> dict[str, dict[int, NDArray[np.int64]]]:
        """Faces around the stack and between layers, by group (Top, Base, Sides, Faults and horizons) and number of
        corners: the cell as in a .vtu file, and the points, counter-clockwise from outside."""
        return {name: faces for name, _, faces in self._groups()}

    def _groups(self) -> Iterator[tuple[str, str, dict[int, NDArray[np.int64]]]]:
        for name, plain, found in zip(*_core.layer_boundary(self._core)):
            rows = {size: [row for row in found if len(row) == 1 + size] for size in (3, 4)}
            yield name, plain, {size: np.array(of_size, np.int64) for size, of_size in rows.items() if of_size}

    def write(self, path: str | os.PathLike[str], *, boundaries: bool = False, progress: Progress | None = None) -> None:
        """Writes the cells for VTK (.vtu), Gmsh (.msh), Abaqus and CalculiX (.inp) or MODFLOW 6 (.disv).

        With `boundaries`, files suit OpenGeoSys: cells have the layer number as MaterialIDs, and each group of faces has a
        .vtu file of its own, such as layers_Top.vtu, with bulk_node_ids and bulk_element_ids.

        Raises ValueError if the format cannot hold the cells, and OSError if the file cannot be written.
        """
        path = pathlib.Path(path)
        if not path.absolute().parent.is_dir():
            raise FileNotFoundError("%s: no folder %s" % (path, path.absolute().parent))
        try:
            if boundaries and path.suffix.lower() != ".vtu":
                raise ValueError("boundaries of a file with another extension, expected .vtu: .msh and .inp always have them")
            if path.suffix.lower() == ".vtu":
                data = self._core
                if boundaries:
                    fields = {name: values for name, values in data["field_data"].items() if not isinstance(values, list)}  # OGS fails with texts
                    used, corners = np.unique(data["cells"][1], return_inverse=True)  # matrices want no other points
                    data = {**data, "cell_data": {**data["cell_data"], "MaterialIDs": data["cell_data"]["Layer"]}, "field_data": fields,
                            "places": self.points[used], "cells": (data["cells"][0], corners.ravel())}
                _core.write_contents(str(path), [("", _xml.unstructured_grid(data))])
                for _, plain, faces in self._groups() if boundaries else ():
                    own = path.with_name("%s_%s.vtu" % (path.stem, plain))
                    _core.write_contents(str(own), [("", _xml.unstructured_grid(_surface_of(self.points, used, faces)))])
            else:
                _core.write_layers(str(path), self._core, progress)
        except ValueError as error:
            raise ValueError("%s: %s" % (path, in_keywords(str(error)))) from None
        except OSError as error:
            raise OSError("%s: %s" % (path, error)) from None


def _surface_of(points: Floats, used: NDArray[np.int64], faces: Mapping[int, NDArray[np.int64]]) -> Data:
    """Faces as cells of their own points, with their numbers among the used ones."""
    sizes = np.concatenate([np.full(len(rows), size) for size, rows in faces.items()])
    bulk, own = np.unique(np.concatenate([rows[:, 1:].ravel() for rows in faces.values()]), return_inverse=True)
    return {"places": points[bulk], "cells": (np.append(0, np.cumsum(sizes)), own.ravel()), "types": np.where(sizes == 3, _TRIANGLE, _QUAD),
            "point_data": {"bulk_node_ids": np.searchsorted(used, bulk).astype(np.uint64)}, "field_data": {},
            "cell_data": {"bulk_element_ids": np.concatenate([rows[:, 0] for rows in faces.values()]).astype(np.uint64)}}


_TRIANGLE, _QUAD = 5, 9  # VTK_TRIANGLE, VTK_QUAD
_WEDGE = 13  # VTK_WEDGE


@functools.lru_cache(maxsize=None)
def _wedges_begin_below() -> bool:
    """True if VTK's wedges begin with the triangle that looks inwards; older versions want the other one, as the core does."""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

    wedge, places, sizes = vtkUnstructuredGrid(), vtkPoints(), vtkCellSizeFilter()
    for z in (0, 1):
        for x, y in ((0, 0), (1, 0), (0, 1)):
            places.InsertNextPoint(x, y, z)
    wedge.SetPoints(places)
    wedge.InsertNextCell(_WEDGE, 6, range(6))
    sizes.SetInputData(wedge)
    sizes.Update()
    return bool(sizes.GetOutput().GetCellData().GetArray("Volume").GetValue(0) > 0.0)


def named_horizons(horizons: Any, stage: str, faults: Mapping[str, Faults] | None = None) -> tuple[dict[str, Horizon], list[tuple[str, Data]]]:
    """Horizons by name, and their data."""
    given = dict(horizons) if isinstance(horizons, Mapping) else {one.name: one for one in horizons if isinstance(one, Horizon)}
    if not isinstance(horizons, Mapping) and len(given) != len(horizons):
        raise ValueError("%s of %d horizons with %d different names, expected a dict of horizons by name" % (stage, len(horizons), len(given)))
    for one in given.values():
        require_horizon(one, stage)
    unknown = set(faults or ()) - set(given)
    if unknown:
        raise ValueError("faults of %s, expected names of the horizons: %s" % (", ".join(sorted(unknown)), ", ".join(given)))
    return given, [(name, one._data(links_of((faults or {}).get(name)))) for name, one in given.items()]


def _stack_options(given: Mapping[str, Horizon], crossings: str | Sequence[str], minimum_thickness: float | str, order: str) -> dict[str, Any]:
    unit = next(iter(given.values())).vertical_unit if given else ""
    if order not in ("by_height", "as_given"):
        raise ValueError("order '%s', expected by_height or as_given" % order)
    words = {"mean": "Mean", "upper_wins": "UpperWins", "lower_wins": "LowerWins", "stop": "Stop"}
    single = crossings if isinstance(crossings, str) else None
    return given_options(by_height=order == "by_height", crossings=single, height_unit="world",
                         crossings_by_layer=None if single else " ".join(words.get(word, word) for word in crossings),
                         minimum_thickness=height("minimum_thickness", minimum_thickness, unit))


def layers(horizons: Mapping[str, Horizon] | Sequence[Horizon], largest_error: float | str | None = None, *, crossings: str | Sequence[str] = "mean",
           minimum_thickness: float | str = 0.0, order: str = "by_height", domain: str = "each_layer", missing: str = "follow",
           largest_hole_size: int = 2500, largest_gap: int = 10, bound_thickness: bool = False, keep_outlines: bool = False,
           pinch_out_lines: bool = True, smallest_pinch: int = 25, effort: str = "best", smallest_angle: float = 10.0, edge_length: float = 0.0,
           edge_growth: float = 0.0, fit_heights: bool = True,
           sublayers: int | Sequence[int] = 1, largest_sublayer_thickness: float | str = 0.0, tetrahedra: bool = False,
           contact: float | None = None, faults: Mapping[str, Faults] | None = None, progress: Progress | None = None) -> Layers:
    """Makes closed volumes of the layers between horizons.

    Parameters
    ----------
    horizons : dict or list of Horizon
        At least two horizons of one survey, on the same lattice or on lattices with multiples of the smallest steps.
    largest_error : float or str, optional
        Largest vertical distance of horizon points from the layers, in the unit of z or with a unit; by default six times
        the noise of the noisiest horizon.
    crossings : "mean", "upper_wins", "lower_wins" or "stop", or a list of these for each layer
        How to treat crossing horizons, for all layers or for each: "mean" moves both to their mean, which suits noise;
        "upper_wins" moves the lower one, as if eroded; "lower_wins" moves the upper one, as in onlap; "stop" is an
        error.
    minimum_thickness : float or str
        Where layers are thinner, their horizons merge.
    order : "by_height" or "as_given"
        Order of the horizons: by mean height in common columns, or as given, uppermost first.
    domain : "each_layer" or "common"
        Extent of the layers: where both of their horizons are, or where all horizons are.
    missing : "follow", "interpolate" or "void"
        Where a horizon has no points: "follow" closes its holes and gaps, and lets it follow the nearer of its two
        neighbours elsewhere; "interpolate" only closes holes and gaps; "void" leaves out the layers next to it.
    largest_hole_size, largest_gap : int
        Largest enclosed holes to close, in columns, and widest gaps.
    bound_thickness : bool
        Also keeps the thickness within the error; otherwise it is within twice the error, with fewer cells.
    keep_outlines : bool
        Keeps outlines of the common domain unchanged in map view.
    pinch_out_lines : bool
        Ends layers at lines; otherwise they end in thin feathers.
    smallest_pinch : int
        Smallest area without a layer that is bounded by such a line, in columns.
    effort, smallest_angle, edge_length, edge_growth, fit_heights
        As in `surface`.
    sublayers : int or list of int for each layer from the uppermost on
        Number of sublayers of equal thickness, for all layers or for each.
    largest_sublayer_thickness : float or str
        Adds sublayers until none is thicker than this, in the unit of z or with a unit; 0: no limit.
    tetrahedra : bool
        Splits all cells into tetrahedra, as a conforming mesh of the same volume.
    contact : float, optional
        z of a level fluid contact, in the direction of the horizons; adds the volume above it to `figures`.
    faults : dict of Faults by name of the horizon, optional
        Faults that divide layers.
    progress : callable, optional

    Returns
    -------
    Layers

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> z = np.full((20, 30), 1000.0)
    >>> one = {"Top": sh.horizon(z, spacing=(25, 25)), "Base": sh.horizon(z + 40.0, spacing=(25, 25))}
    >>> float(sh.layers(one).figures["volume"][0])
    13775000.0
    """
    given, named = named_horizons(horizons, "layers", faults)
    first = next(iter(given.values()), None)
    options = _stack_options(given, crossings, minimum_thickness, order)
    options.update(given_options(
        maximum_error=None if largest_error is None or first is None else height("largest_error", largest_error, first.vertical_unit),
        domain=domain, missing=missing, largest_hole_size=int(largest_hole_size), largest_gap=int(largest_gap), effort=effort,
        bound_thickness=bool(bound_thickness), keep_outlines=bool(keep_outlines), pinch_out_lines=bool(pinch_out_lines),
        smallest_pinch=int(smallest_pinch), smallest_angle=float(smallest_angle), edge_length=float(edge_length),
        edge_growth=float(edge_growth), fit_heights=bool(fit_heights), tetrahedra=bool(tetrahedra),
        sublayers=" ".join(map(str, [sublayers] if isinstance(sublayers, (int, np.integer)) else sublayers)),
        largest_sublayer_thickness=height("largest_sublayer_thickness", largest_sublayer_thickness, first.vertical_unit) if first else None,
        contact=None if contact is None or first is None else first.sign * float(contact)))
    made = call("layers", _core.layers, named, options, progress)
    volumes, figures = made["volumes"], {snake(name): values for name, values in made["figures"].items()}
    offsets, corners = volumes["cells"]
    sizes = np.diff(offsets)
    kinds = {int(size): np.flatnonzero(sizes == size) for size in np.unique(sizes)}
    names = figures.pop("name")
    unit = figures.pop("volume_unit")[0]
    of_kind = {name: {size: volumes["cell_data"][name][places] for size, places in kinds.items()} for name in ("Layer", "Sublayer", "Thickness", "Volume")}
    bodies = {name: mesh_of(name, data, {}, data["field_data"], None) for name, data in zip(names, made["bodies"])}
    meshes = {name: mesh_of(name, data, take_attributes(data["point_data"], given[name].attributes), given[name]._data()["field_data"],
                            given[name].lattice) for name, data in zip(made["names"], made["horizons"])}
    return Layers(names, volumes["places"], {size: corners[offsets[places][:, None] + np.arange(size)] for size, places in kinds.items()},
                  of_kind["Layer"], of_kind["Sublayer"], of_kind["Thickness"], of_kind["Volume"], bodies, meshes, figures, made["curve"], unit, volumes)


def crossings(horizons: Mapping[str, Horizon] | Sequence[Horizon], *, crossings: str | Sequence[str] = "mean", minimum_thickness: float | str = 0.0,
              order: str = "by_height", progress: Progress | None = None) -> dict[str, Horizon]:
    """Puts crossing horizons in order, column by column.

    Parameters
    ----------
    horizons, crossings, minimum_thickness, order
        As in `layers`.
    progress : callable, optional

    Returns
    -------
    dict of Horizon
        Uppermost first, with all points, and with the attribute Moved: how far each point was moved in the direction of
        z.
    """
    given, named = named_horizons(horizons, "crossings")
    names, made = call("crossings", _core.crossings, named, _stack_options(given, crossings, minimum_thickness, order), progress)
    return {name: dataclasses.replace(
        given[name], z=given[name].sign * data["places"][:, 2],
        attributes={**given[name].attributes, "Moved": given[name].sign * data["point_data"]["Moved"]}) for name, data in zip(names, made)}


@dataclasses.dataclass(eq=False, repr=False)
class Distance:
    """Distances between two surfaces, from `distance`, in the unit of x, y and z.

    Attributes
    ----------
    largest, mean, rms : float
        For both directions, in space.
    of_reference, of_mesh : float64 arrays
        Distance in space of each point of the reference, and of the mesh, from the other surface; negative below it.
    vertical_of_reference, vertical_of_mesh : float64 arrays
        Height of each point above the other surface; nan if the other surface is neither above nor below.
    details : dict
        All figures by name, as arrays of (reference to mesh, mesh to reference, both).
    """

    largest: float
    mean: float
    rms: float
    of_reference: Floats
    of_mesh: Floats
    vertical_of_reference: Floats
    vertical_of_mesh: Floats
    details: dict[str, Floats]

    def __repr__(self) -> str:
        vertical = np.abs(self.vertical_of_reference[np.isfinite(self.vertical_of_reference)])
        return "Distance: largest %.4g, mean %.4g, rms %.4g; vertically up to %.4g" % (
            self.largest, self.mean, self.rms, vertical.max(initial=0.0))


def distance(reference: Any, mesh: Any, *, samples_per_point: float = 2.0, seed: int = 1, radius: int = 1, include_filled: bool = False,
             progress: Progress | None = None) -> Distance:
    """Measures distances between a horizon and a mesh, or between two meshes, in both directions.

    Parameters
    ----------
    reference, mesh : Horizon, Mesh, pyvista.PolyData or (points, triangles)
        In the same coordinate system, with z of points upwards. A horizon is meshed with all its points.
    samples_per_point : float
        Samples on each surface per point of the larger one, from 0.01 to 1000. More samples give more exact means and
        percentiles.
    seed : int
        Seed of the samples.
    radius : int
        Radius of outlines, in columns, if the reference is a horizon.
    include_filled : bool
        Includes filled points in the figures.
    progress : callable, optional

    Returns
    -------
    Distance
    """
    data, other = (_surface_data(one, what) for one, what in ((reference, "reference"), (mesh, "mesh")))
    options = {"samples_per_point": float(samples_per_point), "seed": int(seed), "radius": int(radius), "include_filled_points": bool(include_filled)}
    try:
        first, second, _ = _core.distance(data, other, options, progress)
    except ValueError as error:
        raise ValueError(in_keywords(str(error))) from None
    world = 1  # of the units steps, world, diagonal
    details = {snake(name): values[:, world] for name, values in second["field_data"].items()
               if not isinstance(values, list) and values.ndim == 2 and values.shape == (3, 3)}
    both = 2
    largest, mean, rms = (float(details[name][both]) for name in ("largest_distance", "mean_distance", "rms_distance"))
    return Distance(largest, mean, rms,
                    first["point_data"]["Distance"], second["point_data"]["Distance"], first["point_data"]["VerticalDistance"],
                    second["point_data"]["VerticalDistance"], details)


def _surface_data(given: Any, what: str) -> Data:
    if isinstance(given, (Horizon, Mesh)):
        return given._data()
    if hasattr(given, "points") and hasattr(given, "regular_faces"):  # pyvista
        given = given.points, given.triangulate().regular_faces
    if isinstance(given, tuple) and len(given) == 2:
        points, triangles = np.ascontiguousarray(given[0], np.float64), np.asarray(given[1])
        if points.ndim == 2 and points.shape[1] == 3 and triangles.ndim == 2 and triangles.shape[1] == 3:
            return {"places": points, "polygons": (np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64), np.ascontiguousarray(triangles, np.int64).ravel())}
    raise TypeError("%s of %s, expected a Horizon, a Mesh, a pyvista.PolyData, or (points, triangles) of shapes (n, 3) and (m, 3)" % (
        what, type(given).__name__))


