#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on sealed models: bodies of three horizons and two faults, pulled apart; and a fault that dies out.

    sealed_pictures.py FOLDER

Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import numpy as np
import seismichorizons as sh
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

BIN, SIZE = 25.0, 81
DEPTHS = {"H1": 1000.0, "H2": 1200.0, "H3": 1450.0}
FAULTS = {"F1": (700.0, 1.0, 0.15), "F2": (1300.0, -1.0, -0.1)}  # x at 1200 m, the side of the hanging wall, and its turn along y
THROWS = {"F1": 120.0, "F2": 70.0}
COLORS = {"above H1": (0.93, 0.79, 0.48), "H1 to H2": (0.80, 0.51, 0.32), "H2 to H3": (0.55, 0.69, 0.42), "below H3": (0.36, 0.58, 0.68)}
APART = 1.22


def fault_x(name, y, depth):
    x, side, turn = FAULTS[name]
    return x + turn * (y - 1000.0) + 30.0 * np.sin(y / 400.0) + side * 0.55 * (depth - 1200.0)


def is_hanging(name, x, y, depth):
    return FAULTS[name][1] * (x - fault_x(name, y, depth)) > 0.0


def make_horizon(name, depth):
    """F2 is in the hanging wall of F1."""
    x, y = np.meshgrid(np.arange(SIZE) * BIN, np.arange(SIZE) * BIN)
    foot = depth + 30.0 * np.sin(x / 420.0) * np.cos(y / 560.0)
    hanging, between = foot + THROWS["F1"], foot + THROWS["F1"] + THROWS["F2"]
    z = np.where(~is_hanging("F1", x, y, foot), foot, np.nan)
    z = np.where(is_hanging("F1", x, y, hanging) & ~is_hanging("F2", x, y, hanging), hanging, z)
    z = np.where(is_hanging("F1", x, y, between) & is_hanging("F2", x, y, between), between, z)
    return sh.horizon(z, spacing=(BIN, BIN), vertical_unit="m", horizontal_unit="m", name=name)


def make_sticks():
    depths = np.linspace(700.0, 2000.0, 9)
    lines = [(name, np.column_stack((fault_x(name, y, depths), np.full(9, y), -depths)))
             for name in FAULTS for y in np.linspace(-200.0, 2200.0, 13)]
    return sh.Lines([name for name, _ in lines], [line for _, line in lines])


def make_tips():
    """F1 alone, which dies out at both ends: horizons and sticks."""
    x, y = np.meshgrid(np.arange(SIZE) * BIN, np.arange(SIZE) * BIN)
    horizons = []
    for name, depth in DEPTHS.items():
        foot = depth + 30.0 * np.sin(x / 420.0) * np.cos(y / 560.0)
        hanging = foot + 140.0 * np.clip(1.0 - ((y - 1000.0) / 650.0) ** 2, 0.0, None) ** 2
        z = np.where(is_hanging("F1", x, y, hanging), hanging, np.where(is_hanging("F1", x, y, foot), np.nan, foot))
        horizons.append(sh.horizon(z, spacing=(BIN, BIN), vertical_unit="m", horizontal_unit="m", name=name))
    depths = np.linspace(900.0, 1700.0, 9)
    lines = [np.column_stack((fault_x("F1", y, depths), np.full(9, y), -depths)) for y in np.linspace(400.0, 1600.0, 13)]
    return horizons, sh.Lines(["F1"] * len(lines), lines)


def poly_data(mesh, shift, chosen=slice(None)):
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(mesh.points + shift, deep=True))
    triangles = np.asarray(mesh.triangles, np.int64)[chosen]
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(triangles) + 1, 3), deep=True), numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def add(renderer, data, color, edges):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputDataObject(data)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.2)
    actor.GetProperty().SetEdgeVisibility(edges)
    actor.GetProperty().SetEdgeColor([0.75 * part for part in color])
    renderer.AddActor(actor)
    return actor


def draw_bodies(model, renderer):
    middle = model.points.mean(0)
    for name, body in zip(model.names, model.bodies):
        shift = (APART - 1.0) * (body.points.mean(0) - middle) * (1.0, 1.0, 1.4)
        data = poly_data(body, shift)
        add(renderer, data, COLORS[name.split(",")[0]], True)
        creases = vtkFeatureEdges()
        creases.SetInputData(data)
        creases.SetFeatureAngle(25.0)
        creases.Update()
        add(renderer, creases.GetOutput(), (0.15, 0.15, 0.15), False).GetProperty().SetLineWidth(2.0)


def draw_surfaces(model, renderer):
    for name, color in (("H2", COLORS["H1 to H2"]), ("H3", COLORS["H2 to H3"]), ("F1", (0.70, 0.15, 0.12))):
        add(renderer, poly_data(model, 0.0, np.array(model.surface) == name), color, True)


def write(model, draw, way, path):
    renderer, window, image, writer = vtkRenderer(), vtkRenderWindow(), vtkWindowToImageFilter(), vtkPNGWriter()
    renderer.SetBackground(1.0, 1.0, 1.0)
    lights = vtkLightKit()
    lights.SetKeyLightElevation(60.0)
    lights.SetKeyToFillRatio(2.0)
    lights.AddLightsToRenderer(renderer)
    draw(model, renderer)
    middle = model.points.mean(0)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1100, 720)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle)
    camera.SetPosition(middle + np.array(way))
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(1.4)
    window.Render()
    image.SetInput(window)
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def main():
    model = sh.sealed([make_horizon(*given) for given in DEPTHS.items()], make_sticks(), endings="F2 > F1", largest_error=1.0)
    print(model)
    folder = pathlib.Path(sys.argv[1])
    write(model, draw_bodies, [-1200.0, -4200.0, 2300.0], folder / "SealedModel.png")
    write(sh.sealed(*make_tips(), largest_error=1.0), draw_surfaces, [3000.0, -2600.0, 2300.0], folder / "SealedTips.png")


if __name__ == "__main__":
    main()
