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

IS_COMMAND = __name__ in ("__main__", "seismichorizons.horizon_mesh")
PROGRAM = pathlib.Path(sys.argv[0]).stem if IS_COMMAND else "horizon_mesh"
Z_SOURCES, VERTICAL_DIRECTIONS = ("VerticalIndex", "RealZ"), ("Down", "Up")
REPRESENTATIVES, GROWTH_STRATEGIES = ("Barycentre", "NearestPoint"), ("Distance", "Clockwise")
DISTANCE_UNITS = ("Lattice", "World")
HEIGHT_UNITS = ("ms", "s", "m", "ft")
FORMATS = ("vtp", "ts", "stl", "ply", "obj", "dxf", "irap", "gri", "zmap", "tif", "dat", "vsm", "msh", "inp", "disv")
DUPLICATE_POLICIES = ("StrongestAmplitude", "Topmost", "Lowest", "Mean", "Sheets")
JOININGS, POLARITIES = ("BestFirst", "Continuous", "Components"), ("Both", "Positive", "Negative")
STRAY_PICKS, GRIDDING = ("Stop", "LeaveOut"), ("Plate", "Nearest")
CROSSINGS = ("Mean", "UpperWins", "LowerWins", "Stop")
NOT_GIVEN = argparse.SUPPRESS
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


class _Height(float):
    """A number that is not negative, from a text with its unit behind it; without one it counts vertical indices."""

    def __new__(cls, text):
        number, unit = re.fullmatch(r"\s*(.*?)\s*(%s|)\s*" % "|".join(HEIGHT_UNITS), text).groups()
        try:
            height = super().__new__(cls, number)
        except ValueError:
            height = super().__new__(cls, "nan")
        if not 0.0 <= height < float("inf"):
            raise argparse.ArgumentTypeError("%s, expected a number of at least 0, with or without a unit (%s), such as 2ms" % (
                text, ", ".join(HEIGHT_UNITS)))
        height.unit = unit
        return height

    def __str__(self):
        return "%g%s" % (self, self.unit)


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
        prog=pathlib.Path(sys.argv[0]).name if IS_COMMAND else PROGRAM + ".py",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
        description="Reads files of seismic horizons (sparse voxels, text picks of OpendTect, Petrel, OpenWorks, IESX and the "
        "like, grids as IRAP, ZMAP+, CPS-3, EarthVision, Surfer, GXF and GeoTIFF; by their content) or finds the strongest "
        "ones in seismic cubes (SEG-Y), and makes a mesh of few triangles of each, within the largest error, holes open. "
        "Writes one mesh per horizon and one picture per file, and prints what files were taken for, and a table. Files that "
        "already exist are replaced.",
        epilog="Results are named after their file and horizon: x_horizon_1.vtp or x_Top.vtp, x.png and x_error.csv for "
        "x.vsm or x.dat; x_dat.png where there is x.map beside it; a_x.png for a/x.vsm and b_x.png for b/x.vsm. Results of "
        "a file appear all together, or not at all. Distances are in lattice units: 1 is one column step sideways and one "
        "vertical index up or down. Heights (E, T of --despike and --cut-faults) are vertical indices, or have a unit: 2ms, "
        "0.002s, 5m, 16ft. The exit code is 0 when all is done, and 1 when a file, or the report, could not be done, or the "
        "command line is wrong; other files are done all the same. After Ctrl-C it is 130, after the signal TERM 143.")
    parser.add_argument("inputs", nargs="+", metavar="INPUT", type=pathlib.Path, help="files of horizons, or folders of them")
    parser.add_argument("--output-folder", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER",
                        help="where the results go; made when it is missing")
    parser.add_argument("--formats", nargs="+", choices=FORMATS, default=["vtp"],
                        help="what results are written as: meshes for VTK, GOCAD TSurf, STL, PLY, OBJ "
                        "and DXF; grids of the meshes, IRAP text and binary, ZMAP+ and GeoTIFF; points of the horizons "
                        "as picks (dat) and sparse voxels (vsm); with --layers cells for Gmsh (msh), Abaqus (inp) and MODFLOW "
                        "(disv); put -- between them and files that follow")
    _add_reader_options(parser.add_argument_group("reading"))
    _add_cube_options(parser.add_argument_group("seismic cubes"))
    _add_preparation_options(parser.add_argument_group("before meshes are made", "horizons are read as a whole then"))
    _add_mesh_options(parser.add_argument_group("meshes"))
    parser.layers = _add_layer_options(parser.add_argument_group("volumes"))
    parser.stages = parser.add_argument_group("stages of the thesis", "with --stages")
    _add_stage_options(parser.stages)
    _add_error_options(parser.add_argument_group("error"))
    _add_telling_options(parser.add_argument_group("telling"))
    _add_running_options(parser.add_argument_group("running"))
    return parser


