# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The ledger of all stages, by ledger_check.py, on random horizons with holes, islands, faults and spikes.

Arguments: how many of each kind, Common/Horizon/Ledger.h, and the first seed, 0 unless told.
"""

import pathlib
import re
import sys
import unittest
import warnings

import numpy

from vtkmodules.util.numpy_support import numpy_to_vtk

import ledger_check
import vtk_inputs
from seismichorizons import vtk as sh
from seismichorizons_command import ledger
from seismichorizons_command.data import from_vtk

RUNS, HEADER = int(sys.argv[1]), pathlib.Path(sys.argv[2])
FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else 0
sys.argv[2:] = ["-"]

from bound_test import random_horizon, run  # noqa: E402: takes the arguments


def make(name, **properties):
    algorithm = getattr(sh, "vtkHorizon" + name)()
    algorithm.AddObserver("WarningEvent", lambda *arguments: None)  # so that VTK does not print them
    for key, value in properties.items():
        getattr(algorithm, "Set" + key)(value)
    return algorithm


def random_preparations(random):
    """Despiking, faults and hole filling, or some of them, or none."""
    made = []
    if random.random() < 0.4:
        made.append(make("Despiking", Threshold=float(random.uniform(1.0, 10.0)), Action=int(random.random() < 0.3),
                         SpurWidth=int(random.integers(0, 3))))
    if random.random() < 0.4:
        made.append(make("Faults", SmallestThrow=float(random.uniform(1.0, 20.0))))
    if random.random() < 0.4:
        made.append(make("HoleFilling", LargestHoleSize=int(random.integers(1, 30)),
                         ExtrapolationDistance=int(random.integers(0, 3))))
    return made


def random_stages(random):
    """From points to a mesh, stage by stage or in one."""
    error = float(random.choice([0.0, 0.75, 1.0, 2.0, 5.0, 20.0]))
    radius = int(random.integers(1, 4))
    smallest_patch = int(random.choice([1, 1, 8]))
    kind = random.integers(4)
    if kind == 0:
        made = [make("Surface", MaximumError=error, KeepHoles=bool(random.integers(2)), MinimumPatchSize=smallest_patch,
                     CloseFaults=bool(random.integers(2)))]
        if random.random() < 0.5:
            made[0].AutomaticRadiusOff()
            made[0].SetRadius(radius)
        return made
    made = [make("ExteriorBoundary", Radius=radius, BoundaryType=int(random.choice([0, 0, 1, 2])),
                 GrowthStrategy=int(random.integers(2)), SmallestHoleSize=int(random.choice([1, 1, 10])),
                 MinimumPatchSize=smallest_patch)]
    for _ in range(random.integers(3)):
        made.append(make("BoundarySimplification", Method=int(random.integers(2)), DistanceThreshold=error,
                         OutlineTolerance=float(random.choice([0.0, 1.0, 3.0]))))
    if kind == 1:
        return [*made, make("Decimation", MaximumError=error)]
    if random.random() < 0.7:
        name = "RoughSimplification" if random.random() < 0.5 else "ElaborateSimplification"
        made.append(make(name, CellSize=int(random.choice([2, 4, 8]))))
    return [*made, make("Triangulation", CloseFaults=bool(random.integers(2)))]


def sums(own):
    """The columns that are covered, and those that were read."""
    return sum(own.values()) - own["LeftOut"], own["Known"] + own["LeftOut"]


class LedgerTest(unittest.TestCase):
    def prepare(self, random, where):
        """A horizon, its columns, and the points of the last preparation."""
        horizon = random_horizon(random)
        read = ledger_check.columns_of(horizon)["Known"]
        points = horizon
        for stage in random_preparations(random):
            points = run(stage, points)
            self.assertEqual(ledger_check.ledger(points), ledger_check.expected_of_points(read, points),
                             (where, stage.GetClassName()))
        return read, points

    def test_stages(self):
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            read, points = self.prepare(random, seed)
            if not points.GetNumberOfPoints():
                continue
            data, names = points, []
            for stage in random_stages(random):
                names.append(stage.GetClassName())
                if names == ["vtkHorizonExteriorBoundary"] and points.GetFieldData().HasArray("FaultedLinks"):
                    stage.SetRadius(1)  # growth by distance refuses faults with a larger one
                data = run(stage, data)
                own = ledger_check.ledger(data)
                self.assertEqual(own["Known"] + own["LeftOut"], len(read), (seed, names))
                if not data.GetNumberOfPoints():
                    break
            expected = ledger_check.expected_of_mesh(read, points, data)
            dropped = vtk_inputs.details(data).dropped_small_patch_points  # they are left out even under the mesh
            if names.count("vtkHorizonBoundarySimplification") > 1 or dropped:  # the second has no points that the first dropped
                self.assertLessEqual(expected["Known"] - own["Known"], dropped if names.count("vtkHorizonBoundarySimplification") < 2
                                     else len(read), (seed, names))
                own, expected = sums(own), sums(expected)
            self.assertEqual(own, expected, (seed, names))

    def test_small_patches(self):
        """Faults that go around some points cut them off: dropped as a small patch, they are left out even under the mesh."""
        for size in (1, 2, 3):
            block = [(3 + i, 3 + j) for i in range(size) for j in range(size)]
            heights = numpy.full((9, 9), 1000.0)
            links = set()
            for i, j in block:
                heights[j, i] = 1100.0
                links |= {link for link, other in (((i, j, 0), (i + 1, j)), ((i - 1, j, 0), (i - 1, j)), ((i, j, 1), (i, j + 1)),
                                                   ((i, j - 1, 1), (i, j - 1))) if other not in block}
            horizon = vtk_inputs.horizon(heights, VerticalStep=1.0)
            array = numpy_to_vtk(numpy.array(sorted(links, key=lambda link: (link[1], link[0], link[2])), dtype=numpy.int32), deep=1)
            array.SetName("FaultedLinks")
            horizon.GetFieldData().AddArray(array)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = vtk_inputs.details(vtk_inputs.surface(horizon, MaximumError=1.0, MinimumPatchSize=20))
            self.assertEqual(found.dropped_small_patch_points, size * size)
            self.assertGreaterEqual(found.ledger_columns.left_out, size * size)
            self.assertEqual(found.ledger_columns.known + found.ledger_columns.left_out, 81)

    def test_part_of_a_mesh(self):
        """Of a mesh that is not finished, and of the convex hull, the covered columns are right, and none is lost."""
        for seed in range(FIRST, FIRST + RUNS // 4):
            random = numpy.random.default_rng(seed)
            points = random_horizon(random)
            read = ledger_check.columns_of(points)["Known"]
            outlines = run(make("ExteriorBoundary"), points)
            for data, stage in ((points, make("Triangulation", ConvexHull=True)),
                                (outlines, make("Triangulation", MaximumNumberOfTriangles=int(random.integers(1, 50))))):
                mesh = run(stage, data)
                if mesh.GetNumberOfPolys():
                    self.assertEqual(ledger_check.ledger(mesh), ledger_check.expected_of_mesh(read, points, mesh), seed)

    def test_islands(self):
        """A row of points has no triangles: it is left out, and a warning says so."""
        heights = numpy.full((40, 50), numpy.nan)
        heights[:30, :40] = 100.0
        heights[35, 5:25] = 103.0
        heights[10:13, 10:13] = numpy.nan
        horizon = vtk_inputs.horizon(heights, spacing=(25.0, 10.0))
        self.assertEqual(vtk_inputs.details(horizon).ledger_columns.known, 1211)
        mesh = vtk_inputs.surface(horizon, MaximumError=3.0)
        self.assertEqual(vars(vtk_inputs.details(mesh).ledger_columns),
                         {"known": 1191, "filled": 0, "bridged": 0, "extrapolated": 0, "left_out": 20})
        self.assertEqual(vtk_inputs.details(mesh).ledger_area.left_out, 20 * 250.0)
        self.assertEqual(ledger.warning(ledger.read(from_vtk(mesh))), "1.7 % of the points are left out")

    def test_percentages(self):
        """Are figures without an exponent, and of the points at most 100."""
        columns = dict.fromkeys(ledger.ENTRIES, 0)
        for change, text in (({"known": 10, "left_out": 650}, "98 % of the points are left out"),
                             ({"known": 1, "left_out": 100000}, "100 % of the points are left out"),
                             ({"known": 1000, "filled": 2, "extrapolated": 150},
                              "of the covered area, 0.17 % is filled and 13 % is extrapolated")):
            self.assertEqual(ledger.warning({"columns": {**columns, **change}}), text)

    def test_fraction(self):
        said = re.search(r"LedgerWarningFraction = ([0-9.]+);", HEADER.read_text(encoding="utf-8"))
        self.assertEqual(ledger.WARNING_FRACTION, float(said[1]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
