# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers of horizons with holes, gaps and ends, by missing_check.py: the ledger, and volumes that add up.

Arguments: how many random stacks (300 take some minutes), and the first seed, 0 unless told.
"""

import sys
import unittest
import warnings

import numpy as np

import missing_check
import vtk_inputs
from seismichorizons import vtk as sh

RUNS = int(sys.argv[1])
FIRST = int(sys.argv[2]) if len(sys.argv) > 2 else 0
POLICIES = ("Void", "Interpolate", "Follow")
ERROR = 1e-4
BIN = 25.0 * 12.5
ENTRIES = ("known", "filled", "bridged", "extrapolated", "left_out")


def random_mask(random, x, y, is_middle):
    """Where a horizon has points: without holes, a strip as of a fault, and a part of the survey."""
    mask = np.ones(x.shape, bool)
    for _ in range(random.integers(0, 6)):
        j, i = random.integers(0, x.shape[0]), random.integers(0, x.shape[1])
        mask[j:j + random.integers(1, 9), i:i + random.integers(1, 9)] = False
    if random.random() < 0.4:
        angle = random.uniform(0.0, np.pi)
        across = (x - x.mean()) * np.cos(angle) + (y - y.mean()) * np.sin(angle) + random.uniform(-6.0, 6.0)
        mask &= np.abs(across) > random.uniform(0.5, 4.0)
    if random.random() < (0.5 if is_middle else 0.15):
        angle = random.uniform(0.0, 2.0 * np.pi)
        mask &= (x - x.mean()) * np.cos(angle) + (y - y.mean()) * np.sin(angle) < random.uniform(-4.0, 10.0)
    if random.random() < 0.2:
        mask &= random.random(x.shape) < 0.9
    return mask


def random_stack(random):
    """Planes of horizons, upwards, which end where they would cross, and where each of them has points."""
    x, y = np.meshgrid(np.arange(random.integers(8, 30), dtype=float), np.arange(random.integers(8, 30), dtype=float))
    slopes = random.uniform(-0.3, 0.3, (2, 2))
    top = 100.0 + slopes[0, 0] * x + slopes[0, 1] * y
    thickness = random.uniform(12.0, 20.0) + 0.3 * slopes[1, 0] * x + 0.3 * slopes[1, 1] * y
    planes = [top]
    number = random.integers(1, 4)
    for n in range(number):
        tilt = random.uniform(-0.6, 0.6, 2)
        planes.append(top - (n + 1.0) / (number + 1.0) * thickness + tilt[0] * (x - x.mean()) + tilt[1] * (y - y.mean()))
    planes = np.array([*planes, top - thickness])
    masks = np.array([random_mask(random, x, y, 0 < n <= number) for n in range(len(planes))])
    for n in range(1, number + 1):
        masks[n] &= (planes[n] < planes[:n].min(axis=0)) & (planes[n] > planes[-1])
    return planes, masks


def make(stack, names=None, error=0.2, **keywords):
    horizons = {}
    for n, own in enumerate(stack):
        if names is None or n in names:
            horizons[chr(ord("A") + n)] = vtk_inputs.horizon(-own, spacing=(25.0, 12.5), azimuth=30.0, origin=(5e5, 6e6),
                                                             VerticalStep=1.0, VerticalDirection="Down")
    return vtk_inputs.layers(horizons, MaximumError=error, Order="AsGiven", **keywords)


def entries(data, name="ledger_columns"):
    """Of the ledger of a dataset, in order."""
    ledger = getattr(vtk_inputs.details(data), name)
    return [getattr(ledger, entry) for entry in ENTRIES]


def volumes(made):
    return np.array([own.volume for own in made.figures.values()])


class MissingTest(unittest.TestCase):
    def setUp(self):
        self.x, self.y = np.meshgrid(np.arange(120.0), np.arange(100.0))
        self.bumps = 5.0 * np.sin(self.x / 15.0) + 3.0 * np.cos(self.y / 11.0)

    def compare(self, top, middle, base, lost, **keywords):
        """Layers of the middle horizon have all that is between top and base; with Void they lose a part, and say so."""
        whole = volumes(make([top, base], KeepOutlines=True)).sum()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            made = {policy: make([top, middle, base], Missing=policy, **keywords) for policy in POLICIES}
        for policy, share in zip(POLICIES, lost):
            self.assertAlmostEqual(1.0 - volumes(made[policy]).sum() / whole, share, delta=0.001, msg=policy)
            without = sum(own.volume_without for own in made[policy].figures.values())
            self.assertAlmostEqual((volumes(made[policy]).sum() + without) / whole, 1.0, delta=0.001, msg=policy)
        with self.assertWarnsRegex(UserWarning, "A to B without .* % of its area .volume .*, expected all between its horizons"):
            make([top, middle, base], Missing="Void", **keywords)
        with self.assertWarnsRegex(UserWarning, "A to B with interpolated heights over part of its area"):
            default = make([top, middle, base], **keywords)
        self.assertEqual(default.figures, made["Follow"].figures)
        return made

    def test_holes(self):
        """Sixty small holes, closed by a surface like the one around them."""
        random, top = np.random.default_rng(0), -1000.0 + self.bumps
        middle = top - 30.0
        for _ in range(60):
            j, i = random.integers(0, 92), random.integers(0, 112)
            middle[j:j + random.integers(2, 8), i:i + random.integers(2, 8)] = np.nan
        made = self.compare(top, middle, top - 60.0, (0.1436, 0.0, 0.0))
        np.testing.assert_allclose(volumes(made["Follow"]) / volumes(made["Follow"]).sum(), 0.5, atol=0.001)
        mesh = made["Interpolate"].horizons["B"]
        self.assertGreater(entries(mesh)[1], 500)
        self.assertGreater(mesh.GetPointData().GetArray("Filled").GetRange()[1], 0.0)

    def test_ends(self):
        """A horizon that is picked until it meets the next one: the layer between them ends there."""
        top, base = -1000.0 + self.bumps, -1060.0 + self.bumps
        for meets in (top, base):
            middle = meets + np.where(meets is top, -1.0, 1.0) * 0.5 * (60.0 - self.x)
            middle[:, 60:] = np.nan
            made = self.compare(top, middle, base, (60.0 / 119.0, 60.0 / 119.0, 0.0))["Follow"]
            area = made.figures["A to B" if meets is top else "B to C"].area
            self.assertAlmostEqual(area / BIN, 60.0 * 99.0, delta=1.0)
            self.assertEqual(entries(made.bodies["A to B"]), [6000, 0, 0, 6000, 0])

    def test_faults(self):
        """Gaps of the heave of two dipping faults, in another place on each horizon, are closed along the fault."""
        stack = []
        for n in range(3):
            z = -1000.0 - 40.0 * n + 0.1 * self.x
            for first, throw in ((30.0, 20.0), (80.0, -15.0)):
                left = first + 4.0 * n * np.sign(throw) + 0.1 * self.y
                z = np.where((self.x > left) & (self.x < left + 5.0), np.nan, np.where(self.x >= left + 5.0, z - throw, z))
            stack.append(z)
        made = make(stack, Missing="Void")
        without = sum(own.volume_without for own in made.figures.values())
        self.assertGreater(without, 0.1 * volumes(made).sum())
        whole = BIN * 99.0 * 119.0
        for own in make(stack).figures.values():
            self.assertAlmostEqual(own.area, whole, delta=1e-6 * whole)
            self.assertEqual((own.area_without, own.area_extrapolated), (0.0, 0.0))
            self.assertGreater(own.area_filled, 0.05 * whole)

    def test_limits(self):
        """A hole that is too large follows the horizon nearer to it; every third line is closed, too."""
        top = -1000.0 + 0.0 * self.x
        middle = np.where((abs(self.x - 60.0) < 25.0) & (abs(self.y - 50.0) < 25.0), np.nan, -1010.0)
        with self.assertWarnsRegex(UserWarning, "20.01 % extrapolated"):
            made = make([top, middle, top - 60.0], LargestHoleSize=49 * 49 - 1)
        self.assertAlmostEqual(made.figures["A to B"].area / BIN, 99.0 * 119.0 - 48.0 * 48.0, delta=1e-6)
        with self.assertWarnsRegex(UserWarning, "20.01 % filled"):
            filled = make([top, middle, top - 60.0])
        self.assertAlmostEqual(filled.figures["A to B"].volume / BIN, 10.0 * 99.0 * 119.0, delta=1.0)
        lines = np.where((self.x % 3 == 0) & (self.y % 3 == 0), top - 20.0 + 0.1 * self.x, np.nan)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            sparse = make([top, lines, top - 60.0])
        self.assertAlmostEqual(volumes(sparse).sum() / BIN, 60.0 * 99.0 * 119.0, delta=200.0)
        with self.assertRaisesRegex(ValueError, "B with steps of 3 columns from point to point, expected 1"):
            make([top, lines, top - 60.0], Missing="Void")
        for keywords, message in (({"LargestGap": 256}, "largest gap 256, expected 0 to 255"),
                                  ({"LargestHoleSize": -1}, "largest hole size -1, expected at least 0")):
            with self.assertRaisesRegex(ValueError, message):
                make([top, middle, top - 60.0], **keywords)

    def test_progress(self):
        """It is told from begin to end, and what is asked to stop stops, in each tenth of the work."""
        top = -1000.0 + self.bumps
        stack = [top, top - 30.0 + 3.0 * np.sin(self.x * self.y / 50.0), top - 60.0]
        reports = []

        def run(stop_at):
            maker = sh.vtkHorizonLayers()
            maker.SetMaximumError(0.75)
            for own in stack:
                maker.AddInputDataObject(0, vtk_inputs.horizon(-own, VerticalStep=1.0))

            def listen(algorithm, _):
                reports.append(algorithm.GetProgress())
                if stop_at <= reports[-1] < 1.0:
                    algorithm.SetAbortExecuteAndUpdateTime()

            maker.AddObserver("ProgressEvent", listen)
            maker.Update()
            return maker.GetOutputDataObject(0).GetNumberOfCells()

        self.assertGreater(run(2.0), 1000)
        self.assertEqual(reports, sorted(reports))
        self.assertLess(np.diff([0.0, *reports, 1.0]).max(), 0.2)
        for tenth in range(1, 10):
            reports.clear()
            self.assertEqual(run(tenth / 10.0), 0)
            self.assertLess(max(own for own in reports if own < 1.0), tenth / 10.0 + 0.2)

    def test_filled_before(self):
        """Columns that an earlier stage filled count as filled."""
        top = -1000.0 + self.bumps
        middle = np.where((abs(self.x - 60.0) < 5.0) & (abs(self.y - 50.0) < 5.0), np.nan, top - 30.0)
        points = {name: vtk_inputs.horizon(-own, VerticalStep=1.0) for name, own in (("A", top), ("B", middle), ("C", top - 60.0))}
        points["B"] = sh.apply(sh.make("vtkHorizonHoleFilling"), points["B"])
        made = vtk_inputs.layers(points, MaximumError=0.5, Order="AsGiven", Missing="Void")
        self.assertEqual(entries(made.bodies["A to B"]), [12000 - 81, 81, 0, 0, 0])

    def test_random(self):
        checked = np.zeros(3, int)
        for seed in range(FIRST, FIRST + RUNS):
            random = np.random.default_rng(seed)
            planes, masks = random_stack(random)
            if not masks.any(axis=(1, 2)).all():
                continue
            limits = {"LargestHoleSize": int(random.choice([0, 5, 30, 2500])), "LargestGap": int(random.choice([0, 2, 20]))}
            with self.subTest(seed=seed), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                checked += self.check(planes, masks, limits)
        print("%d stacks with layers, %d whose volumes are known, %d that add up to those of top to base" % tuple(checked))
        self.assertGreater(checked.min(), 0.4 * RUNS)

    def check(self, planes, masks, limits):
        """Gives whether there are layers, their volumes are known, and they add up."""
        stack = np.where(masks, planes, np.nan)
        origins = missing_check.origins_of(stack, limits["LargestHoleSize"], limits["LargestGap"])
        heights = missing_check.follow(missing_check.fill_planes(stack, origins, planes), origins)
        whole = missing_check.present_layers(origins, 2)
        if any(not missing_check.present_layers(origins, policy).any() for policy in range(3)):
            return False, False, False
        for policy, name in enumerate(POLICIES):
            try:
                made = make(stack, error=ERROR, Missing=name, **limits)
            except ValueError as error:
                self.assertEqual(name, "Void")
                self.assertIn("columns from point to point, expected 1", str(error))
                continue
            self.check_ledger(made, missing_check.ledger_of(origins, policy))
            if heights is not None:
                self.check_volumes(made, heights, missing_check.present_layers(origins, policy), whole)
        return True, heights is not None, self.check_sum(stack, whole, limits)

    def check_ledger(self, made, expected):
        for own, columns in zip(made.figures.values(), expected):
            areas = np.array([getattr(own, "area_" + entry) for entry in ENTRIES])
            np.testing.assert_allclose(areas / BIN, columns, atol=1e-6)
        for name, body in made.bodies.items():
            self.assertEqual(entries(body), list(expected[list(made.figures).index(name)]))
            np.testing.assert_allclose(entries(body, "ledger_volume"), [
                getattr(made.figures[name], "volume_" + entry) for entry in ENTRIES], rtol=1e-9, atol=1e-6)

    def check_volumes(self, made, heights, present, whole):
        region, full = missing_check.Region(present), missing_check.Region(whole)
        for layer, own in enumerate(made.figures.values()):
            thickness = heights[layer] - heights[layer + 1]
            least, largest = region.volumes(layer, thickness)
            area = region.area[layer].sum()
            slack = 2.0 * (largest - least) + 2.0 * ERROR * area + 1e-6  # where blocks are twisted, as at the end of a horizon
            self.assertGreaterEqual(own.volume / BIN, least - slack)
            self.assertLessEqual(own.volume / BIN, largest + slack)
            by_columns = sum(getattr(own, "volume_" + entry) for entry in ENTRIES) / BIN
            self.assertAlmostEqual(by_columns, thickness[whole[layer]].sum(), delta=ERROR * whole[layer].sum() + 1e-6)
            lacking = 0.5 * (full.conflicts[layer] + region.conflicts[layer])
            self.assertAlmostEqual(own.area_without / BIN, full.area[layer].sum() - area, delta=lacking + 1e-6)

    def check_sum(self, stack, whole, limits):
        """With Follow, layers have all that is between top and base."""
        try:
            pair = make(stack, (0, len(stack) - 1), ERROR, KeepOutlines=True, **limits)
            made = make(stack, error=ERROR, Domain="Common", KeepOutlines=True, **limits)
        except ValueError:  # top and base have no column in common
            return False
        total, expected = volumes(made).sum() / BIN, volumes(pair).sum() / BIN
        is_bridged = any(own.area_bridged > 0.0 for own in (*made.figures.values(), *pair.figures.values()))
        self.assertAlmostEqual(total, expected, delta=4.0 * ERROR * whole[0].size + (0.001 * expected if is_bridged else 0.0))
        return True

    def test_directions(self):
        """Elevations of two files, one of which crosses sea level: signs alone would make it a depth."""
        x = np.arange(12.0) * np.ones((10, 1))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            top, base = (vtk_inputs.horizon(z, spacing=(25.0, 25.0), VerticalUnit="m") for z in (-100.0 + 20.0 * x, -400.0 - x))
        for run in (lambda: vtk_inputs.layers({"Top": top, "Base": base}), lambda: vtk_inputs.thickness(top, base)):
            with self.assertWarnsRegex(UserWarning, "z of the file increases (up|down)wards in .*VerticalDirection"):
                run()

    def test_one_unit(self):
        """Two depths, one of which does not say in what: it may be in feet."""
        x = np.arange(12.0) * np.ones((10, 1))
        top = vtk_inputs.horizon(100.0 + x, spacing=(25.0, 25.0), VerticalUnit="m")
        base = vtk_inputs.horizon(400.0 - x, spacing=(25.0, 25.0))
        for first, second, name in ((top, base, "the other horizon|Base"), (base, top, "the first one|Top|Base")):
            for run in (lambda: vtk_inputs.layers({"Top": first, "Base": second}), lambda: vtk_inputs.thickness(first, second)):
                with self.assertWarnsRegex(UserWarning, "z without a unit in (%s), taken as m as in " % name):
                    run()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