def _add_telling_options(group):
    group.add_argument("--report", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE.html",
                       help="write an HTML report of the run: input, figures, pictures, interactive meshes, and the "
                       "command that repeats it; also measures the error, except of horizons larger than memory")
    group.add_argument("--json", action="store_true",
                       help="print one JSON object with all figures in place of the tables, for programs; "
                       "Documentation/Report.md tells of its keys")


def _add_running_options(running):
    running.add_argument("--no-pictures", action="store_true", help="write no pictures; without an X server there are none")
    running.add_argument("--leave-out-invalid", action="store_true",
                         help="leave out horizons that cannot be processed, with a warning, and do the others of "
                         "their file; otherwise such a file is not done")
    running.add_argument("--memory", type=_memory, metavar="SIZE",
                         help="as much memory as may be used, as 2G or 800M: of sparse voxel files, horizons are read as "
                         "many at a time as fit, and within a largest error one that does not fit alone is meshed in "
                         "windows of rows and joined; other files are read whole, which takes up to 80 bytes a point, "
                         "and refused where they do not fit then (default: three quarters of what the machine has left, where a file "
                         "may be larger)")
    running.add_argument("--threads", type=_number_at_least(int, 0), default=0, metavar="N",
                         help="number of threads; 0 uses all processors")


def _add_reader_options(group):
    group.add_argument("--horizons", nargs="+", type=_horizon, metavar="NAME", default=NOT_GIVEN,
                       help="only these horizons, by their names, or by the IDs of sparse voxel files (default: all); "
                       "put -- between them and files that follow")
    group.add_argument("--vertical-step", type=_vertical_step, default=NOT_GIVEN, metavar="Z",
                       help="length along world z from one vertical index to the next (default: 1 for sparse voxel "
                       "files, where a negative one turns the vertical direction around; for others one that suits "
                       "the data)")
    group.add_argument("--vertical-direction", choices=VERTICAL_DIRECTIONS, default=NOT_GIVEN,
                       help="where vertical indices and z of the file grow to: time and depth do so downwards (default: Up "
                       "for GeoTIFF and Esri ASCII, unless they say otherwise, and where no z is positive; else Down)")
    group.add_argument("--vertical-unit", choices=HEIGHT_UNITS, default=NOT_GIVEN, help="the unit of z (default: what the file says)")
    group.add_argument("--coordinate-system", default=NOT_GIVEN, metavar="NAME",
                       help="that of x and y, as EPSG:23031, for formats that have one (default: what the file says)")
    group.add_argument("--elevation", dest="z_from", choices=Z_SOURCES, default=NOT_GIVEN, help=argparse.SUPPRESS)  # of 0.2
    group.add_argument("--z-from", choices=Z_SOURCES, default=NOT_GIVEN,
                       help="what world z of sparse voxels is made from (default: VerticalIndex)")
    group.add_argument("--duplicate-policy", choices=DUPLICATE_POLICIES, default=NOT_GIVEN,
                       help="which of several points in a column stays, or their mean, or all as sheets (default: StrongestAmplitude)")
    group.add_argument("--columns", default=NOT_GIVEN, metavar="LIST",
                       help='what the columns of a text file hold, as "X,Y,-,Z,My attribute" or "Inline,Crossline,Z" '
                       "(default: what its header says, or its values are like)")
    group.add_argument("--null-values", default=NOT_GIVEN, metavar="LIST",
                       help='what stands for no value in a text file, besides 1e30 and words as nan (default: "-999.25 '
                       '-99999 9999900")')
    group.add_argument("--header-lines", type=_number_at_least(int, 0), default=NOT_GIVEN, metavar="N",
                       help="how many lines at the beginning of a text file are left out, whatever is in them (default: 0)")
    group.add_argument("--stray-picks", choices=STRAY_PICKS, default=NOT_GIVEN,
                       help="picks off the lattice, or far from all others: refuse the file, or leave out up to a tenth of "
                       "them with a warning (default: Stop)")
    group.add_argument("--lattice-tolerance", type=_number_at_least(float, 0.0, more=True), default=NOT_GIVEN,
                       metavar="T", help="how far picks may be off their columns, as a part of a step (default: 0.1)")
    group.add_argument("--gridding", choices=GRIDDING, default=NOT_GIVEN,
                       help="grids picks off any lattice, by a plate or the nearest pick, on --column-step and --row-step")
    group.add_argument("--gridding-radius", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="R",
                       help="columns farther from all picks stay empty (default: those outside their convex hull do)")
    group.add_argument("--gridding-smoothing", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="S",
                       help="how much a plate may differ from picks (default: 0.01)")
    group.add_argument("--corners", nargs=12, type=float, default=NOT_GIVEN, metavar="N",
                       help="three points of the survey, each as inline, crossline, x and y, for line numbers alone")
    group.add_argument("--origin", nargs=3, type=float, default=NOT_GIVEN, metavar=("X", "Y", "Z"),
                       help="world position of the first voxel (default: 0 0 0) or, with z 0, column of picks (default: found)")
    group.add_argument("--column-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"),
                       help="world vector from a column to the next (default: 1 0; for picks found from them)")
    group.add_argument("--row-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"),
                       help="world vector from a row to the next (default: 0 1; for picks found from them)")


