#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns files of seismic horizons into triangle meshes, with a table and a picture of every stage.

Runs in pvbatch, pvpython and the system Python if the package seismichorizons is in PYTHONPATH. This file is the command
line; the modules of the package do the work.
"""

import os
import signal


def _end_at_once(signal_number, _frame):
    os._exit(128 + signal_number)


if __name__ == "__main__":
    # Until the work begins there is nothing to clean up, so Ctrl-C ends the program at once.
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
JOININGS, POLARITIES = ("BestFirst", "Components"), ("Both", "Positive", "Negative")
STRAY_PICKS, GRIDDING = ("Stop", "LeaveOut"), ("Plate", "Nearest")
CROSSINGS = ("Mean", "UpperWins", "LowerWins", "Stop")
NOT_GIVEN = argparse.SUPPRESS
MOST = 2**31  # exceeds the integers of the stages


class _Parser(argparse.ArgumentParser):
    """Reports a wrong command line in the same form as other errors."""

    def error(self, message):
        self.exit(fail("%s (see --help)" % message))


def _number_at_least(convert, least, more=False):
    """Returns an argparse converter for numbers that are at least `least` or, with `more`, larger than it."""

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
    """A non-negative number from a text with a unit; without a unit it is in vertical indices."""

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
    """Converts texts such as "2G", "1.5 GB" or "800M" to bytes."""
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


class _HelpFormatter(argparse.ArgumentDefaultsHelpFormatter):
    def _get_help_string(self, action):
        has_default = action.nargs == 0 or "(default:" in action.help
        return action.help if has_default else super()._get_help_string(action)


def make_parser():
    parser = _Parser(
        prog=pathlib.Path(sys.argv[0]).name if IS_COMMAND else PROGRAM + ".py",
        formatter_class=_HelpFormatter,
        description="Makes a mesh of few triangles, within a largest error, of each horizon in files of sparse voxels, picks "
        "(OpendTect, Petrel, OpenWorks, IESX and others) or grids (IRAP, ZMAP+, CPS-3, EarthVision, Surfer, GXF, GeoTIFF "
        "and others), which are recognized by their content, and of the strongest horizons in seismic cubes (SEG-Y). Writes "
        "a mesh per horizon and a picture per file, and prints how each file was read, and a table. Existing files are "
        "replaced.",
        epilog="Results are named after their file and horizon: x_horizon_1.vtp or x_Top.vtp, x.png and x_error.csv for "
        "x.vsm or x.dat; x_dat.png if there is also x.map; a_x.png for a/x.vsm and b_x.png for b/x.vsm. The results of a file "
        "appear all together or not at all. Distances are in lattice units: 1 is one column horizontally and one vertical "
        "index vertically. Heights (E, T of --despike and --cut-faults) are in vertical indices, or have a unit: 2ms, 0.002s, "
        "5m, 16ft. The exit code is 0 on success, and 1 if a file or the report fails or the command line is wrong; other "
        "files are still processed. It is 130 after Ctrl-C, and 143 after the signal TERM.")
    parser.add_argument("inputs", nargs="+", metavar="INPUT", type=pathlib.Path, help="files of horizons or seismic cubes, or "
                        "folders of them")
    parser.add_argument("--output-folder", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER", help="folder of "
                        "the results; created if missing")
    parser.add_argument("--formats", nargs="+", choices=FORMATS, default=["vtp"], help="formats of the results: meshes for "
                        "VTK, GOCAD TSurf, STL, PLY, OBJ and DXF; grids of the meshes as IRAP text and binary, ZMAP+ and "
                        "GeoTIFF; points of the horizons as picks (dat) and sparse voxels (vsm); with --layers, cells for "
                        "Gmsh (msh), Abaqus (inp) and MODFLOW (disv); end the list with -- before files")
    _add_reader_options(parser.add_argument_group("reading"))
    _add_cube_options(parser.add_argument_group("seismic cubes"))
    _add_preparation_options(parser.add_argument_group("preparation", "horizons are then read whole"))
    _add_mesh_options(parser.add_argument_group("meshes"))
    parser.layers = _add_layer_options(parser.add_argument_group("volumes"))
    parser.stages = parser.add_argument_group("stages of the thesis", "with --stages")
    _add_stage_options(parser.stages)
    _add_error_options(parser.add_argument_group("error"))
    _add_report_options(parser.add_argument_group("report"))
    _add_running_options(parser.add_argument_group("running"))
    return parser


def _add_report_options(group):
    group.add_argument("--report", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE.html", help="write an HTML report with "
                       "input, figures, pictures, interactive meshes, and the command that repeats the run; also measures the "
                       "error, except for horizons larger than memory")
    group.add_argument("--json", action="store_true", help="print all figures as one JSON object instead of the tables; "
                       "Documentation/Report.md lists its keys")


def _add_running_options(running):
    running.add_argument("--no-pictures", action="store_true", help="write no pictures; without an X server there are none")
    running.add_argument("--leave-out-invalid", action="store_true", help="skip horizons that cannot be processed, with a "
                         "warning; by default, such a file has no results")
    running.add_argument("--memory", type=_memory, metavar="SIZE", help="memory limit, such as 2G or 800M. Horizons of sparse "
                         "voxel files are read in groups that fit; one that does not fit is meshed in windows of rows and "
                         "joined. Other files are read whole, at up to 80 bytes per point, and refused if they do not fit "
                         "(default: three quarters of the free memory, if a file may need more)")
    running.add_argument("--threads", type=_number_at_least(int, 0), default=0, metavar="N", help="number of threads; 0 uses "
                         "all processors")


def _add_reader_options(group):
    group.add_argument("--horizons", nargs="+", type=_horizon, metavar="NAME", default=NOT_GIVEN, help="process only these "
                       "horizons, by name or, in sparse voxel files, by ID (default: all); end the list with -- before files")
    group.add_argument("--vertical-step", type=_vertical_step, default=NOT_GIVEN, metavar="Z", help="world z per vertical "
                       "index (default: 1 for sparse voxel files, where a negative step reverses the vertical direction; "
                       "otherwise found from the data)")
    group.add_argument("--vertical-direction", choices=VERTICAL_DIRECTIONS, default=NOT_GIVEN, help="direction in which "
                       "vertical indices and z of the file increase; depth and time increase downwards (default: Up for "
                       "GeoTIFF and Esri ASCII unless they state otherwise, and if no z is positive; otherwise Down)")
    group.add_argument("--vertical-unit", choices=HEIGHT_UNITS, default=NOT_GIVEN, help="unit of z (default: as in the file)")
    group.add_argument("--coordinate-system", default=NOT_GIVEN, metavar="NAME", help="coordinate system of x and y, such as "
                       "EPSG:23031, for formats that store one (default: as in the file)")
    group.add_argument("--elevation", dest="z_from", choices=Z_SOURCES, default=NOT_GIVEN, help=argparse.SUPPRESS)  # of 0.2
    group.add_argument("--z-from", choices=Z_SOURCES, default=NOT_GIVEN, help="source of world z in sparse voxel files "
                       "(default: VerticalIndex)")
    group.add_argument("--duplicate-policy", choices=DUPLICATE_POLICIES, default=NOT_GIVEN, help="point that stays if a "
                       "column has several, their mean, or one horizon per sheet (default: StrongestAmplitude)")
    group.add_argument("--columns", default=NOT_GIVEN, metavar="LIST", help='contents of the fields of a text file, such as '
                       '"X,Y,-,Z,My attribute" or "Inline,Crossline,Z" (default: from its header or its values)')
    group.add_argument("--null-values", default=NOT_GIVEN, metavar="LIST", help='values that mean no value in a text or grid file, '
                       'besides 1e30 and words such as nan (default: "-999.25 -99999 9999900")')
    group.add_argument("--header-lines", type=_number_at_least(int, 0), default=NOT_GIVEN, metavar="N", help="lines to skip "
                       "at the beginning of a text file (default: 0)")
    group.add_argument("--stray-picks", choices=STRAY_PICKS, default=NOT_GIVEN, help="for picks off the lattice or far from "
                       "the others: refuse the file, or leave out up to a tenth of them with a warning (default: Stop)")
    group.add_argument("--lattice-tolerance", type=_number_at_least(float, 0.0, more=True), default=NOT_GIVEN, metavar="T",
                       help="largest distance of picks from their columns, as a fraction of a step (default: 0.1)")
    group.add_argument("--gridding", choices=GRIDDING, default=NOT_GIVEN, help="grid scattered picks with a smooth plate or "
                       "the nearest pick, on --column-step and --row-step")
    group.add_argument("--gridding-radius", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="R", help="leave "
                       "columns empty that are farther than this from all picks (default: those outside the convex hull)")
    group.add_argument("--gridding-smoothing", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="S", help="how "
                       "much a plate may differ from the picks (default: 0.01)")
    group.add_argument("--corners", nargs=12, type=float, default=NOT_GIVEN, metavar="N", help="three points of the survey as "
                       "inline, crossline, x and y; places files that have line numbers only")
    group.add_argument("--origin", nargs=3, type=float, default=NOT_GIVEN, metavar=("X", "Y", "Z"), help="world position of "
                       "the first voxel (default: 0 0 0); for picks, with z 0, position of a column (default: found)")
    group.add_argument("--column-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"), help="world vector from a "
                       "column to the next (default: 1 0; for picks, found)")
    group.add_argument("--row-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"), help="world vector from a "
                       "row to the next (default: 0 1; for picks, found)")


def _add_cube_options(group):
    group.add_argument("--surfaces", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="number of surfaces "
                       "of a cube to mesh, strongest first (default: 20)")
    group.add_argument("--smallest-surface", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="skip "
                       "surfaces with fewer picks (default: a twentieth of the traces, 10 to 100)")
    group.add_argument("--picks", default=NOT_GIVEN, metavar="FILE", help="track only the horizons of this file of picks: "
                       "some picks for each, by name")
    group.add_argument("--limits", nargs="+", default=NOT_GIVEN, metavar="FILE", help="search between two known horizons, or "
                       "on one side of one; end the list with -- before files")
    group.add_argument("--limit-side", choices=("Below", "Above"), default=NOT_GIVEN, help="side of a single limit to search "
                       "(default: Below)")
    for lines in ("inlines", "crosslines"):
        group.add_argument("--" + lines, nargs=2, type=_line_number, default=NOT_GIVEN, metavar=("FIRST", "LAST"),
                           help="range of %s to use (default: all)" % lines)
    group.add_argument("--polarity", choices=POLARITIES, default=NOT_GIVEN, help="sign of the amplitudes to track (default: "
                       "Both)")
    group.add_argument("--joining", choices=JOININGS, default=NOT_GIVEN, help="how picks are joined to surfaces: most similar "
                       "first, whole events, or connected components (default: BestFirst)")
    group.add_argument("--amplitude-percentile", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="P",
                       help="percentage of the weakest reflections to ignore (default: 25)")


def _add_preparation_options(group):
    group.add_argument("--despike", type=_Height, default=NOT_GIVEN, metavar="T", help="remove points farther than T above or "
                       "below those around them; 0 derives T from the noise (default: none)")
    group.add_argument("--cut-faults", type=_Height, default=NOT_GIVEN, metavar="T", help="find faults with a throw of at "
                       "least T; 0 derives T from the noise (default: none)")
    lines = group.add_mutually_exclusive_group()
    lines.add_argument("--fault-lines", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE", help="cut along the fault "
                       "traces of this file, and remove points inside its fault polygons")
    lines.add_argument("--fault-sticks", type=pathlib.Path, default=NOT_GIVEN, metavar="FILE", help="cut along surfaces "
                       "through the fault sticks of this file, and write these surfaces")
    group.add_argument("--close-faults", action="store_true", help="close the mesh at these faults with triangles, which have "
                       "1 in the array Fault")
    group.add_argument("--fill-holes", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="fill holes of at "
                       "most N columns with smooth surfaces (default: none)")


def _add_mesh_options(group):
    target = group.add_mutually_exclusive_group()
    target.add_argument("--largest-error", type=_Height, default=NOT_GIVEN, metavar="E", help="largest vertical distance of a "
                        "point from the mesh (default: six times the noise of each horizon)")
    target.add_argument("--triangles", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="at most N "
                        "triangles per mesh, with the smallest error they allow")
    target.add_argument("--stages", action="store_true", help="use the stages of the thesis, from exterior boundary to "
                        "triangulation")
    group.add_argument("--radius", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="K", help="longest step of an "
                       "outline between two points, in columns; narrower breaks are bridged (default: from the points; 1 with "
                       "--stages)")
    group.add_argument("--growth-strategy", choices=GROWTH_STRATEGIES, default=NOT_GIVEN, help="how an outline "
                       "with a radius above 1 grows (default: Clockwise)")
    group.add_argument("--minimum-patch-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="leave out "
                       "patches with fewer points (default: 1)")
    group.add_argument("--smallest-hole-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="close "
                       "holes of fewer columns (default: automatic; 1 with --stages)")
    group.add_argument("--outline-tolerance", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="largest horizontal deviation of outlines, in columns (default: the error, at most 0.75 unless "
                       "--triangles is given; 0 with --stages)")
    group.add_argument("--distance-threshold", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="largest vertical deviation of outlines (default: the error; 0.4 with --stages)")


def _add_layer_options(group):
    group.add_argument("--layers", action="store_true", default=NOT_GIVEN, help="make closed volumes between the horizons of "
                       "a file, or of several files with one horizon each: cells (.vtu), one body per layer in formats of "
                       "meshes, and a table (.csv)")
    return (group.add_argument("--crossings", nargs="+", choices=CROSSINGS, default=NOT_GIVEN, help="policy where horizons "
                               "cross, or one for each layer from the top; end the list with -- before files (default: Mean)"),
            group.add_argument("--order", choices=("ByHeight", "AsGiven"), default=NOT_GIVEN, help="order of the horizons for "
                               "--layers; AsGiven: as listed by --horizons or the files, uppermost first"),
            group.add_argument("--missing", choices=("Void", "Interpolate", "Follow"), default=NOT_GIVEN, help="where a "
                               "horizon has no points: no layers; holes and gaps at faults closed; absent horizons also "
                               "follow a neighbour (default: Follow)"))


def _add_stage_options(group):
    group.add_argument("--hole-boundaries", action="store_true", default=NOT_GIVEN, help="outline holes as well, so that they "
                       "stay open in the mesh")
    group.add_argument("--fewest-outline-points", action="store_true", default=NOT_GIVEN, help="use the fewest outline points "
                       "within the outline tolerance and the distance threshold")
    group.add_argument("--bound-deviation", action="store_true", default=NOT_GIVEN, help="keep dropped outline points within "
                       "the distance threshold of the outline")
    group.add_argument("--cell-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="S", help="side of the cells "
                       "of the rough simplification, in lattice units (default: 3)")
    group.add_argument("--skip-rough", action="store_true", default=NOT_GIVEN, help="skip the rough simplification: keep "
                       "every point inside the outline")
    group.add_argument("--elaborate", action="store_true", default=NOT_GIVEN, help="also simplify by curvature: fewer points "
                       "where a horizon is flat")
    group.add_argument("--elaborate-cell-size", type=_number_at_least(int, 1), default=NOT_GIVEN, metavar="S", help="side of "
                       "the largest cells of the elaborate simplification, in lattice units (default: 8)")
    group.add_argument("--flatness-threshold", type=_number_at_least(float, 0.0), default=NOT_GIVEN, metavar="F",
                       help="largest curvature within a cell, from 0 (planes) to 1/3 (anything; default: 0.12)")
    group.add_argument("--representative", choices=REPRESENTATIVES, default=NOT_GIVEN, help="point that represents a cell: "
                       "the mean of its points, or the point nearest to it (default: Barycentre)")


def _add_error_options(group):
    group.add_argument("--measure-error", action="store_true", help="measure the distance of each mesh from the full horizon "
                       "in both directions: fields of the table (lattice units), arrays of the meshes, and a .csv file for "
                       "each input")
    group.add_argument("--distance-unit", choices=DISTANCE_UNITS, default=NOT_GIVEN, help="unit of the arrays; the "
                       ".csv file has both (default: Lattice)")
    group.add_argument("--samples-per-point", type=_number_at_least(float, 0.01), default=NOT_GIVEN, metavar="N", help="number of "
                       "samples on each surface per point of the horizon (default: 2)")


def tell(kind, text):
    """Writes an error or a warning."""
    sys.stderr.write("%s: %s: %s\n" % (PROGRAM, kind, text))
    sys.stderr.flush()


def fail(error):
    """Writes an error and returns the exit code."""
    tell("error", error)
    return 1


def _run(options):
    """Processes all files, then writes figures and report. Returns the exit code."""
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
        if not is_text and pathlib.Path(word) not in options.inputs:  # errors of files are reported one by one
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
