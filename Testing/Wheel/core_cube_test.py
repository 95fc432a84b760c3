# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package for numpy: cubes from arrays, and amplitudes at horizons, compared with plain loops.

Argument: a folder for files.
"""

import dataclasses
import math
import pathlib
import sys
import tracemalloc
import types
import unittest

import numpy as np
import seismichorizons as sh

FOLDER = pathlib.Path(sys.argv[1])
ROWS, COLUMNS, SAMPLES = 30, 40, 60
LATTICE = sh.Lattice((ROWS, COLUMNS), (4e5, 6e6), (24.0, 7.0), (-7.0, 24.0), 1000.0, 4.0, SAMPLES, (100.0, 1.0, 200.0, 2.0))
CORNERS = [LATTICE.places(column, row) for column, row in ((0, 0), (0, ROWS - 1), (COLUMNS - 1, 0), (COLUMNS - 1, ROWS - 1))]


def one_event(seed=1):
    """Values with one event of amplitude 1, and its z."""
    j, i = np.mgrid[0:ROWS, 0:COLUMNS]
    event = 1120.0 + 20.0 * np.sin(i / 9.0) + 10.0 * np.cos(j / 7.0)
    away = 1000.0 + 4.0 * np.arange(SAMPLES) - event[..., None]
    noise = np.random.default_rng(seed).normal(size=away.shape)
    return (np.exp(-((away / 10.0) ** 2)) + 0.05 * noise).astype(np.float32), event


def rough(event, seed=3):
    """A horizon with noise, missing columns, and points outside of the cube."""
    random = np.random.default_rng(seed)
    z = event + random.normal(0.0, 30.0, event.shape)
    z[random.random(z.shape) < 0.3] = np.nan
    z[4:9, 3:11] = np.nan
    return sh.horizon(z, origin=LATTICE.origin, column_step=LATTICE.column_step, row_step=LATTICE.row_step, vertical_unit="ms", name="Top")


class Fake:
    """A DataArray, as far as it is used."""

    def __init__(self, values, dims, coords):
        self.values, self.dims, self.coords, self.shape = values, dims, coords, values.shape

    def __getitem__(self, name):
        return self.coords[name]

    def transpose(self, *dims):
        return Fake(self.values.transpose([self.dims.index(dim) for dim in dims]), dims, self.coords)


class Coordinate(types.SimpleNamespace):
    attrs = {}

    def transpose(self, *dims):
        return Coordinate(dims=dims, values=self.values.transpose([self.dims.index(dim) for dim in dims]))


def as_xarray(values, lattice):
    """With its dimensions in another order."""
    rows, columns, samples = values.shape
    x, y = lattice.places(np.arange(columns)[None], np.arange(rows)[:, None])
    inline, step, crossline, cross_step = lattice.lines
    z = Coordinate(values=lattice.first_z + lattice.vertical_step * np.arange(samples))
    z.attrs = {"units": "ms"}
    return Fake(values.transpose(2, 1, 0), ("time", "crossline", "inline"), {
        "inline": Coordinate(values=inline + step * np.arange(rows)), "crossline": Coordinate(values=crossline + cross_step * np.arange(columns)),
        "time": z, "cdp_x": Coordinate(values=x.T, dims=("crossline", "inline")), "cdp_y": Coordinate(values=y.T, dims=("crossline", "inline"))})


class CubeTest(unittest.TestCase):
    def test_all_ways_are_the_same_cube(self):
        values, event = one_event()
        np.save(FOLDER / "values.npy", values)
        made = [sh.cube(values, LATTICE, vertical_unit="ms"), sh.cube(values, dataclasses.replace(LATTICE, indices=1), vertical_unit="ms"),
                sh.cube(values, corners=CORNERS, lines=LATTICE.lines, first_z=1000.0, vertical_step=4.0, vertical_unit="ms"),
                sh.cube(np.load(FOLDER / "values.npy", mmap_mode="r"), corners=CORNERS[:3], first_z=1000.0, vertical_step=4, vertical_unit="ms"),
                sh.cube(as_xarray(values, LATTICE)), sh.cube(values.astype(">f4"), LATTICE, vertical_unit="ms")]
        for cube in made:
            self.assertEqual((cube.vertical_unit, cube.vertical_domain, cube.lattice.shape), ("ms", "time", (ROWS, COLUMNS)))
            self.assertTrue(np.allclose((cube.lattice.origin, cube.lattice.column_step, cube.lattice.row_step),
                                        (LATTICE.origin, LATTICE.column_step, LATTICE.row_step), atol=1e-6))
            found = sh.extract(cube, {"Top": np.array([[*LATTICE.places(20, 15), event[15, 20]]])})["Top"]
            self.assertGreater(len(found), 0.9 * event.size)
            self.assertLess(np.abs(found.z - event[found.columns[:, 1], found.columns[:, 0]]).max(), 4.0)
        self.assertEqual(made[2].lattice.lines, made[4].lattice.lines)

    def test_whole_numbers(self):
        values, event = one_event()
        for dtype in (np.int8, np.int16, np.int32, np.float16, np.float64):
            cube = sh.cube((100 * values).astype(dtype), LATTICE)
            found = sh.extract(cube, np.array([[*LATTICE.places(20, 15), event[15, 20]]]))
            self.assertGreater(len(next(iter(found.values()))), 0.9 * event.size, dtype)

    def test_missing_samples(self):
        """Masks, nan and nodata are the same."""
        values, event = one_event()
        holes = np.zeros(values.shape, bool)
        holes[10:14, 10:20] = True
        seed = np.array([[*LATTICE.places(30, 25), event[25, 30]]])
        found = [next(iter(sh.extract(sh.cube(given, LATTICE, nodata=nodata), seed).values())) for given, nodata in (
            (np.where(holes, np.float32(np.nan), values), None), (np.ma.MaskedArray(values, holes), None),
            (np.where(holes, np.float32(-999.25), values), -999.25))]
        for one in found:
            self.assertFalse(holes[one.columns[:, 1], one.columns[:, 0], 0].any())
            self.assertTrue(np.array_equal(one.z, found[0].z))

    def test_a_large_array_is_copied_once(self):
        path = FOLDER / "large.npy"
        large = np.lib.format.open_memmap(path, "w+", np.float32, (100, 200, 100))
        large[:] = 1.0
        large.flush()
        size = large.nbytes
        tracemalloc.start()
        try:
            cube = sh.cube(np.load(path, mmap_mode="r"), sh.Lattice((100, 200)), vertical_step=4.0)
            self.assertLess(tracemalloc.get_traced_memory()[1], 0.1 * size)
            cube._data()
            self.assertLess(tracemalloc.get_traced_memory()[1], 1.1 * size)
        finally:
            tracemalloc.stop()

    def test_refusals(self):
        values, _ = one_event()
        bent = as_xarray(values, LATTICE)
        bent.coords["cdp_x"].values = bent.coords["cdp_x"].values + 5.0 * np.arange(ROWS) ** 2
        gaps = as_xarray(values, LATTICE)
        gaps.coords["inline"].values[3:] += 7
        none = as_xarray(values, LATTICE)
        del none.coords["cdp_x"]
        for words, call in (
                (r"values of 2 axes, expected \(inlines, crosslines, samples\)", lambda: sh.cube(values[0], LATTICE)),
                (r"values of shape \(29, 40, 60\), expected \(30, 40, 60\) of the lattice", lambda: sh.cube(values[1:], LATTICE)),
                ("no lattice, expected one of lattice and corners", lambda: sh.cube(values)),
                ("lattice and corners, expected one of", lambda: sh.cube(values, LATTICE, corners=CORNERS)),
                ("corners without vertical_step, expected z between samples", lambda: sh.cube(values, corners=CORNERS)),
                ("vertical_step -4, expected more than 0", lambda: sh.cube(values, LATTICE, vertical_step=-4)),
                (r"corners of shape \(2, 2\), expected three or four", lambda: sh.cube(values, corners=CORNERS[:2], vertical_step=4)),
                ("on one line", lambda: sh.cube(values, corners=[(0, 0), (1, 1), (2, 2)], vertical_step=4)),
                ("a fourth corner .* from where the others have it", lambda: sh.cube(values, corners=[*CORNERS[:3], (0, 0)], vertical_step=4)),
                ("values of type bool, expected numbers", lambda: sh.cube(values > 0, LATTICE)),
                ("from a lattice, expected less than half a step: lattice or corners give another", lambda: sh.cube(bent)),
                ("coordinates inline without equal steps", lambda: sh.cube(gaps)),
                ("no coordinates cdp_x, expected these, or lattice or corners", lambda: sh.cube(none)),
                ("dimensions a, b, c, expected inline, crossline", lambda: sh.cube(Fake(values, ("a", "b", "c"), {})))):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                call()
        self.assertEqual(sh.cube(bent, LATTICE).lattice.origin, LATTICE.origin)


def plain_figures(cube, horizon, first, last):
    """Amplitudes point by point; windows are from one z to another, in the direction of the cube."""
    matrix = np.column_stack((cube.lattice.column_step, cube.lattice.row_step))
    rows = []
    for x, y, z, z0, z1 in zip(horizon.x, horizon.y, horizon.z * horizon.sign * cube.sign, first, last):
        i, j = np.linalg.solve(matrix, np.subtract((x, y), cube.lattice.origin))
        i, j = (round(a) if abs(a - round(a)) < 1e-6 else a for a in (i, j))
        trace = np.full(cube.values.shape[2], np.nan)
        if 0 <= i <= cube.values.shape[1] - 1 and 0 <= j <= cube.values.shape[0] - 1:
            trace[:] = 0.0
            for a, wa in ((math.floor(i), 1 - i % 1), (math.ceil(i), i % 1)):
                for b, wb in ((math.floor(j), 1 - j % 1), (math.ceil(j), j % 1)):
                    if wa * wb > 0.0:
                        own = cube.values[b, a].astype(float)
                        trace += wa * wb * (own if cube.known is None else np.where(cube.known[b, a], own, np.nan))
        k = (z - cube.lattice.first_z) / cube.lattice.vertical_step
        at = np.nan
        if 0 <= k <= len(trace) - 1:
            at = trace[math.floor(k)] if k % 1 == 0 else trace[math.floor(k)] * (1 - k % 1) + trace[math.ceil(k)] * (k % 1)
        heights = cube.lattice.first_z + cube.lattice.vertical_step * np.arange(len(trace))
        used = trace[(heights >= z0 - 1e-9) & (heights <= z1 + 1e-9) & np.isfinite(trace)]
        rows.append((at, *((math.sqrt((used**2).mean()), used.mean(), used.max(), used.min()) if len(used) else [np.nan] * 4)))
    return np.array(rows).T


class AmplitudesTest(unittest.TestCase):
    NAMES = ("CubeAmplitude", "RmsAmplitude", "MeanAmplitude", "LargestAmplitude", "SmallestAmplitude")

    def check(self, found, expected):
        for name, values in zip(self.NAMES, expected):
            self.assertTrue(np.allclose(found[name], values, equal_nan=True), name)
        self.assertTrue(0.1 < np.isfinite(expected[0]).mean() < 1.0)

    def setUp(self):
        values, self.event = one_event()
        self.cube = sh.cube(np.where(np.random.default_rng(5).random(values.shape) < 0.02, np.float32(np.nan), values), LATTICE, vertical_unit="ms")
        self.top = rough(self.event)

    def test_windows_on_the_lattice(self):
        found = sh.amplitudes(self.cube, self.top, above="10 ms", below=21.0)
        self.check(found, plain_figures(self.cube, self.top, self.top.z - 10.0, self.top.z + 21.0))
        self.assertEqual(set(sh.amplitudes(self.cube, self.top)), {"CubeAmplitude"})
        self.assertEqual(self.top.attributes, {})

    def test_beyond_the_cube(self):
        """Windows that begin or end outside have the samples inside."""
        for shift in (-130.0, 150.0):
            top = dataclasses.replace(self.top, z=self.top.z + shift)
            self.check(sh.amplitudes(self.cube, top, above=40.0, below=40.0), plain_figures(self.cube, top, top.z - 40.0, top.z + 40.0))

    def test_between_horizons(self):
        base = rough(self.event + 15.0, 9)
        z = base.grid()[self.top.columns[:, 1], self.top.columns[:, 0]]
        found = sh.amplitudes(self.cube, self.top, base, above=4.0)
        self.check(found, plain_figures(self.cube, self.top, self.top.z - 4.0, z))
        self.assertTrue(np.isnan(found["MeanAmplitude"][np.isnan(z)]).all())

    def test_off_the_lattice(self):
        j, i = np.mgrid[0:17, 0:23]
        x, y = LATTICE.places(1.3 + 1.8 * i + 0.2 * j, 0.7 + 1.9 * j - 0.1 * i)
        steps = {"column_step": (x[0, 1] - x[0, 0], y[0, 1] - y[0, 0]), "row_step": (x[1, 0] - x[0, 0], y[1, 0] - y[0, 0])}
        top = sh.horizon(1110.0 + 5.0 * np.sin(i), origin=(x[0, 0], y[0, 0]), vertical_unit="ms", **steps)
        self.check(sh.amplitudes(self.cube, top, above=8.0, below=8.0), plain_figures(self.cube, top, top.z - 8.0, top.z + 8.0))

    def test_hidden_samples_and_both_directions(self):
        known = np.random.default_rng(8).random(self.cube.values.shape) < 0.97
        values = np.where(known, np.nan_to_num(self.cube.values), np.float32(1e5))
        for direction in ("down", "up"):
            cube = sh.Cube(values, LATTICE, known, direction=direction)
            sign = 1.0 if direction == "down" else -1.0
            above, below = (12.0, 20.0) if direction == "down" else (20.0, 12.0)
            for own in ("down", "up"):
                same = 1.0 if own == direction else -1.0
                top = dataclasses.replace(self.top, z=same * self.top.z, direction=own)
                found = sh.amplitudes(cube, top, above=12.0, below=20.0)
                z = self.top.z
                self.check(found, plain_figures(cube, top, z - above, z + below))
            self.assertLess(np.nanmax(found["LargestAmplitude"]), 10.0, sign)

    def test_blocks_do_not_matter(self):
        from seismichorizons import _volume

        expected = sh.amplitudes(self.cube, self.top, above=9.0, below=3.0)
        before, _volume.BLOCK = _volume.BLOCK, 7 * SAMPLES
        try:
            found = sh.amplitudes(self.cube, self.top, above=9.0, below=3.0)
        finally:
            _volume.BLOCK = before
        for name in self.NAMES:
            self.assertTrue(np.allclose(found[name], expected[name], 1e-12, equal_nan=True))

    def test_they_go_out(self):
        found = sh.amplitudes(self.cube, self.top)
        sh.write(found, FOLDER / "top.dat")
        written = next(iter(sh.read(FOLDER / "top.dat").values()))
        self.assertTrue(np.allclose(written["CubeAmplitude"], found["CubeAmplitude"], equal_nan=True))
        self.assertIn("CubeAmplitude", sh.surface(found, "20 ms").attributes)

    def test_refusals(self):
        other = sh.horizon(np.full((5, 5), 1100.0), name="Base")
        for kind, words, call in (
                (TypeError, "amplitudes of ndarray, expected a Cube", lambda: sh.amplitudes(self.cube.values, self.top)),
                (TypeError, "amplitudes of str, expected a Horizon", lambda: sh.amplitudes(self.cube, "Top")),
                (ValueError, "above -3.0, expected a finite number, at least 0", lambda: sh.amplitudes(self.cube, self.top, above=-3.0)),
                (ValueError, "below '3 m', a length, for a horizon with z in ms", lambda: sh.amplitudes(self.cube, self.top, below="3 m")),
                (ValueError, "Base on another lattice than Top, expected the same", lambda: sh.amplitudes(self.cube, self.top, other))):
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                call()


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
