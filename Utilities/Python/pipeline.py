# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a file to meshes: the horizons of a file, and all stages of a horizon with their data and times.

    horizons, seconds = read("survey.vsm")
    result = run("survey.vsm", *horizons[0], Settings(rough={"CellSize": 4}, error={}))
    result.data["mesh"], result.seconds["mesh"], result.figures

Or directly from points to a mesh, with the parameters that were chosen:

    mesh, chosen = surface(horizons[0][1], largest_error=1.0)
"""

import re
import time
from dataclasses import dataclass, field, replace
from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import heights, ledger, parts, tsurf, writing
from .parts import SURFACE
from .reading import read, read_first  # noqa: F401: the first step of a pipeline
from .stage import HorizonError, apply, make, update

# Stages in order, named after the data that they make.
STAGES = {
    "boundary": "vtkHorizonExteriorBoundary",
    "simplified": "vtkHorizonBoundarySimplification",
    "rough": "vtkHorizonRoughSimplification",
    "elaborate": "vtkHorizonElaborateSimplification",
    "mesh": "vtkHorizonTriangulation"}
# Optional stages that come before all others.
PREPARATIONS = {
    "despiked": "vtkHorizonDespiking",
    "torn": "vtkHorizonFaults",
    "filled": "vtkHorizonHoleFilling"}
# Properties of vtkHorizonSurface that are chosen unless given. Each has a switch named "Automatic" followed by its name.
CHOSEN = ("Radius", "SmallestHoleSize", "OutlineTolerance", "DistanceThreshold")


@dataclass
class Settings:
    """Properties of the reader, of each stage and of the error measurement; omitted properties have their defaults. None
    skips a stage.

    `despiked`, `torn` and `filled` belong to despiking, faults and hole filling, which come first; `fault_lines` are
    lines that define faults. `surface` (see surface_properties) is a single stage that replaces all others. `layers`
    belongs to volumes between all horizons of a file. Heights may have units (heights.Height).

    `horizons` lists the IDs or names of the horizons to read, None for all. A horizon that cannot be processed raises an
    error or, with `leave_out_invalid`, has an empty mesh and a warning. `formats` lists the formats of meshes
    (writing.FORMATS), and `other_files` the input files other than those of horizons. `memory` is the limit in bytes,
    None for most of the free memory; as many horizons as fit are read at a time; `jobs` is the number of
    files that share it. With `error_if_whole`, the error of a
    horizon larger than memory, which cannot be measured, is not requested.
    """

    reader: dict = field(default_factory=dict)
    despiked: Optional[dict] = None
    torn: Optional[dict] = None
    fault_lines: Optional[vtkPolyData] = None
    filled: Optional[dict] = None
    boundary: dict = field(default_factory=dict)
    simplified: dict = field(default_factory=dict)
    rough: Optional[dict] = field(default_factory=dict)
    elaborate: Optional[dict] = None
    mesh: dict = field(default_factory=dict)
    surface: Optional[dict] = None
    layers: Optional[dict] = None
    error: Optional[dict] = None
    error_if_whole: bool = False
    horizons: Optional[list] = None
    leave_out_invalid: bool = False
    formats: tuple = ("vtp",)
    other_files: tuple = ()
    memory: Optional[int] = None
    jobs: int = 1

    def make_stages(self):
        """Returns the stages from points to mesh in order, as (name, algorithm)."""
        stages = [(name, STAGES[name], getattr(self, name)) for name in STAGES]
        if self.surface is not None:
            stages = [("mesh", SURFACE, self.surface)]
        stages = [(name, PREPARATIONS[name], getattr(self, name)) for name in PREPARATIONS] + stages
        return [(name, self.make(class_name, given)) for name, class_name, given in stages if given is not None]

    def can_cut(self):
        """Whether a horizon larger than memory can be meshed in windows."""
        by_error = self.surface is not None and self.surface.get("Target") != "NumberOfTriangles"
        can_go_without = (self.error is None or self.error_if_whole) and not writing.POINT_FORMATS.keys() & set(self.formats)
        return by_error and can_go_without and all(
            getattr(self, name) is None for name in (*PREPARATIONS, "layers"))

    def said_unit(self):
        """Returns the unit of the given heights; empty if they have none."""
        return next((value.unit for properties in (self.despiked, self.torn, self.surface, self.layers) if properties
                     for value in properties.values() if getattr(value, "unit", "")), "")

    def plain_error(self):
        """Returns the largest error in vertical indices; None if it has another unit, is automatic or was not given."""
        error = (self.surface or {}).get("MaximumError")
        return None if error is None or getattr(error, "unit", "") else error

    def in_unit_of(self, horizon):
        """Returns the settings with heights converted to the unit of z of a horizon. Raises HorizonError."""
        return self.in_unit(heights.unit_of(horizon))

    def in_unit(self, unit):
        """Does the same for a unit of z."""
        return replace(self, **{name: heights.in_unit(getattr(self, name), unit)
                                for name in ("despiked", "torn", "surface", "layers") if getattr(self, name) is not None})

    def make(self, class_name, properties):
        """Makes a stage or the error measurement."""
        stage = make(class_name, **properties)
        if self.leave_out_invalid:
            stage.SetInvalidHorizonsToLeaveOut()
        return stage


def surface_properties(largest_error=None, triangles=None, **properties):
    """Returns properties of vtkHorizonSurface: the largest error or the number of triangles as the target, and other
    properties by name. Properties that are given are not chosen automatically."""
    target = {} if triangles is None else {"Target": "NumberOfTriangles", "MaximumNumberOfTriangles": triangles}
    if largest_error is not None:
        target["MaximumError"] = largest_error
    return {**target, **{"Automatic" + name: False for name in CHOSEN if name in properties}, **properties}


def surface(points, largest_error=None, triangles=None, **properties):
    """Makes the mesh of a horizon directly from its points. Returns the mesh and a dictionary of the chosen parameters. The
    target is either the largest error in lattice units, automatic if neither is given, or the largest number of triangles.
    Raises HorizonError."""
    if largest_error is not None and triangles is not None:
        raise ValueError("largest_error and triangles, expected one of them")
    mesh = apply(make(SURFACE), points, **surface_properties(largest_error, triangles, **properties))
    return mesh, chosen_parameters(mesh)


def chosen_parameters(mesh):
    """Returns the automatically chosen parameters of a mesh of vtkHorizonSurface, by property name."""
    data = mesh.GetFieldData()
    arrays = [data.GetArray(n) for n in range(data.GetNumberOfArrays()) if data.GetArray(n) is not None]
    return {array.GetName()[len("Chosen"):]: array.GetValue(0) for array in arrays
            if (array.GetName() or "").startswith("Chosen")}


class Result:
    """All stages of one horizon: the data by stage ("points" as read, "measured" with distances from the mesh), the seconds
    that each took, the figures of the error as a table, or None, with distances in `unit`, and warnings as texts. `source`
    is the file label in errors and progress."""

    def __init__(self, source, name, points):
        self.source = source
        self.name = name
        self.data = {"points": points}
        self.number_of_points = 0 if points is None else points.GetNumberOfPoints()
        self.loops = None  # number of outlines before simplification, and of their points
        self.simplified = None  # the same after simplification
        self.seconds = {}
        self.figures = None
        self.unit = "Lattice"
        self.height_unit = ""  # unit of reported errors; vertical indices if empty
        self.per_index = 1.0  # size of a vertical index in this unit
        self.warnings = []

    def report_in(self, unit):
        """Reports errors in a unit or, if it is empty, in the unit of z."""
        self.height_unit = unit or heights.unit_of(self.data["mesh"]) or "z"
        self.per_index = heights.per_index(self.data["mesh"], self.height_unit)

    def release(self):
        """Releases all data except the mesh and data shared by all horizons."""
        self.data = {name: self.data[name] for name in ("mesh", "fault surfaces") if name in self.data}

    def warn_of_ledger(self):
        """Warns of mesh areas without points and of points that the mesh does not cover."""
        mesh = self.data["mesh"]
        found = ledger.warning(ledger.read(mesh))
        if found and mesh.GetNumberOfPolys():
            self.warnings.append("%s: %s" % (self.name, found))

    def run_stage(self, stage, algorithm):
        warnings = []
        try:
            self.seconds[stage] = update(algorithm, "%s: %s: %s" % (self.source, self.name, stage), warnings,
                                         (self.number_of_points, "points"))
        except HorizonError as error:  # the message names the horizon but not the file
            raise HorizonError("%s: %s" % (self.source, self._named(str(error)))) from None
        finally:
            self.warnings += map(self._named, warnings)

    def _named(self, text):
        """Returns a message with the name of the horizon in place of its number."""
        return re.sub(r"^Horizon -?\d+(?=: )", lambda _: self.name, text)


def fault_settings(unit, vertical_direction, throw=None, traces=None, sticks=None):
    """Returns Settings.torn and Settings.fault_lines for a smallest throw to detect, and a file of traces and polygons or
    of sticks. Raises HorizonError."""
    if throw is None and traces is None and sticks is None:
        return None, None
    torn = {"Detect": False} if throw is None else {"SmallestThrow": throw, "ThrowUnit": unit}
    path = traces if sticks is None else sticks
    if path is None:
        return torn, None
    torn["LineType"] = "Traces" if sticks is None else "Sticks"
    return torn, apply(make("vtkFaultLinesReader", FileName=str(path), VerticalDirection=vertical_direction or "Automatic"))


def _require_same_direction(result, points, settings):
    """Raises HorizonError if z of the horizon increases upwards by its format and no direction was given for fault sticks,
    whose z increases downwards."""
    direction = points.GetFieldData().GetArray("VerticalDirection")
    if (settings.torn.get("LineType") == "Sticks" and "VerticalDirection" not in settings.reader
            and direction is not None and direction.GetValue(0) > 0
            and points.GetCenter()[2] > 0.0 >= settings.fault_lines.GetBounds()[5]):
        raise HorizonError("%s: %s: elevations, which increase upwards, with fault sticks, expected --vertical-direction "
                           "for both" % (result.source, result.name))


def run(source, name, points, settings, surface=None):
    """Runs all stages on the points of a horizon. If it was sampled from the triangles of a surface, errors are measured
    from those triangles. Raises HorizonError."""
    result = Result(source, name, points)
    unit = settings.said_unit()
    try:
        settings = settings.in_unit_of(points)
    except HorizonError as error:
        raise HorizonError("%s: %s: %s" % (source, name, error)) from None
    data = points
    for stage, algorithm in settings.make_stages():
        algorithm.SetInputDataObject(0, data)
        if stage == "torn" and settings.fault_lines is not None:
            _require_same_direction(result, points, settings)
            algorithm.SetInputDataObject(1, settings.fault_lines)
        result.run_stage(stage, algorithm)
        data = result.data[stage] = algorithm.GetOutputDataObject(0)
        if stage == "torn":
            result.data["faults"] = algorithm.GetOutputDataObject(1)
            result.data["fault surfaces"] = algorithm.GetOutputDataObject(2)
        elif settings.surface is not None and stage == "mesh":
            result.data["boundary"] = algorithm.GetOutputDataObject(1)
    result.loops = count_loops(result.data["boundary"])
    result.simplified = count_loops(result.data.get("simplified", result.data["mesh"]))
    if surface is not None:
        tsurf.account(result, surface, unit)
    result.warn_of_ledger()
    if settings.error is not None:
        _measure(result, settings, surface or result.data["boundary"])
    return result


def run_windows(source, windows, settings):
    """Makes the mesh of a horizon larger than memory (parts.Windows). Raises HorizonError."""
    result = Result(source, windows.name, None)
    result.number_of_points = windows.number_of_points
    start = time.monotonic()
    surface = settings.in_unit(windows.unit).surface
    try:
        result.data = {"mesh": parts.mesh(windows, surface, "%s: %s" % (source, windows.name), result.warnings)}
    except HorizonError as error:
        if not settings.leave_out_invalid:
            raise HorizonError("%s: %s" % (source, error)) from None
        result.warnings.append("%s is left out" % error)
        result.data = {"mesh": vtkPolyData()}
    result.seconds["mesh"] = time.monotonic() - start
    result.simplified = count_loops(result.data["mesh"])
    result.warn_of_ledger()
    return result


def count_loops(horizon):
    """Returns the number of outlines and of their points. The repeated first point of a closed outline is not counted."""
    lines = horizon.GetLines()
    points = 0
    for number in range(lines.GetNumberOfCells()):
        size = lines.GetCellSize(number)
        points += max(1, size - 1)
    return lines.GetNumberOfCells(), points


def _measure(result, settings, reference):
    """Measures the error against a surface, or against the horizon within its outlines before they were simplified."""
    meter = settings.make("vtkHorizonSurfaceDistance", settings.error)
    meter.SetInputDataObject(0, reference)
    meter.SetInputDataObject(1, result.data["mesh"])
    result.run_stage("error", meter)
    result.unit = settings.error.get("DistanceUnit", result.unit)
    result.data["measured"] = meter.GetOutputDataObject(0)
    result.data["mesh"] = meter.GetOutputDataObject(1)
    result.figures = meter.GetOutputDataObject(2)
