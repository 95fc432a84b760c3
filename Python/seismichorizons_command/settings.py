# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts the options of the command to properties of the reader and of each stage."""

from . import wording
from .arguments import assigned
from .core import HorizonError, snake
from .options import CUBE_PROPERTIES
from .pipeline import Settings, fault_settings, surface_properties

# Properties of readers that are options of the same name, and those of another one.
SAME = (
    "VerticalDirection", "VerticalStep", "VerticalUnit", "CoordinateSystem", "ZFrom", "DuplicatePolicy", "Columns", "NullValues",
    "HeaderLines", "Where", "StrayPicks", "LatticeTolerance", "Origin", "ColumnStep", "RowStep", "Polarity", "Joining",
    "AmplitudePercentile", "Picks", "Limits", "LimitSide", "Gridding", "GriddingRadius", "GriddingSmoothing")
RENAMED = {"LargestNumber": "surfaces", "SmallestSize": "smallest_surface", "InlineRange": "inlines", "CrosslineRange": "crosslines"}
# Of surfaces and layers.
QUALITY = ("EdgeLength", "SmallestAngle")
# What messages of classes name, in the words of the command.
NAMES = {**{name: "--cube " + name for name in CUBE_PROPERTIES}, **{name: "--" + option.replace("_", "-") for name, option in {**{name: snake(name) for name in SAME}, **RENAMED}.items()},
         "LatticeSource OriginAndSteps": "--origin, --column-step and --row-step", "LatticeSource CornerPoints": "--corners", "NoLattice": "--picks",
         "Order AsGiven": "--order AsGiven", "MinimumPatchSize": "--minimum-patch-size"}
CORNERS = ("FirstCorner", "SecondCorner", "ThirdCorner")


def with_options(text):
    """Returns a message with options in place of properties."""
    return wording.rename(text, NAMES, wording.as_option)


def given(options, *same, **renamed):
    """The values of options that were given, by the names of their properties; all others have the defaults of their
    classes."""
    names = {**{name: snake(name) for name in same}, **renamed}
    return {key: getattr(options, name) for key, name in names.items() if hasattr(options, name)}


def _unit(height):
    return "World" if height.unit else "Steps"


def _reader(options):
    properties = {**given(options, *SAME, **RENAMED), **assigned(getattr(options, "cube", ()))}
    if hasattr(options, "corners"):
        corners = options.corners
        properties.update(LatticeSource="CornerPoints",
                          **{name: corners[4 * n:4 * n + 4] for n, name in enumerate(CORNERS)})
    return properties


def _surface(options, boundary, simplified):
    """Returns properties of the single surface stage, from the largest error or number of triangles and the options given
    beside it. None for the stages of the thesis."""
    if options.stages:
        return None
    target = given(options, largest_error="largest_error", triangles="triangles")
    error = target.get("largest_error")
    unit = {"ErrorUnit": "World"} if getattr(error, "unit", "") else {}
    named = {**boundary, **simplified}
    names = ("Radius", "SmallestHoleSize", "OutlineTolerance", "DistanceThreshold", "GrowthStrategy", "MinimumPatchSize")
    return surface_properties(**target, **unit, **{name: named[name] for name in names if name in named}, **given(options, *QUALITY))


def _error(options):
    """The error of the meshes, if given, with its unit."""
    error = given(options, MaximumError="largest_error")
    return {**error, **({"HeightUnit": "World"} if getattr(error.get("MaximumError"), "unit", "") else {})}


def _layers(options):
    """Returns properties of the layers; their error is the error of the meshes, if given."""
    words = getattr(options, "crossings", [])
    crossings = {} if not words else {"Crossings": words[0]} if len(words) == 1 else {"CrossingsByLayer": " ".join(words)}
    sublayers = {"Sublayers": " ".join(options.sublayers).replace(",", " ")} if hasattr(options, "sublayers") else {}
    return {**_error(options), **crossings, **sublayers, **given(options, "Order", "Missing", "Tetrahedra", *QUALITY)}


def make_settings(options):
    """Returns the settings of all stages."""
    settings = Settings(horizons=getattr(options, "horizons", None), leave_out_invalid=options.leave_out_invalid)
    settings.formats = options.formats
    settings.fault_formats = options.fault_formats
    settings.grids_of_meshes = options.grids_of_meshes
    settings.written_direction = getattr(options, "written_direction", "").lower()
    settings.memory = options.memory
    settings.jobs = options.jobs
    settings.other_files = [*getattr(options, "limits", []), *getattr(options, "fault_lines", []), *getattr(options, "fault_sticks", []),
                            *given(options, picks="picks").values()]
    settings.reader = _reader(options)
    if hasattr(options, "despike"):
        settings.despiked = {"Threshold": options.despike, "ThresholdUnit": _unit(options.despike)}
    throw = getattr(options, "cut_faults", None)
    settings.torn, settings.fault_lines, settings.fault_files = fault_settings(
        None if throw is None else _unit(throw), settings.reader.get("VerticalDirection"), throw, **given(options, traces="fault_lines", sticks="fault_sticks"))
    for name, is_given in (("close-faults", options.close_faults), ("fault-formats", settings.fault_formats), ("cutoffs", hasattr(options, "cutoffs")), ("sealed", hasattr(options, "sealed"))):
        if is_given and settings.torn is None:
            raise HorizonError("--%s without faults, expected --cut-faults, --fault-lines or --fault-sticks" % name)
    of_sealed = ("fault_endings", "fault_tips", "unconformities", "walls")
    of_plates = (("gridding_radius", ("gridding",)), ("gridding_smoothing", ("gridding",)))
    for name, needed in (*of_plates, ("fault_dip", ("cutoffs", "sealed")), *((name, ("sealed",)) for name in of_sealed)):
        if hasattr(options, name) and not any(hasattr(options, other) for other in needed):
            raise HorizonError("--%s without %s, expected both" % (name.replace("_", "-"), " or ".join("--" + other for other in needed)))
    if hasattr(options, "cutoffs"):
        settings.cutoffs = given(options, Dip="fault_dip")
    if hasattr(options, "sealed"):
        settings.sealed = {**_error(options), **given(options, Dip="fault_dip", Endings="fault_endings", Tips="fault_tips", Outline="walls")}
        if hasattr(options, "unconformities"):
            settings.sealed["Unconformities"] = "; ".join(options.unconformities)
    settings.filled = {"LargestHoleSize": options.fill_holes} if hasattr(options, "fill_holes") else None
    settings.boundary = given(options, "GrowthStrategy", "MinimumPatchSize", "Radius", "SmallestHoleSize", "KeepHoles")
    settings.simplified = {
        **({"Method": "FewestPoints"} if hasattr(options, "fewest_outline_points") else {}),
        **given(options, "BoundDeviation", "OutlineTolerance", "DistanceThreshold")}
    settings.rough = None if hasattr(options, "skip_rough") else given(options, "CellSize", "Representative")
    settings.elaborate = None if not hasattr(options, "elaborate") else given(
        options, "FlatnessThreshold", "Representative", CellSize="elaborate_cell_size")
    settings.surface = _surface(options, settings.boundary, settings.simplified)
    if hasattr(options, "layers"):
        settings.layers = _layers(options)
    if options.close_faults:
        (settings.mesh if settings.surface is None else settings.surface)["CloseFaults"] = True
    settings.error_if_whole = hasattr(options, "report") and not options.measure_error
    settings.error = None if not options.measure_error and not settings.error_if_whole else given(
        options, "DistanceUnit", "SamplesPerPoint")
    return settings
