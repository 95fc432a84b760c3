# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of the command, in groups."""

import argparse

from .arguments import HEIGHT_UNITS, AddToList, Assignments, Height, line_number, memory, number_at_least, path, vertical_step

Z_SOURCES, VERTICAL_DIRECTIONS = ("VerticalIndex", "RealZ"), ("Down", "Up")
REPRESENTATIVES, GROWTH_STRATEGIES = ("Barycentre", "NearestPoint"), ("Distance", "Clockwise")
DISTANCE_UNITS = ("Steps", "World")
LAYER_FORMATS = ("msh", "inp", "disv")
FORMATS = ("vtp", "ts", "stl", "ply", "obj", "dxf", "irap", "gri", "zmap", "cps3", "grd", "asc", "tif", "dat", "vsm", *LAYER_FORMATS)
FAULT_FORMATS = ("dat", "csv", "pl", "gpkg")
DUPLICATE_POLICIES = ("StrongestAmplitude", "Topmost", "Lowest", "Mean", "Sheets")
JOININGS, POLARITIES = ("BestFirst", "Components"), ("Both", "Positive", "Negative")
STRAY_PICKS, GRIDDING = ("Stop", "LeaveOut"), ("Plate", "Nearest")
# Properties of a cube and of its extraction without an option of their own.
CUBE_PROPERTIES = (
    "InlineByte", "CrosslineByte", "XByte", "YByte", "SampleRange", "SampleFormat", "NumberOfSamples", "IgnoreIncompleteTrace",
    "DuplicatePolicy", "DelayPolicy", "VerticalDomain", "HorizontalUnit", "PhaseRotation", "Position", "AmplitudeThreshold", "Connectivity",
    "LargestStep", "SmallestCorrelation", "SmallestContact", "Order", "GuideTolerance", "GrowthCorrelation", "GrowthReach", "LeastConfidence", "KeepOthers")
CROSSINGS = ("Mean", "UpperWins", "LowerWins", "Stop")
NOT_GIVEN = argparse.SUPPRESS


def add_result_options(group):
    group.add_argument("-o", "--output-folder", type=path, default=".", metavar="FOLDER", help="folder of "
                       "the results; created if missing")
    group.add_argument("--formats", action=AddToList, values=FORMATS, default=["vtp"], metavar="LIST", help="formats of the "
                       "results: meshes for VTK (vtp), GOCAD (ts), stl, ply, obj and dxf; points of the horizons as grids, IRAP "
                       "text (irap) and binary (gri), ZMAP+ (zmap), CPS-3 (cps3), Surfer (grd), Esri ASCII (asc) and GeoTIFF "
                       "(tif), as picks (dat) and sparse voxels (vsm); with --layers, cells for Gmsh (msh), Abaqus (inp) and MODFLOW (disv) (default: "
                       "vtp)")
    group.add_argument("--grids-of-meshes", action="store_true", help="write grids with the heights of the meshes "
                       "instead of the points of the horizons")
    group.add_argument("--written-direction", choices=VERTICAL_DIRECTIONS, default=NOT_GIVEN, help="direction in which z of written "
                       "grids, picks, lines and GOCAD files increases; Petrel expects Up (default: as in the input; Up for GOCAD meshes)")


def add_report_options(group):
    group.add_argument("--report", type=path, default=NOT_GIVEN, metavar="FILE.html", help="write an HTML report: "
                       "input, figures, pictures, interactive meshes, and the command that repeats the run; the "
                       "error is measured, too, except for horizons larger than memory")
    printed = group.add_mutually_exclusive_group()
    printed.add_argument("--json", action="store_true", help="print all figures as one JSON object instead of the tables; "
                       "Documentation/Report.md lists its keys")
    printed.add_argument("-q", "--quiet", action="store_true", help="print errors and warnings only")


def add_running_options(running):
    running.add_argument("--no-pictures", action="store_true", help="draw no pictures; without an X server, none are "
                         "drawn")
    running.add_argument("--leave-out-invalid", action="store_true", help="skip horizons that cannot be processed, "
                         "with a warning; by default, their file has no results")
    running.add_argument("--memory", type=memory, metavar="SIZE", help="memory limit, such as 2G or 800M. Horizons "
                         "of sparse voxel files are read in groups that fit, and of a horizon that does not fit, "
                         "rows are read while it is meshed, with the same result. Other files are read whole, at up to 80 bytes per point, and "
                         "refused if they do not fit (default: three quarters of the free memory, if a file may need "
                         "more)")
    running.add_argument("--threads", type=number_at_least(int, 0), default=0, metavar="N", help="number of threads; 0 uses "
                         "all processors")
    running.add_argument("-j", "--jobs", type=number_at_least(int, 1), default=1, metavar="N", help="process N files at a "
                         "time, each with its share of the threads and of the memory")


