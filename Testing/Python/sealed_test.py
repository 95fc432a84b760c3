# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sealed models in turned surveys far from the origin: volumes, sides, the account of picks, what is said, and files.

Arguments: the program horizon-mesh, and a folder for files.
"""

import importlib.util
import math
import pathlib
import subprocess
import sys
import unittest
import warnings

import numpy as np
import sealed_programs
import seismichorizons as sh

PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
DEPTHS = {"A": -1000.0, "B": -1200.0, "C": -1450.0}
SIZE, LEVELS = 2000.0, 200  # of the survey; for true volumes
SLOPE = 1.0 / math.tan(math.radians(60.0))
ORIGIN, TURN = np.array((612345.6, 6065432.1)), math.radians(27.0)


def turned(u, v, angle=TURN, origin=ORIGIN):
    return origin + np.stack([u, v], -1) @ np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])


class Graben:
    """F2 dips against F1, in its hanging wall."""

    faults = {"F1": (700.0, 1.0), "F2": (1200.0, -1.0)}  # u at -1200, and the side of the hanging wall
    throws = {"F1": 120.0, "F2": 60.0}

    def __init__(self, bins=(25.0, 20.0), rough=0.0):
        self.bins, self.rough = bins, rough
        self.u, self.v = np.meshgrid(np.arange(SIZE / bins[0] + 1) * bins[0], np.arange(SIZE / bins[1] + 1) * bins[1])

    def hanging(self, name, u, z):
        at, side = self.faults[name]
        return side * (u - at) + SLOPE * (z + 1200.0) > 0.0

    def foot(self, name, u, v):
        return DEPTHS[name] + 25.0 * np.sin(u / 420.0) * np.cos(v / 560.0)

    def picks(self, name):
        """NaN where the horizon is cut out."""
        z, foot = np.full(self.u.shape, np.nan), self.foot(name, self.u, self.v)
        for sides, drop in (((False, None), 0.0), ((True, False), 120.0), ((True, True), 180.0)):
            height = foot - drop
            own = self.hanging("F1", self.u, height) == sides[0]
            z = np.where(own if sides[1] is None else own & (self.hanging("F2", self.u, height) == sides[1]), height, z)
        return z + self.rough * np.random.default_rng(len(name)).normal(size=z.shape)

    def horizons(self, change=lambda name, z: z, **options):
        """Options of columns may be overridden, as in left-handed surveys."""
        return {name: sh.horizon(change(name, self.picks(name)), **{**dict(origin=ORIGIN, spacing=self.bins, azimuth=63.0, direction="up", vertical_unit="m",
                                 vertical_step=1.0, name=name), **options}) for name in DEPTHS}

    def sticks(self, slope=SLOPE, **more):
        z = np.linspace(-600.0, -2000.0, 8)
        lines = [(name, np.column_stack((turned(at - side * slope * (z + 1200.0), np.full(8, v)), z)))
                 for name, (at, side) in {**self.faults, **more}.items() for v in np.arange(-300.0, 2400.0, 300.0)]
        return sh.Lines([name for name, _ in lines], [line for _, line in lines], direction="up", vertical_unit="m")

    def volumes(self, least, most):
        """By layer, in a box of these heights."""
        u, v = np.meshgrid((np.arange(LEVELS) + 0.5) * SIZE / LEVELS, (np.arange(LEVELS) + 0.5) * SIZE / LEVELS)
        sums = np.zeros(len(DEPTHS) + 1)
        for z in least + (np.arange(LEVELS) + 0.5) * (most - least) / LEVELS:
            drop = np.where(self.hanging("F1", u, z), 120.0 + np.where(self.hanging("F2", u, z), 60.0, 0.0), 0.0)
            layer = sum((z < self.foot(name, u, v) - drop).astype(int) for name in DEPTHS)
            sums += np.bincount(layer.ravel(), minlength=len(sums))
        return sums * SIZE * SIZE * (most - least) / LEVELS ** 3


def sealed(horizons, faults, **options):
    """The model, and what was said."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        model = sh.sealed(horizons, faults, **{"largest_error": 1.0, "endings": "F2 > F1", **options})
    return model, " | ".join(str(one.message) for one in said)


def layers(model):
    return np.array([sum(volume for own, volume in zip(model.figures["layer"], model.figures["volume"]) if own == layer)
                     for layer in ("above A", "A to B", "B to C", "below C")])


