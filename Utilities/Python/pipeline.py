# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a file to meshes: the horizons of a file, and all stages of a horizon with their data and times.

    horizons, seconds = read("survey.vsm")
    result = run("survey.vsm", *horizons[0], Settings(rough={"CellSize": 4}, error={}))
    result.data["mesh"], result.seconds["mesh"], result.figures

Or straight from points to a mesh, with the parameters that were chosen:

    mesh, chosen = surface(horizons[0][1], largest_error=1.0)
"""

import time
from dataclasses import dataclass, field, replace
from typing import Optional

from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import heights, ledger, parts, tsurf, writing
from .parts import SURFACE
from .reading import read, read_first  # noqa: F401: the first step of a pipeline
from .stage import HorizonError, apply, make, update

# In their order. Each name is that of the data the stage makes.
STAGES = {
    "boundary": "vtkHorizonExteriorBoundary",
    "simplified": "vtkHorizonBoundarySimplification",
    "rough": "vtkHorizonRoughSimplification",
    "elaborate": "vtkHorizonElaborateSimplification",
    "mesh": "vtkHorizonTriangulation"}
# Before all of them, on request.
PREPARATIONS = {
    "despiked": "vtkHorizonDespiking",
    "torn": "vtkHorizonFaults",
    "filled": "vtkHorizonHoleFilling"}
# Properties of the surface, which takes the place of all of them, that are chosen, unless they are given: each has a
# switch, "Automatic" and its name.
CHOSEN = ("Radius", "SmallestHoleSize", "OutlineTolerance", "DistanceThreshold")


@dataclass
class Settings:
    """Properties of the reader, of every stage and of the measure of the error; those that are not named have their
    defaults. None leaves a stage out. `despiked`, `torn` and `filled` are those of despiking, faults and hole filling,
    which come first; `fault_lines` are those that faults are given by. With `surface` (see surface_properties) one stage takes the place of all others.
    `layers` are those of volumes between all horizons of a file.
    `horizons` are the IDs or names of those to read, None for all. A horizon that cannot be
    processed raises an error, or with `leave_out_invalid` has an empty mesh and a warning. `formats` are those that
    meshes are written in (writing.FORMATS). `other_files` are read besides inputs. `memory` are the bytes that may be used, None for most of what the machine has
    left; horizons are read as many at a time as fit. Heights may have units (heights.Height). With `error_if_whole` the error of a horizon that is larger than memory,
    which cannot be measured, is not asked for."""

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

    def make_stages(self):
        """The stages from points to mesh in their order, as (name, algorithm)."""
        stages = [(name, STAGES[name], getattr(self, name)) for name in STAGES]
        if self.surface is not None:
            stages = [("mesh", SURFACE, self.surface)]
        stages = [(name, PREPARATIONS[name], getattr(self, name)) for name in PREPARATIONS] + stages
        return [(name, self.make(class_name, given)) for name, class_name, given in stages if given is not None]

    def can_cut(self):
        """Whether a horizon that is larger than memory can be meshed in windows."""
        by_error = self.surface is not None and self.surface.get("Target") != "NumberOfTriangles"
        can_go_without = (self.error is None or self.error_if_whole) and not writing.POINT_FORMATS.keys() & set(self.formats)
        return by_error and can_go_without and all(
            getattr(self, name) is None for name in (*PREPARATIONS, "layers"))

    def said_unit(self):
        """That of the heights, empty where they have none."""
        return next((value.unit for properties in (self.despiked, self.torn, self.surface, self.layers) if properties
                     for value in properties.values() if getattr(value, "unit", "")), "")

    def plain_error(self):
        """The largest error in vertical indices; None where it is in another unit, automatic, or not what was asked for."""
        error = self.surface and self.surface.get("MaximumError")
        return None if error is None or getattr(error, "unit", "") else error

    def is_automatic(self):
        """Whether the largest error is chosen by the noise of each horizon."""
        return self.surface is not None and not {"MaximumError", "Target"} & self.surface.keys()

    def in_unit_of(self, horizon):
        """The same with heights in the unit of z of a horizon. Raises HorizonError."""
        return replace(self, **{name: heights.in_unit_of(getattr(self, name), horizon)
                                for name in ("despiked", "torn", "surface", "layers") if getattr(self, name) is not None})

    def make(self, class_name, properties):
        """A stage, or the measure."""
        stage = make(class_name, **properties)
        if self.leave_out_invalid:
            stage.SetInvalidHorizonsToLeaveOut()
        return stage


def surface_properties(largest_error=None, triangles=None, **properties):
    """Properties of vtkHorizonSurface: the largest error or the number of triangles as the target, and others by their
    names. Those that are chosen otherwise are switched over."""
    target = {} if triangles is None else {"Target": "NumberOfTriangles", "MaximumNumberOfTriangles": triangles}
    if largest_error is not None:
        target["MaximumError"] = largest_error
    return {**target, **{"Automatic" + name: False for name in CHOSEN if name in properties}, **properties}


def surface(points, largest_error=None, triangles=None, **properties):
    """The mesh of a horizon, straight from its points, and a dictionary of the parameters that were chosen. Either the
    largest error is given (in lattice units; automatic when there is no number of triangles) or the most triangles there
    may be. Raises HorizonError."""
    if largest_error is not None and triangles is not None:
        raise ValueError("largest_error and triangles, expected one of them")
    mesh = apply(make(SURFACE), points, **surface_properties(largest_error, triangles, **properties))
    return mesh, chosen_parameters(mesh)


def chosen_parameters(mesh):
    """What a mesh of vtkHorizonSurface says that was chosen, by the names of the properties."""
    data = mesh.GetFieldData()
    arrays = [data.GetArray(n) for n in range(data.GetNumberOfArrays()) if data.GetArray(n) is not None]
    return {array.GetName()[len("Chosen"):]: array.GetValue(0) for array in arrays
            if (array.GetName() or "").startswith("Chosen")}


class Result:
    """All stages of one horizon, which has a name: the data by stage ("points" are what was read, "measured" is the horizon
    with its distances from the mesh), the seconds each took, and the figures of the error as a table, or None; distances
    are in `unit`; warnings as texts. The source is what errors and progress name: the file."""

    def __init__(self, source, name, points):
        self.source = source
        self.name = name
        self.data = {"points": points}
        self.number_of_points = 0 if points is None else points.GetNumberOfPoints()
        self.loops = None  # outlines over all points, and the points in them
        self.simplified = None  # the same once points were dropped
        self.seconds = {}
        self.figures = None
        self.unit = "Lattice"
        self.height_unit = ""  # that errors are told in; vertical indices where it is empty
        self.per_index = 1.0  # so much of it
        self.warnings = []

    def tell_in(self, unit):
        """Errors are told in a unit or, where it is empty, in that of z."""
        self.height_unit = unit or heights.unit_of(self.data["mesh"]) or "z"
        self.per_index = heights.per_index(self.data["mesh"], self.height_unit)

    def release(self):
        """Gives all data back but the mesh, and what is the same for all horizons."""
        self.data = {name: self.data[name] for name in ("mesh", "fault surfaces") if name in self.data}

    def warn_of_ledger(self):
        """Of what the mesh covers without points, and of points that it does not cover."""
        mesh = self.data["mesh"]
        found = ledger.warning(ledger.read(mesh))
        if found and mesh.GetNumberOfPolys():
            self.warnings.append("%s: %s" % (self.name, found))

    def run_stage(self, stage, algorithm):
        try:
            self.seconds[stage] = update(algorithm, "%s: %s: %s" % (self.source, self.name, stage), self.warnings,
                                         (self.number_of_points, "points"))
        except HorizonError as error:  # names the horizon, but not the file
            raise HorizonError("%s: %s" % (self.source, error)) from None


def fault_settings(unit, vertical_direction, throw=None, traces=None, sticks=None):
    """Settings.torn and Settings.fault_lines for a throw from which on faults are detected, and a file of traces and
    polygons or of sticks. Raises HorizonError."""
    if throw is None and traces is None and sticks is None:
        return None, None
    torn = {"Detect": False} if throw is None else {"SmallestThrow": throw, "ThrowUnit": unit}
    path = traces if sticks is None else sticks
    if path is None:
        return torn, None
    torn["LineType"] = "Traces" if sticks is None else "Sticks"
    return torn, apply(make("vtkFaultLinesReader", FileName=str(path), VerticalDirection=vertical_direction or "Automatic"))


def _require_same_direction(result, points, settings):
    """Raises HorizonError where z of the horizon counts upwards by its format, and nobody said so of fault sticks, whose z
    counts downwards."""
    direction = points.GetFieldData().GetArray("VerticalDirection")
    if (settings.torn.get("LineType") == "Sticks" and "VerticalDirection" not in settings.reader
            and direction is not None and direction.GetValue(0) > 0
            and points.GetCenter()[2] > 0.0 >= settings.fault_lines.GetBounds()[5]):
        raise HorizonError("%s: %s: elevations, which increase upwards, with fault sticks, expected --vertical-direction "
                           "for both" % (result.source, result.name))


def run(source, name, points, settings, surface=None):
    """Runs all stages on the points of a horizon. Where it was made from the triangles of a surface, the errors are from those.
    Raises HorizonError."""
    result = Result(source, name, points)
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
        tsurf.account(result, surface)
    result.warn_of_ledger()
    if settings.error is not None:
        _measure(result, settings, surface or result.data["boundary"])
    return result


def run_windows(source, windows, settings):
    """Makes the mesh of a horizon that is larger than memory (parts.Windows). Raises HorizonError."""
    result = Result(source, windows.name, None)
    result.number_of_points = windows.number_of_points
    start = time.monotonic()
    try:
        result.data = {"mesh": parts.mesh(windows, settings.surface, "%s: %s" % (source, windows.name), result.warnings)}
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
    """Number of outlines, and of points in them (a closed line repeats its first one; a single point does not)."""
    lines = horizon.GetLines()
    points = 0
    for number in range(lines.GetNumberOfCells()):
        size = lines.GetCellSize(number)
        points += max(1, size - 1)
    return lines.GetNumberOfCells(), points


def _measure(result, settings, reference):
    """The reference is a surface, or the horizon within its outlines, as they were before they were simplified."""
    meter = settings.make("vtkHorizonSurfaceDistance", settings.error)
    meter.SetInputDataObject(0, reference)
    meter.SetInputDataObject(1, result.data["mesh"])
    result.run_stage("error", meter)
    result.unit = settings.error.get("DistanceUnit", result.unit)
    result.data["measured"] = meter.GetOutputDataObject(0)
    result.data["mesh"] = meter.GetOutputDataObject(1)
    result.figures = meter.GetOutputDataObject(2)