def add_reader_options(group):
    group.add_argument("--horizons", action=AddToList, are_names=True, metavar="LIST", default=NOT_GIVEN, help="process only "
                       "these horizons, by name or, in sparse voxel files, by ID (default: all)")
    group.add_argument("--vertical-step", type=vertical_step, default=NOT_GIVEN, metavar="Z", help="world z per vertical "
                       "index (default: 1 for sparse voxel files, where a negative step reverses the vertical direction; "
                       "otherwise found from the data)")
    group.add_argument("--vertical-direction", choices=VERTICAL_DIRECTIONS, default=NOT_GIVEN, help="direction in which "
                       "vertical indices and z of the file increase; depth and time increase downwards (default: Up for "
                       "GeoTIFF and Esri ASCII unless they state otherwise, and if no z is positive; otherwise Down)")
    group.add_argument("--vertical-unit", choices=HEIGHT_UNITS, default=NOT_GIVEN, help="unit of z (default: as in the file)")
    group.add_argument("--coordinate-system", default=NOT_GIVEN, metavar="NAME", help="coordinate system of x and y, such as "
                       "EPSG:23031, for formats that store one (default: as in the file)")
    group.add_argument("--z-from", choices=Z_SOURCES, default=NOT_GIVEN, help="source of world z in sparse voxel files "
                       "(default: VerticalIndex)")
    group.add_argument("--duplicate-policy", choices=DUPLICATE_POLICIES, default=NOT_GIVEN, help="if a column has "
                       "several points: the one to keep, their mean, or one horizon per sheet (default: "
                       "StrongestAmplitude)")
    group.add_argument("--columns", default=NOT_GIVEN, metavar="LIST", help="columns of a text file, such as "
                       '"X,Y,-,Z,My attribute" or "Inline,Crossline,Z" (default: from its header or its values)')
    group.add_argument("--null-values", default=NOT_GIVEN, metavar="LIST", help="values that mark missing z in a "
                       'text or grid file, in addition to 1e30 and words such as nan (default: "-999.25 -99999 '
                       '9999900")')
    group.add_argument("--header-lines", type=number_at_least(int, 0), default=NOT_GIVEN, metavar="N", help="lines to skip "
                       "at the beginning of a text file (default: 0)")
    group.add_argument("--where", default=NOT_GIVEN, metavar="COLUMN=VALUE", help="read only the lines of a text file that have "
                       "this value in this column (default: all)")
    group.add_argument("--stray-picks", choices=STRAY_PICKS, default=NOT_GIVEN, help="for picks off the lattice or far from "
                       "the others: refuse the file, or leave out up to a tenth of them with a warning (default: Stop)")
    group.add_argument("--lattice-tolerance", type=number_at_least(float, 0.0, more=True), default=NOT_GIVEN, metavar="T",
                       help="largest distance of picks from their columns, as a fraction of a step (default: 0.1)")
    group.add_argument("--gridding", choices=GRIDDING, default=NOT_GIVEN, help="grid scattered picks with a smooth plate or "
                       "the nearest pick, on --column-step and --row-step")
    group.add_argument("--gridding-radius", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="R", help="leave "
                       "columns empty if they are farther than this from every pick (default: those outside the "
                       "convex hull)")
    group.add_argument("--gridding-smoothing", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="S", help="how "
                       "far a plate may depart from the picks (default: 0.01)")
    group.add_argument("--corners", nargs=12, type=float, default=NOT_GIVEN, metavar="N", help="inline, crossline, x "
                       "and y of three points of the survey, to locate files that have only line numbers")
    group.add_argument("--origin", nargs=3, type=float, default=NOT_GIVEN, metavar=("X", "Y", "Z"), help="world "
                       "position of the first voxel (default: 0 0 0), or for picks of any column, with z 0 (default: "
                       "found)")
    group.add_argument("--column-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"), help="world vector from a "
                       "column to the next (default: 1 0; for picks, found)")
    group.add_argument("--row-step", nargs=2, type=float, default=NOT_GIVEN, metavar=("X", "Y"), help="world vector from a "
                       "row to the next (default: 0 1; for picks, found)")


