# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The promise of the largest error, by bound_check.py, on random horizons that are ragged, steep, torn and thin.

Arguments: how many of each kind, a folder with real horizons or a dash, and the first seed, 0 unless told.
"""

import pathlib
import sys
import unittest

import numpy
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import bound_check
from seismichorizons import vtk as sh

RUNS = int(sys.argv[1])
REAL = pathlib.Path(sys.argv[2])
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 0


def make_horizon(columns, heights, turned):
    """A horizon on a lattice that stands upright, or in a turned survey in UTM metres with time downwards."""
    matrix = numpy.eye(4)
    if turned:
        matrix[:2, :2] = 25.0 * numpy.array([[0.8, -0.6], [0.6, 0.8]])
        matrix[2, 2] = -4.0
        matrix[:3, 3] = 482_000.0, 6_345_000.0, -1200.0
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    places = numpy.column_stack([columns, heights]) @ matrix[:3, :3].T + matrix[:3, 3]
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=1))
    data.SetPoints(points)
    size = [*(columns.max(axis=0) + 1), 1]
    for name, values in (("LatticeDimensions", numpy.array([size], numpy.int32)), ("LatticeToWorld", matrix.reshape(1, 16))):
        array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=1)
        array.SetName(name)
        data.GetFieldData().AddArray(array)
    return data


def smooth(random, size, reach):
    noise = random.normal(size=size)
    for axis in (0, 1):
        for _ in range(3):
            noise = sum(numpy.roll(noise, step, axis) for step in range(-reach, reach + 1)) / (2 * reach + 1)
    return noise / max(numpy.abs(noise).max(), 1e-9)


def random_mask(random, size):
    kind = random.integers(5)
    if kind == 0:
        mask = random.random(size) < random.uniform(0.3, 0.98)
    elif kind == 1:
        mask = smooth(random, size, int(random.integers(1, 4))) > random.uniform(-0.5, 0.2)
    elif kind == 2:  # a comb of spurs
        mask = numpy.zeros(size, bool)
        mask[:, : size[1] // 2] = True
        mask[:: int(random.integers(2, 4))] = True
    elif kind == 3:  # a slanted rim
        i, j = numpy.indices(size)
        mask = i * random.uniform(0.1, 2.0) + random.integers(-1, 2, size) < j
    else:
        mask = numpy.ones(size, bool)
        for _ in range(random.integers(1, 8)):
            i, j = random.integers(0, size[0]), random.integers(0, size[1])
            mask[i : i + random.integers(1, 6), j : j + random.integers(1, 6)] = False
    mask[tuple(random.integers(0, size))] = True
    return mask


def random_heights(random, size):
    i, j = numpy.indices(size)
    heights = 20.0 * smooth(random, size, int(random.integers(1, 4))) * 10.0 ** random.integers(-1, 2)
    kind = random.integers(4)
    if kind == 1:
        heights = heights + random.uniform(-8, 8) * i + random.uniform(-8, 8) * j
    elif kind == 2:
        heights = heights + numpy.where(i * random.uniform(-1, 1) > j - size[1] / 2, 30.0, 0.0)
    elif kind == 3:
        heights = heights + random.normal(size=size) * random.choice([0.3, 3.0])
    return numpy.rint(heights) if random.random() < 0.5 else heights


def random_horizon(random):
    size = random.integers(3, 45, 2)
    mask = random_mask(random, size)
    # Row by row, as all readers have them.
    columns = numpy.argwhere(mask.T)[:, ::-1]
    return make_horizon(columns, random_heights(random, size)[tuple(columns.T)], random.random() < 0.3)


def run(algorithm, data, refusal=None):
    """The output, or None if the stage refuses with this text."""
    messages = []

    @calldata_type(VTK_STRING)
    def note(_caller, _event, message):
        messages.append(message)

    algorithm.AddObserver("ErrorEvent", note)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *arguments: None)
    algorithm.SetInputData(data)
    algorithm.Update()
    assert all(refusal and refusal in message for message in messages), f"{algorithm.GetClassName()}: {messages}"
    return None if messages else algorithm.GetOutputDataObject(0)


def random_tolerances(random):
    """Of the mesh, of outlines in plan, and of those in height."""
    error = float(random.choice([0.0, 0.5, 0.75, 1.0, 2.0, 5.0, 20.0]))
    return error, float(random.choice([0.0, 0.5, 1.0, 3.0, error])), float(random.choice([0.0, 0.5, 2.0, 10.0, error]))


class BoundTest(unittest.TestCase):
    def check(self, seed, horizon, mesh, *tolerances, **parts):
        if mesh.GetNumberOfPolys() > 0:
            faults = bound_check.check(horizon, mesh, *tolerances, **parts)
            self.assertEqual(faults[:3], [], f"seed {seed}, tolerances {tolerances}, {len(faults)} faults")

    def test_surface(self):
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            horizon = random_horizon(random)
            if random.random() < 0.3:
                faults = sh.vtkHorizonFaults()
                faults.SetSmallestThrow(float(random.uniform(1.0, 20.0)))
                horizon = run(faults, horizon)
            error, outline, height = random_tolerances(random)
            surface = sh.vtkHorizonSurface()
            surface.SetErrorUnitToSteps()
            surface.SetMaximumError(error)
            surface.SetEffort(int(random.integers(2)))
            surface.SetFitHeights(bool(random.integers(2)))
            surface.SetKeepHoles(bool(random.integers(2)))
            if random.random() < 0.3:
                surface.AutomaticRadiusOff()
                surface.SetRadius(int(random.integers(1, 4)))
            if random.random() < 0.5:
                surface.AutomaticOutlineToleranceOff()
                surface.SetOutlineTolerance(outline)
                surface.AutomaticDistanceThresholdOff()
                surface.SetDistanceThreshold(height)
            else:
                outline = height = error
            if random.random() < 0.3:
                surface.SetEdgeLength(float(random.uniform(4.0, 15.0)))
                surface.SetEdgeGrowth(float(random.choice([0.0, 0.1, 0.5])))
            self.check(seed, horizon, run(surface, horizon), error, outline, height)

    def test_number(self):
        """At most so many triangles, and errors as told."""
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            horizon = random_horizon(random)
            surface = sh.vtkHorizonSurface()
            surface.SetTargetToNumberOfTriangles()
            most = int(10 ** random.uniform(1.0, 4.0))
            surface.SetMaximumNumberOfTriangles(most)
            surface.SetEffort(int(random.integers(2)))
            surface.SetPriority(int(random.integers(2)))
            surface.SetFitHeights(bool(random.integers(2)))
            mesh = run(surface, horizon, "that the outlines require")
            if mesh and mesh.GetNumberOfPolys() > 0:
                self.assertLessEqual(mesh.GetNumberOfPolys(), most, f"seed {seed}")
                told = {name: bound_check.value(mesh, name) for name in (
                    "LargestError", "LargestEdgeError", "ChosenOutlineTolerance", "ChosenDistanceThreshold")}
                error = max(told["LargestError"], told["LargestEdgeError"])
                self.check(seed, horizon, mesh, error, told["ChosenOutlineTolerance"], told["ChosenDistanceThreshold"])

    def test_stages(self):
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            horizon = random_horizon(random)
            error, outline, height = random_tolerances(random)
            boundary = run(sh.vtkHorizonExteriorBoundary(), horizon)
            simplification = sh.vtkHorizonBoundarySimplification()
            simplification.SetMethod(int(random.integers(2)))
            simplification.SetOutlineTolerance(outline)
            simplification.SetDistanceThreshold(height)
            simplification.BoundDeviationOn()
            outlines = run(simplification, boundary)
            decimation = sh.vtkHorizonDecimation()
            decimation.SetErrorUnitToSteps()
            decimation.SetMaximumError(error)
            self.check(seed, horizon, run(decimation, outlines), error, outline, height, in_stages=True)

    def test_figures_of_stages_before(self):
        """A second simplification keeps the figures of the first; those of triangles do not outlive these."""
        horizon = random_horizon(numpy.random.default_rng(13))
        data = run(sh.vtkHorizonExteriorBoundary(), horizon)
        for tolerance in (3.0, 0.0):
            simplification = sh.vtkHorizonBoundarySimplification()
            simplification.SetMethodToFewestPoints()
            simplification.SetOutlineTolerance(tolerance)
            simplification.SetDistanceThreshold(tolerance)
            data = run(simplification, data)
            self.assertGreater(bound_check.value(data, "NumberOfOutsidePoints"), 0)
            self.assertGreater(bound_check.value(data, "OutlineDeviation"), 0.0)
        mesh = run(sh.vtkHorizonDecimation(), data)
        points = vtkPolyData()  # of the mesh, without its triangles, which stages of points refuse
        points.ShallowCopy(mesh)
        points.SetPolys(None)
        points.GetCellData().Initialize()
        rough = run(sh.vtkHorizonRoughSimplification(), points)
        self.assertTrue(mesh.GetFieldData().HasArray("LargestError"))
        for name in ("LargestError", "MeanError", "LargestLoopError", "TriangleCount", "SmallestAngle"):
            self.assertFalse(rough.GetFieldData().HasArray(name), name)
        boundary = run(sh.vtkHorizonExteriorBoundary(), points)
        self.assertFalse(boundary.GetFieldData().HasArray("NumberOfOutsidePoints"))
        for stage in (sh.vtkHorizonDecimation, sh.vtkHorizonSurface):
            said = []
            again = stage()
            again.AddObserver("ErrorEvent", lambda *arguments: said.append(1))
            again.SetInputData(mesh)
            again.Update()
            self.assertTrue(said)
            self.assertEqual(again.GetErrorCode() != 0 or again.GetOutputDataObject(0).GetNumberOfPoints(), 0)

    @unittest.skipUnless(REAL.is_dir(), "no real horizons")
    def test_real(self):
        for path in sorted(REAL.glob("*/*.ijz")):
            rows = numpy.array([line.split() for line in path.read_text().splitlines() if line[0] != "#"][1:], float)
            rows = rows[numpy.lexsort((rows[:, 0], rows[:, 1]))]
            horizon = make_horizon(rows[:, :2].astype(int), rows[:, 2], False)
            for error in (0.75, 3.0) if len(rows) < 100_000 else (3.0,):
                surface = sh.vtkHorizonSurface()
                surface.SetErrorUnitToSteps()
                surface.SetMaximumError(error)
                self.check(path.name, horizon, run(surface, horizon), error, error)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
