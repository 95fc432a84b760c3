# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws meshes that differ in one parameter of Horizon Surface, side by side.

    pvbatch side_by_side.py survey.vsm picture.png MaximumError 0.25 1 4

Needs an X server; the plugin must be loaded. Flat horizons are drawn with vertical exaggeration.
"""

import argparse
import pathlib
import sys

from paraview import simple

SIZE = (520, 440)
TEXT = (0.13, 0.16, 0.20)
HEIGHT_SHARE = 0.25  # displayed height of a horizon as a fraction of its width
TOWARD = {False: (-0.45, -0.75, 0.62), True: (0.0, 0.0, 1.0)}  # directions to the viewer: oblique, and from above


def make_surface(horizons, name, value):
    surface = simple.HorizonSurface(Input=horizons)
    if name not in surface.ListProperties():
        sys.exit("side_by_side: no property '%s', expected one of Horizon Surface" % name)
    if hasattr(surface, "Automatic" + name):
        setattr(surface, "Automatic" + name, 0)
    setattr(surface, name, int(value) if value == int(value) else value)
    surface.UpdatePipeline()
    return surface


def draw(mesh, title, view):
    display = simple.Show(mesh, view)
    display.SetRepresentationType("Surface With Edges")
    simple.ColorBy(display, None)
    display.DiffuseColor = (0.72, 0.78, 0.80)
    display.EdgeColor = (0.20, 0.26, 0.33)
    bounds = mesh.GetDataInformation().GetBounds()
    width = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    height = bounds[5] - bounds[4]
    display.Scale = (1.0, 1.0, max(1.0, HEIGHT_SHARE * width / height) if height > 0.0 else 1.0)
    label = simple.Show(simple.Text(Text=title), view)
    label.Color, label.FontSize, label.WindowLocation = TEXT, 16, "Upper Center"


def look_at(mesh, view, scale, from_above):
    bounds = mesh.GetDataInformation().GetBounds()
    middle = [(bounds[n] + bounds[n + 1]) / 2 for n in (0, 2, 4)]
    middle[2] *= scale
    view.CameraFocalPoint = middle
    view.CameraPosition = [at + toward for at, toward in zip(middle, TOWARD[from_above])]
    view.CameraViewUp = (0.0, 1.0, 0.0) if from_above else (0.0, 0.0, 1.0)
    simple.ResetCamera(view)
    view.CameraParallelProjection = 1
    simple.GetActiveCamera().Zoom(1.25 if from_above else 1.35)


def main():
    parser = argparse.ArgumentParser(prog="side_by_side", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("picture", metavar="PICTURE.png", help="the picture to write")
    parser.add_argument("--horizon", metavar="NAME", help="this horizon of the file (default: all)")
    parser.add_argument("--from-above", action="store_true", help="look down on the map")
    parser.add_argument("property", metavar="PROPERTY", help="a property of Horizon Surface")
    parser.add_argument("values", metavar="VALUE", type=float, nargs="+", help="its values, one panel each")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.file).is_file():
        sys.exit("side_by_side: %s: no such file" % arguments.file)
    horizons = simple.OpenDataFile(arguments.file)
    if arguments.horizon:
        horizons.HorizonStatus = [arguments.horizon]
    layout = simple.CreateLayout("side by side")
    for number, value in enumerate(arguments.values):
        surface = make_surface(horizons, arguments.property, value)
        view = simple.CreateView("RenderView")
        view.OrientationAxesVisibility, view.UseColorPaletteForBackground, view.Background = 0, 0, (1.0, 1.0, 1.0)
        cells = surface.GetDataInformation().GetNumberOfCells()
        draw(surface, "%s %g: %d triangles" % (arguments.property, value, cells), view)
        look_at(surface, view, simple.GetDisplayProperties(surface, view).Scale[2], arguments.from_above)
        simple.AssignViewToLayout(view, layout, 0)
        if number + 1 < len(arguments.values):
            layout.SplitHorizontal(layout.GetViewLocation(view), 1.0 / (len(arguments.values) - number))
    layout.SetSize(SIZE[0] * len(arguments.values), SIZE[1])
    simple.SaveScreenshot(arguments.picture, layout)


main()