def _add_cube_options(group):
    group.add_argument("--surfaces", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N",
                       help="how many surfaces of a cube become meshes, the strongest ones (default: 20)")
    group.add_argument("--smallest-surface", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N",
                       help="surfaces of fewer picks are left out (default: a twentieth of the traces, 10 to 100)")
    group.add_argument("--picks", default=NOT_GIVEN, metavar="FILE",
                       help="the horizons that picks of a file ask for, in place of all: some picks of each, by name")
    group.add_argument("--limits", nargs="+", default=NOT_GIVEN, metavar="FILE",
                       help="search between two older horizons, or on one side of one; put -- before files that follow")
    group.add_argument("--limit-side", choices=("Below", "Above"), default=NOT_GIVEN,
                       help="the side of a single limit that is searched (default: Below)")
    for lines in ("inlines", "crosslines"):
        group.add_argument("--" + lines, nargs=2, type=_line_number, default=NOT_GIVEN, metavar=("FIRST", "LAST"),
                           help="only these %s, by their numbers (default: all)" % lines)
    group.add_argument("--polarity", choices=POLARITIES, default=NOT_GIVEN,
                       help="the sign of the amplitudes of reflections that are taken (default: Both)")
    group.add_argument("--joining", choices=JOININGS, default=NOT_GIVEN,
                       help="picks become surfaces: most alike first, whole events, or what touches (default: BestFirst)")
    group.add_argument("--amplitude-percentile", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="P",
                       help="percent of reflections that are too weak (default: 25)")


def _add_preparation_options(group):
    group.add_argument("--despike", type=_Height, default=NOT_GIVEN, metavar="T",
                       help="remove points more than T off the surface around them; 0 finds T by the noise (default: none)")
    group.add_argument("--cut-faults", type=_Height, default=NOT_GIVEN, metavar="T",
                       help="find faults that throw by T or more; 0 finds T by the noise (default: none)")
    lines = group.add_mutually_exclusive_group()
    lines.add_argument("--fault-lines", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE",
                       help="cut along the fault traces of a file, and leave out what is inside its fault polygons")
    lines.add_argument("--fault-sticks", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE",
                       help="cut where surfaces between the fault sticks of a file pass, and write these surfaces")
    group.add_argument("--close-faults", action="store_true",
                       help="close the mesh at these faults by triangles, which have 1 in the array Fault")
    group.add_argument("--fill-holes", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N",
                       help="fill holes of at most N columns with smooth surfaces (default: none)")


def _add_mesh_options(group):
    target = group.add_mutually_exclusive_group()
    target.add_argument("--largest-error", type=_Height, default=NOT_GIVEN, metavar="E",
                        help="how far a point may be from the mesh, vertically; outlines may move by as much sideways, in "
                        "columns (default: six times the noise of each horizon)")
    target.add_argument("--triangles", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N",
                        help="at most N triangles in each mesh, as near to its horizon as it then can be")
    target.add_argument("--stages", action="store_true",
                        help="by the stages of the thesis, from exterior boundary to triangulation")
    group.add_argument("--radius", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="K",
                       help="the longest step of the outline between two points, in columns: narrower gaps are "
                       "bridged (default: chosen from the points; 1 with --stages)")
    group.add_argument("--growth-strategy", choices=GROWTH_STRATEGIES, default=GROWTH_STRATEGIES[1],
                       help="how an outline of a radius above 1 grows")
    group.add_argument("--minimum-patch-size", type=_number_at_least(int, 1), default=1, metavar="N",
                       help="patches with fewer points are left out")
    group.add_argument("--smallest-hole-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N",
                       help="holes of fewer columns are closed (default: chosen; 1 with --stages)")
    group.add_argument("--outline-tolerance", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="how far outlines may move, in columns (default: the error, up to 2 if no --triangles; 0 with --stages)")
    group.add_argument("--distance-threshold", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="how far outlines may move up or down (default: the error; 0.4 with --stages)")


