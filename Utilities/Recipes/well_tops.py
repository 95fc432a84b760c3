# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the horizons of a file with well tops, as spheres with the names of their wells.

    pvbatch well_tops.py top_chalk.dat tops.csv picture.png

Columns of the table are Well, X, Y and Depth, or the names given. Needs an X server; the plugin must be loaded.
"""

import argparse
import csv
import pathlib
import sys
import tempfile

from paraview import simple

SIZE = (1100, 700)
COLOR = (0.85, 0.15, 0.10)


def read_tops(path, columns):
    """The wells with their places, a list of four texts each."""
    with open(path, encoding="utf-8-sig", newline="") as file:
        rows = list(csv.DictReader(file))
    missing = [name for name in columns if rows and name not in rows[0]]
    if missing or not rows:
        sys.exit("well_tops: %s: no %s, expected columns %s and a row for each top" % (
            path, "column " + ", ".join(missing) if missing else "rows", ", ".join(columns)))
    tops = [[row[name] or "" for name in columns] for row in rows]
    for number, (_, *place) in enumerate(tops):
        try:
            list(map(float, place))
        except ValueError:
            sys.exit("well_tops: %s: row %d has '%s', expected three numbers" % (path, number + 1, "', '".join(place)))
    return tops


def show_tops(rows, direction, view):
    """Positive depths or times are below 0 in the view."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "tops.csv"
        with table.open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([["Well", "X", "Y", "Z"], *rows])
        points = simple.TableToPoints(Input=simple.CSVReader(FileName=[str(table)]), XColumn="X", YColumn="Y", ZColumn="Z",
                                      KeepAllDataArrays=1)
        tops = simple.Transform(Input=points)
        tops.Transform.Scale = (1.0, 1.0, 1.0 if direction == "up" else -1.0)
        tops.UpdatePipeline()
    display = simple.Show(tops, view)
    display.SetRepresentationType("Points")
    display.PointSize, display.RenderPointsAsSpheres = 18, 1
    display.AmbientColor = display.DiffuseColor = COLOR
    # Names are drawn at selected points.
    simple.QuerySelect(QueryString="(id >= 0)", FieldType="POINT", Source=tops)
    display.SelectionPointLabelVisibility, display.SelectionPointFieldDataArrayName = 1, "Well"
    display.SelectionPointLabelFontSize, display.SelectionPointLabelColor = 20, (0.0, 0.0, 0.0)
    display.SelectionColor = COLOR


def main():
    parser = argparse.ArgumentParser(prog="well_tops", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("tops", metavar="TOPS.csv", help="a table of well tops")
    parser.add_argument("picture", metavar="PICTURE.png", help="the picture to write")
    parser.add_argument("--columns", metavar="NAME,NAME,NAME,NAME", default="Well,X,Y,Depth",
                        help="those of the well, of x, y and of z")
    parser.add_argument("--direction", default="down", choices=("down", "up"), help="where z of the table increases to")
    parser.add_argument("--exaggeration", metavar="N", type=float, default=1.0, help="of heights")
    arguments = parser.parse_args()
    for name in (arguments.file, arguments.tops):
        if not pathlib.Path(name).is_file():
            sys.exit("well_tops: %s: no such file" % name)
    view = simple.CreateView("RenderView")
    view.ViewSize, view.OrientationAxesVisibility = SIZE, 0
    view.UseColorPaletteForBackground, view.Background = 0, (1.0, 1.0, 1.0)
    horizons = simple.OpenDataFile(arguments.file)
    simple.Show(horizons, view)
    tops = read_tops(arguments.tops, arguments.columns.split(","))
    show_tops(tops, arguments.direction, view)
    for display in view.Representations:
        if display.GetProperty("Scale"):
            display.Scale = (1.0, 1.0, arguments.exaggeration)
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = (0, 0, 0), (-0.35, -0.75, 0.56), (0, 0, 1)
    simple.ResetCamera(view)
    simple.SaveScreenshot(arguments.picture, view)
    print("%d well tops" % len(tops))


main()