def add_cube_options(group):
    group.add_argument("--surfaces", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="number of surfaces "
                       "of a cube to mesh, strongest first (default: 20)")
    group.add_argument("--smallest-surface", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="skip "
                       "surfaces with fewer picks (default: a twentieth of the traces, 10 to 100)")
    group.add_argument("--picks", default=NOT_GIVEN, metavar="FILE", help="track only the horizons in this file, "
                       "each from a few picks")
    group.add_argument("--limits", action=AddToList, default=NOT_GIVEN, metavar="FILES", help="search only between "
                       "two known horizons, or on one side of a single one")
    group.add_argument("--limit-side", choices=("Below", "Above"), default=NOT_GIVEN, help="with a single limit, the "
                       "side to search (default: Below)")
    for lines in ("inlines", "crosslines"):
        group.add_argument("--" + lines, nargs=2, type=line_number, default=NOT_GIVEN, metavar=("FIRST", "LAST"),
                           help="range of %s to use (default: all)" % lines)
    group.add_argument("--polarity", choices=POLARITIES, default=NOT_GIVEN, help="sign of the amplitudes to track (default: "
                       "Both)")
    group.add_argument("--joining", choices=JOININGS, default=NOT_GIVEN, help="how picks are joined into surfaces: "
                       "most similar events first, or connected components (default: BestFirst)")
    group.add_argument("--cube", action=AddToList, values=Assignments(name + "=" for name in CUBE_PROPERTIES), default=NOT_GIVEN, metavar="LIST",
                       help="other properties of the cube and its extraction, by their names in ParaView, such as "
                       "InlineByte=9,CrosslineByte=21 or SampleFormat=5, DelayPolicy=Nearest, SampleRange=0:200, "
                       "KeepOthers=on")
    group.add_argument("--amplitude-percentile", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="P",
                       help="ignore reflections weaker than this percentage of samples (default: 40)")


def add_preparation_options(group):
    group.add_argument("--despike", type=Height, default=NOT_GIVEN, metavar="T", help="remove points farther than T above or "
                       "below those around them; 0 derives T from the noise (default: none)")
    group.add_argument("--cut-faults", type=Height, default=NOT_GIVEN, metavar="T", help="find faults with a throw of at "
                       "least T; 0 derives T from the noise (default: none)")
    lines = group.add_mutually_exclusive_group()
    lines.add_argument("--fault-lines", action=AddToList, default=NOT_GIVEN, metavar="FILES", help="cut along the fault "
                       "traces of these files, and remove points inside their fault polygons")
    lines.add_argument("--fault-sticks", action=AddToList, default=NOT_GIVEN, metavar="FILES", help="cut along "
                       "surfaces through the fault sticks of these files, and write these surfaces; of several "
                       "files, unnamed faults are named after their file")
    group.add_argument("--fault-formats", action=AddToList, values=FAULT_FORMATS, default=[], metavar="LIST", help="also write "
                       "the fault lines of each horizon: tables (dat, csv), GOCAD (pl) and GeoPackage (gpkg) (default: none)")
    group.add_argument("--cutoffs", action="store_true", default=NOT_GIVEN, help="find where horizons meet faults, "
                       "and write tables of throws and juxtaposed layers (csv), and cutoffs and fault polygons in "
                       "--fault-formats (default: dat)")
    group.add_argument("--fault-dip", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="D", help="dip of "
                       "faults without sticks for --cutoffs and --sealed, in degrees (default: from the gap between "
                       "picks)")
    group.add_argument("--sealed", action="store_true", default=NOT_GIVEN, help="make closed bodies of the layers "
                       "between faults, and write the model for GOCAD (ml), Gmsh (msh) and VTK (vtp), and tables "
                       "(csv)")
    group.add_argument("--fault-endings", default=NOT_GIVEN, metavar="TEXT", help="faults of --sealed that end at "
                       'another fault, as "F2 > F1; F3 > F1" (default: chosen, with a warning)')
    group.add_argument("--fault-tips", choices=("Sticks", "Through"), default=NOT_GIVEN, help="end faults of "
                       "--sealed where their sticks end, or extend them to walls and other faults (default: Sticks)")
    group.add_argument("--unconformities", action=AddToList, default=NOT_GIVEN, metavar="NAMES", help="horizons at "
                       "which faults of --sealed end from below (default: none)")
    group.add_argument("--walls", choices=("Box", "Picks"), default=NOT_GIVEN, help="walls of --sealed: a box, or "
                       "along the outline of the picks (default: Box)")
    group.add_argument("--close-faults", action="store_true", help="close the mesh at faults with triangles, marked "
                       "1 in the array Fault")
    group.add_argument("--fill-holes", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="fill holes of at "
                       "most N columns with smooth surfaces (default: none)")


