#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns files of seismic horizons into triangle meshes, with a table and a picture of every stage.

Runs in pvbatch, in pvpython and in the Python of the system, as long as the package seismichorizons is in PYTHONPATH.
The work is done by the modules of that package; here is the command line.
"""

import os
import signal


def _end_at_once(signal_number, _frame):
    os._exit(128 + signal_number)


if __name__ == "__main__":
    # As long as nothing is done there is nothing to leave in order: from here on, before anything else is loaded.
    signal.signal(signal.SIGINT, _end_at_once)
    signal.signal(signal.SIGTERM, _end_at_once)

import argparse  # noqa: E402
import pathlib  # noqa: E402
import re  # noqa: E402
import sys  # noqa: E402

PROGRAM = "horizon_mesh"
ELEVATIONS = ("VerticalIndex", "RealZ")
VERTICAL_DIRECTIONS = ("Down", "Up")
REPRESENTATIVES = ("Barycentre", "NearestPoint")
GROWTH_STRATEGIES = ("Distance", "Clockwise")
DISTANCE_UNITS = ("Lattice", "World")
FORMATS = ("vtp", "ts", "stl", "ply", "obj")
DUPLICATE_POLICIES = ("StrongestAmplitude", "Topmost", "Lowest", "Sheets")
JOININGS = ("BestFirst", "Continuous", "Components")
POLARITIES = ("Both", "Positive", "Negative")
MOST = 2**31  # more than integers of stages can be


class _Parser(argparse.ArgumentParser):
    """Refuses a wrong command line in the same form as everything else."""

    def error(self, message):
        self.exit(fail("%s (see --help)" % message))


def _number_at_least(convert, least, more=False):
    """A converter of argparse for numbers that are not smaller than `least` (or, with `more`, larger than it)."""

    def check(text):
        value = convert(text)
        if not (value > least if more else value >= least) or value >= (MOST if convert is int else float("inf")):
            raise ValueError(text)
        return value

    end = " and < 2^31" if convert is int else ""
    check.__name__ = "%s %s %g%s:" % ("integer" if convert is int else "number", ">" if more else ">=", least, end)
    return check


def _line_number(text):
    value = int(text)
    if not -MOST <= value < MOST:
        raise ValueError(text)
    return value


_line_number.__name__ = "integer of 32 bits:"


def _vertical_step(text):
    value = float(text)
    if value == 0.0 or value != value or abs(value) == float("inf"):
        raise ValueError(text)
    return value


_vertical_step.__name__ = "number other than 0:"


def _memory(text):
    """Bytes from "2G", "1.5 GB", "800M" and the like."""
    found = re.fullmatch(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*([KMGT]?)I?B?\s*", text.upper())
    size = float(found.group(1)) * 1024 ** " KMGT".index(found.group(2) or " ") if found else 0.0
    if not 1.0 <= size < float("inf"):
        raise ValueError(text)
    return int(size)


_memory.__name__ = "size like 2G or 800M:"


def _horizon(text):
    if os.path.exists(text):
        raise argparse.ArgumentTypeError("%s is a file; put -- between horizons and files that follow" % text)
    return text


def make_parser():
    parser = _Parser(
        prog=PROGRAM + ".py",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
        description="Reads files of seismic horizons (sparse voxel files, text picks of OpendTect, Petrel, OpenWorks, IESX "
        "and the like, grids as IRAP, ZMAP+, CPS-3, EarthVision, Surfer and GXF; by what is in them, whatever their "
        "extension) or finds the largest ones in seismic cubes (SEG-Y), and turns each horizon in them into a triangle mesh: exterior "
        "boundary, boundary simplification, rough and (on request) elaborate simplification, triangulation. Or, "
        "recommended, with one number: --largest-error or --triangles, from which all else follows. Writes one "
        "mesh per horizon and one picture per file, and prints a table; on request, measures the error. Files "
        "that already exist are replaced.",
        epilog="Results are named after their file and horizon: x_horizon_1.vtp or x_Top.vtp, x.png and x_error.csv for "
        "x.vsm or x.dat. Where files have "
        "the same name, the names of their folders come first, as many as it takes: a_x.png for a/x.vsm, and b_x.png "
        "for b/x.vsm. Results of a file appear all together, or not at all. Distances are in lattice units: 1 is one "
        "column step sideways and one vertical index up or down. The exit code is 0 when all is done, and 1 when a file, or "
        "the report, could not be done, or the command line is wrong; the "
        "other files are done all the same. After Ctrl-C it is 130, after the signal TERM 143.")
    parser.add_argument("inputs", nargs="+", metavar="INPUT", type=pathlib.Path,
                        help="files of horizons, or folders of them")
    parser.add_argument("--output-folder", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER",
                        help="where the results go; made when it is missing")
    parser.add_argument("--formats", nargs="+", choices=FORMATS, default=["vtp"],
                        help="formats of the meshes: VTK, GOCAD TSurf, STL, PLY (single precision) and OBJ; put -- "
                        "between them and files that follow")
    _add_reader_options(parser.add_argument_group("reading"))
    _add_cube_options(parser.add_argument_group("seismic cubes"))
    _add_preparation_options(parser.add_argument_group("before all stages", "horizons are read as a whole then"))
    _add_stage_options(parser.add_argument_group("stages"))
    _add_error_options(parser.add_argument_group("error"))
    _add_telling_options(parser.add_argument_group("telling"))
    _add_running_options(parser.add_argument_group("running"))
    return parser


def _add_telling_options(group):
    group.add_argument("--report", type=pathlib.Path, default=argparse.SUPPRESS, metavar="FILE.html",
                       help="write a page for a browser about the whole run: what was read, figures, pictures, meshes to "
                       "turn around, and how to do it again, all in one file; measures the error, too, but of horizons "
                       "that are larger than memory")
    group.add_argument("--json", action="store_true",
                       help="print one JSON object with all figures in place of the tables, for programs; "
                       "Documentation/Report.md tells of its keys")


def _add_running_options(running):
    running.add_argument("--no-pictures", action="store_true", help="write no pictures (then no X server is needed)")
    running.add_argument("--leave-out-invalid", action="store_true",
                         help="leave out horizons that can not be processed, with a warning, and do the others of "
                         "their file; otherwise such a file is not done")
    running.add_argument("--memory", type=_memory, metavar="SIZE",
                         help="as much memory as may be used, as 2G or 800M: of sparse voxel files, horizons are read as "
                         "many at a time as fit, and with --largest-error one that does not fit alone is meshed in "
                         "windows of rows and joined; other files are read whole, which takes up to 80 bytes a point, "
                         "and refused where they do not fit then (default: three quarters of what the machine has left, where a file "
                         "may be larger)")
    running.add_argument("--threads", type=_number_at_least(int, 0), default=0, metavar="N",
                         help="number of threads; 0 uses all processors")


def _add_reader_options(group):
    group.add_argument("--horizons", nargs="+", type=_horizon, metavar="NAME", default=argparse.SUPPRESS,
                       help="only these horizons, by their names, or by the IDs of sparse voxel files (default: all); "
                       "put -- between them and files that follow")
    group.add_argument("--vertical-step", type=_vertical_step, default=argparse.SUPPRESS, metavar="Z",
                       help="length along world z from one vertical index to the next (default: 1 for sparse voxel "
                       "files, where a negative one turns the vertical direction around; for others one that suits "
                       "the data)")
    group.add_argument("--vertical-direction", choices=VERTICAL_DIRECTIONS, default=VERTICAL_DIRECTIONS[0],
                       help="where vertical indices and z of the file grow to: time and depth do so downwards")
    group.add_argument("--elevation", choices=ELEVATIONS, default=argparse.SUPPRESS,
                       help="what the world z of a point of sparse voxel files is made from (default: VerticalIndex)")
    group.add_argument("--duplicate-policy", choices=DUPLICATE_POLICIES, default=argparse.SUPPRESS,
                       help="which voxel or pick stays where a horizon has several in a column, or all on sheets that are "
                       "horizons of their own (default: StrongestAmplitude)")
    group.add_argument("--columns", default=argparse.SUPPRESS, metavar="LIST",
                       help='what the columns of a text file hold, as "X,Y,-,Z,My attribute" or "Inline,Crossline,Z" '
                       "(default: what its header says, or its values are like)")
    group.add_argument("--null-values", default=argparse.SUPPRESS, metavar="LIST",
                       help='what stands for no value in a text file, besides 1e30 and words as nan (default: "-999.25 '
                       '-99999 9999900")')
    group.add_argument("--origin", nargs=3, type=float, default=argparse.SUPPRESS, metavar=("X", "Y", "Z"),
                       help="world position of the first voxel of the cube (default: 0 0 0), or, with z 0, of the first "
                       "column of picks (default: found from them)")
    group.add_argument("--column-step", nargs=2, type=float, default=argparse.SUPPRESS, metavar=("X", "Y"),
                       help="world vector from a column to the next (default: 1 0; for picks found from them)")
    group.add_argument("--row-step", nargs=2, type=float, default=argparse.SUPPRESS, metavar=("X", "Y"),
                       help="world vector from a row to the next (default: 0 1; for picks found from them)")


def _add_cube_options(group):
    group.add_argument("--surfaces", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="N",
                       help="how many surfaces of a cube become meshes, the largest ones (default: 20)")
    group.add_argument("--smallest-surface", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="N",
                       help="surfaces of fewer picks are left out (default: 100)")
    group.add_argument("--inlines", nargs=2, type=_line_number, default=argparse.SUPPRESS, metavar=("FIRST", "LAST"),
                       help="only these inlines, by their numbers (default: all)")
    group.add_argument("--crosslines", nargs=2, type=_line_number, default=argparse.SUPPRESS, metavar=("FIRST", "LAST"),
                       help="only these crosslines, by their numbers (default: all)")
    group.add_argument("--polarity", choices=POLARITIES, default=argparse.SUPPRESS,
                       help="the sign of the amplitudes of reflections that are taken (default: Both)")
    group.add_argument("--joining", choices=JOININGS, default=argparse.SUPPRESS,
                       help="how picks become surfaces: the most alike first, which stops at faults; whole strong events, "
                       "some over faults; or whatever touches (default: BestFirst)")
    group.add_argument("--amplitude-percentile", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS,
                       metavar="P", help="the part of the reflections that are too weak, in percent (default: 25)")


def _add_preparation_options(group):
    group.add_argument("--despike", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS, metavar="T",
                       help="remove points that are more than T above or below the surface through those around them; 0 "
                       "finds T by the noise; height unit (default: none)")
    group.add_argument("--cut-faults", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS, metavar="T",
                       help="find faults that throw by T or more, and leave the mesh open there; 0 finds T by the noise; "
                       "height unit (default: no fault is cut)")
    lines = group.add_mutually_exclusive_group()
    lines.add_argument("--fault-lines", type=pathlib.Path, default=argparse.SUPPRESS, metavar="FILE",
                       help="cut along the fault traces of a file, and leave out what is inside its fault polygons")
    lines.add_argument("--fault-sticks", type=pathlib.Path, default=argparse.SUPPRESS, metavar="FILE",
                       help="cut where surfaces between the fault sticks of a file pass, and write these surfaces")
    group.add_argument("--height-unit", choices=DISTANCE_UNITS, default=DISTANCE_UNITS[0],
                       help="the unit of --largest-error, --despike and --cut-faults: vertical indices, or that of z, such "
                       "as m or ms")
    group.add_argument("--close-faults", action="store_true",
                       help="close the mesh at these faults by triangles, which have 1 in the array Fault")
    group.add_argument("--fill-holes", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="N",
                       help="fill holes of at most N columns with points that go on smoothly from their rims (default: none)")


def _add_stage_options(group):
    target = group.add_mutually_exclusive_group()
    target.add_argument("--largest-error", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS, metavar="E",
                        help="few triangles, with no point farther from the mesh than this, vertically, in place of "
                        "the stages below; outlines may move by as much; 0.75 suits horizons of whole voxels; height "
                        "unit")
    target.add_argument("--triangles", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="N",
                        help="the same with at most N triangles in each mesh, as near to its horizon as it then can be")
    group.add_argument("--radius", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="K",
                       help="how far the outline may reach from one point to the next, and so how wide a gap it "
                       "closes; lattice units (default: 1; chosen from the points with --largest-error or "
                       "--triangles)")
    group.add_argument("--growth-strategy", choices=GROWTH_STRATEGIES, default=GROWTH_STRATEGIES[1],
                       help="how an outline of a radius above 1 grows")
    group.add_argument("--minimum-patch-size", type=_number_at_least(int, 1), default=1, metavar="N",
                       help="patches with fewer points are left out")
    group.add_argument("--hole-boundaries", action="store_true",
                       help="give holes an outline of their own, so that they stay open in the mesh; with "
                       "--largest-error or --triangles they always have one")
    group.add_argument("--smallest-hole-size", type=_number_at_least(int, 1), default=argparse.SUPPRESS, metavar="N",
                       help="holes of fewer columns are closed all the same (default: 1; chosen with --largest-error "
                       "or --triangles)")
    group.add_argument("--outline-tolerance", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS,
                       metavar="T",
                       help="how far the outline may move on the map when its corners are dropped; lattice units "
                       "(default: 0; the error with --largest-error or --triangles)")
    group.add_argument("--fewest-outline-points", action="store_true",
                       help="give outlines the fewest points within the outline tolerance on the map and the distance "
                       "threshold in height")
    group.add_argument("--bound-deviation", action="store_true",
                       help="keep every dropped outline point within the distance threshold of the new outline")
    group.add_argument("--distance-threshold", type=_number_at_least(float, 0.0), default=argparse.SUPPRESS, metavar="T",
                       help="an outline point closer than this to the line through its neighbours is dropped; "
                       "lattice units (default: 0.4; the error with --largest-error or --triangles)")
    group.add_argument("--cell-size", type=_number_at_least(int, 1), default=3, metavar="S",
                       help="side of the cells that the rough simplification merges; lattice units")
    group.add_argument("--skip-rough", action="store_true",
                       help="leave out the rough simplification: keep every point inside the outline")
    group.add_argument("--elaborate", action="store_true",
                       help="then simplify by curvature, too: fewer points where a horizon is flat")
    group.add_argument("--elaborate-cell-size", type=_number_at_least(int, 1), default=8, metavar="S",
                       help="side of the largest cells of the elaborate simplification; lattice units")
    group.add_argument("--flatness-threshold", type=_number_at_least(float, 0.0), default=0.12, metavar="F",
                       help="how curved a cell of the elaborate simplification may be, from 0 (only a plane is flat) "
                       "to 1/3 (everything is)")
    group.add_argument("--representative", choices=REPRESENTATIVES, default=REPRESENTATIVES[0],
                       help="what stands for the points of a cell: their mean, or the one of them nearest to it")


def _add_error_options(group):
    group.add_argument("--measure-error", action="store_true",
                       help="measure how far each mesh is from the horizon at full resolution, both ways: columns of the "
                       "table (in lattice units), arrays of the meshes, and all figures as a .csv file for each input")
    group.add_argument("--distance-unit", choices=DISTANCE_UNITS, default=DISTANCE_UNITS[0],
                       help="the unit of the arrays; the .csv file has both")
    group.add_argument("--samples-per-point", type=_number_at_least(float, 0.01), default=2.0, metavar="N",
                       help="how densely the faces are sampled: places on each surface for each point of the horizon")


def _given(options, **names):
    """Properties that were given a value, by the names of their options."""
    return {key: getattr(options, name) for key, name in names.items() if hasattr(options, name)}


def _make_surface(options, boundary, simplified):
    """What one number means: that, and what was given beside it. None without such a number."""
    from seismichorizons.pipeline import CHOSEN, surface_properties

    target = _given(options, largest_error="largest_error", triangles="triangles")
    given = {**boundary, **simplified}
    names = (*CHOSEN, "GrowthStrategy", "MinimumPatchSize")
    unit = {"ErrorUnit": options.height_unit} if options.height_unit != DISTANCE_UNITS[0] else {}
    return surface_properties(**target, **unit, **{name: given[name] for name in names if name in given}) if target else None


def make_settings(options):
    """What the options mean for each stage."""
    from seismichorizons.pipeline import Settings, fault_settings

    settings = Settings(horizons=getattr(options, "horizons", None), leave_out_invalid=options.leave_out_invalid)
    settings.formats = options.formats
    settings.memory = options.memory
    settings.reader = {"VerticalDirection": options.vertical_direction, **_given(
        options, VerticalStep="vertical_step", Elevation="elevation", DuplicatePolicy="duplicate_policy",
        Columns="columns", NullValues="null_values", Origin="origin", ColumnStep="column_step", RowStep="row_step",
        LargestNumber="surfaces", SmallestSize="smallest_surface", InlineRange="inlines", CrosslineRange="crosslines",
        Polarity="polarity", Joining="joining", AmplitudePercentile="amplitude_percentile")}
    unit = options.height_unit
    settings.despiked = {"Threshold": options.despike, "ThresholdUnit": unit} if hasattr(options, "despike") else None
    settings.torn, settings.fault_lines = fault_settings(unit, options.vertical_direction, **_given(
        options, throw="cut_faults", traces="fault_lines", sticks="fault_sticks"))
    settings.filled = {"LargestHoleSize": options.fill_holes} if hasattr(options, "fill_holes") else None
    settings.boundary = {
        "GrowthStrategy": options.growth_strategy, "MinimumPatchSize": options.minimum_patch_size,
        "HoleBoundaries": options.hole_boundaries,
        **_given(options, Radius="radius", SmallestHoleSize="smallest_hole_size")}
    settings.simplified = {
        "Method": "FewestPoints" if options.fewest_outline_points else "Threshold",
        "BoundDeviation": options.bound_deviation,
        **_given(options, OutlineTolerance="outline_tolerance", DistanceThreshold="distance_threshold")}
    settings.rough = None if options.skip_rough else {
        "CellSize": options.cell_size, "Representative": options.representative}
    settings.elaborate = None if not options.elaborate else {
        "CellSize": options.elaborate_cell_size, "FlatnessThreshold": options.flatness_threshold,
        "Representative": options.representative}
    settings.surface = _make_surface(options, settings.boundary, settings.simplified)
    if options.close_faults:
        (settings.mesh if settings.surface is None else settings.surface)["CloseFaults"] = True
    settings.error_if_whole = hasattr(options, "report") and not options.measure_error
    settings.error = None if not options.measure_error and not settings.error_if_whole else {
        "DistanceUnit": options.distance_unit, "SamplesPerPoint": options.samples_per_point}
    return settings


def tell(kind, text):
    """Tells of an error, or of a warning."""
    sys.stderr.write("%s: %s: %s\n" % (PROGRAM, kind, text))
    sys.stderr.flush()


def fail(error):
    """Says what is wrong, and returns the exit code."""
    tell("error", error)
    return 1


def _run(options):
    """All files, then what is told of them. Returns the exit code."""
    from seismichorizons import batch, interrupt, record, report
    from seismichorizons.stage import HorizonError

    page = getattr(options, "report", None)
    with_pictures = not options.no_pictures
    run = record.Record(tell, bool(page or options.json), report.make_album(with_pictures) if page else None)
    try:
        if page:
            report.check(page)
        batch.run(options.inputs, options.output_folder, make_settings(options), with_pictures, run, not options.json)
        interrupt.check()
        if page:
            report.write(run.as_values(), page, run.album)
    except (HorizonError, OSError) as error:
        run.fail(error)
    if options.json:
        try:
            batch.print_lines([run.as_json()])
        except HorizonError as error:
            run.fail(error)
    return 0 if run.is_done() else 1


def main(arguments):
    parser = make_parser()
    options = parser.parse_args(arguments)
    for word in arguments:
        is_text = word == word.encode(errors="replace").decode()
        if not is_text and pathlib.Path(word) not in options.inputs:  # what is wrong with files is told one by one
            parser.error("%s is not in UTF-8" % ascii(word))
    if _given(options, error="largest_error", number="triangles") and (options.elaborate or options.skip_rough):
        parser.error("--largest-error or --triangles takes the place of --elaborate and --skip-rough")
    try:
        from seismichorizons import interrupt
        from seismichorizons.stage import set_threads
    except ImportError as error:
        return fail("the Python package seismichorizons can not be loaded; is its folder in PYTHONPATH? (%s)" % error)
    interrupt.listen()
    set_threads(options.threads)
    return _run(options)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