def _add_layer_options(group):
    group.add_argument("--layers", action="store_true", default=NOT_GIVEN, help="make closed volumes between the horizons of a "
                       "file, or of files of one each, too, within the largest error: cells (.vtu), a body for each in formats of meshes, a table (.csv)")
    return (group.add_argument("--crossings", nargs="+", choices=CROSSINGS, default=NOT_GIVEN, help="what is done where horizons "
                               "cross, or a word for each layer from the uppermost on; put -- before files (default: Mean)"),
            group.add_argument("--order", choices=("ByHeight", "AsGiven"), default=NOT_GIVEN, help="which horizon is above which "
                               "for --layers; AsGiven: as --horizons, the file or the files list them, the uppermost first"),
            group.add_argument("--missing", choices=("Void", "Interpolate", "Follow"), default=NOT_GIVEN, help="where a horizon has no "
                               "points: no layers; its holes and gaps closed; absent ones follow another one, too (default: Follow)"))


def _add_stage_options(group):
    group.add_argument("--hole-boundaries", action="store_true", default=NOT_GIVEN,
                       help="give holes an outline of their own, so that they stay open in the mesh")
    group.add_argument("--fewest-outline-points", action="store_true", default=NOT_GIVEN,
                       help="give outlines the fewest points within the outline tolerance and the distance threshold")
    group.add_argument("--bound-deviation", action="store_true", default=NOT_GIVEN,
                       help="keep dropped outline points within the distance threshold of the outline")
    group.add_argument("--cell-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="S",
                       help="side of the cells that the rough simplification merges; lattice units (default: 3)")
    group.add_argument("--skip-rough", action="store_true", default=NOT_GIVEN,
                       help="leave out the rough simplification: keep every point inside the outline")
    group.add_argument("--elaborate", action="store_true", default=NOT_GIVEN,
                       help="then simplify by curvature, too: fewer points where a horizon is flat")
    group.add_argument("--elaborate-cell-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="S",
                       help="side of the largest cells of the elaborate simplification; lattice units (default: 8)")
    group.add_argument("--flatness-threshold", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="F",
                       help="how curved its cells may be, from 0 (planes) to 1/3 (anything; default: 0.12)")
    group.add_argument("--representative", choices=REPRESENTATIVES, default=NOT_GIVEN,
                       help="the mean of the points of a cell, or the nearest to it (default: Barycentre)")


def _add_error_options(group):
    group.add_argument("--measure-error", action="store_true",
                       help="measure how far each mesh is from the horizon at full resolution, both ways: columns of the "
                       "table (in lattice units), arrays of the meshes, and all figures as a .csv file for each input")
    group.add_argument("--distance-unit", choices=DISTANCE_UNITS, default=DISTANCE_UNITS[0],
                       help="the unit of the arrays; the .csv file has both")
    group.add_argument("--samples-per-point", type=_number_at_least(float, 0.01), default=2.0, metavar="N",
                       help="places on each surface for each point of the horizon")


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
    from seismichorizons.options import make_settings
    from seismichorizons.stage import HorizonError, heard_by

    page = getattr(options, "report", None)
    with_pictures = not options.no_pictures and batch.has_display()
    run = record.Record(tell, bool(page or options.json), report.make_album(with_pictures) if page else None)
    if not with_pictures and not options.no_pictures:
        run.warn("no pictures, as there is no X server (xvfb-run starts one)")
    try:
        if page:
            report.check(page)
        with heard_by(run.warn):
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


def main(arguments=None):
    arguments = sys.argv[1:] if arguments is None else arguments
    parser = make_parser()
    options = parser.parse_args(arguments)
    for action in parser.stages._group_actions:
        if hasattr(options, action.dest) and not options.stages:
            parser.error("%s is an option of --stages" % action.option_strings[0])
    of_layers = [action.option_strings[0] for action in parser.layers if hasattr(options, action.dest)] + [
        form for form in options.formats if form in ("msh", "inp", "disv")]
    if of_layers and not hasattr(options, "layers"):
        parser.error("%s requires --layers" % of_layers[0])
    for word in arguments:
        is_text = word == word.encode(errors="replace").decode()
        if not is_text and pathlib.Path(word) not in options.inputs:  # what is wrong with files is told one by one
            parser.error("%s is not in UTF-8" % ascii(word))
    try:
        from seismichorizons import interrupt
        from seismichorizons.stage import set_threads
    except ImportError as error:
        return fail("the Python package seismichorizons cannot be loaded; is its folder in PYTHONPATH? (%s)" % error)
    interrupt.listen()
    set_threads(options.threads)
    return _run(options)


if __name__ == "__main__":
    sys.exit(main())
