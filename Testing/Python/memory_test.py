# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons within a memory limit: the same results as without, also where rows are read while a horizon is meshed.

Arguments: the program generate_horizons, the program horizon_mesh.py, and a folder for files.
"""

import contextlib
import io
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import unittest
from unittest import mock

import ledger_check
import mesh_checks
import numpy as np
from seismichorizons import _core
from seismichorizons_command import batch, core, data, memory, pipeline, record
from seismichorizons_command.core import HorizonError, set_threads
from seismichorizons_command.supply import Supply

GENERATOR, PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
ERROR = 0.75


def generate(name, points, *arguments):
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / name
    subprocess.run([str(GENERATOR), "--points", str(points), *arguments, str(path)], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def limit_of(points):
    """A limit for which so many points can be worked on at a time."""
    return memory.WORKED * points


class alone:
    """As if the program took no memory itself, whatever it has."""

    def __enter__(self):
        self._patches = [mock.patch.object(memory, "SPARE", 0), mock.patch.object(memory, "_resident", lambda: 0)]
        for patch in self._patches:
            patch.start()

    def __exit__(self, *_):
        for patch in self._patches:
            patch.stop()


class PlanTest(unittest.TestCase):
    def test_groups(self):
        """In their order, all of them, each that fits; none could have taken the next one, too."""
        rng = random.Random(1)
        for _ in range(300):
            sizes = [rng.randrange(1, 1000) for _ in range(rng.randrange(1, 12))]
            with alone():
                budget = memory.Budget(limit_of(rng.randrange(100, 3000)))
            groups = memory.make_groups(sizes, budget)
            self.assertEqual(sum(groups, []), list(range(len(sizes))))

            def fits(group):
                largest = max(sizes[n] for n in group)
                return memory.WORKED * largest + memory.HELD * (sum(sizes[n] for n in group) - largest) <= budget.left

            for group, after in zip(groups, groups[1:] + [[]]):
                self.assertTrue(fits(group) or len(group) == 1)
                self.assertFalse(after and fits(group + after[:1]))

    def test_bytes_by_rows(self):
        """Large horizons take memory for a band, small ones for all points."""
        self.assertEqual(memory.bytes_by_rows(1000, 100, 50000), memory.AT_ONCE * 50000 + 20000 + 30000)
        part = _core.columns_of_part(10000, 10000)
        self.assertTrue(4 * 10 ** 6 < part < 5 * 10 ** 6)
        kept = memory.KEPT_BANDS * part / 10 ** 8
        self.assertTrue(0.1 < kept < 0.5)
        self.assertAlmostEqual(memory.bytes_by_rows(10000, 10000, 10 ** 7) - memory.bytes_by_rows(10000, 10000, 0),
                               (memory.KEPT_BYTES * kept + memory.MESH_BYTES) * 10 ** 7, delta=20)
        self.assertEqual(memory.bytes_by_rows(10000, 10000, 0), memory.COLUMN_BYTES * part + 20 * 10 ** 6)

    def test_budget(self):
        with alone():
            budget = memory.Budget(limit_of(1000))
        self.assertTrue(budget.fits(1000) and not budget.fits(1001))
        self.assertTrue(budget.fits(900, 300) and not budget.fits(900, 301))
        self.assertEqual(budget.most_at_once(), memory.WORKED * 1000 // memory.AT_ONCE)
        budget.require(1000, "x")
        with self.assertRaisesRegex(HorizonError, r"x: 1001 points take 235K, expected at most the 235K that are left of "
                                    "--memory 235K"):
            budget.require(1001, "x")
        tight = memory.Budget(1 << 20)
        self.assertEqual(tight.most_at_once(), 0)
        self.assertEqual([memory.size_text(n) for n in (1, 5 << 20, 1000 << 20, 1023 << 20, 3 << 29, 1 << 40, 1010 << 40)],
                         ["1K", "5M", "1000M", "1023M", "1.5G", "1T", "1010T"])
        self.assertTrue(memory.Budget().left is None or memory.Budget().fits(1000))
        with mock.patch.object(memory, "_available", lambda: None):
            self.assertTrue(memory.Budget().fits(10 ** 15))


class BatchTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.three = generate("three.vsm", 60000, "--dropouts", "0.03")
        cls.one = generate("one.vsm", 60000, "--dropouts", "0.03", "--horizons", "1", "--seed", "5")

    def setUp(self):
        self.output = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.output, ignore_errors=True)

    def run_batch(self, path, points=None, name="", **given):
        """The messages, what was printed, and the bytes of the results, with memory for so many points at a time."""
        settings = pipeline.Settings(**{"surface": pipeline.surface_properties(largest_error=ERROR), **given})
        settings.memory = None if points is None else limit_of(points)
        messages, printed = [], io.StringIO()
        output = self.output / (name or str(points))
        with contextlib.redirect_stdout(printed), alone():
            batch.run([path], output, settings, False,
                      record.Record(lambda kind, text: ledger_check.is_warning(text) or messages.append("%s: %s" % (kind, text))))
        files = {p.name: p.read_bytes() for p in output.iterdir()} if output.exists() else {}
        return messages, printed.getvalue(), files

    def sizes(self, path):
        return [data.count_points(points) for _, points in pipeline.read(path)[0]]

    def test_same_results(self):
        """Of one horizon at a time, two, and all; also when only some are wanted."""
        sizes = self.sizes(self.three)
        for given in ({}, {"horizons": [1, 3]}, {"surface": None}, {"formats": ("vtp", "ts")},
                      {"reader": {"ZFrom": "RealZ"}}, {"error": {}, "horizons": [2]}):
            expected = self.run_batch(self.three, **given)[2]
            self.assertTrue(expected)
            for points in (max(sizes), max(sizes) + 2 * min(sizes) // 5, 2 * sum(sizes)):
                messages, printed, files = self.run_batch(self.three, points, **given)
                self.assertEqual(messages, [])
                self.assertEqual(files.keys(), expected.keys())
                for name in files:
                    self.assertTrue(files[name] == expected[name], name)

    def test_supply(self):
        """Horizons before are given back; without a limit the file is read at once."""
        sizes = self.sizes(self.three)
        with alone():
            supply = Supply(self.three, None, memory.Budget(limit_of(max(sizes))))
        self.assertEqual((supply.names, supply.is_whole), (["Horizon 1", "Horizon 2", "Horizon 3"], False))
        self.assertEqual([data.count_points(points) for _, points in supply], sizes)
        self.assertTrue(Supply(self.three, None, memory.Budget()).is_whole)
        with self.assertRaisesRegex(HorizonError, "there is no horizon 9; the file has 1, 2, 3"):
            Supply(self.three, [9], memory.Budget(1 << 40))

    def check_by_rows(self, path, **given):
        """Compares the results of half the memory, and returns the mesh."""
        size = max(self.sizes(path))
        expected = self.run_batch(path, **given)
        with mock.patch.object(pipeline, "run_by_rows", wraps=pipeline.run_by_rows) as by_rows:
            messages, printed, files = self.run_batch(path, size // 2, **given)
        by_rows.assert_called_once()
        self.assertEqual(messages, expected[0])
        self.assertTrue(files)
        self.assertEqual(files.keys(), expected[2].keys())
        for name in files:
            self.assertTrue(files[name] == expected[2][name], name)
        self.assertIn(str(size), printed)
        return mesh_checks.read(self.output / str(size // 2) / sorted(files)[0])

    def test_by_rows(self):
        """The same file as of all points, with all arrays and figures."""
        surface = pipeline.surface_properties
        for given in ({"largest_error": ERROR}, {}, {"largest_error": 1.5, "ErrorUnit": "World"},
                      {"largest_error": 0.002, "ErrorUnit": "Diagonal"}, {"largest_error": ERROR, "MinimumPatchSize": 40},
                      {"largest_error": ERROR, "FitHeights": False}, {"largest_error": 2.0, "OutlineTolerance": 0.0}):
            with self.subTest(**given):
                mesh = self.check_by_rows(self.one, surface=surface(RowsOfPart=64, **given), reader={"VerticalStep": 2.0})
                self.assertGreater(mesh_checks.check_mesh(mesh), 0)
                shutil.rmtree(self.output)

    def test_at_once(self):
        """Also with a radius above 1, of which all points are meshed at once."""
        for given in ({"Radius": 2}, {"Effort": "Fast"}, {"Radius": 3, "GrowthStrategy": "Distance", "MinimumPatchSize": 50}):
            with self.subTest(**given):
                self.check_by_rows(self.one, surface=pipeline.surface_properties(largest_error=ERROR, **given))
                shutil.rmtree(self.output)

    def test_readers(self):
        surface = pipeline.surface_properties(RowsOfPart=64)
        for reader in ({"ZFrom": "RealZ"}, {"DuplicatePolicy": "Mean"}, {"DuplicatePolicy": "Lowest", "VerticalDirection": "Up"}):
            with self.subTest(**reader):
                self.check_by_rows(self.one, surface=surface, reader=reader)
                shutil.rmtree(self.output)

    def test_some_by_rows(self):
        """One horizon is larger than the limit, the others are not."""
        points = sorted(self.sizes(self.three))[1] + 1
        given = {"surface": pipeline.surface_properties(largest_error=ERROR, RowsOfPart=64)}
        messages, printed, files = self.run_batch(self.three, points, **given)
        self.assertEqual((messages, len(files)), ([], 3))
        self.assertEqual(files, self.run_batch(self.three, **given)[2])
        self.assertEqual(printed.count("\n"), 16)  # two tables

    def test_errors(self):
        size, = self.sizes(self.one)
        name = "one.vsm: Horizon 1: "
        stages = "%d points take" % size
        for given, points, text in (
                ({"surface": None}, size - 1, name + stages),
                ({"surface": pipeline.surface_properties(triangles=900)}, size - 1, name + stages),
                ({"error": {}}, size - 1, name + stages),
                ({}, size // 4, name + "%d points, meshed by rows, take " % size)):
            messages, _, files = self.run_batch(self.one, points, **given)
            self.assertEqual((len(messages), files), (1, {}))
            self.assertTrue(messages[0].startswith("error: " + text), messages[0])
        # Nothing is left of one that is larger than the limit.
        nothing = pipeline.surface_properties(largest_error=ERROR, MinimumPatchSize=10 ** 6)
        expected = self.run_batch(self.one, surface=nothing)
        self.assertRegex(expected[0][0], "none of the %d points is in a patch " % size)
        self.assertEqual(self.run_batch(self.one, size // 2, surface=nothing)[::2], expected[::2])

    def test_left_out(self):
        sizes = self.sizes(self.three)
        given = {"leave_out_invalid": True, "surface": pipeline.surface_properties(largest_error=-2.0, RowsOfPart=64)}
        messages, printed, files = self.run_batch(self.three, sorted(sizes)[1] + 1, **given)
        self.assertEqual((messages, files), self.run_batch(self.three, **given)[::2])
        self.assertNotIn("inf", printed)

    def test_other_formats(self):
        """These are read whole; a horizon that is too large then is refused."""
        path = FOLDER / "picks.dat"
        path.write_text("Inline Crossline X Y Z\n" + "".join(
            "%d %d %d %d %d\n" % (1 + i, 1 + j, 25 * i, 25 * j, 100 + i) for i in range(30) for j in range(20)))
        messages, _, files = self.run_batch(path, 600)
        self.assertEqual((messages, len(files)), ([], 1))
        messages, _, files = self.run_batch(path, 599, name="less")
        self.assertEqual((len(messages), files), (1, {}))
        self.assertRegex(messages[0], "error: picks.dat: .*: 600 points take ")

    def test_all_at_once(self):
        """Horizons of a file that is read whole are in memory beside the one that is worked on."""
        path = FOLDER / "three.dat"
        path.write_text("".join('"%s"\t%d\t%d\t%d\t%d\t%d\n' % (name, i, j, 25 * i, 25 * j, 9 + i)
                                for name in "ABC" for j in range(20) for i in range(30)))
        messages, _, files = self.run_batch(path, 1000)
        self.assertEqual((messages, len(files)), ([], 3))
        messages, _, files = self.run_batch(path, 999, name="less")
        self.assertEqual((len(messages), files), (1, {}))
        self.assertRegex(messages[0], "error: three.dat: all horizons, with the largest: 1800 points take ")

    def test_peak(self):
        """What the whole program uses is near the limit, far below what the horizon takes without."""
        path = generate("peak.vsm", 5000000, "--dropouts", "0.03", "--horizons", "1")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        limit = 700 << 20
        done = subprocess.run([sys.executable, str(PROGRAM), "--no-pictures", "--largest-error", "1", "--memory", "700M",
                               "--output-folder", str(self.output), str(path)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=250)
        self.assertEqual(done.returncode, 0, done.stderr)
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10
        print("peak of %.0f MB" % (peak / 1e6))
        self.assertLess(before << 10, limit, "a child before took more")
        self.assertLess(peak, limit)
        self.assertGreater(mesh_checks.check_mesh(mesh_checks.read(self.output / "peak_horizon_1.vtp")), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
