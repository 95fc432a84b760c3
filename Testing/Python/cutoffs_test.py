# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cutoffs of generated horizons against truth by bisection, in turned surveys with oblong bins, far from the origin: what users see
of lines, polygons, tables and diagrams. Faults of all forms, picks of the wrong side, and picks that climb the fault.

Arguments: the program horizon-mesh, and a folder for files.
"""

import itertools
import math
import pathlib
import subprocess
import sys
import unittest
import warnings

import numpy as np
import seismichorizons as sh

PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
DEPTHS = (-1000.0, -1200.0, -1450.0)


class Survey:
    """Bins of a turned survey in UTM coordinates; u and v are along columns and rows."""

    def __init__(self, bins=(25.0, 25.0), azimuth=63.0, shape=(81, 81)):
        self.bins, self.azimuth, self.origin = bins, azimuth, np.array((612345.6, 6065432.1))
        turn = math.radians(90.0 - azimuth)
        self.turn = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
        self.u, self.v = np.meshgrid(np.arange(shape[1]) * bins[0], np.arange(shape[0]) * bins[1])

    def world(self, u, v):
        return self.origin + np.stack([u, v], -1) @ self.turn.T

    def local(self, places):
        return ((places[:, :2] - self.origin) @ self.turn).T

    def horizon(self, z, name):
        return sh.horizon(z, origin=self.origin, spacing=self.bins, azimuth=self.azimuth, direction="up", vertical_unit="m", horizontal_unit="m",
                          vertical_step=1.0, name=name)


class Fault:
    """The hanging wall is where n > offset(s, z); s is along strike, n across."""

    def __init__(self, name="F1", dip=60.0, strike=0.0, at=(900.0, 1000.0), offset=None):
        turn = math.radians(strike)
        self.name, self.at = name, np.array(at)
        self.across, self.along = np.array((math.cos(turn), math.sin(turn))), np.array((-math.sin(turn), math.cos(turn)))
        self.offset = offset or (lambda s, z: -(z + 1200.0) / math.tan(math.radians(dip)))

    def place(self, u, v):
        way = np.stack([u, v], -1) - self.at
        return way @ self.along, way @ self.across

    def distance(self, u, v, z):
        s, n = self.place(u, v)
        return n - self.offset(s, z)

    def height(self, surface, s):
        """Where a surface meets the fault, by bisection."""
        low, high = np.full(np.shape(s), -1e4), np.full(np.shape(s), 1e4)
        for _ in range(80):
            z = 0.5 * (low + high)
            place = self.at + np.multiply.outer(s, self.along) + self.offset(s, z)[..., None] * self.across
            above = surface(place[..., 0], place[..., 1]) > z
            low, high = np.where(above, z, low), np.where(above, high, z)
        return 0.5 * (low + high)

    def sticks(self, survey, places=np.linspace(-1300.0, 1300.0, 9), heights=np.linspace(-1900.0, -500.0, 8)):
        lines = []
        for s in places:
            n = self.offset(np.full(len(heights), s), heights)
            on_map = self.at + s * self.along + n[:, None] * self.across
            lines.append(np.column_stack((survey.world(*on_map.T), heights)))
        return sh.Lines([self.name] * len(lines), lines, [str(n) for n in range(len(lines))], direction="up", vertical_unit="m", vertical_domain="depth",
                        horizontal_unit="m")


def folded(z):
    return lambda u, v: z + 25.0 * np.sin(u / 420.0) * np.cos(v / 560.0) + 0.02 * (v - 1000.0)


def moved(surface, throw):
    return lambda u, v: surface(u, v) - (throw(u, v) if callable(throw) else throw)


def pick(survey, fault, foot, hanging, noise=0.0, wrong=0.0, climb=0.0, seed=1):
    """One pick per column. A tracker follows the footwall for `wrong` metres beyond its cutoff, or climbs the fault over `climb`."""
    random = np.random.default_rng(seed)
    foot, hanging = foot(survey.u, survey.v), hanging(survey.u, survey.v)
    on_foot, on_hanging = fault.distance(survey.u, survey.v, foot) < 0.0, fault.distance(survey.u, survey.v, hanging) > 0.0
    z = np.where(on_hanging, hanging, np.where(on_foot, foot, np.nan))
    middle = fault.distance(survey.u, survey.v, 0.5 * (foot + hanging))
    z = np.where(on_foot & on_hanging & (middle < 0.0), foot, z)
    if wrong:
        beyond = fault.distance(survey.u, survey.v, foot)
        z = np.where((beyond >= 0.0) & (beyond < wrong), foot, z)
    if climb:
        z = foot + (hanging - foot) * np.clip(middle / climb + 0.5, 0.0, 1.0)
    return z + random.normal(0.0, noise, z.shape) if noise else z


def errors_of(found, survey, fault, name, foot, hanging):
    """Height errors of all vertices against truth, and whether places are guessed."""
    errors, guessed = [], []
    lines = found.lines[name]
    for line, stick, profile in zip(lines, lines.sticks, found.profiles[name]):
        s, n = fault.place(*survey.local(line))
        errors.append(line[:, 2] - fault.height(foot if stick == "footwall" else hanging, s))
        guessed.append(profile.guessed)
        assert np.abs(n - fault.offset(s, line[:, 2])).max() < 4.0, "off the fault"
    return np.concatenate(errors), np.concatenate(guessed)


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


class CutoffsTest(unittest.TestCase):
    def find(self, fault, throw=90.0, survey=None, **picks):
        survey = survey or Survey()
        foot = folded(DEPTHS[1])
        hanging = moved(foot, throw)
        horizon = survey.horizon(pick(survey, fault, foot, hanging, **picks), "H")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = sh.cutoffs(horizon, fault.sticks(survey), largest_error=0.0)
        return found, *errors_of(found, survey, fault, "H", foot, hanging)

    def test_faults_of_all_forms(self):
        curved = Fault(offset=lambda s, z: -(z + 1200.0) / 1.5 + 120.0 * np.sin(s / 500.0))
        listric = Fault(offset=lambda s, z: 0.0 * s - (z + 1200.0) * 0.9 + 3e-4 * (z + 1200.0) ** 2)
        for fault, throw in ((Fault(), 90.0), (Fault(dip=35.0, strike=30.0), 60.0), (Fault(dip=85.0, strike=205.0), 90.0), (curved, 90.0),
                             (listric, 90.0), (Fault(), -60.0), (Fault(), lambda u, v: 40.0 + 0.05 * v)):
            found, errors, guessed = self.find(fault, throw)
            with self.subTest(fault=vars(fault), throw=throw):
                self.assertLess(rms(errors), 0.2)
                self.assertLess(np.mean(guessed > 0), 0.2)
                self.assertGreater(len(errors), 100)

    def test_trackers_that_go_wrong(self):
        """Within two deviations of the noise, in bins of both shapes."""
        for bins, columns in itertools.product(((25.0, 25.0), (25.0, 12.5), (12.5, 25.0)), (1, 3, 5)):
            survey = Survey(bins, shape=(int(2000.0 / bins[1]) + 1, int(2000.0 / bins[0]) + 1))
            _, errors, _ = self.find(Fault(), survey=survey, noise=2.0, wrong=columns * bins[0])
            with self.subTest(bins=bins, columns=columns):
                self.assertLess(rms(errors), 4.0)

    def test_picks_that_climb_are_no_bend(self):
        for columns in (2, 3, 4, 6):
            found, _, _ = self.find(Fault(dip=85.0), climb=columns * 25.0)
            self.assertAlmostEqual(found.figures["throw_mean"][0], 90.0, delta=9.0)

    def test_noise_is_told(self):
        """Of places that are off by more than three times their spread there are few, and walls are not exchanged."""
        found, errors, _ = self.find(Fault(dip=45.0, strike=70.0), noise=3.0)
        spreads = np.concatenate([profile.spread for profile in found.profiles["H"]])
        self.assertLess(np.mean(np.isnan(spreads)), 0.05)
        self.assertLess(np.mean(np.abs(errors) > 3.0 * spreads), 0.03)
        self.assertGreater(found.figures["throw_least"][0], 60.0)

    def test_tips(self):
        survey, fault = Survey(azimuth=90.0), Fault(dip=70.0)
        throw = lambda u, v: 100.0 * np.maximum(0.0, 1.0 - ((v - 1000.0) / 600.0) ** 2)  # noqa: E731
        foot = folded(DEPTHS[1])
        horizon = survey.horizon(pick(survey, fault, foot, moved(foot, throw)), "H")
        found = sh.cutoffs(horizon, fault.sticks(survey, np.linspace(-550.0, 550.0, 9)), largest_error=0.0)
        polygon, = found.polygons["H"]
        np.testing.assert_array_equal(polygon[0], polygon[-1])
        self.assertEqual(found.figures["tips"][0], 2)
        s, _ = fault.place(*survey.local(found.lines["H"].lines[0]))
        np.testing.assert_allclose([min(s), max(s)], [-618.75, 618.75], atol=2.0)  # half the distance of sticks beyond the last
        for profile in found.profiles["H"]:
            self.assertEqual([profile.throw[0], profile.throw[-1]], [0.0, 0.0])
            self.assertEqual([profile.guessed[0], profile.guessed[-1]], [2, 2])

    def test_figures_and_areas(self):
        """On level horizons at a plane: exact areas, and figures that are sums over the lines."""
        survey, fault = Survey(), Fault()
        horizons = {}
        for number, depth in enumerate(DEPTHS):
            level = lambda u, v, depth=depth: np.full(np.shape(u), depth)  # noqa: E731
            horizons["ABC"[number]] = survey.horizon(pick(survey, fault, level, moved(level, 90.0)), "ABC"[number])
        found = sh.cutoffs(horizons, fault.sticks(survey), largest_error=0.0)
        areas = {(foot, hanging): area for foot, hanging, area in zip(found.areas["footwall"], found.areas["hanging_wall"], found.areas["area"])}
        along = found.profiles["A"][0].along
        unit = (along[-1] - along[0]) / math.sin(math.radians(60.0))
        expected = {("A to B", "above A"): 90.0, ("A to B", "A to B"): 110.0, ("B to C", "A to B"): 90.0, ("B to C", "B to C"): 160.0,
                    ("below C", "B to C"): 90.0}
        self.assertEqual(areas.keys(), expected.keys())
        for pair, height in expected.items():
            self.assertAlmostEqual(areas[pair] / (height * unit), 1.0, delta=1e-9)
        np.testing.assert_allclose(found.figures["throw_mean"], 90.0, atol=1e-6)
        np.testing.assert_allclose(found.figures["heave_mean"], 90.0 / math.tan(math.radians(60.0)), atol=1e-6)
        diagram = found.diagrams["F1"]
        x, z = diagram.corners[..., 0], diagram.corners[..., 1]
        shoelace = 0.5 * np.abs(np.sum(x * np.roll(z, -1, 1) - np.roll(x, -1, 1) * z, 1))
        of_pair = sum(area for area, *pair in zip(shoelace, diagram.footwall, diagram.hanging_wall) if tuple(pair) == ("A to B", "A to B"))
        self.assertAlmostEqual(of_pair / (110.0 * (along[-1] - along[0])), 1.0, delta=1e-9)

    def test_a_fault_beside(self):
        """Two faults eight columns apart, and the block between them."""
        survey = Survey()
        faults = [Fault("F1"), Fault("F2", at=(1100.0, 1000.0))]
        foot = folded(DEPTHS[1])
        walls = [foot, moved(foot, 60.0), moved(foot, 100.0)]
        z = np.full(survey.u.shape, np.nan)
        for wall, surface in enumerate(walls):
            own = surface(survey.u, survey.v)
            sides = [fault.distance(survey.u, survey.v, own) > 0.0 for fault in faults]
            z = np.where((sides[0] == (wall > 0)) & (sides[1] == (wall > 1)), own, z)
        sticks = [fault.sticks(survey) for fault in faults]
        found = sh.cutoffs(survey.horizon(z, "H"), sticks, largest_error=0.0)
        self.assertEqual(found.names, ["F1", "F2"])
        np.testing.assert_allclose(found.figures["throw_mean"], [60.0, 40.0], atol=0.5)
        self.assertEqual(len(found.lines["H"]), 4)

    def test_cuts_and_surfaces_as_faults(self):
        """Without sticks the gap gives the heave; the surfaces that were used give the same again."""
        survey, fault = Survey(), Fault()
        foot = folded(DEPTHS[1])
        horizon = survey.horizon(pick(survey, fault, foot, moved(foot, 90.0)), "H")
        found = sh.cutoffs(horizon, sh.faults(horizon))
        self.assertEqual(found.names, ["H fault 1"])
        self.assertAlmostEqual(found.figures["throw_mean"][0], 90.0, delta=1.0)
        self.assertAlmostEqual(found.figures["heave_mean"][0], 52.0, delta=15.0)
        dipping = sh.cutoffs(horizon, sh.faults(horizon), dip=60.0)
        self.assertAlmostEqual(dipping.figures["heave_mean"][0], 52.0, delta=1.0)
        exact = sh.cutoffs(horizon, fault.sticks(survey))
        again = sh.cutoffs(horizon, exact.faults)
        np.testing.assert_allclose(again.figures["throw_mean"], exact.figures["throw_mean"], atol=0.1)

    def test_what_is_left_out_is_told(self):
        survey, fault = Survey(), Fault()
        foot = folded(DEPTHS[1])
        horizon = survey.horizon(pick(survey, fault, foot, moved(foot, 90.0)), "H")
        far = Fault("Far", at=(9000.0, 1000.0))
        alone = sh.Lines(["Alone"], [fault.sticks(survey).lines[0]], ["1"], direction="up")
        bent = Fault("Bent", offset=lambda s, z: np.sqrt(np.maximum(0.0, 1200.0 ** 2 - s ** 2)) - 900.0 - 0.5 * (z + 1200.0))
        for faults, text in (([fault.sticks(survey), far.sticks(survey)], "1 of 2 faults (Far) cut no horizon"),
                             ([fault.sticks(survey), alone], "1 fault sticks (Alone) form no surface"),
                             ([fault.sticks(survey), bent.sticks(survey, np.linspace(-1190.0, 1190.0, 15))], "turn too far along strike (Bent)")):
            with self.assertWarnsRegex(UserWarning, text.replace("(", r"\(").replace(")", r"\)")):
                sh.cutoffs(horizon, faults)
        level = sh.Lines(["L"] * 2, [np.array([(x, y, -1200.0) for y in (0.0, 900.0)]) + [*survey.origin, 0.0] for x in (0.0, 400.0)], ["1", "2"], direction="up")
        for faults, text in ((far.sticks(survey), "expected picks on both sides"), (level, "fault L with picks at one height"),
                             (sh.faults(horizon, "500 m"), "horizons without faults"), ([], "no fault among")):
            with self.assertRaisesRegex(ValueError, text):
                sh.cutoffs(horizon, faults)
        with self.assertRaisesRegex(ValueError, "dip 2, expected 5 to 90 degrees, or 0"):
            sh.cutoffs(horizon, fault.sticks(survey), dip=2.0)

    def test_command(self):
        """Tables, cutoffs and polygons of files, which are read as they were written."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        survey, fault = Survey(), Fault()
        for number, depth in enumerate(DEPTHS[:2]):
            foot = folded(depth)
            sh.write(survey.horizon(pick(survey, fault, foot, moved(foot, 90.0)), "AB"[number]), FOLDER / ("%s.dat" % "AB"[number]))
        sh.write(fault.sticks(survey), FOLDER / "sticks.dat")
        subprocess.run([sys.executable, PROGRAM, "--cutoffs", "--fault-sticks", "sticks.dat", "--vertical-direction", "Up", "--output-folder", "out", "--no-pictures",
                        "A.dat", "B.dat"], cwd=FOLDER, check=True, capture_output=True)
        self.assertIn("A to B", (FOLDER / "out" / "stack_juxtaposition.csv").read_text())
        rows = (FOLDER / "out" / "stack_throws.csv").read_text().splitlines()
        self.assertEqual(len(rows), 3)
        polygons = sh.read_faults(FOLDER / "out" / "stack_A_fault_polygons.dat", direction="up")
        np.testing.assert_array_equal(polygons.lines[0][0], polygons.lines[0][-1])
        again = sh.read_faults(FOLDER / "out" / "stack_A_cutoffs.dat", direction="up")
        self.assertEqual(again.sticks, ["footwall", "hanging wall"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
