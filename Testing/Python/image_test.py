# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one stage of the sample and compares it with its baseline.

With --changed a parameter is slightly off, and the picture has to differ: this shows that the comparison sees.
"""

import argparse
import pathlib
import sys

import image_compare
import seismichorizons as sh
from seismichorizons import pictures

SIZE = (480, 420)


class Parameters:
    """What the scenes are made with, and slightly different values of the same."""

    def __init__(self, changed):
        self.row_step = (0.02, 1.0) if changed else (0.0, 1.0)
        self.distance_threshold = 0.45 if changed else 0.4
        self.cell_size = 4 if changed else 3
        self.flatness_threshold = 0.0 if changed else 0.12


def read(sample, parameters):
    reader = sh.vtkVerneySparseMatrixReader()
    reader.SetFileName(sample)
    reader.SetRowStep(parameters.row_step)
    reader.Update()
    return reader.GetOutputDataObject(0).GetPartition(0, 0)


def apply(algorithm, data):
    algorithm.SetInputDataObject(0, data)
    algorithm.Update()
    return algorithm.GetOutputDataObject(0)


def simplified_boundary(data, parameters):
    algorithm = sh.vtkHorizonBoundarySimplification()
    algorithm.SetDistanceThreshold(parameters.distance_threshold)
    return apply(algorithm, apply(sh.vtkHorizonExteriorBoundary(), data))


def rough(data, parameters):
    algorithm = sh.vtkHorizonRoughSimplification()
    algorithm.SetCellSize(parameters.cell_size)
    return apply(algorithm, simplified_boundary(data, parameters))


def elaborate(data, parameters):
    algorithm = sh.vtkHorizonElaborateSimplification()
    algorithm.SetFlatnessThreshold(parameters.flatness_threshold)
    return apply(algorithm, simplified_boundary(data, parameters))


def panel(scene, sample, changed):
    """The panel of a scene. Only what belongs to the scene is changed, not what leads to it."""
    usual, own = Parameters(False), Parameters(changed)
    if scene == "Points":
        return pictures.Panel("", "", read(sample, own), pictures.POINTS)
    if scene == "ExteriorBoundary":
        data = apply(sh.vtkHorizonExteriorBoundary(), read(sample, own))
        return pictures.Panel("", "", data, pictures.OUTLINE)
    data = read(sample, usual)
    if scene == "BoundarySimplification":
        return pictures.Panel("", "", simplified_boundary(data, own), pictures.OUTLINE, data)
    if scene == "RoughSimplification":
        return pictures.Panel("", "", rough(data, own), pictures.POINTS)
    if scene == "ElaborateSimplification":
        return pictures.Panel("", "", elaborate(data, own), pictures.LEVELS)
    mesh = apply(sh.vtkHorizonTriangulation(), rough(data, own))
    if scene == "SurfaceDistance":
        meter = sh.vtkHorizonSurfaceDistance()
        meter.SetInputDataObject(0, data)
        meter.SetInputDataObject(1, mesh)
        meter.Update()
        return pictures.Panel("", "", meter.GetOutputDataObject(1), pictures.DISTANCE)
    return pictures.Panel("", "", mesh, pictures.MESH)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene")
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--changed", action="store_true")
    options = parser.parse_args()
    row = [panel(options.scene, str(options.data / "sample.vsm"), options.changed)]
    image = image_compare.pixels(pictures.draw([row], text=False, panel_size=SIZE))
    name = options.scene + ("-changed" if options.changed else "")
    baseline = options.data / "Baseline" / (options.scene + ".png")
    sys.exit(0 if image_compare.check(image, baseline, options.output, name, options.changed) else 1)


if __name__ == "__main__":
    main()
