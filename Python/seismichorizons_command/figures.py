# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The results of a run as plain values for programs (--json) and for the report: dictionaries, lists, texts and numbers.
Documentation/Report.md describes all keys."""

import math
import os
import platform
import sys

import numpy as np

import seismichorizons

from . import data, heights, ledger, triangles
from .data import text, value, values
from .pipeline import PREPARATIONS, STAGES, SURFACE, chosen_parameters
from .tables import TWO_SIDED, prepared_number

BINS = 24  # of the histogram of distances
ANGLE_BINS = 12  # of 5 degrees, up to 60, the upper limit of the smallest angle of a triangle
CHUNK = 1 << 20  # triangles processed at a time
ERRORS = {"LargestDistance": "largest", "LargestDistanceFound": "largest_found", "MeanDistance": "mean",
          "RmsDistance": "rms", "DistancePercentile50": "median", "DistancePercentile90": "percentile_90",
          "DistancePercentile95": "percentile_95", "DistancePercentile99": "percentile_99", "OutlineDistance": "outline"}
VERTICAL = {"LargestError": "largest", "MeanError": "mean", "LargestEdgeError": "edges",
            "LargestLoopError": "outlines"}
STATED = {"VerticalUnit": "vertical_unit", "VerticalDomain": "vertical_domain", "HorizontalUnit": "horizontal_unit",
          "CoordinateSystem": "coordinate_system"}
UNITS = {"lattice": "Steps", "world": "World"}  # by name in the figures of a run


def versions():
    """Returns the versions of the software used; None for ParaView and VTK if the program runs without them."""
    try:
        from paraview import __version__ as paraview
    except ImportError:
        paraview = None
    vtk = sys.modules.get("vtkmodules.vtkCommonCore")
    return {"SeismicHorizons": seismichorizons.__version__, "ParaView": paraview, "VTK": vtk and vtk.vtkVersion.GetVTKVersion(),
            "Python": platform.python_version(), "NumPy": np.__version__}


def plain(word):
    """Returns command-line words and file names as writable text, whatever their bytes."""
    return str(word).encode("utf-8", "backslashreplace").decode()


def command():
    """Returns the command line of this program and its working folder."""
    words = getattr(sys, "orig_argv", None) or [sys.executable, *sys.argv]
    return {"words": list(map(plain, words)), "folder": plain(os.getcwd())}


def parameters(settings):
    """Returns the parameters of the reader, of each stage and of the measure, by the property names of the classes."""
    stages = {**PREPARATIONS, **(STAGES if settings.surface is None else {})}
    given = {"reader": {**settings.reader, **({} if settings.horizons is None else {"Horizons": settings.horizons})},
             **{class_name: getattr(settings, name) for name, (class_name, _) in stages.items()},
             SURFACE: settings.surface, "vtkHorizonLayers": settings.layers, "vtkHorizonSurfaceDistance": settings.error}
    return {name: dict(properties) for name, properties in given.items() if properties is not None}


def survey(horizon):
    """Returns the lattice of a horizon and what its file states about coordinates; unknown values are None."""
    known = {key: text(horizon, name) or None for name, key in STATED.items()}
    direction = data.vertical_direction(horizon)
    known["vertical_direction"] = None if not direction else "down" if direction < 0 else "up"
    known["line_numbers"] = dict(zip(("first_inline", "inline_step", "first_crossline", "crossline_step"),
                                     values(horizon, "LineNumbers"))) or None
    matrix = values(horizon, "LatticeToWorld")
    known["lattice"] = None if not matrix else {
        "columns": values(horizon, "LatticeDimensions"),
        "origin": matrix[3:12:4], "column_step": matrix[0:8:4], "row_step": matrix[1:8:4], "vertical_step": matrix[10]}
    for name, key in (("DroppedDuplicates", "dropped_duplicates"), ("DroppedRepeats", "dropped_repeats"),
                      ("DroppedNulls", "dropped_nulls"), ("LargestConflict", "largest_conflict")):
        known[key] = value(horizon, name)
    return known


def horizon(result):
    """Returns the figures of a result (pipeline.Result)."""
    mesh = result.data["mesh"]
    before, after = result.number_of_points, data.count_points(mesh)
    loops, loop_points = result.loops or (result.simplified[0], None)
    vertical = {key: value(mesh, name) for name, key in VERTICAL.items()}
    noise = dict([heights.noise_of(mesh) or (None, None)])
    return {
        "name": result.name, "points_in": before, "points_out": after, "triangles": triangles.count_surface(mesh),
        "fault_triangles": triangles.count_at_faults(mesh),
        "reduction": 1.0 - after / before if before else None,
        "patches": value(mesh, "NumberOfPatches"), "holes": value(mesh, "NumberOfHoles"),
        "outlines": loops, "outline_points_in": loop_points, "outline_points": result.simplified[1],
        "vertical_step": _vertical_step(mesh),
        "told_in": {"unit": result.height_unit or None, "per_index": result.per_index},
        "bounds": data.bounds(mesh) if after else None,
        "angles": angles(mesh),
        "seconds": {**result.seconds, "total": sum(result.seconds.values())},
        "chosen": chosen_parameters(mesh),
        "faults": faults(result.data.get("torn")),
        "prepared": {name: prepared_number(mesh, name) for name in PREPARATIONS if name in result.seconds},
        "vertical_error": None if vertical["largest"] is None else vertical,
        "automatic_error": {"noise": noise.get("noise"), "rounding": noise.get("rounding")},
        "points_outside": value(mesh, "NumberOfOutsidePoints"),
        "ledger": ledger.read(mesh),
        "error": None if result.figures is None else {name: _errors(result.figures, row, unit)
                                                      for row, (name, unit) in enumerate(UNITS.items())},
        "distances": distances(result),
        "results": [], "warnings": list(result.warnings)}


def faults(torn):
    """Returns a row for each fault that cuts a horizon: its name, its links, and the mean and the largest throw, without sign,
    in vertical indices, None if unknown."""
    fields = torn["field_data"] if torn else {}
    if not len(fields.get("FaultLine", ())):
        return []
    names, throws = np.array(fields["FaultNames"])[fields["FaultLine"]], np.abs(fields["FaultThrow"])
    rows = []
    for name in dict.fromkeys(fields["FaultNames"]):
        own = throws[names == name]
        known = own[np.isfinite(own)]
        if len(own):
            rows.append({"name": name, "links": len(own), "throw_mean": float(known.mean()) if len(known) else None,
                         "throw_largest": float(known.max()) if len(known) else None})
    return rows


def _vertical_step(mesh):
    matrix = values(mesh, "LatticeToWorld")
    return abs(matrix[10]) if matrix else None


def angles(mesh):
    """Returns the smallest angle of each surface triangle in map view, on the lattice, in degrees: the minimum, and counts
    in bins of five degrees from 0 to 60. None without triangles."""
    corners = triangles.of_surface(mesh)
    if not len(corners):
        return None
    matrix = values(mesh, "LatticeToWorld")
    points = mesh["places"]
    if matrix:
        matrix = np.array(matrix).reshape(4, 4)
        points = (points - matrix[:3, 3]) @ np.linalg.inv(matrix[:3, :3]).T
    counts = np.zeros(ANGLE_BINS, dtype=np.int64)
    smallest = 60.0
    for first in range(0, len(corners), CHUNK):
        found = _smallest_angles(points[:, :2][corners[first:first + CHUNK]])
        counts += np.histogram(found, bins=ANGLE_BINS, range=(0.0, 60.0))[0]
        smallest = min(smallest, float(found.min()))
    return {"smallest": smallest, "counts": counts.tolist()}


def _smallest_angles(places):
    """Smallest angles in degrees of triangles with (n, 3, 2) coordinates."""
    angles_of = []
    for corner in range(3):
        a = places[:, (corner + 1) % 3] - places[:, corner]
        b = places[:, (corner + 2) % 3] - places[:, corner]
        angles_of.append(np.arctan2(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]), (a * b).sum(axis=1)))
    # Rounding must not put equilateral triangles beyond the last bin.
    return np.minimum(np.degrees(np.min(angles_of, axis=0)), 60.0)


def distances(result):
    """Returns a histogram of the distances of the horizon's points from the mesh, in equal bins up to the largest distance.
    Filled points are not counted. None if distances were not measured."""
    arrays = result.data.get("measured", data.empty())["point_data"]
    if not len(arrays.get("Distance", ())):
        return None
    found = arrays["Distance"]
    found = found[np.isfinite(found) & (arrays["Filled"] == 0 if "Filled" in arrays else True)]
    if not len(found):
        return None
    farthest = float(found.max())
    counts = np.histogram(found, bins=BINS, range=(0.0, farthest or 1.0))[0]
    return {"unit": next(name for name, unit in UNITS.items() if unit == result.unit), "farthest": farthest, "counts": counts.tolist()}


def _errors(table, row, unit):
    """Returns the figures for both directions in one of the units, from the table of the measure."""
    row = TWO_SIDED + 3 * row
    assert table["Unit"][row] == unit
    return {key: float(table[name][row]) for name, key in ERRORS.items()}


def without_nan(value):
    """Returns the value with None in place of numbers that JSON does not support."""
    if isinstance(value, dict):
        return {key: without_nan(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
