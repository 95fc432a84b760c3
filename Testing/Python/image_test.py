# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws one stage of blobs.vsm and compares it with its baseline.

With --changed a parameter is slightly off, and the picture has to differ: this shows that the comparison sees.
"""

import math

import image_compare
import numpy
import vtk_inputs
from seismichorizons import vtk as sh
from seismichorizons.vtk import apply, make, update
from seismichorizons_command import pictures
from seismichorizons_command.data import from_vtk
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

SIZE = (480, 420)


class Parameters:
    """What the scenes are made with, and slightly different values of the same."""

    def __init__(self, changed):
        self.row_step = (0.02, 1.0) if changed else (0.0, 1.0)
        self.distance_threshold = 0.75 if changed else 0.4
        self.cell_size = 4 if changed else 3
        self.flatness_threshold = 0.0 if changed else 0.12
        self.maximum_error = 0.9 if changed else 0.75
        self.angle = 0.52 if changed else 0.5
        self.spike_threshold = 10.0 if changed else 4.0
        self.smallest_throw = 14.0 if changed else 4.0
        self.largest_hole = 100 if changed else 4000
        self.amplitude_percentile = 75 if changed else 40


def make_panel(data, style, behind=None):
    """A panel of VTK's data, without texts."""
    return pictures.Panel("", "", from_vtk(data), style, None if behind is None else from_vtk(behind))


def read_first(sample, row_step):
    """The first horizon of a file."""
    return next(iter(vtk_inputs.read(sample, RowStep=row_step).values()))


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


def folded_cube(columns=60, rows=50, samples=120):
    """Three layers, folded and cut by a fault, as amplitudes: parabolas in place of wavelets, the same everywhere."""
    i, j, k = numpy.meshgrid(numpy.arange(columns), numpy.arange(rows), numpy.arange(samples), indexing="ij")
    fold = 12.0 * ((i - 25.0) / 30.0) ** 2 - 6.0 * ((j - 20.0) / 25.0) ** 2 + numpy.where(i + 0.3 * j > 40.0, 9.0, 0.0)
    cube = numpy.zeros((columns, rows, samples))
    for depth, strength in ((20.0, 1.0), (48.0, -0.7), (76.0, 0.8)):
        away = (k - depth - fold) / 5.0
        cube += strength * numpy.where(abs(away) < 1.0, 1.0 - 2.0 * away ** 2, 0.0)
    image = vtkImageData()
    image.SetDimensions(columns, rows, samples)
    image.SetSpacing(1.0, 1.0, -0.8)
    amplitudes = numpy_support.numpy_to_vtk(cube.ravel(order="F"), deep=True)
    amplitudes.SetName("Amplitude")
    image.GetPointData().SetScalars(amplitudes)
    return image


