# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the layers between the horizons of a file, separated vertically, and a chart of their volumes above a contact.

    pvbatch layers_apart.py survey.vsm picture.png --crossings LowerWins

Needs an X server; the plugin must be loaded. Bodies are moved only in the view; the data are unchanged.
"""

import argparse
import pathlib
import sys

from paraview import simple

SIZE = (1100, 520)
HEIGHT_SHARE = 0.35  # height of all layers with their gaps, as a fraction of their width
GAP = 0.25  # gap between layers, as a fraction of the total height
COLORS = ((0.93, 0.79, 0.48), (0.80, 0.50, 0.32), (0.55, 0.69, 0.42), (0.36, 0.58, 0.68), (0.45, 0.38, 0.56), (0.62, 0.62, 0.64))
TEXT = (0.13, 0.16, 0.20)


def names_of(bodies):
    """Returns the names of the blocks as selectors."""
    info = bodies.GetDataInformation().DataInformation.GetDataAssembly()
    return ["/Root/" + info.GetNodeName(child) for child in info.GetChildNodes(0, False)]


def draw_bodies(bodies, view):
    bounds = bodies.GetDataInformation().GetBounds()
    width, height = max(bounds[1] - bounds[0], bounds[3] - bounds[2]), bounds[5] - bounds[4]
    scale = max(1.0, HEIGHT_SHARE * width / height) if height > 0.0 else 1.0
    for number, selector in enumerate(names_of(bodies)):
        display = simple.Show(simple.ExtractBlock(Input=bodies, Assembly="Hierarchy", Selectors=[selector]), view)
        if display.ColorArrayName[1]:
            simple.ColorBy(display, None)
        display.SetRepresentationType("Surface With Edges")
        display.DiffuseColor = COLORS[number % len(COLORS)]
        display.EdgeColor = (0.25, 0.25, 0.25)
        display.Scale = (1.0, 1.0, scale)
        place = "Position" if display.GetProperty("Position") else "Translation"  # in ParaView 5 and 6
        setattr(display, place, (0.0, 0.0, -number * GAP * height * scale))
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = (0, 0, 0), (-0.5, -0.8, 0.45), (0, 0, 1)
    simple.ResetCamera(view)


def draw_volumes(volumes, view):
    """Draws the curve of each layer; contacts get deeper to the right."""
    display = simple.Show(volumes, view, "XYChartRepresentation")
    display.UseIndexForXAxis, display.XArrayName = 0, "Contact"
    display.SeriesVisibility = [name for name in display.SeriesLabel[::2] if name != "Contact"]
    view.LeftAxisTitle, view.BottomAxisTitle = "Volume above the contact", "Contact"


def main():
    parser = argparse.ArgumentParser(prog="layers_apart", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("picture", metavar="PICTURE.png", help="the picture to write")
    parser.add_argument("--crossings", metavar="POLICY", default="Mean", choices=("Mean", "UpperWins", "LowerWins", "Stop"),
                        help="what is done where horizons cross")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.file).is_file():
        sys.exit("layers_apart: %s: no such file" % arguments.file)
    words = {"UpperWins": "Upper Wins", "LowerWins": "Lower Wins"}
    layers = simple.HorizonLayers(Input=simple.OpenDataFile(arguments.file),
                                  Crossings=words.get(arguments.crossings, arguments.crossings))
    layers.UpdatePipeline()
    if not layers.GetDataInformation().GetNumberOfCells():
        sys.exit("layers_apart: %s: no layers, expected at least two horizons above each other" % arguments.file)
    layout = simple.CreateLayout("layers")
    scene = simple.CreateView("RenderView")
    scene.OrientationAxesVisibility, scene.UseColorPaletteForBackground, scene.Background = 0, 0, (1.0, 1.0, 1.0)
    draw_bodies(simple.OutputPort(layers, 1), scene)
    simple.AssignViewToLayout(scene, layout, 0)
    layout.SplitHorizontal(layout.GetViewLocation(scene), 0.6)
    chart = simple.CreateView("XYChartView")
    draw_volumes(simple.OutputPort(layers, 4), chart)
    simple.AssignViewToLayout(chart, layout, 2)
    layout.SetSize(*SIZE)
    simple.SaveScreenshot(arguments.picture, layout)
    print(layers.GetProperty("Results").GetElement(0) if layers.GetProperty("Results") else "", end="")


main()
