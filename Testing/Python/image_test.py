# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one stage of the sample and compares it with its baseline.

With --changed a parameter is slightly off, and the picture has to differ: this shows that the comparison sees.
"""

import math

import image_compare
import seismichorizons as sh
from seismichorizons import pictures
from seismichorizons.pipeline import read_first, surface
from seismichorizons.stage import apply, make, update
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

SIZE = (480, 420)


class Parameters:
    """What the scenes are made with, and slightly different values of the same."""

    def __init__(self, changed):
        self.row_step = (0.02, 1.0) if changed else (0.0, 1.0)
        self.distance_threshold = 0.45 if changed else 0.4
        self.cell_size = 4 if changed else 3
        self.flatness_threshold = 0.0 if changed else 0.12
        self.maximum_error = 0.9 if changed else 0.75
        self.angle = 0.52 if changed else 0.5


def simplified_boundary(data, parameters):
    outlined = apply(sh.vtkHorizonExteriorBoundary(), data)
    return apply(sh.vtkHorizonBoundarySimplification(), outlined, DistanceThreshold=parameters.distance_threshold)


def rough(data, parameters):
    straight = simplified_boundary(data, parameters)
    return apply(sh.vtkHorizonRoughSimplification(), straight, CellSize=parameters.cell_size)


def elaborate(data, parameters):
    straight = simplified_boundary(data, parameters)
    return apply(sh.vtkHorizonElaborateSimplification(), straight, FlatnessThreshold=parameters.flatness_threshold)


def voxels(sample, angle):
    """The cells of a volume at the voxels of all horizons, on a survey that is turned."""
    along, across = (2.0 * math.cos(angle), 2.0 * math.sin(angle)), (-math.sin(angle), math.cos(angle))
    reader = make("vtkVerneySparseMatrixReader", FileName=sample, OutputType="Volume", ColumnStep=along, RowStep=across)
    update(reader)
    cells = vtkThreshold()
    cells.SetInputConnection(reader.GetOutputPort())
    cells.SetInputArrayToProcess(0, 0, 0, 0, "SurfaceId")
    cells.SetLowerThreshold(1)
    cells.AllScalarsOff()
    surface = vtkGeometryFilter()
    surface.SetInputConnection(cells.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def panel(scene, sample, changed):
    """The panel of a scene. Only what belongs to the scene is changed, not what leads to it."""
    usual, own = Parameters(False), Parameters(changed)
    if scene == "Points":
        return pictures.Panel("", "", read_first(sample, RowStep=own.row_step), pictures.POINTS)
    if scene == "Volume":
        return pictures.Panel("", "", voxels(sample, own.angle), pictures.MESH)
    if scene == "ExteriorBoundary":
        data = apply(sh.vtkHorizonExteriorBoundary(), read_first(sample, RowStep=own.row_step))
        return pictures.Panel("", "", data, pictures.OUTLINE)
    data = read_first(sample, RowStep=usual.row_step)
    if scene == "BoundarySimplification":
        return pictures.Panel("", "", simplified_boundary(data, own), pictures.OUTLINE, data)
    if scene == "RoughSimplification":
        return pictures.Panel("", "", rough(data, own), pictures.POINTS)
    if scene == "ElaborateSimplification":
        return pictures.Panel("", "", elaborate(data, own), pictures.LEVELS)
    if scene == "Decimation":
        straight = apply(sh.vtkHorizonBoundarySimplification(), apply(sh.vtkHorizonExteriorBoundary(), data),
                         DistanceThreshold=0.75, OutlineTolerance=0.75)
        mesh = apply(sh.vtkHorizonDecimation(), straight, MaximumError=own.maximum_error)
        return pictures.Panel("", "", mesh, pictures.MESH)
    if scene == "Surface":
        return pictures.Panel("", "", surface(data, largest_error=own.maximum_error)[0], pictures.MESH)
    mesh = apply(sh.vtkHorizonTriangulation(), rough(data, own))
    if scene == "SurfaceDistance":
        meter = sh.vtkHorizonSurfaceDistance()
        apply(meter, data, mesh)
        return pictures.Panel("", "", meter.GetOutputDataObject(1), pictures.DISTANCE)
    return pictures.Panel("", "", mesh, pictures.MESH)


def main():
    parser = image_compare.make_parser()
    parser.add_argument("scene")
    options = parser.parse_args()
    row = [panel(options.scene, str(options.data / "sample.vsm"), options.changed)]
    image = image_compare.pixels(pictures.draw([row], text=False, panel_size=SIZE))
    image_compare.finish(image, options.scene, options)


if __name__ == "__main__":
    main()
