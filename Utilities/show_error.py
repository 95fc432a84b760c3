#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws meshes coloured by their distance from a horizon, with a table of figures.

    pvbatch show_error.py [OPTIONS] REFERENCE MESH [MESH ...] PICTURE.png

Runs in pvbatch and pvpython, and needs an X server. The plugin SeismicHorizons is loaded from the build tree, otherwise
from PV_PLUGIN_PATH.
"""

import argparse
import math
import pathlib
import sys

from paraview import servermanager, simple

COLORS = pathlib.Path(__file__).resolve().with_name("DistanceColors.json")
PLUGIN = "build/release/lib/paraview-*/plugins/SeismicHorizons/SeismicHorizons.so"
PRESETS = {"Distance": "Horizon Distance", "VerticalDistance": "Horizon Vertical Distance"}
PANEL = (900, 780)
TEXT = (0.13, 0.16, 0.20)
HEIGHT_SHARE = 0.15  # displayed height of a horizon as a fraction of its width
TOWARD = (0.30, -0.66, 0.69)  # direction from the horizon to the viewer


def make_parser():
    parser = argparse.ArgumentParser(prog="show_error.py", formatter_class=argparse.ArgumentDefaultsHelpFormatter,
                                     description=__doc__.splitlines()[0])
    parser.add_argument("reference", metavar="REFERENCE", help="the horizon: a .vsm file, or any mesh ParaView reads")
    parser.add_argument("meshes", metavar="MESH", nargs="+", help="meshes of it, one panel each")
    parser.add_argument("picture", metavar="PICTURE.png", help="the picture to write")
    parser.add_argument("--horizon", type=int, metavar="ID", help="this horizon of the .vsm file (default: the first)")
    parser.add_argument("--array", choices=sorted(PRESETS), default="Distance", help="what the colours show")
    parser.add_argument("--unit", choices=("Steps", "World"), default="Steps", help="the unit of the distances")
    parser.add_argument("--largest", type=float, metavar="D",
                        help="the distance of the last colour (default: the largest 99th percentile of all panels, "
                        "rounded up)")
    parser.add_argument("--titles", nargs="+", metavar="TEXT", help="titles of the panels (default: the file names)")
    parser.add_argument("--edges", action="store_true", help="draw the edges of the triangles")
    return parser


def load_plugin():
    plugin = next(COLORS.parents[1].glob(PLUGIN), None)
    if not hasattr(simple, "HorizonSurfaceDistance") and plugin:
        simple.LoadPlugin(str(plugin), remote=False, ns=vars(simple))
    if not hasattr(simple, "HorizonSurfaceDistance"):
        sys.exit("show_error: the plugin SeismicHorizons is not loaded; is its folder in PV_PLUGIN_PATH?")


def open_reference(path, horizon):
    reader = simple.OpenDataFile(path)
    if reader is None:
        sys.exit("show_error: %s cannot be read" % path)
    if path.endswith((".vsm", ".vsm.gz")):
        reader.UpdatePipelineInformation()
        names = list(reader.HorizonStatus.Available)
        name = names[0] if horizon is None else "Horizon %d" % horizon
        if name not in names:
            sys.exit("show_error: %s has no %s, but %s" % (path, name, ", ".join(names)))
        reader.HorizonStatus = [name]
    return reader


def figures(distance):
    """Returns the table of the measure as a list of dictionaries, one per row."""
    table = servermanager.Fetch(distance, idx=2)
    names = [table.GetColumnName(column) for column in range(table.GetNumberOfColumns())]
    return [{name: table.GetValue(row, column) for column, name in enumerate(names)}
            for row in range(table.GetNumberOfRows())]


def round_up(value):
    """Rounds up to a number whose quarters, the labels of the scale, are short."""
    unit = 10.0 ** math.floor(math.log10(value)) if value > 0.0 else 1.0
    return unit * next(digit for digit in (1.0, 2.0, 4.0, 6.0, 8.0, 10.0) if value <= digit * unit * (1.0 + 1e-12))


def figure(rows, direction, unit, name):
    return max(row[name].ToDouble() for row in rows
               if row["Direction"].ToString() == direction and row["Unit"].ToString() == unit)


def caption(rows, points, unit):
    """Returns three lines; with several horizons, the largest figures of all."""
    largest, mean, outline = (figure(rows, "Two-sided", unit, name)
                              for name in ("LargestDistance", "MeanDistance", "OutlineDistance"))
    share = [100.0 * figure(rows, "Two-sided", "Diagonal", name) for name in ("LargestDistance", "MeanDistance")]
    median, percentile = (figure(rows, "Two-sided", unit, "DistancePercentile%d" % n) for n in (50, 95))
    outline = 0.0 if outline < 1e-9 * largest else outline  # rounding is shown as zero
    return ("{:,} points".format(points),
            "largest %.3g   mean %.3g   (%.2g %% and %.2g %% of the diagonal)" % (largest, mean, *share),
            "median %.3g   95th percentile %.3g   outline %.3g" % (median, percentile, outline))


def add_text(view, text, size, position, bold=False):
    display = simple.Show(simple.Text(registrationName="text", Text=text), view)
    display.WindowLocation = "Any Location"
    display.Position = position
    display.FontSize = size
    display.Bold = int(bold)
    display.Color = TEXT
    display.Justification = "Left"


def make_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = PANEL
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background, view.Background2 = (0.90, 0.92, 0.95), (0.99, 0.99, 1.0)
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    return view


def place_camera(view, bounds, exaggeration):
    low, high = bounds[0::2], bounds[1::2]
    middle = [0.5 * (a + b) for a, b in zip(low, high)]
    middle[2] *= exaggeration
    width = max(high[0] - low[0], high[1] - low[1])
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 3.0 * width * t for m, t in zip(middle, TOWARD)]
    view.CameraViewUp = (0.0, 0.0, 1.0)
    simple.ResetCamera(view)
    view.CameraParallelScale *= 0.82  # ResetCamera leaves room for rotation
    # The horizon is slightly below the centre, for the text above.
    lift = (0.0, 0.0, 0.05 * width)
    view.CameraFocalPoint = [f + d for f, d in zip(view.CameraFocalPoint, lift)]
    view.CameraPosition = [p + d for p, d in zip(view.CameraPosition, lift)]


def color(display, view, options, largest):
    simple.ColorBy(display, ("POINTS", options.array))
    colors = simple.GetColorTransferFunction(options.array)
    colors.ApplyPreset(PRESETS[options.array], True)
    colors.RescaleTransferFunction(0.0 if options.array == "Distance" else -largest, largest)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(colors, view)
    bar.Title = "Distance," if options.array == "Distance" else "Vertical distance,"
    bar.ComponentTitle = "lattice units" if options.unit == "Steps" else "world units"
    bar.TitleColor = bar.LabelColor = TEXT
    bar.TitleFontSize, bar.LabelFontSize = 16, 15
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength, bar.ScalarBarThickness = (0.55, 0.05), 0.40, 14
    bar.DrawNanAnnotation = int(options.array == "VerticalDistance")
    bar.NanAnnotation = "nothing there"
    low = 0.0 if options.array == "Distance" else -largest
    bar.UseCustomLabels, bar.AddRangeLabels = 1, 0
    bar.CustomLabels = [low + (largest - low) * n / 4.0 for n in range(5)]
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-.3g", "%-.3g"


def draw_panel(distance, title, options, largest):
    view = make_view()
    mesh = simple.OutputPort(distance, 1)
    bounds = mesh.GetDataInformation().GetBounds()
    width = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    depth = bounds[5] - bounds[4]
    exaggeration = float("%.2g" % (HEIGHT_SHARE * width / depth)) if depth > 0 else 1.0
    display = simple.Show(mesh, view)
    display.Representation = "Surface With Edges" if options.edges else "Surface"
    display.EdgeColor, display.LineWidth = (0.42, 0.44, 0.47), 0.5
    display.Scale = (1.0, 1.0, exaggeration)
    display.Specular, display.Diffuse, display.Ambient = 0.05, 0.72, 0.30
    color(display, view, options, largest)
    place_camera(view, bounds, exaggeration)
    add_text(view, title, 24, (0.03, 0.938), bold=True)
    points = mesh.GetDataInformation().GetNumberOfPoints()
    for line, text in enumerate(caption(figures(distance), points, options.unit)):
        add_text(view, text, 16, (0.03, 0.895 - 0.038 * line))
    add_text(view, "heights x %g" % exaggeration, 14, (0.03, 0.03))
    return view


def main():
    options = make_parser().parse_args()
    load_plugin()
    simple._DisableFirstRenderCameraReset()
    simple.ImportPresets(str(COLORS))
    reference = open_reference(options.reference, options.horizon)
    measures = [simple.HorizonSurfaceDistance(Reference=reference, Mesh=simple.OpenDataFile(mesh),
                                              DistanceUnit=options.unit) for mesh in options.meshes]
    rows = [figures(measure) for measure in measures]
    if not all(rows):
        sys.exit("show_error: nothing was measured")
    largest = options.largest or round_up(
        max(figure(r, "Two-sided", options.unit, "DistancePercentile99") for r in rows))
    titles = options.titles or [pathlib.Path(mesh).stem for mesh in options.meshes]
    layout = simple.CreateLayout("error")
    place = 0
    for number, (measure, title) in enumerate(zip(measures, titles)):
        simple.AssignViewToLayout(draw_panel(measure, title, options, largest), layout, place)
        if number + 1 < len(measures):
            left = len(measures) - number
            place = layout.SplitHorizontal(place, 1.0 / left) + 1
    layout.SetSize(PANEL[0] * len(measures), PANEL[1])
    simple.SaveScreenshot(options.picture, layout, ImageResolution=(PANEL[0] * len(measures), PANEL[1]))


main()
