# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether even meshes keep what Documentation/HorizonSurface.md promises: lengths of inner edges, angles, growth, error
and figures, on random and on real horizons. Nothing here is shared with what is checked.

Arguments: how many random horizons of each kind, a folder with real horizons or a dash, and the first seed, 0 by default.
"""

import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

import bound_check
import bound_test
import vtk_inputs
from bound_test import FIRST, REAL, RUNS
from seismichorizons import vtk as sh

ANGLE = 25.0  # degrees
LEAST = 3.0  # columns, of edges that grow from outlines
SLACK = 1e-6


def distances(places, starts, ends):
    """The distance of each place from the nearest of some segments."""
    nearest = numpy.full(len(places), numpy.inf)
    ways = ends - starts
    lengths = numpy.maximum((ways**2).sum(axis=1), 1e-30)
    for n in range(0, len(places), 500):
        from_start = places[n : n + 500, None] - starts
        part = numpy.clip((from_start * ways).sum(axis=2) / lengths, 0.0, 1.0)
        nearest[n : n + 500] = numpy.hypot(*numpy.moveaxis(from_start - part[..., None] * ways, 2, 0)).min(axis=1)
    return nearest


class EvenMesh:
    """An even mesh in plan, on the lattice, measured anew."""

    def __init__(self, mesh, flat=None):
        corners = bound_check.lattice_points(mesh)[:, :2]
        self.corners = numpy.rint(corners)
        assert numpy.abs(corners - self.corners).max(initial=0.0) < 1e-3
        self.triangles = bound_check.cells(mesh.GetPolys(), 3) if flat is None else flat
        numbers = numpy.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 3, 2), axis=2)
        edges, self.edge_of, count = numpy.unique(numbers.reshape(-1, 2), axis=0, return_inverse=True, return_counts=True)
        self.edge_of = self.edge_of.reshape(-1, 3)
        self.lengths = numpy.hypot(*(self.corners[edges[:, 0]] - self.corners[edges[:, 1]]).T)
        # Outlines, and faults, whose sides are apart, are edges of one triangle.
        self.is_inner = count == 2
        self.rims = edges[~self.is_inner]
        self.on_rim = numpy.zeros(len(corners), bool)
        self.on_rim[self.rims.ravel()] = True
        # The cracks of faults close at their ends, where two points have one column.
        places = set(map(tuple, self.corners[self.on_rim]))
        self.on_rim = numpy.array([tuple(place) in places for place in self.corners], bool)
        self.is_chord = self.is_inner & self.on_rim[edges].all(axis=1)
        self.angles = bound_check.smallest_angles(self.corners, self.triangles)
        self.touching = self.on_rim[self.triangles].any(axis=1)

    def longest(self, chords):
        return self.lengths[self.is_chord if chords else self.is_inner & ~self.is_chord].max(initial=0.0)

    def smallest_inside(self):
        return self.angles[~self.touching].min(initial=180.0)

    def beyond_growth(self, growth):
        """By how many columns inner edges are longer than the distance of their triangles from the rim allows."""
        middles = self.corners[self.triangles].mean(axis=1)
        away = distances(middles, *(self.corners[self.rims[:, n]] for n in (0, 1)))
        own = numpy.where(self.is_inner[self.edge_of], self.lengths[self.edge_of], 0.0).max(axis=1)
        return (own - LEAST - growth * away).max(initial=-LEAST)


def flat(mesh):
    """The mesh in plan, on the lattice, for VTK."""
    data, points = vtkPolyData(), vtkPoints()
    corners = bound_check.lattice_points(mesh)
    points.SetData(numpy_to_vtk(numpy.column_stack([numpy.rint(corners[:, :2]), numpy.zeros(len(corners))]), deep=True))
    data.SetPoints(points)
    polys = vtkCellArray()
    polys.DeepCopy(mesh.GetPolys())
    data.SetPolys(polys)
    return data


def vtk_angles(mesh):
    quality = vtkMeshQuality()
    quality.SetInputData(flat(mesh))
    quality.SetTriangleQualityMeasureToMinAngle()
    quality.Update()
    return vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))


def horizon_of(mask, heights, turned=False):
    columns = numpy.argwhere(mask.T)[:, ::-1]  # row by row
    return bound_test.make_horizon(columns, heights[tuple(columns.T)], turned)


def random_mask(random, size):
    """Horizons whose columns are all there up to their outlines."""
    i, j = numpy.indices(size)
    kind = random.integers(4)
    if kind == 0:
        return numpy.ones(size, bool)
    if kind == 1:
        mask = bound_test.smooth(random, size, int(random.integers(2, 6))) > random.uniform(-0.5, 0.2)
    elif kind == 2:
        mask = i * random.uniform(0.1, 2.0) + random.integers(-1, 2, size) < j
    else:
        mask = numpy.ones(size, bool)
        for _ in range(random.integers(1, 8)):
            row, column = random.integers(0, size[0]), random.integers(0, size[1])
            mask[row : row + random.integers(1, 9), column : column + random.integers(1, 9)] = False
    mask[tuple(random.integers(0, size))] = True
    return mask


def with_faults(horizon, throw):
    faults = sh.vtkHorizonFaults()
    faults.SetSmallestThrow(throw)
    return bound_test.run(faults, horizon)


def make_even(horizon, error, length, growth=0.0, **options):
    """Without automatic choices, which would close holes: columns without points leave no place for vertices."""
    surface = sh.vtkHorizonSurface()
    given = dict(ErrorUnit=0, MaximumError=error, EdgeLength=length, EdgeGrowth=growth, AutomaticRadius=False, Radius=1,
                 AutomaticSmallestHoleSize=False, SmallestHoleSize=1, **options)
    for name, value in given.items():
        getattr(surface, "Set" + name)(value)
    return bound_test.run(surface, horizon)


SQUARE = (90, 90)
I, J = numpy.indices(SQUARE)
HARD = {
    **{f"strip of {width} columns": numpy.ones((width, 120), bool) for width in (1, 2, 3, 4, 5, 7)},
    "column": numpy.ones((1, 1), bool), "two rows": numpy.ones((2, 2), bool), "corner": I + J < 3,
    "comb of single columns": (I < 40) | (J % 2 == 0), "comb": (I < 40) | (J % 12 < 6),
    "slanted strip": abs(I - J) < 4, "slanted spur": abs(I - J) < 2, "gentle slant": (I * 7 > J - 20) & (I * 7 < J + 200),
    "wedge": (J > 0.2 * I) & (J < 0.5 * I), "needle": (J >= 0.3 * I) & (J <= 0.4 * I + 1),
    "disc": numpy.hypot(I - 45, J - 45) < 44, "ring": abs(numpy.hypot(I - 45, J - 45) - 35) < 2.5,
    "pinholes": (I % 10 != 5) | (J % 10 != 5), "slit": (I != 45) | (J < 5) | (J > 84), "saw": J < 60 + I % 5 * 4,
    "far patches": numpy.isin(numpy.indices((900, 90))[0] // 40, (0, 9, 22)),
}


class EvenTest(unittest.TestCase):
    def check_figures(self, horizon, mesh, even, error, name):
        self.assertEqual(bound_check.check(horizon, mesh, error, error)[:3], [], name)
        self.assertAlmostEqual(bound_check.value(mesh, "SmallestAngle"), even.angles.min(), delta=SLACK, msg=name)
        numpy.testing.assert_allclose(vtk_angles(mesh), even.angles, atol=SLACK, err_msg=str(name))

    def check_lengths(self, even, length, growth, name):
        self.assertLessEqual(max(even.longest(chords) for chords in (False, True)), length + SLACK, name)
        if growth > 0.0:
            # The distance, in steps from column to column, is up to a twelfth too large, and up to a column off.
            self.assertLessEqual(even.beyond_growth(1.09 * growth), growth + SLACK, name)

    def check_angles(self, even, length, name):
        """Sharp corners of outlines and narrow places reach some columns inwards."""
        away = distances(even.corners, *(even.corners[even.rims[:, n]] for n in (0, 1)))
        inside = (away[even.triangles] > max(2.0, length / 8)).all(axis=1)
        self.assertGreaterEqual(even.angles[inside].min(initial=180.0), ANGLE - SLACK, name)

    def test_random(self):
        """On horizons without missing columns."""
        below = total = 0
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            size = random.integers(5, 90, 2)
            horizon = horizon_of(random_mask(random, size), bound_test.random_heights(random, size), random.random() < 0.3)
            if random.random() < 0.3:
                horizon = with_faults(horizon, float(random.uniform(1.0, 20.0)))
            error = float(random.choice([0.0, 0.5, 1.0, 2.0, 5.0, 20.0, 1000.0]))
            length = float(random.choice([4.0, 5.5, 8.0, 12.0, 25.0, 100.0]))
            growth = float(random.choice([0.0, 0.0, 0.1, 0.3, 1.0]))
            mesh = make_even(horizon, error, length, growth, Effort=int(random.integers(2)), FitHeights=bool(random.integers(2)))
            if mesh.GetNumberOfPolys() == 0:
                continue
            even = EvenMesh(mesh)
            self.check_figures(horizon, mesh, even, error, seed)
            self.check_lengths(even, length, growth, seed)
            self.check_angles(even, length, seed)
            below += (even.angles < ANGLE - SLACK).sum()
            total += len(even.angles)
        self.assertLess(below, 0.005 * total)

    def test_ragged(self):
        """Where columns are missing, errors and figures still hold."""
        for seed in range(FIRST, FIRST + RUNS):
            random = numpy.random.default_rng(seed)
            horizon = bound_test.random_horizon(random)
            error = float(random.choice([0.0, 0.5, 2.0, 20.0]))
            surface = sh.vtkHorizonSurface()
            surface.SetMaximumError(error)
            surface.SetEdgeLength(float(random.choice([4.0, 8.0, 25.0])))
            surface.SetEdgeGrowth(float(random.choice([0.0, 0.3])))
            mesh = bound_test.run(surface, horizon)
            if mesh.GetNumberOfPolys() > 0:
                self.check_figures(horizon, mesh, EvenMesh(mesh), error, seed)

    def test_hard_outlines(self):
        for name, mask in HARD.items():
            horizon = horizon_of(mask, 0.5 * numpy.sin(0.1 * numpy.indices(mask.shape)[0]))
            for length, growth in ((4.0, 0.0), (10.0, 0.0), (10.0, 0.3), (500.0, 0.05)):
                mesh = make_even(horizon, 1.0, length, growth)
                if mesh.GetNumberOfPolys() > 0:
                    even = EvenMesh(mesh)
                    self.check_figures(horizon, mesh, even, 1.0, name)
                    self.check_lengths(even, length, growth, name)
                    self.check_angles(even, length, name)
                    # Edges of three columns leave no room in strips of four.
                    most = max(4, 0.04 * len(even.angles)) if growth == 0.0 else 0.2 * len(even.angles)
                    self.assertLessEqual((even.angles < ANGLE - SLACK).sum(), most, name)
                else:
                    self.assertIn(name, ("column", "strip of 1 columns"))

    def test_hard_heights(self):
        whole = numpy.ones(SQUARE, bool)
        random = numpy.random.default_rng(7)
        for name, heights in {"flat": 0.0 * I, "steep": 50.0 * I, "cliff": numpy.where(I > J, 300.0, 0.0),
                              "noise": 10.0 * random.normal(size=SQUARE), "bowl": 0.01 * (I - 40.0) ** 2}.items():
            for turned, length, growth in ((False, 4.0, 0.0), (False, 12.0, 0.0), (True, 30.0, 0.3)):
                horizon = horizon_of(whole, heights, turned)
                mesh = make_even(horizon, 1.0, length, growth)
                even = EvenMesh(mesh)
                if length > 4.0:
                    self.check_figures(horizon, mesh, even, 1.0, name)
                self.check_lengths(even, length, growth, name)
                self.assertGreaterEqual(even.smallest_inside(), ANGLE - SLACK, name)
                self.assertLessEqual((even.angles < ANGLE - SLACK).mean(), 0.01, name)

    def test_closed_faults(self):
        """The steep triangles that close cracks are not even; the others are as without them."""
        heights = numpy.where(I > 45 + 0.2 * J, 100.0, 0.0) + 0.1 * J
        horizon = with_faults(horizon_of(numpy.ones(SQUARE, bool), heights), 30.0)
        mesh = make_even(horizon, 1.0, 8.0, CloseFaults=True)
        is_fault = vtk_to_numpy(mesh.GetCellData().GetArray("Fault"))[-mesh.GetNumberOfPolys() :]
        even = EvenMesh(mesh, bound_check.cells(mesh.GetPolys(), 3)[is_fault == 0])
        self.assertGreater(is_fault.sum(), 0)
        self.check_lengths(even, 8.0, 0.0, "closed")
        self.assertGreaterEqual(even.angles.min(), ANGLE - SLACK)

    def test_layers(self):
        """The plan of layers, without and with lines where they pinch out."""
        waves = 40.0 + 5.0 * numpy.sin(0.1 * I)
        upper = horizon_of(numpy.ones(SQUARE, bool), waves)
        for heights in (3.0 * numpy.cos(0.07 * J), numpy.minimum(waves, 30.0 + 0.2 * I + 0.1 * J)):
            lower = horizon_of(numpy.ones(SQUARE, bool), heights)
            for domain, length, growth, lines in ((0, 8.0, 0.0, False), (0, 20.0, 0.3, False), (1, 8.0, 0.0, False), (0, 8.0, 0.0, True)):
                layers = sh.vtkHorizonLayers()
                for name, value in {"HeightUnit": 0, "MaximumError": 1.0, "EdgeLength": length, "EdgeGrowth": growth,
                                    "Domain": domain, "PinchOutLines": lines}.items():
                    getattr(layers, "Set" + name)(value)
                sh.apply(layers, vtk_inputs.collect({"upper": upper, "lower": lower}))
                plans = [EvenMesh(mesh) for mesh in sh.horizons_of(layers.GetOutputDataObject(2)).values()]
                self.assertEqual(len(plans), 2)
                for even in plans:
                    self.check_lengths(even, length, growth, "layers")
                    if not lines:
                        self.assertGreaterEqual(even.smallest_inside(), ANGLE - SLACK)
                    self.assertLess((even.angles < ANGLE - SLACK).mean(), 0.04 if lines else 0.01)

    @unittest.skipUnless(REAL.is_dir(), "no real horizons")
    def test_real(self):
        """Some columns are missing inside these."""
        for path in sorted(REAL.glob("*/*.ijz")):
            rows = numpy.array([line.split() for line in path.read_text().splitlines() if line[0] != "#"][1:], float)
            rows = rows[numpy.lexsort((rows[:, 0], rows[:, 1]))]
            horizon = bound_test.make_horizon(rows[:, :2].astype(int), rows[:, 2], False)
            for error, length, growth in ((3.0, 12.0, 0.0), (6.0, 30.0, 0.3), (3.0, 4.0, 0.0)):
                surface = sh.vtkHorizonSurface()
                surface.SetErrorUnitToSteps()
                surface.SetMaximumError(error)
                surface.SetEdgeLength(length)
                surface.SetEdgeGrowth(growth)
                mesh = bound_test.run(surface, horizon)
                even = EvenMesh(mesh)
                self.check_lengths(even, length, growth if len(rows) < 20_000 and path.stem != "segment" else 0.0, path.stem)
                if len(rows) < 100_000 and growth > 0.0:
                    self.check_figures(horizon, mesh, even, error, path.stem)
                is_narrow = even.angles < ANGLE - SLACK
                self.assertLess(is_narrow.mean(), 0.03 if path.stem == "segment" else 0.0015, path.stem)
                self.assertLessEqual((is_narrow & ~even.touching).sum(), 5, path.stem)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
