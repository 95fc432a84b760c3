# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of boundaries in the documentation.

    python3 boundary_pictures.py MEASUREMENTS SAMPLE OUTPUT_FOLDER

MEASUREMENTS is what BoundaryBenchmark printed, SAMPLE a .vsm file. Needs an X server.
"""

import collections
import csv
import pathlib
import sys

from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY, vtkPlotPoints
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTable
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 registers the device that draws charts

import seismichorizons as sh
from seismichorizons import pictures

CHART_SIZE = (640, 420)
COLORS = ((31, 119, 180), (214, 39, 40), (44, 160, 44), (148, 103, 189), (255, 127, 14), (140, 86, 75))
PANEL_SIZE = (420, 340)


def column(name, values):
    array = vtkFloatArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def add_curve(chart, number, name, points):
    table = vtkTable()
    table.AddColumn(column("x", [x for x, _ in points]))
    table.AddColumn(column(name, [y for _, y in points]))
    curve = chart.AddPlot(vtkChart.LINE)
    curve.SetInputData(table, 0, 1)
    curve.SetColor(*COLORS[number % len(COLORS)], 255)
    curve.SetWidth(2.0)
    curve.SetMarkerStyle(vtkPlotPoints.CIRCLE)


def draw_chart(curves, x_title, y_title, legend, path):
    """Writes curves, a dictionary of lists of points, as a picture."""
    view = vtkContextView()
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().SetMultiSamples(0)
    view.GetRenderWindow().SetSize(*CHART_SIZE)
    view.GetRenderer().SetBackground(1.0, 1.0, 1.0)
    chart = vtkChartXY()
    view.GetScene().AddItem(chart)
    for number, (name, points) in enumerate(curves.items()):
        add_curve(chart, number, name, sorted(points))
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(legend[0])
    chart.GetLegend().SetVerticalAlignment(legend[1])
    chart.GetAxis(vtkAxis.BOTTOM).SetTitle(x_title)
    chart.GetAxis(vtkAxis.LEFT).SetTitle(y_title)
    chart.GetAxis(vtkAxis.LEFT).SetBehavior(vtkAxis.FIXED)
    chart.GetAxis(vtkAxis.LEFT).SetRange(0.0, 1.1 * max(y for points in curves.values() for _, y in points))
    view.GetRenderWindow().Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(view.GetRenderWindow())
    grabber.ReadFrontBufferOff()
    grabber.Update()
    pictures.write(grabber.GetOutput(), path)


def draw_measurements(rows, folder):
    times = collections.defaultdict(list)
    rates = collections.defaultdict(list)
    lengths = {r["points"]: int(r["boundary points"]) for r in rows if r["what"] == "exterior"}
    for row in rows:
        million = int(row["points"]) / 1e6
        per_million = 1000.0 * float(row["seconds"]) / million
        parameter = float(row["parameter"])
        if row["what"] == "exterior":
            for rule in ("clockwise", "distance"):
                times["%s, %.2g million points" % (rule, million)].append((parameter, per_million))
        if row["what"] in ("clockwise", "distance"):
            times["%s, %.2g million points" % (row["what"], million)].append((parameter, per_million))
        if row["what"] == "simplification":
            rate = 100.0 * (1.0 - int(row["boundary points"]) / lengths[row["points"]])
            rates["%.2g million points" % million].append((parameter, rate))
    draw_chart(times, "radius (columns)", "ms per million points", (vtkChartLegend.LEFT, vtkChartLegend.TOP),
               folder / "BoundaryTime.png")
    draw_chart(rates, "distance threshold (lattice units)", "boundary points dropped (%)",
               (vtkChartLegend.RIGHT, vtkChartLegend.BOTTOM), folder / "BoundaryRate.png")


def apply(algorithm, data):
    algorithm.SetInputDataObject(0, data)
    algorithm.Update()
    return algorithm.GetOutputDataObject(0)


def read(sample):
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(str(sample))
    reader.Update()
    return reader.GetOutputDataObject(0).GetPartition(0, 0)


def ragged(data):
    """A corner of a horizon with less than half of its points, as automatic tracking leaves it in noise."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for number in range(data.GetNumberOfPoints()):
        i, j, k = data.GetPoint(number)
        # Any hash will do that is the same everywhere.
        noise = (int(i) * 73856093 ^ int(j) * 19349663) * 2654435761 % 2**32 / 2**32
        if 30 <= i < 80 and 25 <= j < 65 and noise < 0.45:
            points.InsertNextPoint(i, j, k)
    part = vtkPolyData()
    part.SetPoints(points)
    vertices = vtkCellArray()
    for number in range(points.GetNumberOfPoints()):
        vertices.InsertNextCell(1, [number])
    part.SetVerts(vertices)
    part.SetFieldData(data.GetFieldData())
    return part


def outline_panel(data, rule, radius, holes):
    algorithm = sh.vtkHorizonExteriorBoundary()
    algorithm.SetRadius(radius)
    algorithm.SetGrowthStrategy(rule)
    algorithm.SetHoleBoundaries(holes)
    algorithm.SetSmallestHoleSize(2)
    outline = apply(algorithm, data)
    counts = [int(outline.GetFieldData().GetArray(name).GetTuple1(0)) for name in ("NumberOfPatches", "NumberOfHoles")]
    points = outline.GetLines().GetNumberOfConnectivityIds() - outline.GetNumberOfLines()
    caption = "%d patches, %d boundary points" % (counts[0], points)
    if holes:
        caption = "%d patches, %d holes, %d boundary points" % (*counts, points)
    name = "Clockwise" if rule == sh.vtkHorizonExteriorBoundary.Clockwise else "Distance"
    return pictures.Panel("%s, radius %d" % (name, radius), caption, outline, pictures.OUTLINE, data)


def main():
    measurements, sample, folder = (pathlib.Path(argument) for argument in sys.argv[1:4])
    with open(measurements, encoding="utf-8") as file:
        draw_measurements(list(csv.DictReader(file)), folder)
    data = read(sample)
    rules = (sh.vtkHorizonExteriorBoundary.Distance, sh.vtkHorizonExteriorBoundary.Clockwise)
    for name, horizon, holes in (("Radius", ragged(data), False), ("Holes", data, True)):
        rows = [[outline_panel(horizon, rule, radius, holes) for radius in (1, 2, 3)] for rule in rules]
        pictures.write(pictures.draw(rows, panel_size=PANEL_SIZE), folder / ("Boundary%s.png" % name))


if __name__ == "__main__":
    main()