def with_spikes(data, every=97, height=12.0):
    """A copy with some points so many vertical indices higher, those of the first half, or lower."""
    spiked = vtkPolyData()
    spiked.DeepCopy(data)
    points = numpy_support.vtk_to_numpy(spiked.GetPoints().GetData())
    step = height * spiked.GetFieldData().GetArray("LatticeToWorld").GetComponent(0, 10)
    points[:len(points) // 2:every, 2] += step
    points[len(points) // 2::every, 2] -= 0.75 * step
    return spiked


def torn(data):
    """A copy with two faults that cross, the second of which ends inside."""
    faulted = vtkPolyData()
    faulted.DeepCopy(data)
    points = numpy_support.vtk_to_numpy(faulted.GetPoints().GetData())
    i, j = points[:, 0] - points[:, 0].min(), points[:, 1] - points[:, 1].min()
    away = j - 0.35 * i - 20.0
    throws = numpy.where(i - 0.2 * j > 60.0, 12.0, 0.0) + numpy.where(away > 0.0, 1.0, -1.0) * (
        numpy.maximum(0.0, 9.0 - 0.09 * i) * numpy.exp(-abs(away) / 40.0))
    points[:, 2] += numpy.round(throws) * faulted.GetFieldData().GetArray("LatticeToWorld").GetComponent(0, 10)
    return faulted


def fault_lines(data, smallest_throw):
    """The points of a horizon, and its fault lines."""
    finder = sh.vtkHorizonFaults()
    horizon = vtkPolyData()
    horizon.ShallowCopy(apply(finder, data, SmallestThrow=smallest_throw))
    throws = numpy_support.numpy_to_vtk(numpy.zeros(horizon.GetNumberOfPoints()), deep=True)
    throws.SetName("Throw")
    horizon.GetPointData().AddArray(throws)
    together = vtkAppendPolyData()
    together.AddInputData(horizon)
    together.AddInputData(finder.GetOutputDataObject(1))
    together.Update()
    return together.GetOutput()


def marked(data, name, level):
    """The points in the colours of levels: those that an array of 0 and 1 marks have that level."""
    marks = numpy_support.vtk_to_numpy(data.GetPointData().GetArray(name))
    origins = numpy_support.numpy_to_vtk(numpy.outer(marks, (level, 0, 0)).astype(numpy.int32), deep=True)
    origins.SetName("CellOrigin")
    data.GetPointData().AddArray(origins)
    return make_panel(data, pictures.LEVELS)


def reflections(amplitude_percentile):
    """All horizons of that cube as one dataset."""
    found = apply(sh.vtkSeismicReflectionExtraction(), folded_cube(), AmplitudePercentile=amplitude_percentile)
    together = vtkAppendPolyData()
    for n in range(found.GetNumberOfPartitionedDataSets()):
        together.AddInputData(found.GetPartition(n, 0))
    together.Update()
    return together.GetOutput()


def bodies(maximum_error):
    """Three layers of a faulted fold, taken apart: the second one ends on the third, the first one has a fault."""
    x, y = numpy.meshgrid(numpy.arange(90.0), numpy.arange(70.0))
    fold = 12.0 * numpy.sin(x / 14.0) * numpy.cos(y / 25.0)
    thrown = numpy.where((x - 0.3 * y > 50.0), 7.0, 0.0)
    depths = {"Sea": 100.0 + 0.3 * fold, "Top": 112.0 + 0.5 * fold + thrown,
              "Fill": numpy.minimum(135.0 + 0.2 * fold + thrown, 98.0 + 0.7 * x + 0.6 * fold + thrown), "Base": 150.0 + fold + thrown}
    depths["Fill"] = numpy.maximum(depths["Fill"], depths["Top"])
    horizons = {name: vtk_inputs.horizon(z, spacing=(2.0, 2.0), VerticalStep=1.0) for name, z in depths.items()}
    horizons["Base"] = apply(sh.vtkHorizonFaults(), horizons["Base"], SmallestThrow=4.0)
    together = vtkAppendPolyData()
    for number, body in enumerate(vtk_inputs.layers(horizons, MaximumError=maximum_error).bodies.values()):
        numpy_support.vtk_to_numpy(body.GetPoints().GetData())[:, 2] -= 18.0 * number
        together.AddInputData(body)
    together.Update()
    return together.GetOutput()


def panel(scene, sample, changed):
    """The panel of a scene. Only what belongs to the scene is changed, not what leads to it."""
    usual, own = Parameters(False), Parameters(changed)
    if scene == "Points":
        return make_panel(read_first(sample, own.row_step), pictures.POINTS)
    if scene == "Volume":
        return make_panel(voxels(sample, own.angle), pictures.MESH)
    if scene == "ExteriorBoundary":
        data = apply(sh.vtkHorizonExteriorBoundary(), read_first(sample, own.row_step))
        return make_panel(data, pictures.OUTLINE)
    if scene == "Layers":
        return make_panel(bodies(own.maximum_error), pictures.BODIES)
    if scene == "Reflections":
        return make_panel(reflections(own.amplitude_percentile), pictures.POINTS)
    data = read_first(sample, usual.row_step)
    if scene == "Despiking":
        found = apply(sh.vtkHorizonDespiking(), with_spikes(data), Action="Flag", Threshold=own.spike_threshold)
        return marked(found, "Spike", 3)
    if scene == "Faults":
        faulted = torn(data)
        return make_panel(fault_lines(faulted, own.smallest_throw), pictures.FAULTS, faulted)
    if scene == "HoleFilling":
        return marked(apply(sh.vtkHorizonHoleFilling(), data, LargestHoleSize=own.largest_hole), "Filled", 2)
    if scene == "BoundarySimplification":
        return make_panel(simplified_boundary(data, own), pictures.OUTLINE, data)
    if scene == "RoughSimplification":
        return make_panel(rough(data, own), pictures.POINTS)
    if scene == "ElaborateSimplification":
        return make_panel(elaborate(data, own), pictures.LEVELS)
    if scene == "Decimation":
        straight = apply(sh.vtkHorizonBoundarySimplification(), apply(sh.vtkHorizonExteriorBoundary(), data),
                         DistanceThreshold=0.75, OutlineTolerance=0.75)
        mesh = apply(sh.vtkHorizonDecimation(), straight, MaximumError=own.maximum_error)
        return make_panel(mesh, pictures.MESH)
    if scene == "Surface":
        return make_panel(vtk_inputs.surface(data, MaximumError=own.maximum_error), pictures.MESH)
    if scene == "Thickness":
        other = list(vtk_inputs.read(sample, RowStep=usual.row_step).values())[1]
        mesh = vtk_inputs.surface(vtk_inputs.thickness(data, other), MaximumError=own.maximum_error)
        mesh.GetPointData().GetArray("Isochore").SetName("Distance")
        return make_panel(mesh, pictures.DISTANCE)
    mesh = apply(sh.vtkHorizonTriangulation(), rough(data, own))
    if scene == "SurfaceDistance":
        meter = sh.vtkHorizonSurfaceDistance()
        apply(meter, data, mesh)
        return make_panel(meter.GetOutputDataObject(1), pictures.DISTANCE)
    return make_panel(mesh, pictures.MESH)


def main():
    parser = image_compare.make_parser()
    parser.add_argument("scene")
    options = parser.parse_args()
    row = [panel(options.scene, str(options.data / "blobs.vsm"), options.changed)]
    image = image_compare.pixels(pictures.draw([row], text=False, panel_size=SIZE))
    image_compare.finish(image, options.scene, options)


if __name__ == "__main__":
    main()
