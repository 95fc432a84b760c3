# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a file to meshes: the horizons of a file, and all stages of a horizon with their data and times.

    horizons, seconds = read("survey.vsm")
    result = run("survey.vsm", *horizons[0], Settings(rough={"CellSize": 4}, error={}))
    result.data["mesh"], result.seconds["mesh"], result.figures
"""

import time
from dataclasses import dataclass, field, replace
from typing import Optional

from seismichorizons import _core, read_faults

from . import core, data, heights, ledger, tsurf, writing
from .core import HorizonError
from .progress import file_work
from .reading import read, read_first  # noqa: F401: the first step of a pipeline

SURFACE = "vtkHorizonSurface"  # the class of the single stage that replaces all of these
# Stages in order, named after the data that they make: the name of the class in ParaView, and the function of the core.
STAGES = {
    "boundary": ("vtkHorizonExteriorBoundary", _core.boundary),
    "simplified": ("vtkHorizonBoundarySimplification", _core.boundary_simplification),
    "rough": ("vtkHorizonRoughSimplification", _core.rough_simplification),
    "elaborate": ("vtkHorizonElaborateSimplification", _core.elaborate_simplification),
    "mesh": ("vtkHorizonTriangulation", _core.triangulation)}
# Optional stages that come before all others.
PREPARATIONS = {
    "despiked": ("vtkHorizonDespiking", _core.despike),
    "torn": ("vtkHorizonFaults", _core.faults),
    "filled": ("vtkHorizonHoleFilling", _core.fill_holes)}


@dataclass
class Settings:
    """Properties of the reader, of each stage and of the error measurement, by their names in ParaView; omitted ones have
    their defaults. None skips a stage.

    `despiked`, `torn` and `filled` belong to despiking, faults and hole filling, which come first; `fault_lines` are
    lines that define faults. `surface` (see surface_properties) is a single stage that replaces all others. `layers`
    belongs to volumes between all horizons of a file. Heights may have units (heights.Height).

    `horizons` lists the IDs or names of the horizons to read, None for all. A horizon that cannot be processed raises an
    error or, with `leave_out_invalid`, has an empty mesh and a warning. `formats` lists the formats of meshes
    (options.FORMATS), and `other_files` the input files other than those of horizons. `memory` is the limit in bytes,
    None for most of the free memory; as many horizons as fit are read at a time; `jobs` is the number of
    files that share it. With `error_if_whole`, the error of a
    horizon larger than memory, which cannot be measured, is not requested.
    """

    reader: dict = field(default_factory=dict)
    despiked: Optional[dict] = None
    torn: Optional[dict] = None
    fault_lines: Optional[dict] = None
    given_faults: Optional[object] = None  # The core's, of a file; collects warnings of its horizons.
    fault_files: tuple = ()  # what each was taken for
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
    fault_formats: tuple = ()  # of lines, cutoffs and polygons
    cutoffs: Optional[dict] = None  # between all horizons of a file, or of several files of one each
    sealed: Optional[dict] = None
    grids_of_meshes: bool = False  # not of points
    written_direction: str = ""  # "down" or "up"; empty for that of the input
    other_files: tuple = ()
    memory: Optional[int] = None
    jobs: int = 1

    def stages(self):
        """Returns the stages from points to mesh in order, as (name, function of the core, properties)."""
        stages = [("mesh", _core.surface, self.surface)] if self.surface is not None else [
            (name, function, getattr(self, name)) for name, (_, function) in STAGES.items()]
        stages = [(name, function, getattr(self, name)) for name, (_, function) in PREPARATIONS.items()] + stages
        return [(name, function, given) for name, function, given in stages if given is not None]

    def can_go_by_rows(self):
        """Whether rows of a horizon larger than memory can be read while it is meshed."""
        by_error = self.surface is not None and "MaximumNumberOfTriangles" not in self.surface
        can_go_without = (self.error is None or self.error_if_whole) and not any(
            writing.is_of_points(form, self.grids_of_meshes) for form in self.formats)
        return by_error and can_go_without and all(
            getattr(self, name) is None for name in (*PREPARATIONS, "layers"))  # There are no cutoffs without faults, which are a preparation.

    def joins_horizons(self):
        """Whether something is made of all horizons together."""
        return not (self.layers is None and self.cutoffs is None and self.sealed is None)

    def said_unit(self):
        """Returns the unit of the given heights; empty if they have none."""
        return next((value.unit for properties in (self.despiked, self.torn, self.surface, self.layers, self.sealed) if properties
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
                                for name in ("despiked", "torn", "surface", "layers", "sealed") if getattr(self, name) is not None})


def surface_properties(largest_error=None, triangles=None, **properties):
    """Returns properties of the surface: the largest error or the number of triangles as the target, and other properties by
    name. Properties that are not given are chosen automatically."""
    target = {} if triangles is None else {"MaximumNumberOfTriangles": triangles}
    if largest_error is not None:
        target["MaximumError"] = largest_error
    return {**target, **properties}


def chosen_parameters(mesh):
    """Returns the automatically chosen parameters of a mesh, by property name."""
    return {name[len("Chosen"):]: data.value(mesh, name) for name in mesh["field_data"] if name.startswith("Chosen")}


class Result:
    """All stages of one horizon: the data by stage ("points" as read, "measured" with distances from the mesh), the seconds
    that each took, the figures of the error as a table, or None, with distances in `unit`, and warnings as texts. `source`
    is the file label in errors and progress."""

    def __init__(self, source, name, points):
        self.source = source
        self.name = name
        self.data = {"points": points}
        self.number_of_points = 0 if points is None else data.count_points(points)
        self.loops = None  # number of outlines before simplification, and of their points
        self.simplified = None  # the same after simplification
        self.seconds = {}
        self.figures = None
        self.unit = "Steps"
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
        if found and data.count_polygons(mesh):
            self.warnings.append("%s: %s" % (self.name, found))

    def run_stage(self, stage, function, *arguments):
        """Returns the outputs of a stage. Raises HorizonError."""
        start = time.monotonic()
        try:
            outputs, warnings = core.run(function, *arguments, label="%s: %s: %s" % (self.source, self.name, stage),
                                         work=(self.number_of_points, "points"))
        except HorizonError as error:  # which names neither file nor horizon
            raise HorizonError("%s: %s: %s" % (self.source, self.name, error)) from None
        self.seconds[stage] = time.monotonic() - start
        self.warnings += ["%s: %s" % (self.name, text) for text in filter(None, warnings)]
        return outputs

    def leave_out(self, error):
        """Has an empty mesh, and a warning in place of an error that begins with the source and the name."""
        reason = str(error).removeprefix("%s: %s: " % (self.source, self.name))
        self.warnings.append("%s is left out: %s" % (self.name, reason))
        self.data["mesh"] = data.empty()
        self.data.setdefault("boundary", self.data["mesh"])


def fault_settings(unit, vertical_direction, throw=None, traces=None, sticks=None):
    """Returns Settings.torn, Settings.fault_lines and Settings.fault_files for a smallest throw to detect, and files of traces and
    polygons or of sticks. Raises HorizonError."""
    if throw is None and traces is None and sticks is None:
        return None, None, ()
    torn = {"Detect": False} if throw is None else {"SmallestThrow": throw, "ThrowUnit": unit}
    files = traces if sticks is None else sticks
    if files is None:
        return torn, None, ()
    torn["LineType"] = "Traces" if sticks is None else "Sticks"
    direction = core.snake(vertical_direction or "")
    lines = core.run(lambda progress: read_faults(files, direction="" if direction == "automatic" else direction, progress=progress),
                     work=file_work(files[0]))
    return torn, lines._data(), tuple("%s: %s" % ("fault lines" if sticks is None else "fault sticks", line) for line in lines.taken)


def _require_same_direction(result, points, settings):
    """Raises HorizonError if z of the horizon increases upwards by its format and no direction was given for fault sticks,
    whose z increases downwards."""
    if (settings.torn.get("LineType") == "Sticks" and "VerticalDirection" not in settings.reader
            and data.vertical_direction(points) > 0
            and sum(data.bounds(points)[4:]) > 0.0 >= data.bounds(settings.fault_lines)[5]):
        raise HorizonError("%s: %s: elevations, which increase upwards, with fault sticks, expected --vertical-direction "
                           "for both" % (result.source, result.name))


def with_faults(settings):
    """Returns the settings for the horizons of a file, whose `given_faults` has the warnings of lines without an effect."""
    return settings if settings.fault_lines is None else replace(settings, given_faults=_core.GivenFaults(settings.fault_lines))


def run(source, name, points, settings, surface=None):
    """Runs all stages on the points of a horizon. If it was sampled from the triangles of a surface, errors are measured
    from those triangles. Raises HorizonError."""
    result = Result(source, name, points)
    unit = settings.said_unit()
    try:
        settings = settings.in_unit_of(points)
    except HorizonError as error:
        raise HorizonError("%s: %s: %s" % (source, name, error)) from None
    try:
        _run_stages(result, settings)
    except HorizonError as error:
        if not settings.leave_out_invalid:
            raise
        result.leave_out(error)
    result.loops = count_loops(result.data["boundary"])
    result.simplified = count_loops(result.data.get("simplified", result.data["mesh"]))
    if surface is not None:
        tsurf.account(result, surface, unit)
    result.warn_of_ledger()
    if settings.error is not None and data.count_polygons(result.data["mesh"]):
        try:
            _measure(result, settings, surface or result.data["boundary"])
        except HorizonError as error:
            if not settings.leave_out_invalid:
                raise
            result.leave_out(error)
    return result


def _run_stages(result, settings):
    """Runs the stages, each on the data of the one before. Raises HorizonError."""
    last = result.data["points"]
    for stage, function, given in settings.stages():
        properties = core.options({name: value for name, value in given.items() if name != "LineType"})
        if stage == "torn":
            if settings.fault_lines is not None:
                _require_same_direction(result, last, settings)
            properties["are_sticks"] = given.get("LineType") == "Sticks"
            outputs = result.run_stage(stage, function, last, settings.given_faults, properties)
            result.data["faults"], result.data["fault surfaces"] = outputs[1:]
        else:
            outputs = result.run_stage(stage, function, last, properties)
            if stage == "mesh" and settings.surface is not None:
                result.data["boundary"] = outputs[1]
        last = result.data[stage] = outputs[0]


def run_by_rows(source, horizon, settings):
    """Makes the mesh of a horizon larger than memory (large.LargeHorizon). Raises HorizonError."""
    result = Result(source, horizon.name, None)
    result.number_of_points = horizon.number_of_points
    surface = settings.in_unit(horizon.unit).surface
    try:
        result.data = {"mesh": result.run_stage("mesh", horizon.mesh, core.options(surface))}
    except HorizonError as error:
        if not settings.leave_out_invalid:
            raise
        result.leave_out(error)
        result.release()
    result.simplified = count_loops(result.data["mesh"])
    result.warn_of_ledger()
    return result


def count_loops(horizon):
    """Returns the number of outlines and of their points. The repeated first point of a closed outline is not counted."""
    sizes = [len(line) for line in data.lines(horizon)]
    return len(sizes), sum(max(1, size - 1) for size in sizes)


def _measure(result, settings, reference):
    """Measures the error against a surface, or against the horizon within its outlines before they were simplified."""
    given = settings.error
    options = core.options({name: value for name, value in given.items() if name != "DistanceUnit"})
    result.unit = given.get("DistanceUnit", result.unit)
    options.update(in_world_units=result.unit == "World", name=result.name)
    measured, mesh, figures = result.run_stage(
        "error", lambda *arguments: (_core.distance(*arguments), []), reference, result.data["mesh"], options)
    result.data["measured"], result.data["mesh"], result.figures = measured, mesh, figures
