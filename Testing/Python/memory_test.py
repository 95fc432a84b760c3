# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons within a memory limit: the same results as without, or a mesh that is joined and as good.

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

    def test_windows(self):
        """From the first to the last row with points, sharing rows, of two rows at least, none too large."""
        rng = random.Random(2)
        refused = 0
        for n in range(500):
            sizes = [0] * rng.randrange(4) + [rng.randrange(60) for _ in range(rng.randrange(2, 90))] + [0] * (n % 3)
            if not any(sizes):
                continue
            most = rng.randrange(30, 800)
            windows = memory.make_windows(sizes, most)
            if windows is None:
                refused += 1
                self.assertGreater(2 * memory.ROWS_TO_CHOOSE * max(sizes), most)
                continue
            rows = [row for row, size in enumerate(sizes) if size]
            self.assertEqual((windows[0][0], windows[-1][1]), (rows[0], rows[-1]))
            for (first, last), after in zip(windows, windows[1:] + [(windows[-1][1], 0)]):
                self.assertEqual(last, after[0])
                self.assertTrue(last > first or len(windows) == 1)
                self.assertTrue(0 < sum(sizes[first:last + 1]) <= most)
        self.assertTrue(20 < refused < 400)

    def test_cuts_at_full_rows(self):
        """Where every second row has no points, seams are at the others."""
        windows = memory.make_windows([0, 50] * 100, 700)
        self.assertGreater(len(windows), 7)
        self.assertTrue(all(first % 2 == 1 and last % 2 == 1 for first, last in windows))

    def test_budget(self):
        with alone():
            budget = memory.Budget(limit_of(1000))
        self.assertTrue(budget.fits(1000) and not budget.fits(1001))
        self.assertTrue(budget.fits(900, 300) and not budget.fits(900, 301))
        self.assertEqual(budget.most_points(), 1000)
        budget.require(1000, "x")
        with self.assertRaisesRegex(HorizonError, r"x: 1001 points take 235K, expected at most the 235K that are left of "
                                    "--memory 235K"):
            budget.require(1001, "x")
        tight = memory.Budget(1 << 20)
        self.assertEqual(tight.most_points(), 0)
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

    def check_windows(self, path, points, least_parts, **given):
        messages, printed, files = self.run_batch(path, points, **given)
        self.assertEqual(messages, [])
        name, = files
        mesh = mesh_checks.read(self.output / str(points) / name)
        horizon = pipeline.read_first(path)
        self.assertGreater(mesh_checks.check_mesh(mesh), 0)
        self.assertEqual(mesh_checks.array(mesh, "PointCount").sum(), data.count_points(horizon))
        self.assertGreaterEqual(mesh.GetFieldData().GetArray("NumberOfParts").GetValue(0), least_parts)
        self.assertIn(str(data.count_points(horizon)), printed)
        return mesh, horizon, files[name]

    def test_windows(self):
        """A mesh that is valid, near to all points, and hardly larger than that of the whole; always the same."""
        size, = self.sizes(self.one)
        settings = pipeline.Settings(surface=pipeline.surface_properties(largest_error=ERROR))
        whole = pipeline.run("one.vsm", "Horizon 1", pipeline.read_first(self.one), settings).data["mesh"]
        for parts_wanted in (2, 5, 20):
            points = size // parts_wanted + 2 * 300
            mesh, horizon, content = self.check_windows(self.one, points, parts_wanted - 1)
            for figure in ("NumberOfPatches", "NumberOfHoles", "ChosenRadius"):
                self.assertEqual(mesh.GetFieldData().GetArray(figure).GetValue(0), data.value(whole, figure))
            self.assertLess(mesh.GetNumberOfPoints(), (1.1 + 0.05 * parts_wanted) * data.count_points(whole))
            self.assertLessEqual(mesh.GetFieldData().GetArray("LargestError").GetValue(0), ERROR + 1e-9)
            self.check_distances(horizon, mesh)
            set_threads(1)
            again = self.run_batch(self.one, points, name="again")[2]
            set_threads(2)
            self.assertEqual(list(again.values()), [content])

    def check_distances(self, horizon, mesh):
        """No point inside the outlines is farther from the mesh than the error, and all but few are above or below it."""
        (outlines,), _ = core.run(_core.boundary, horizon, {"keep_holes": True, "smallest_hole_size": 9})
        reference, _, _ = core.run(_core.distance, outlines, data.from_vtk(mesh), {"in_world_units": False})
        inside = reference["point_data"]["Boundary"] == 0
        distances = reference["point_data"]["VerticalDistance"][inside]
        known = np.isfinite(distances)
        self.assertGreater(known.mean(), 0.999)
        self.assertLessEqual(abs(distances[known]).max(), ERROR + 1e-6)

    def test_given_parameters(self):
        given = pipeline.surface_properties(largest_error=1.5, Radius=2, MinimumPatchSize=40)
        mesh, _, _ = self.check_windows(self.one, 9000, 6, surface={**given, "MinimumPatchSize": 1})
        patches = mesh.GetFieldData().GetArray("NumberOfPatches").GetValue(0)
        self.assertEqual(mesh.GetFieldData().GetArray("ChosenRadius").GetValue(0), 2)
        messages, _, files = self.run_batch(self.one, 9000, name="small", surface=given)
        self.assertEqual((messages, len(files)), ([], 1))
        left = mesh_checks.read(self.output / "small" / "one_horizon_1.vtp").GetFieldData()
        self.assertLessEqual(left.GetArray("NumberOfPatches").GetValue(0), patches)

    def test_automatic_error(self):
        """One for all windows, by the noise of the largest."""
        messages, printed, _ = self.run_batch(self.one, 9000, surface=pipeline.surface_properties())
        fields = mesh_checks.read(self.output / "9000" / "one_horizon_1.vtp").GetFieldData()
        largest, chosen = (fields.GetArray(name).GetValue(0) for name in ("LargestError", "ChosenMaximumError"))
        self.assertEqual(messages, [])
        self.assertTrue(0.75 < largest <= chosen + 1e-9, (largest, chosen))
        self.assertIn("error %.2g vertical indices, six times the noise" % chosen, printed)

    def test_some_in_windows(self):
        """One horizon is larger than the limit, the others are not."""
        sizes = self.sizes(self.three)
        points = sorted(sizes)[1] + 1
        messages, printed, files = self.run_batch(self.three, points)
        self.assertEqual((messages, len(files)), ([], 3))
        expected = self.run_batch(self.three)[2]
        same = [files[name] == expected[name] for name in sorted(files)]
        self.assertEqual(same, [size <= points for size in sizes])
        self.assertEqual(printed.count("\n"), 16)  # two tables

    def test_errors(self):
        size, = self.sizes(self.one)
        name = "one.vsm: Horizon 1: "
        stages = "%d points take" % size
        for given, points, text in (
                ({"surface": None}, size - 1, name + stages),
                ({"surface": pipeline.surface_properties(triangles=900)}, size - 1, name + stages),
                ({"error": {}}, size - 1, name + stages),
                ({}, 150, name + "rows of up to "),
                ({"surface": pipeline.surface_properties(largest_error=1.0, Radius=2, GrowthStrategy="Distance")},
                 9000, name + "a seam and growth by distance")):
            messages, _, files = self.run_batch(self.one, points, **given)
            self.assertEqual((len(messages), files), (1, {}))
            self.assertTrue(messages[0].startswith("error: " + text), messages[0])
        messages, _, files = self.run_batch(self.one, 9000, leave_out_invalid=True, surface=pipeline.surface_properties(
            largest_error=1.0, Radius=2, GrowthStrategy="Distance"))
        self.assertEqual(len(messages), 2)
        self.assertIn("growth by distance with a radius of 2 columns", messages[0])
        self.assertTrue(messages[0].startswith("warning: ") and messages[0].endswith(" is left out"), messages[0])
        self.assertEqual(messages[1], "error: one.vsm: all horizons were left out")
        # Of a horizon that is cut, and left out, nothing is known; the summary of its file is that of the others.
        sizes = self.sizes(self.three)
        messages, printed, files = self.run_batch(self.three, sorted(sizes)[1] + 1, leave_out_invalid=True, surface=(
            pipeline.surface_properties(largest_error=1.0, Radius=2, GrowthStrategy="Distance")))
        self.assertEqual((len(messages), len(files)), (1, 2))
        self.assertRegex(messages[0], "^warning: three.vsm: Horizon %d: a seam and growth by distance .* is left out$" % (
            1 + sizes.index(max(sizes))))
        self.assertIn(" vertical indices, growing down", printed)
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
        path = generate("peak.vsm", 1500000, "--dropouts", "0.03", "--horizons", "1")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        limit = 250 << 20
        done = subprocess.run([sys.executable, str(PROGRAM), "--no-pictures", "--largest-error", "1", "--memory", "250M",
                               "--output-folder", str(self.output), str(path)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=250)
        self.assertEqual(done.returncode, 0, done.stderr)
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss << 10
        print("peak of %.0f MB for %d points" % (peak / 1e6, self.sizes(path)[0]))
        self.assertLess(before << 10, limit, "a child before took more")
        self.assertLess(peak, 1.3 * limit)
        self.assertGreater(mesh_checks.check_mesh(mesh_checks.read(self.output / "peak_horizon_1.vtp")), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
