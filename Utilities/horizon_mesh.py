#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Turns sparse voxel files of seismic horizons into triangle meshes, with a table and a picture of every stage.

Runs in pvbatch, in pvpython and in the Python of the system, as long as the package seismichorizons is in PYTHONPATH.
"""

import argparse
import os
import pathlib
import sys
import tempfile
import time

PROGRAM = "horizon_mesh"
LONG_WORK = 1.0  # seconds after which a stage starts to report its progress
PICTURE_ROWS = 8  # horizons in one picture, at most
ELEVATIONS = ("VerticalIndex", "RealZ")
REPRESENTATIVES = ("Barycentre", "NearestPoint")
GROWTH_STRATEGIES = ("Distance", "Clockwise")
DISTANCE_UNITS = ("Lattice", "World")
DUPLICATE_POLICIES = ("StrongestAmplitude", "Topmost", "Lowest")


class HorizonMeshError(Exception):
    """What the user should read: one line."""


# ---- Command line ---------------------------------------------------------------------------------------------------
class _Parser(argparse.ArgumentParser):
    """Refuses a wrong command line in the same form as everything else."""

    def error(self, message):
        raise HorizonMeshError("%s (see --help)" % message)


def _number_at_least(convert, least, more=False):
    """A converter of argparse for numbers that are not smaller than `least` (or, with `more`, larger than it)."""

    def check(text):
        value = convert(text)
        if not (value > least if more else value >= least) or value == float("inf"):
            raise ValueError(text)
        return value

    check.__name__ = "%s %s %g:" % ("integer" if convert is int else "number", ">" if more else ">=", least)
    return check


def _vertical_step(text):
    value = float(text)
    if value == 0.0 or value != value or abs(value) == float("inf"):
        raise ValueError(text)
    return value


_vertical_step.__name__ = "number other than 0:"


def make_parser():
    parser = _Parser(
        prog=PROGRAM + ".py",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
        description="Reads sparse voxel files (.vsm), and turns each horizon in them into a triangle mesh: exterior "
        "boundary, boundary simplification, rough and (on request) elaborate simplification, triangulation. Writes one .vtp file per horizon and "
        "one picture per file, and prints a table; on request, measures the error. Files that already exist are replaced.",
        epilog="Distances are in lattice units: 1 is one column step sideways and one vertical index up or down. The "
        "exit code is 1 when a file could not be done; the other files are done all the same.")
    parser.add_argument("inputs", nargs="+", metavar="INPUT", type=pathlib.Path,
                        help=".vsm files, or folders of them")
    parser.add_argument("--output-folder", type=pathlib.Path, default=pathlib.Path("."), metavar="FOLDER",
                        help="where the results go; made when it is missing")
    _add_reader_options(parser.add_argument_group("reading"))
    _add_stage_options(parser.add_argument_group("stages"))
    _add_error_options(parser.add_argument_group("error"))
    running = parser.add_argument_group("running")
    running.add_argument("--no-pictures", action="store_true", help="write no pictures (then no X server is needed)")
    running.add_argument("--threads", type=_number_at_least(int, 0), default=0, metavar="N",
                         help="number of threads; 0 uses all processors")
    return parser


def _add_reader_options(group):
    group.add_argument("--horizons", nargs="+", type=int, metavar="ID", help="only these horizons (default: all)",
                       default=argparse.SUPPRESS)
    group.add_argument("--elevation", choices=ELEVATIONS, default=ELEVATIONS[0],
                       help="what the world z of a point is made from")
    group.add_argument("--duplicate-policy", choices=DUPLICATE_POLICIES, default=DUPLICATE_POLICIES[0],
                       help="which voxel stays where a horizon has several in a column")
    group.add_argument("--origin", nargs=3, type=float, default=[0.0, 0.0, 0.0], metavar=("X", "Y", "Z"),
                       help="world position of the first voxel of the cube")
    group.add_argument("--column-step", nargs=2, type=float, default=[1.0, 0.0], metavar=("X", "Y"),
                       help="world vector from a column to the next")
    group.add_argument("--row-step", nargs=2, type=float, default=[0.0, 1.0], metavar=("X", "Y"),
                       help="world vector from a row to the next")
    group.add_argument("--vertical-step", type=_vertical_step, default=1.0, metavar="Z",
                       help="world z from one vertical index to the next; may be negative, but not 0")


def _add_stage_options(group):
    group.add_argument("--radius", type=_number_at_least(int, 1), default=1, metavar="K",
                       help="how far the outline may reach from one point to the next, and so how wide a gap it closes; "
                       "lattice units")
    group.add_argument("--growth-strategy", choices=GROWTH_STRATEGIES, default=GROWTH_STRATEGIES[1],
                       help="how an outline of a radius above 1 grows")
    group.add_argument("--minimum-patch-size", type=_number_at_least(int, 1), default=1, metavar="N",
                       help="patches with fewer points are left out")
    group.add_argument("--hole-boundaries", action="store_true",
                       help="give holes an outline of their own, so that they stay open in the mesh")
    group.add_argument("--smallest-hole-size", type=_number_at_least(int, 1), default=1, metavar="N",
                       help="holes of fewer columns are closed all the same")
    group.add_argument("--outline-tolerance", type=_number_at_least(float, 0.0), default=0.0, metavar="T",
                       help="how far the outline may move on the map when its corners are dropped; lattice units")
    group.add_argument("--bound-deviation", action="store_true",
                       help="keep every dropped outline point within the distance threshold of the new outline")
    group.add_argument("--distance-threshold", type=_number_at_least(float, 0.0), default=0.4, metavar="T",
                       help="an outline point closer than this to the line through its neighbours is dropped; "
                       "lattice units")
    group.add_argument("--cell-size", type=_number_at_least(int, 1), default=3, metavar="S",
                       help="side of the cells that the rough simplification merges; lattice units")
    group.add_argument("--skip-rough", action="store_true",
                       help="leave out the rough simplification: keep every point inside the outline")
    group.add_argument("--elaborate", action="store_true",
                       help="then simplify by curvature, too: fewer points where a horizon is flat")
    group.add_argument("--elaborate-cell-size", type=_number_at_least(int, 1), default=8, metavar="S",
                       help="side of the largest cells of the elaborate simplification; lattice units")
    group.add_argument("--flatness-threshold", type=_number_at_least(float, 0.0), default=0.12, metavar="F",
                       help="how curved a cell of the elaborate simplification may be, from 0 (only a plane is flat) to "
                       "1/3 (everything is)")
    group.add_argument("--representative", choices=REPRESENTATIVES, default=REPRESENTATIVES[0],
                       help="what stands for the points of a cell: their mean, or the one of them nearest to it")


def _add_error_options(group):
    group.add_argument("--measure-error", action="store_true",
                       help="measure how far each mesh is from the horizon at full resolution, both ways: adds columns "
                       "to the table (in lattice units), the arrays Distance and VerticalDistance to the meshes, and "
                       "writes all figures to a .csv file for each input")
    group.add_argument("--distance-unit", choices=DISTANCE_UNITS, default=DISTANCE_UNITS[0],
                       help="the unit of the arrays; the .csv file has both")
    group.add_argument("--samples-per-point", type=_number_at_least(float, 0.01), default=2.0, metavar="N",
                       help="how densely the faces are sampled: places on each surface for each point of the horizon")


# ---- The stages -----------------------------------------------------------------------------------------------------
class Stage:
    """Runs one VTK algorithm: collects its errors, reports its progress when it takes long, and takes its time."""

    def __init__(self, algorithm, label):
        from vtkmodules.util.misc import calldata_type
        from vtkmodules.util.vtkConstants import VTK_STRING

        self.algorithm = algorithm
        self.label = label
        self.seconds = 0.0
        self.errors = []
        self._last_report = time.monotonic()
        self._reported = False

        @calldata_type(VTK_STRING)
        def on_error(_caller, _event, message):
            self.errors.append(message)

        # Only the algorithm says what is wrong; its executive repeats that something is.
        algorithm.AddObserver("ErrorEvent", on_error)
        algorithm.GetExecutive().AddObserver("ErrorEvent", on_error)
        algorithm.AddObserver("ProgressEvent", self._on_progress)

    def run(self):
        start = time.monotonic()
        self._last_report = start
        self.algorithm.Update()
        self.seconds = time.monotonic() - start
        if self._reported and sys.stderr.isatty():
            sys.stderr.write("\n")
        self.check()
        return self.algorithm.GetOutputDataObject(0)

    def check(self):
        if self.errors:
            raise HorizonMeshError(_one_line(self.errors[0]))

    def _on_progress(self, _caller, _event):
        now = time.monotonic()
        if now - self._last_report < LONG_WORK:
            return
        self._last_report = now
        self._reported = True
        # A terminal has one line that changes, a log file has one line per report.
        form = "\r%s: %3.0f %%" if sys.stderr.isatty() else "%s: %3.0f %%\n"
        sys.stderr.write(form % (self.label, 100.0 * self.algorithm.GetProgress()))
        sys.stderr.flush()


def _one_line(message):
    """The text of a VTK error without the place in the source that it comes from."""
    _, _, text = message.partition("): ")
    return " ".join((text or message).split())


def read(path, options):
    """Reads a file and returns its horizons as a list of (ID, polydata), and the time it took."""
    import seismichorizons as sh

    reader = sh.vtkVerneySparseMatrixReader()
    stage = Stage(reader, "%s: reading" % path.name)
    reader.SetFileName(str(path))
    reader.SetElevation(ELEVATIONS.index(options.elevation))
    reader.SetDuplicatePolicy(DUPLICATE_POLICIES.index(options.duplicate_policy))
    reader.SetOrigin(options.origin)
    reader.SetColumnStep(options.column_step)
    reader.SetRowStep(options.row_step)
    reader.SetVerticalStep(options.vertical_step)
    select(stage, options)
    output = stage.run()
    horizons = []
    for block in range(output.GetNumberOfPartitionedDataSets()):
        name = output.GetMetaData(block).Get(output.NAME())
        horizon = output.GetPartition(block, 0)
        if horizon is not None and horizon.GetNumberOfPoints():
            horizons.append((int(name.split()[-1]), horizon))
    return horizons, stage.seconds


def select(stage, options):
    """Leaves only the horizons switched on that the user asked for."""
    wanted = getattr(options, "horizons", None)
    if wanted is None:
        return
    reader = stage.algorithm
    reader.UpdateInformation()
    stage.check()
    known = [reader.GetHorizonName(i) for i in range(reader.GetNumberOfHorizons())]
    reader.DisableAllHorizons()
    for horizon in wanted:
        name = "Horizon %d" % horizon
        if name not in known:
            raise HorizonMeshError("%s: there is no horizon %d; the file has %s" % (
                stage.label.rpartition(":")[0], horizon, ", ".join(k.split()[-1] for k in known) or "none"))
        reader.SetHorizonStatus(name, 1)


def stages(options):
    """The stages in their order, as (short name, algorithm)."""
    import seismichorizons as sh

    boundary = sh.vtkHorizonExteriorBoundary()
    boundary.SetRadius(options.radius)
    boundary.SetGrowthStrategy(GROWTH_STRATEGIES.index(options.growth_strategy))
    boundary.SetMinimumPatchSize(options.minimum_patch_size)
    boundary.SetHoleBoundaries(options.hole_boundaries)
    boundary.SetSmallestHoleSize(options.smallest_hole_size)
    simplified = sh.vtkHorizonBoundarySimplification()
    simplified.SetOutlineTolerance(options.outline_tolerance)
    simplified.SetBoundDeviation(options.bound_deviation)
    simplified.SetDistanceThreshold(options.distance_threshold)
    rough = sh.vtkHorizonRoughSimplification()
    rough.SetCellSize(options.cell_size)
    elaborate = sh.vtkHorizonElaborateSimplification()
    elaborate.SetCellSize(options.elaborate_cell_size)
    elaborate.SetFlatnessThreshold(options.flatness_threshold)
    for algorithm in (rough, elaborate):
        algorithm.SetRepresentative(REPRESENTATIVES.index(options.representative))
    chain = [("boundary", boundary), ("simplified", simplified)]
    if not options.skip_rough:
        chain.append(("rough", rough))
    if options.elaborate:
        chain.append(("elaborate", elaborate))
    chain.append(("mesh", sh.vtkHorizonTriangulation()))
    return chain


class HorizonResult:
    """All stages of one horizon: the data by stage name, and the seconds each took."""

    def __init__(self, horizon_id, points):
        self.id = horizon_id
        self.data = {"points": points}
        self.seconds = {}
        self.figures = None  # of the error, as a table

    def run(self, label, options):
        self._run_stages(label, options)
        if options.measure_error:
            self._measure(label, options)

    def _measure(self, label, options):
        """The reference is the horizon within its outlines, as they were before they were simplified."""
        import seismichorizons as sh

        meter = sh.vtkHorizonSurfaceDistance()
        meter.SetDistanceUnit(DISTANCE_UNITS.index(options.distance_unit))
        meter.SetSamplesPerPoint(options.samples_per_point)
        meter.SetInputDataObject(0, self.data["boundary"])
        meter.SetInputDataObject(1, self.data["mesh"])
        stage = Stage(meter, "%s: horizon %d: error" % (label, self.id))
        try:
            stage.run()
        except HorizonMeshError as error:
            raise HorizonMeshError("%s: %s" % (label, error)) from None
        self.data["mesh"] = meter.GetOutputDataObject(1)
        self.figures = meter.GetOutputDataObject(2)
        self.seconds["error"] = stage.seconds

    def _run_stages(self, label, options):
        data = self.data["points"]
        for name, algorithm in stages(options):
            stage = Stage(algorithm, "%s: horizon %d: %s" % (label, self.id, name))
            algorithm.SetInputDataObject(0, data)
            try:
                data = stage.run()
            except HorizonMeshError as error:  # names the horizon, but not the file
                raise HorizonMeshError("%s: %s" % (label, error)) from None
            self.data[name] = data
            self.seconds[name] = stage.seconds

    @property
    def thinned(self):
        """What the mesh is made from."""
        return self.data.get("elaborate", self.data.get("rough", self.data["simplified"]))


# ---- Results --------------------------------------------------------------------------------------------------------
COLUMNS = ("horizon", "points in", "loops", "loop points", "after", "points out", "triangles", "reduction",
           "boundary s", "simplify s", "rough s", "elaborate s", "mesh s")
ERROR_COLUMNS = ("largest error", "mean error", "outline error", "error s")
TWO_SIDED = 2  # the row of the figures in lattice units for both directions


def _loops(horizon):
    """Number of outlines, and of points in them (a closed line repeats its first one; a single point does not)."""
    lines = horizon.GetLines()
    points = 0
    for number in range(lines.GetNumberOfCells()):
        size = lines.GetCellSize(number)
        points += max(1, size - 1)
    return lines.GetNumberOfCells(), points


def table_row(result):
    before = result.data["points"].GetNumberOfPoints()
    after = result.data["mesh"].GetNumberOfPoints()
    loops, loop_points = _loops(result.data["boundary"])
    seconds = [result.seconds.get(name) for name in ("boundary", "simplified", "rough", "elaborate", "mesh")]
    return ("%d" % result.id, "%d" % before, "%d" % loops, "%d" % loop_points,
            "%d" % _loops(result.data["simplified"])[1], "%d" % after,
            "%d" % result.data["mesh"].GetNumberOfPolys(), "%.1f %%" % (100.0 * (before - after) / before),
            *("-" if s is None else "%.2f" % s for s in seconds), *_error_cells(result))


def _error_cells(result):
    if result.figures is None:
        return ()
    figures = [result.figures.GetValueByName(TWO_SIDED, name).ToDouble()
               for name in ("LargestDistance", "MeanDistance", "OutlineDistance")]
    return (*("%.3f" % figure for figure in figures), "%.2f" % result.seconds["error"])


def print_table(path, read_seconds, results):
    columns = COLUMNS + (ERROR_COLUMNS if results[0].figures is not None else ())
    rows = [columns] + [table_row(result) for result in results]
    widths = [max(len(row[column]) for row in rows) for column in range(len(columns))]
    print("%s: read in %.2f s" % (path.name, read_seconds))
    for number, row in enumerate(rows):
        print("  " + "  ".join(text.rjust(width) for text, width in zip(row, widths)))
        if number == 0:
            print("  " + "  ".join("-" * width for width in widths))
    sys.stdout.flush()


def write_mesh(mesh, path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputDataObject(0, mesh)
    # Not the default, which appends raw bytes: readers of VTK up to 9.2 stumble over them with a recent Expat library.
    writer.SetDataModeToBinary()
    stage = Stage(writer, "%s: writing" % path.name)
    try:
        written = writer.Write()
        stage.check()
    except HorizonMeshError as error:
        raise HorizonMeshError("cannot write %s: %s" % (path.name, error)) from None
    if not written or not path.is_file():
        raise HorizonMeshError("cannot write %s" % path.name)


def write_figures(results, path):
    """The tables of the error of all horizons as one file of comma-separated values."""
    import csv

    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        for number, result in enumerate(results):
            table = result.figures
            columns = range(table.GetNumberOfColumns())
            if number == 0:
                writer.writerow([table.GetColumnName(column) for column in columns])
            for row in range(table.GetNumberOfRows()):
                values = [table.GetValue(row, column) for column in columns]
                writer.writerow([repr(v.ToDouble()) if v.IsDouble() else v.ToString() for v in values])


def write_picture(results, path):
    from seismichorizons import pictures

    rows = [_panels(result) for result in results[:PICTURE_ROWS]]
    if len(results) > PICTURE_ROWS:
        print("  the picture shows the first %d of %d horizons" % (PICTURE_ROWS, len(results)))
    pictures.write(pictures.draw(rows), path)


def _panels(result):
    from seismichorizons.pictures import MESH, OUTLINE, POINTS, Panel

    def count(number, noun):
        return "{:,} {}{}".format(number, noun, "" if number == 1 else "s")

    points = result.data["points"]
    loops, loop_points = _loops(result.data["boundary"])
    after = _loops(result.data["simplified"])[1]
    mesh = result.data["mesh"]
    panels = [
        Panel("Horizon %d" % result.id, count(points.GetNumberOfPoints(), "point"), points, POINTS),
        Panel("Exterior boundary", "%s, %s" % (count(loops, "loop"), count(loop_points, "point")),
              result.data["boundary"], OUTLINE, points),
        Panel("Simplified boundary", count(after, "point"), result.data["simplified"], OUTLINE, points)]
    for name, title in (("rough", "Rough simplification"), ("elaborate", "Elaborate simplification")):
        if name in result.data:
            thinned = result.data[name]
            panels.append(Panel(title, count(thinned.GetNumberOfPoints(), "point"), thinned, POINTS))
    panels.append(Panel("Mesh", count(mesh.GetNumberOfPolys(), "triangle"), mesh, MESH))
    return panels


# ---- Files ----------------------------------------------------------------------------------------------------------
def find_files(inputs):
    files = []
    for path in inputs:
        if path.is_dir():
            found = sorted(path.glob("*.vsm"))
            if not found:
                raise HorizonMeshError("%s: there is no .vsm file in this folder" % path)
            files.extend(found)
        else:
            files.append(path)
    taken = {}
    for path in files:
        if path.stem in taken:
            raise HorizonMeshError("%s and %s would write the same results" % (taken[path.stem], path))
        taken[path.stem] = path
    return files


def process(path, options):
    """Does one file. Results appear in the output folder all together at the end, or not at all."""
    horizons, read_seconds = read(path, options)
    if not horizons:
        raise HorizonMeshError("%s: there is no voxel to work on" % path)
    results = []
    for horizon_id, points in horizons:
        result = HorizonResult(horizon_id, points)
        result.run(path.name, options)
        results.append(result)
    with tempfile.TemporaryDirectory(prefix=".%s-" % PROGRAM, dir=options.output_folder) as folder:
        folder = pathlib.Path(folder)
        for result in results:
            write_mesh(result.data["mesh"], folder / ("%s_horizon_%d.vtp" % (path.stem, result.id)))
        if options.measure_error:
            write_figures(results, folder / ("%s_error.csv" % path.stem))
        if not options.no_pictures:
            write_picture(results, folder / ("%s.png" % path.stem))
        for file in sorted(folder.iterdir()):
            os.replace(file, options.output_folder / file.name)
    print_table(path, read_seconds, results)


def check_packages():
    try:
        import seismichorizons  # noqa: F401
    except ImportError as error:
        raise HorizonMeshError("the Python package seismichorizons can not be loaded; is its folder in PYTHONPATH? "
                               "(%s)" % error) from None


def check_display():
    """VTK ends the program when it finds no X server: better to say so before any work is done."""
    import ctypes
    import ctypes.util

    library = ctypes.util.find_library("X11") or "libX11.so.6"
    try:
        x11 = ctypes.CDLL(library)
    except OSError:
        return
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        raise HorizonMeshError("pictures need an X server; start one with Utilities/with-xvfb.sh, or use --no-pictures")
    x11.XCloseDisplay(ctypes.c_void_p(display))


def set_threads(number):
    from vtkmodules.vtkCommonCore import vtkSMPTools

    # The default back-end of many VTK builds is the sequential one.
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(number)


def run(arguments):
    options = make_parser().parse_args(arguments)
    check_packages()
    files = find_files(options.inputs)
    if not options.no_pictures:
        check_display()
    set_threads(options.threads)
    made_folder = not options.output_folder.exists()
    options.output_folder.mkdir(parents=True, exist_ok=True)
    failures = 0
    for path in files:
        try:
            process(path, options)
        except (HorizonMeshError, OSError) as error:
            failures += 1
            report(error)
    if made_folder and not any(options.output_folder.iterdir()):
        options.output_folder.rmdir()
    return 1 if failures else 0


def report(error):
    sys.stdout.flush()
    sys.stderr.write("%s: error: %s\n" % (PROGRAM, error))
    sys.stderr.flush()


def main(arguments):
    try:
        return run(arguments)
    except (HorizonMeshError, OSError) as error:
        report(error)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