def add_mesh_options(group):
    target = group.add_mutually_exclusive_group()
    target.add_argument("--largest-error", type=Height, default=NOT_GIVEN, metavar="E", help="largest vertical distance of "
                        "points from the mesh (default: six times the noise of each horizon)")
    target.add_argument("--triangles", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="at most N "
                        "triangles per mesh, with the smallest error they allow")
    target.add_argument("--stages", action="store_true", help="use the stages of the thesis, from exterior boundary to "
                        "triangulation")
    group.add_argument("--radius", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="K", help="longest hop "
                       "of an outline along each axis, in columns; narrower breaks are bridged (default: from the "
                       "points; 1 with --stages)")
    group.add_argument("--growth-strategy", choices=GROWTH_STRATEGIES, default=NOT_GIVEN, help="how an outline "
                       "with a radius above 1 grows (default: Clockwise)")
    group.add_argument("--minimum-patch-size", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="leave out "
                       "patches with fewer points (default: 1)")
    group.add_argument("--smallest-hole-size", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="N", help="close "
                       "holes with fewer columns (default: automatic; 1 with --stages)")
    group.add_argument("--outline-tolerance", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="largest horizontal deviation of outlines, in columns (default: the error, at most 0.75, more if "
                       "outlines would need over half of --triangles; 0 with --stages)")
    group.add_argument("--distance-threshold", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="T",
                       help="largest vertical deviation of outlines (default: the error; 0.4 with --stages)")
    return (group.add_argument("--edge-length", type=number_at_least(float, 4.0), default=NOT_GIVEN, metavar="L", help="longest inner "
                               "edge, in columns, of even, near-equilateral triangles for simulation (default: few triangles "
                               "instead)"),
            group.add_argument("--smallest-angle", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="A", help="smallest "
                               "angle in map view that optimisation may create, in degrees (default: 2, and 10 for --layers)"))


def add_layer_options(group):
    group.add_argument("--layers", action="store_true", default=NOT_GIVEN, help="make closed volumes between the "
                       "horizons of a file, or of several files with one horizon each: cells (.vtu), one body per "
                       "layer in the formats of meshes, and a table (.csv)")
    return (group.add_argument("--crossings", action=AddToList, values=CROSSINGS, metavar="LIST", default=NOT_GIVEN, help="policy "
                               "where horizons cross, or one for each layer from the top: %s (default: Mean)" % ", ".join(CROSSINGS)),
            group.add_argument("--order", choices=("ByHeight", "AsGiven"), default=NOT_GIVEN, help="order of the "
                               "horizons for --layers: by height, or as listed in --horizons or by the files, "
                               "uppermost first"),
            group.add_argument("--missing", choices=("Void", "Interpolate", "Follow"), default=NOT_GIVEN, help="where "
                               "a horizon has no points: make no layers; close holes and gaps at faults; or also let "
                               "absent horizons follow a neighbour (default: Follow)"),
            group.add_argument("--sublayers", action=AddToList, are_names=True, metavar="LIST", default=NOT_GIVEN, help="number of sublayers "
                               "of each layer, or one for each layer from the top (default: 1)"),
            group.add_argument("--tetrahedra", action="store_true", default=NOT_GIVEN, help="split the cells of layers into tetrahedra"))


def add_stage_options(group):
    group.add_argument("--keep-holes", action="store_true", default=NOT_GIVEN, help="outline holes as well, so that they "
                       "stay open in the mesh")
    group.add_argument("--fewest-outline-points", action="store_true", default=NOT_GIVEN, help="use the fewest outline points "
                       "within the outline tolerance and the distance threshold")
    group.add_argument("--bound-deviation", action="store_true", default=NOT_GIVEN, help="keep dropped outline points within "
                       "the distance threshold of the outline")
    group.add_argument("--cell-size", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="S", help="side of the cells "
                       "of the rough simplification, in lattice units (default: 3)")
    group.add_argument("--skip-rough", action="store_true", default=NOT_GIVEN, help="skip the rough simplification: keep "
                       "every point inside the outline")
    group.add_argument("--elaborate", action="store_true", default=NOT_GIVEN, help="also simplify by curvature: fewer points "
                       "where a horizon is flat")
    group.add_argument("--elaborate-cell-size", type=number_at_least(int, 1), default=NOT_GIVEN, metavar="S", help="side of "
                       "the largest cells of the elaborate simplification, in lattice units (default: 8)")
    group.add_argument("--flatness-threshold", type=number_at_least(float, 0.0), default=NOT_GIVEN, metavar="F",
                       help="largest curvature within a cell, from 0 (planes) to 1/3 (anything; default: 0.12)")
    group.add_argument("--representative", choices=REPRESENTATIVES, default=NOT_GIVEN, help="point that represents a cell: "
                       "the mean of its points, or the point nearest to it (default: Barycentre)")


def add_error_options(group):
    group.add_argument("--measure-error", action="store_true", help="measure the distance between each mesh and the "
                       "full horizon, in both directions: columns of the table (lattice units), arrays of the "
                       "meshes, and a .csv file for each input")
    group.add_argument("--distance-unit", choices=DISTANCE_UNITS, default=NOT_GIVEN, help="unit of the arrays; the "
                       ".csv file has both (default: Lattice)")
    group.add_argument("--samples-per-point", type=number_at_least(float, 0.01), default=NOT_GIVEN, metavar="N", help="number of "
                       "samples on each surface per point of the horizon (default: 2)")
