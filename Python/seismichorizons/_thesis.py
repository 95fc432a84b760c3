# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The single stages of the thesis; `surface` runs all stages at once.

Points with outlines and meshes are `Mesh` objects. Options and their defaults are those on the pages of the stages. All
functions raise ValueError for data that a stage does not accept, and for options out of range.
"""

from __future__ import annotations

from typing import Any

from . import _core
from ._data import Progress, call, take_attributes
from ._horizon import Horizon
from ._mesh import Mesh, mesh_of
from ._stages import Faults, given_options, links_of, require_horizon
from ._units import height


def _run(stage: Any, of: Horizon | Mesh, data: Any, options: dict[str, Any], progress: Progress | None) -> Mesh:
    made, *_ = call(of.name, stage, data, options, progress)
    return mesh_of(of.name, made, take_attributes(made["point_data"], of.attributes), data["field_data"], of.lattice)


def exterior_boundary(horizon: Horizon, *, radius: int | None = None, growth: str | None = None, kind: str | None = None,
                      keep_holes: bool | None = None, smallest_hole_size: int | None = None, smallest_hole_area: float | None = None,
                      minimum_patch_size: int | None = None, faults: Faults | None = None, progress: Progress | None = None) -> Mesh:
    """Finds the outline of each connected patch, and of holes if requested.

    Parameters
    ----------
    horizon : Horizon
    radius : int
        Largest hop of outlines along each axis, in columns, from 1 to 32; 1 by default.
    growth : "clockwise" or "distance"
        Course of outlines with a radius above 1: "clockwise" goes straight across narrow bays, "distance" around every
        detail.
    kind : "exterior", "topological4" or "topological8"
    keep_holes : bool
        Keeps holes open, with an outline; off by default.
    smallest_hole_size : int
        Holes with fewer columns strictly inside are closed.
    smallest_hole_area : float
        Holes with a smaller area, in square units of x and y, are also closed.
    minimum_patch_size : int
        Patches with fewer points are dropped.
    faults : Faults, optional
        Faults that split the horizon, with an outline along both sides.
    progress : callable, optional

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> len(sh.exterior_boundary(sh.horizon(np.full((20, 30), 1000.0))).outlines[0])
    96
    """
    require_horizon(horizon, "an exterior boundary")
    options = given_options(radius=radius, growth=growth, kind=kind, keep_holes=keep_holes, smallest_hole_size=smallest_hole_size,
                            smallest_hole_area=smallest_hole_area, minimum_patch_size=minimum_patch_size)
    return _run(_core.boundary, horizon, horizon._data(links_of(faults)), options, progress)


def boundary_simplification(outlined: Mesh, *, method: str | None = None, distance_threshold: float | None = None,
                            bound_deviation: bool | None = None, outline_tolerance: float | None = None,
                            progress: Progress | None = None) -> Mesh:
    """Drops outline points within tolerances.

    Parameters
    ----------
    outlined : Mesh
        Points with outlines, from `exterior_boundary`.
    method : "threshold" or "fewest_points"
        The method of the thesis, or the fewest points within the tolerances.
    distance_threshold : float
        Points closer to the line through their neighbours are dropped, in lattice units; 0.4 by default. With
        "fewest_points", the largest vertical distance of a dropped point from the new outline.
    bound_deviation : bool
        Keeps dropped points within `distance_threshold` of the final outline.
    outline_tolerance : float
        Largest distance in map view of a dropped point from the new outline, in columns; 0 by default.
    progress : callable, optional
    """
    options = given_options(method=method, distance_threshold=distance_threshold, bound_deviation=bound_deviation,
                            outline_tolerance=outline_tolerance)
    return _run(_core.boundary_simplification, outlined, outlined._data(), options, progress)


def rough_simplification(outlined: Mesh, *, cell_size: int | None = None, maximum_number_of_points: int | None = None,
                         representative: str | None = None, progress: Progress | None = None) -> Mesh:
    """Replaces inner points with one point per square cell.

    Parameters
    ----------
    outlined : Mesh
    cell_size : int
        Edge length of cells, in columns; 3 by default.
    maximum_number_of_points : int
        Chooses the cell size for at most this number of points.
    representative : "barycentre" or "nearest_point"
    progress : callable, optional
    """
    options = given_options(cell_size=cell_size, maximum_number_of_points=maximum_number_of_points, representative=representative)
    return _run(_core.rough_simplification, outlined, outlined._data(), options, progress)


def elaborate_simplification(outlined: Mesh, *, cell_size: int | None = None, flatness_threshold: float | None = None,
                             maximum_number_of_points: int | None = None, representative: str | None = None,
                             progress: Progress | None = None, **more: float | str) -> Mesh:
    """Replaces inner points with one point per cell. Cells are smaller near outlines and where the surface is curved.

    Parameters
    ----------
    outlined : Mesh
    cell_size : int
        Largest edge length of cells, in columns; 8 by default.
    flatness_threshold : float
        Largest curvature of a flat cell, from 0 to 1/3; smaller values keep more points; 0.12 by default.
    maximum_number_of_points : int
        Chooses the threshold for at most this number of points.
    representative : "barycentre" or "nearest_point"
    progress : callable, optional
    **more
        boundary_density_threshold, boundary_extent_threshold, boundary_cell_size_threshold, smallest_cell_size, growth_per_ring,
        and neighbour_mean ("over_cubes" or "over_pieces").
    """
    known = {"boundary_density_threshold", "boundary_extent_threshold", "boundary_cell_size_threshold", "smallest_cell_size",
             "growth_per_ring", "neighbour_mean"}
    for name in more:
        if name not in known:
            raise TypeError("%s, expected one of %s" % (name, ", ".join(sorted(known))))
    options = given_options(cell_size=cell_size, flatness_threshold=flatness_threshold, maximum_number_of_points=maximum_number_of_points,
                            representative=representative, **more)
    return _run(_core.elaborate_simplification, outlined, outlined._data(), options, progress)


def triangulation(outlined: Mesh, *, search: str | None = None, convex_hull: bool | None = None, maximum_boundary_angle: float | None = None,
                  maximum_boundary_edge_length: float | None = None, close_faults: bool | None = None,
                  progress: Progress | None = None) -> Mesh:
    """Connects all points inside the outlines by a constrained Delaunay triangulation.

    Parameters
    ----------
    outlined : Mesh
    search : "voxel_traversal" or "compactness"
        How the third points of triangles are found. The mesh is the same.
    convex_hull : bool
        Meshes the convex hull of all points and ignores outlines, without outer triangles that exceed the limits below.
    maximum_boundary_angle : float
        Largest angle opposite a boundary edge, in degrees, with `convex_hull`.
    maximum_boundary_edge_length : float
        Longest boundary edge, in columns, with `convex_hull`; 0: no limit.
    close_faults : bool
        Closes cracks at faults with steep triangles.
    progress : callable, optional
    """
    options = given_options(search=search, convex_hull=convex_hull, maximum_boundary_angle=maximum_boundary_angle,
                            maximum_boundary_edge_length=maximum_boundary_edge_length, close_faults=close_faults)
    return _run(_core.triangulation, outlined, outlined._data(), options, progress)


def decimation(outlined: Mesh, largest_error: float | str | None = None, *, points: int | None = None, reduction: float | None = None,
               fit_heights: bool | None = None, effort: str | None = None, priority: str | None = None, smallest_angle: float | None = None,
               edge_length: float | None = None, edge_growth: float | None = None,
               crossing_tolerance: str | None = None, close_faults: bool | None = None, progress: Progress | None = None) -> Mesh:
    """Makes a mesh with few triangles within a given error. Outlines are unchanged.

    Parameters
    ----------
    outlined : Mesh
        All points of a horizon, with outlines.
    largest_error : float or str, optional
        As in `surface`.
    points : int, optional
        Largest number of points, including outlines, instead of an error.
    reduction : float, optional
        Fraction of points to drop, instead of an error.
    fit_heights, effort, smallest_angle, edge_length, edge_growth, crossing_tolerance, close_faults
        As in `surface`.
    priority : "sum_of_squares" or "largest_errors"
        Error to minimise for a given number of points: the sum of squares, or the largest error.
    progress : callable, optional
    """
    if sum(value is not None for value in (largest_error, points, reduction)) > 1:
        raise ValueError("several of largest_error, points and reduction, expected one")
    options = given_options(
        fit_heights=fit_heights, effort=effort, priority=priority, smallest_angle=smallest_angle, edge_length=edge_length,
        edge_growth=edge_growth, close_faults=close_faults,
        crossing_tolerance=crossing_tolerance, error_unit="world", maximum_number_of_points=points, target_reduction=reduction,
        target="points" if points is not None else "reduction" if reduction is not None else "error",
        maximum_error=None if largest_error is None else height("largest_error", largest_error, outlined.vertical_unit))
    return _run(_core.decimation, outlined, outlined._data(), options, progress)