class SealedTest(unittest.TestCase):
    def test_volumes_and_sides(self):
        """In right- and left-handed surveys, with oblong bins."""
        graben = Graben()
        faults, rows = graben.sticks(), graben.u.shape[0]
        across = turned(np.array([25.0]), np.array([0.0]), origin=0.0)[0], turned(np.array([0.0]), np.array([-20.0]), origin=0.0)[0]
        left = dict(origin=turned(np.array([0.0]), np.array([20.0 * (rows - 1)]))[0], spacing=None, azimuth=None, column_step=across[0], row_step=across[1])
        for horizons in (graben.horizons(), graben.horizons(lambda _, z: z[::-1], **left)):
            model, said = sealed(horizons, faults)
            self.assertEqual((len(model), said), (12, ""))
            box = model.points[:, 2].min(), model.points[:, 2].max()
            np.testing.assert_allclose(layers(model), graben.volumes(*box), rtol=1e-3)
            self.assertAlmostEqual(model.figures["volume"].sum() / (SIZE * SIZE * (box[1] - box[0])), 1.0, 9)
            corners = model.points[model.triangles] - [*ORIGIN, 0.0]
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            self.assertTrue((normals[model.surface_type == 0, 2] > 0.0).all())
            parts = np.einsum("ij,ij->i", corners[:, 0], normals) / 6.0
            volumes = np.zeros(len(model))
            for side, sign in ((model.body_above, -1.0), (model.body_below, 1.0)):
                np.add.at(volumes, side[side >= 0], sign * parts[side >= 0])
            np.testing.assert_allclose(volumes, model.figures["volume"], rtol=1e-9)
            for number, one in enumerate(model.surface):
                if one in graben.faults:
                    above = model.names[model.body_above[number]]
                    self.assertIn(one + " hanging wall", above)
                    self.assertIn(one + " footwall", model.names[model.body_below[number]])
    
    def test_picks_are_accounted_for(self):
        graben = Graben()

        def change(name, z):
            z = z.copy()
            z[20:40, 10:30] = np.nan
            if name == "B":
                z -= 300.0 * np.exp(-((graben.u - 1600.0) / 150.0) ** 2)
            if name == "C":
                z += 400.0 * np.exp(-((graben.u - 1600.0) / 150.0) ** 2)
            return z

        horizons = graben.horizons(change)
        model, said = sealed(horizons, graben.sticks())
        for number, horizon in enumerate(horizons.values()):
            given = np.isfinite(horizon.z).sum() if np.ndim(horizon.z) == 2 else len(horizon.z)
            own = sum(model.picks[kind][number] for kind in ("used", "beside_faults", "not_agreeing", "doubled", "outside"))
            self.assertEqual(own, given)
        self.assertGreater(model.picks["moved"][2], 100)
        self.assertIn("C moved at %d picks" % model.picks["moved"][2], said)

    def test_what_is_said(self):
        graben = Graben()
        horizons, faults = graben.horizons(), graben.sticks()
        _, said = sealed(horizons, faults, endings="")
        self.assertIn("endings chosen automatically", said)
        model, said = sealed(graben.horizons(lambda _, z: np.where((graben.u > 300.0) & (graben.u < 600.0), np.nan, z)), faults)
        self.assertIn("A continued over", said)
        self.assertEqual(set(model.guessed), {0, 1})

        def take_away(name, z):
            """All but four picks of B in the footwall of F1."""
            left = np.where(graben.hanging("F1", graben.u, z), z, np.nan)
            left[[0, 0, -1, -1], [0, 1, 0, 1]] = z[[0, 0, -1, -1], [0, 1, 0, 1]]
            return left if name == "B" else z

        model, said = sealed(graben.horizons(take_away), faults)
        self.assertIn("B without picks in the block F1 footwall", said)
        self.assertIn(2, model.guessed)

    def test_sticks_that_do_not_fit(self):
        graben = Graben()
        horizons = graben.horizons()
        _, said = sealed(horizons, graben.sticks(F2=(900.0, -1.0)))
        self.assertRegex(said, "parts of faults left out \\(F2 in the (footwall|hanging wall) of F1, [1-9][0-9] % of it\\)")
        model, said = sealed(horizons, graben.sticks(F3=(1800.0, 1.0)))
        self.assertIn("faults without a throw (F3)", said)
        self.assertIn("F3", model.surface)
        near = sealed(horizons, graben.sticks(F3=(760.0, 1.0)), endings="F2 > F1; F3 > F1; F2 > F3")[0]
        self.assertIn("F3", near.surface)

    def test_unconformities(self):
        """A fault that ends below one may be larger than those that cut it, or smaller."""
        v, u = np.mgrid[0:60, 0:80] * 25.0
        foots, throws, volumes = {"F1": 600.0, "F2": 1400.0}, {"F1": 60.0, "F2": 60.0}, []
        horizons = [sh.horizon(sum((np.where(u > foots[fault] - 0.5 * (z + 1200.0), -throw, 0.0) for fault, throw in own.items()), z), origin=(0.0, 0.0), spacing=(25.0, 25.0),
                               azimuth=90.0, direction="up", vertical_unit="m", vertical_step=1.0, name=name)
                    for name, z, own in (("U", -800.0, {"F2": 40.0}), ("A", -1300.0, throws), ("B", -1900.0, throws))]
        for bottom in (-2000.0, -1500.0):
            lines = [(fault, np.column_stack((foots[fault] - 0.5 * (z + 1200.0), np.full(8, y), z))) for y in np.arange(-100.0, 1700.0, 200.0)
                     for fault, z in (("F1", np.linspace(-900.0, bottom, 8)), ("F2", np.linspace(-600.0, -1450.0, 8)))]
            model, _ = sealed(horizons, sh.Lines([fault for fault, _ in lines], [line for _, line in lines], direction="up", vertical_unit="m"), endings="", unconformities="U", tips="through")
            above = {block for layer, block in zip(model.figures["layer"], model.figures["block"]) if layer == "above U"}
            self.assertEqual((len(model), above), (11, {"F2 hanging wall", "F2 footwall"}))
            volumes.append([sum(volume for own, volume in zip(model.figures["layer"], model.figures["volume"]) if own == layer) for layer in ("U to A", "A to B")])
        np.testing.assert_allclose(volumes[0], volumes[1], rtol=0.001)
        eroded = sh.horizon(np.where(u < 500.0, np.nan, -1300.0 - np.where(u > 600.0 - 0.5 * -100.0, 60.0, 0.0)), origin=(0.0, 0.0), spacing=(25.0, 25.0), azimuth=90.0,
                            direction="up", vertical_unit="m", vertical_step=1.0, name="A")
        model, _ = sealed([horizons[0], eroded, horizons[2]], sh.Lines([fault for fault, _ in lines], [line for _, line in lines], direction="up", vertical_unit="m"),
                          endings="", unconformities="U")
        self.assertAlmostEqual(np.ptp(model.points[:, 0]), 1975.0)

    def test_outline(self):
        """Walls follow an L with ragged edges, holes and one spur, with few corners."""
        graben, random = Graben(), np.random.default_rng(5)
        across, along = 1300.0 + random.uniform(-30.0, 30.0, graben.u.shape), 1200.0 + random.uniform(-30.0, 30.0, graben.u.shape)
        out = (graben.u > across) & (graben.v > along)
        out[70, 52:70] = False  # a spur
        out |= random.uniform(size=out.shape) < 0.05
        horizons = graben.horizons(lambda _, z: np.where(out, np.nan, z))
        model, _ = sealed(horizons, graben.sticks(), outline="picks")
        walls = {name for name, kind in zip(model.surface, model.surface_type) if kind == 2}
        self.assertTrue(6 <= len(walls) <= 32, walls)
        on = model.points[np.unique(model.triangles[model.surface_type == 2])]
        u, v = ((on[:, :2] - ORIGIN) @ np.array([[math.cos(TURN), -math.sin(TURN)], [math.sin(TURN), math.cos(TURN)]])).T
        inner = np.where((u < 1300.0) | (v < 1200.0), np.maximum(1300.0 - u, 1200.0 - v), np.minimum(u - 1300.0, v - 1200.0))
        away = np.min([u, v, SIZE - u, SIZE - v, np.abs(inner)], axis=0)
        self.assertLess(np.quantile(away, 0.9), 75.0)
        self.assertLess(away.max(), 210.0)  # Hops of eight columns cut the corner at the spur.
        height = np.ptp(model.points[:, 2])
        self.assertLess(abs(model.figures["volume"].sum() / height / (SIZE ** 2 - 700.0 * 800.0) - 1.0), 0.03)
        words = ("used", "beside_faults", "not_agreeing", "doubled", "outside")
        for n, horizon in enumerate(horizons.values()):
            self.assertEqual(sum(model.picks[word][n] for word in words), len(horizon))
        self.assertGreater(min(model.picks["outside"]), 0)
        with self.assertRaisesRegex(ValueError, "outline 'hull', expected box or picks"):
            sealed(horizons, graben.sticks(), outline="hull")

    def test_tips(self):
        """A fault dies out at both ends of its sticks: a slit in four bodies, in place of eight."""
        graben = Graben()
        throw = 90.0 * np.clip(1.0 - ((graben.v - 1000.0) / 550.0) ** 2, 0.0, None)
        horizons = {}
        for name in DEPTHS:
            foot = graben.foot(name, graben.u, graben.v)
            z = np.where(graben.hanging("F1", graben.u, foot - throw), foot - throw, np.where(graben.hanging("F1", graben.u, foot), np.nan, foot))
            horizons[name] = sh.horizon(z, origin=ORIGIN, spacing=graben.bins, azimuth=63.0, direction="up", vertical_unit="m", vertical_step=1.0, name=name)
        z = np.linspace(-600.0, -2000.0, 8)
        sticks = sh.Lines(["F1"] * 11, [np.column_stack((turned(700.0 - SLOPE * (z + 1200.0), np.full(8, v)), z)) for v in np.arange(500.0, 1501.0, 100.0)],
                          direction="up", vertical_unit="m")
        through, _ = sealed(horizons, sticks, endings="", tips="through")
        model, said = sealed(horizons, sticks, endings="")
        self.assertEqual((len(through), len(model), model.names[0]), (8, 4, "above A"))
        layers = [sum(volume for own, volume in zip(through.figures["layer"], through.figures["volume"]) if own == layer) for layer in model.figures["layer"]]
        np.testing.assert_allclose(model.figures["volume"], layers, rtol=0.002)
        slit = model.triangles[model.body_above == model.body_below]
        self.assertEqual({model.surface[n] for n in np.flatnonzero(model.body_above == model.body_below)}, {"F1"})
        _, v = ((model.points[slit.ravel(), :2] - ORIGIN) @ np.array([[math.cos(TURN), -math.sin(TURN)], [math.sin(TURN), math.cos(TURN)]])).T
        self.assertTrue(430.0 < v.min() < 480.0 and 1520.0 < v.max() < 1570.0, (v.min(), v.max()))
        self.assertNotIn("beyond their", said)
        self.assertIn("tip", model.lines.names)
        for body in model.bodies:
            edges = np.sort(np.concatenate([body.triangles[:, [0, 1]], body.triangles[:, [1, 2]], body.triangles[:, [2, 0]]]), axis=1)
            self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())
        for ending in ("ml", "msh", "stl"):
            FOLDER.mkdir(parents=True, exist_ok=True)
            model.write(FOLDER / ("tips." + ending))
        if importlib.util.find_spec("opengeode_geosciencesio"):
            self.assertEqual(sealed_programs.inspect_structure(FOLDER / "tips.ml"), (4, 0))
        level = graben.sticks()
        level = sh.Lines(level.names, [line[(line[:, 2] < -900.0) & (line[:, 2] > -1650.0)] for line in level.lines], direction="up", vertical_unit="m")
        self.assertEqual(len(sealed(graben.horizons(), level)[0]), 8)  # Sticks of both faults end at one height, above A and below C.
        short = sh.Lines(["F1"] * 3, [line for line in sticks.lines[4:7]], direction="up", vertical_unit="m")
        longer, said = sealed(horizons, short, endings="")
        self.assertRegex(said, r"faults whose throw continues beyond their sticks \(F1 by [23][0-9][0-9]")
        self.assertEqual(len(longer), 4)

    def test_upright_faults(self):
        """The hanging wall is where horizons are lower."""
        graben = Graben()
        graben.faults = {"F1": (1010.0, 1.0)}
        for step in (80.0, -80.0):
            z = np.where(graben.u > 1010.0, -1200.0 - step, -1200.0)
            horizon = sh.horizon(z, origin=ORIGIN, spacing=graben.bins, azimuth=63.0, direction="up", vertical_unit="m", vertical_step=1.0, name="A")
            model, _ = sealed([horizon], graben.sticks(slope=0.0), endings="")
            flat = np.flatnonzero(model.surface_type == 0)
            heights = model.points[model.triangles[flat], 2].mean(1)
            hanging = np.array(["hanging" in model.names[model.body_below[n]] for n in flat])
            self.assertLess(heights[hanging].max(), heights[~hanging].min())

    def test_refused(self):
        graben = Graben()
        horizons, faults = graben.horizons(), graben.sticks()
        twice = sh.Lines(faults.names + ["F3"] * 9, faults.lines + faults.lines[:9], direction="up", vertical_unit="m")
        in_time = sh.Lines(faults.names, faults.lines, direction="up", vertical_unit="ms", vertical_domain="time")
        for given, sticks, options, text in (
                (horizons, faults, {"endings": "F9 > F1"}, "fault F9 in Endings, expected the name of a given fault"),
                (horizons, faults, {"endings": "F2 > F1; F1 > F2"}, "expected rules without cycles"),
                (horizons, faults, {"endings": "F2, F1"}, "ending F2, F1, expected a fault, >"),
                (horizons, faults, {"unconformities": "D"}, "unconformity D, expected the name of a horizon"),
                (horizons, faults, {"unconformities": "A"}, "unconformities at which no fault ends"),
                (horizons, faults, {"largest_error": 0.0}, "maximum error 0, expected more"),
                (horizons, twice, {}, "within a column of F1, expected one of them"),
                (graben.horizons(vertical_unit="ms"), in_time, {}, "horizons in time, expected depth"),
                (graben.horizons(spacing=None, azimuth=None, column_step=(25.0, 0.0), row_step=(8.0, 20.0)), faults, {}, "degrees, expected 90")):
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                sealed(given, sticks, **options)
        with self.assertRaisesRegex(ValueError, "each detected in a single horizon"):
            sealed(horizons, {name: sh.faults(horizon) for name, horizon in horizons.items()}, endings="", dip=60.0)

    def test_stopped(self):
        graben, parts = Graben(), []

        def stop(part):
            parts.append(part)
            if part > 0.4:
                raise StopIteration

        with self.assertRaises(StopIteration):
            sealed(graben.horizons(), graben.sticks(), progress=stop)
        self.assertLess(parts[-1], 0.9)

    def test_files(self):
        """The program and the package write the same model."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        graben = Graben()
        for name, horizon in graben.horizons().items():
            sh.write(horizon, FOLDER / (name + ".dat"))
        sh.write(graben.sticks(), FOLDER / "sticks.dat")
        subprocess.run([sys.executable, PROGRAM, "--sealed", "--fault-sticks", "sticks.dat", "--fault-endings", "F2 > F1", "--largest-error", "1m", "--vertical-unit", "m",
                        "--vertical-direction", "Up", "--output-folder", "out", "--no-pictures", "A.dat", "B.dat", "C.dat"], cwd=FOLDER, check=True, capture_output=True)
        rows = (FOLDER / "out" / "stack_bodies.csv").read_text().splitlines()
        self.assertEqual((rows[0], len(rows)), ("Layer,Block,Volume,Area", 13))
        self.assertIn("F1,A to B,above A,", (FOLDER / "out" / "stack_fault_areas.csv").read_text())
        model, _ = sealed(graben.horizons(), graben.sticks())
        for ending in ("ml", "msh", "stl", "vtp"):
            model.write(FOLDER / ("model." + ending))
            self.assertGreater((FOLDER / ("model." + ending)).stat().st_size, 10000)
        self.assertEqual((FOLDER / "model.ml").read_text().count("REGION "), (FOLDER / "out" / "stack_sealed.ml").read_text().count("REGION "))
        words = ["--sealed", "--fault-sticks", "sticks.dat", "--vertical-unit", "m", "--vertical-direction", "Up", "--output-folder", "walls", "--no-pictures",
                 "--walls", "Picks", "--fault-tips", "Through", "A.dat", "B.dat", "C.dat"]
        subprocess.run([sys.executable, PROGRAM, *words], cwd=FOLDER, check=True, capture_output=True)
        self.assertIn("TSURF Wall 4", (FOLDER / "walls" / "stack_sealed.ml").read_text().replace("_", " "))
        done = subprocess.run([sys.executable, PROGRAM, *words, "--unconformities", "D"], cwd=FOLDER, capture_output=True, text=True)
        self.assertIn("unconformity D, expected the name of a horizon", done.stderr)
        with self.assertRaisesRegex(ValueError, "extension"):
            model.write(FOLDER / "model.obj")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
