# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The modules of the package, function by function, on a horizon whose results can be counted by hand.

Argument: a folder for files.
"""

import contextlib
import io
import os
import pathlib
import shutil
import signal
import sys
import unittest
from unittest import mock

import numpy as np
from seismichorizons import _core
from seismichorizons_command import batch, core, data, interrupt, overview, pictures, pipeline, progress, record, tables, writing
from seismichorizons_command.core import HorizonError
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData

FOLDER = pathlib.Path(sys.argv[1]).resolve()

# A plane of 5 x 4 columns: 14 points around 6. Its outline is straight but for 4 corners.
PLANE = b"5 4 9\n" + b"3 1 1 0.5 4.0\n" * 20
# The same, and two points of another horizon below it.
TWO_HORIZONS = b"5 4 9\n" + b"3 1 1 0.5 4.0 6 2 1 0.5 8.0\n" * 2 + b"3 1 1 0.5 4.0\n" * 18
ROUNDING = 1e-12  # of the meter's real numbers; distances here are 0
NO_ROUGH = pipeline.Settings(rough=None)


def write(name, content):
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / name
    path.write_bytes(content)
    return path


def plane():
    return pipeline.read_first(write("plane.vsm", PLANE))


def loops_of(*loops):
    """Outlines over points that lie anywhere."""
    offsets = np.cumsum([0, *map(len, loops)])
    return {**data.empty(), "places": np.zeros((1 + max(map(max, loops)), 3)), "lines": (offsets, np.concatenate(loops))}


def largest_error(figures):
    return figures["LargestDistance"][tables.TWO_SIDED]


def surface(points, **given):
    """The mesh of a horizon, and the parameters that were chosen for it."""
    result = pipeline.run("a file", "Horizon 1", points, pipeline.Settings(surface=pipeline.surface_properties(**given)))
    return result.data["mesh"], pipeline.chosen_parameters(result.data["mesh"])


class SurfaceTest(unittest.TestCase):
    def test_surface(self):
        """A plane is two triangles, and all is chosen; what is given is kept."""
        mesh, chosen = surface(plane(), largest_error=0.5)
        self.assertEqual((data.count_points(mesh), data.count_polygons(mesh)), (4, 2))
        self.assertEqual(chosen, {"Radius": 1, "SmallestHoleSize": 9, "OutlineTolerance": 0.5, "DistanceThreshold": 0.5,
                                  "MaximumError": 0.5, "MaximumNumberOfPoints": 0})
        chosen = surface(plane(), triangles=10, Radius=2, Effort="Fast")[1]
        self.assertEqual((chosen["Radius"], chosen["MaximumNumberOfPoints"]), (2, 8))
        self.assertAlmostEqual(surface(plane())[1]["MaximumError"], 6.0 / 12.0 ** 0.5)  # whole heights
        with self.assertRaisesRegex(HorizonError, "Horizon 1: radius 33, expected 1 to 32 columns"):
            surface(plane(), Radius=33)

    def test_settings(self):
        """One stage gives the mesh, and outlines to measure it against."""
        settings = pipeline.Settings(surface=pipeline.surface_properties(largest_error=0.5), error={})
        result = pipeline.run("a file", "Horizon 1", plane(), settings)
        self.assertEqual(sorted(result.data), ["boundary", "measured", "mesh", "points"])
        self.assertEqual(data.count_points(result.data["boundary"]), 20)
        self.assertLess(largest_error(result.figures), ROUNDING)
        self.assertEqual([tables.row(result)[head] for head in ("loops", "kept", "triangles")], ["1", "4", "2"])


def listen(test):
    """Has signals noted as long as a test runs."""
    for number in (signal.SIGINT, signal.SIGTERM):
        test.addCleanup(signal.signal, number, signal.getsignal(number))
    patch = mock.patch.object(interrupt, "_noted", None)
    patch.start()
    test.addCleanup(patch.stop)
    interrupt.listen()


class InterruptTest(unittest.TestCase):
    def test_stage_stops(self):
        """At the next report of its progress, without a result."""
        points, reports = plane(), []
        with mock.patch.object(progress.Progress, "show", lambda _, fraction: reports.append(fraction)):
            core.run(_core.surface, points, {})
        self.assertGreater(len(reports), 2)
        reports.clear()
        listen(self)

        def interrupted(_, fraction):
            reports.append(fraction)
            os.kill(os.getpid(), signal.SIGTERM)

        with mock.patch.object(progress.Progress, "show", interrupted), self.assertRaises(SystemExit):
            core.run(_core.surface, points, {})
        self.assertEqual(len(reports), 1)

    def test_exit_code(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            listen(self)
            interrupt.check()
            os.kill(os.getpid(), number)
            with self.assertRaises(SystemExit) as raised:
                interrupt.check()
            self.assertEqual(raised.exception.code, 128 + number)


class PipelineTest(unittest.TestCase):
    def test_read(self):
        path = write("two.vsm", TWO_HORIZONS)
        horizons, seconds = pipeline.read(path)
        self.assertEqual([(name, data.count_points(points)) for name, points in horizons], [("Horizon 1", 20), ("Horizon 2", 2)])
        self.assertGreaterEqual(seconds, 0.0)
        (only,), _ = pipeline.read(str(path), horizons=[2], ZFrom="RealZ", Origin=[0.0, 0.0, 100.0])
        self.assertEqual(only[0], "Horizon 2")
        self.assertEqual(data.bounds(only[1]), [0.0, 1.0, 0.0, 0.0, -8.0, -8.0])

    def test_nothing_to_read(self):
        for name, content, horizons, message in (
                ("two.vsm", TWO_HORIZONS, [2, 4], "two.vsm: there is no horizon 4; the file has 1, 2"),
                ("none.vsm", b"2 1 3\n\n\n", None, "none.vsm: no points, expected those of a horizon"),
                ("none.vsm", b"2 1 3\n\n\n", [1], "none.vsm: there is no horizon 1; the file has none")):
            with self.assertRaises(HorizonError) as raised:
                pipeline.read(write(name, content), horizons)
            self.assertTrue(str(raised.exception).endswith(message), raised.exception)

    def test_stages(self):
        names = ["boundary", "simplified", "rough", "elaborate", "mesh"]
        for settings, left_out in ((pipeline.Settings(), {"elaborate"}), (NO_ROUGH, {"rough", "elaborate"}),
                                   (pipeline.Settings(elaborate={}), set())):
            self.assertEqual([name for name, _, _ in settings.stages()], [n for n in names if n not in left_out])
        self.assertEqual(pipeline.Settings(rough={"CellSize": 7}).stages()[2], ("rough", _core.rough_simplification, {"CellSize": 7}))

    def test_run(self):
        points = plane()
        result = pipeline.run("plane.vsm", "Horizon 1", points, pipeline.Settings(rough=None, error={}))
        self.assertIs(result.data["points"], points)
        self.assertEqual({name: data.count_points(made) for name, made in result.data.items()},
                         {"points": 20, "boundary": 20, "simplified": 10, "mesh": 10, "measured": 20})
        # With n points, h of them on the outline, there are 2 n - 2 - h triangles.
        self.assertEqual(data.count_polygons(result.data["mesh"]), 14)
        self.assertIn("Distance", result.data["mesh"]["point_data"])
        self.assertEqual(set(result.seconds), {"boundary", "simplified", "mesh", "error"})
        self.assertEqual({len(column) for column in result.figures.values()}, {9})
        self.assertIsNone(pipeline.run("plane.vsm", "Horizon 1", points, NO_ROUGH).figures)

    def test_error_is_that_of_all_points(self):
        """A point of the outline that stands out by 1 is dropped, and missed."""
        voxel = b"3 1 1 0.5 4.0\n"
        points = pipeline.read_first(write("bump.vsm", b"5 4 9\n" + 2 * voxel + b"4 1 1 0.5 4.0\n" + 17 * voxel))
        settings = pipeline.Settings(simplified={"DistanceThreshold": 2.0}, rough=None, error={})
        result = pipeline.run("bump.vsm", "Horizon 1", points, settings)
        self.assertEqual(data.bounds(result.data["mesh"])[4:], [-3.0, -3.0])
        self.assertLess(abs(largest_error(result.figures) - 1.0), ROUNDING)

    def test_error_names_the_file(self):
        with self.assertRaises(HorizonError) as raised:
            pipeline.run("plane.vsm", "Horizon 1", plane(), pipeline.Settings(rough={"CellSize": 0}))
        self.assertEqual(str(raised.exception), "plane.vsm: Horizon 1: cell size 0, expected at least 1 column")


class ResultTest(unittest.TestCase):
    """Tables, files and panels of one result."""

    def setUp(self):
        self.result = pipeline.run("plane.vsm", "Horizon 1", plane(), pipeline.Settings(rough=None, error={}))
        self.result.seconds = {"boundary": 1.0, "simplified": 0.5, "mesh": 12.345, "error": 0.0}

    def test_loops(self):
        self.assertEqual(pipeline.count_loops(loops_of([0, 1, 2, 0], [3])), (2, 4))

    def test_row(self):
        row = {"horizon": "1", "points": "20", "loops": "1", "loop points": "14", "after": "4", "kept": "10",
               "triangles": "14", "reduction": "50.0 %"}
        error = {"Hausdorff": "0.000", "mean distance": "0.000", "outlines off": "0.000"}
        self.assertEqual(tables.row(self.result), {**row, **error, "seconds": "13.85"})
        self.result.figures = None
        self.assertEqual(tables.row(self.result), {**row, "seconds": "13.85"})
        self.assertTrue(tables.table([self.result])[0].endswith("reduction  seconds"))

    def test_wide_table(self):
        """What there is no room for is in a second table, below; a long name is cut in its middle."""
        self.result.name = "Top of " + 30 * "x" + " Formation"
        self.result.seconds["torn"] = 0.0
        lines = tables.table([self.result, self.result])
        self.assertEqual(len(lines), 9)
        self.assertLessEqual(max(map(len, lines)), tables.WIDTH)
        self.assertEqual(lines[4], "")
        self.assertEqual([lines[n].split()[0] for n in (0, 5)], 2 * ["horizon"])
        self.assertIn("Top of xxxxxxx...xxxx Formation", lines[2])

    def test_align(self):
        self.assertEqual(tables.align([("a", "long"), ("123", "4")]), ["  a  long", "---  ----", "123     4"])

    def test_figures(self):
        path = FOLDER / "figures.csv"
        writing.write_tables([self.result.figures, self.result.figures], path)
        lines = path.read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(lines), 1 + 2 * 9)
        self.assertEqual(lines[1:10], lines[10:])
        self.assertEqual(lines[0].split(",")[0], next(iter(self.result.figures)))

    def test_disk_is_full(self):
        image = vtkImageData()
        image.SetDimensions(2, 2, 1)
        image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
        for write_result, content in ((writing.write_tables, [self.result.figures]), (pictures.write, image)):
            with self.assertRaises(HorizonError) as raised:
                write_result(content, pathlib.Path("/dev/full"))
            self.assertEqual(str(raised.exception), "full cannot be written: closing the file failed, expected disk space for the rest")

    def test_panels(self):
        self.assertEqual([(panel.title, panel.caption) for panel in overview.panels(self.result)], [
            ("Horizon 1", "20 points"), ("Exterior boundary", "1 loop, 14 points"), ("Simplified boundary", "4 points"),
            ("Mesh", "14 triangles")])
        result = pipeline.run("plane.vsm", "Horizon 1", plane(), pipeline.Settings(elaborate={}))
        self.assertEqual([panel.title for panel in overview.panels(result)][3:-1],
                         ["Rough simplification", "Elaborate simplification"])


class BatchTest(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.output = self.folder / "output"

    def run_batch(self, inputs, settings=NO_ROUGH):
        """The number of failures, the messages, and what was printed."""
        messages, printed = [], io.StringIO()
        run = record.Record(lambda kind, text: messages.append("%s: %s" % (kind, text)))
        with contextlib.redirect_stdout(printed):
            batch.run(inputs, self.output, settings, False, run)
        failures = sum(bool(file["error"]) for file in run.files)
        self.assertEqual(run.is_done(), failures == 0)
        return failures, messages, printed.getvalue()

    def test_files(self):
        paths = [self.folder / name for name in ("b.vsm", "a.vsm", "c.txt")]
        for path in paths:
            path.touch()
        elsewhere, messages = pathlib.Path("elsewhere.vsm"), []
        self.output.mkdir()
        run = record.Record(lambda kind, text: messages.append(text))
        self.assertEqual(batch.find_files([elsewhere, self.output, self.folder], run), [elsewhere, paths[1], paths[0]])
        self.assertEqual(messages, ["%s: there is no file of horizons in this folder" % self.output])
        self.assertFalse(run.is_done())

    def test_invalid_horizons(self):
        """The second horizon has no triangles, and so no error that could be measured."""
        path = write("two.vsm", TWO_HORIZONS)
        problem = ("warning: two.vsm: Horizon 2 is left out: no triangles between 2 points, expected some that are not on one line; "
                   "--formats dat writes the points of a line")
        settings = pipeline.Settings(rough=None, error={})
        failures, messages, printed = self.run_batch([path], settings)
        self.assertEqual((failures, messages), (0, [problem]))
        self.assertEqual(sorted(p.name for p in self.output.iterdir()), ["two_error.csv", "two_horizon_1.vtp"])
        self.assertEqual(len(printed.splitlines()), 12)
        settings.horizons = [2]
        self.assertEqual(self.run_batch([path], settings)[:2], (
            1, [problem, "error: two.vsm: all horizons were left out"]))

    def test_labels(self):
        """As short as they can be; results of all files have different names."""
        for paths, labels in ((["s/x.vsm", "s/y.vsm"], ["x.vsm", "y.vsm"]),
                              (["a/x.vsm", "b/x.vsm", "y.vsm"], ["a/x.vsm", "b/x.vsm", "y.vsm"]),
                              (["/1/a/x.vsm", "/2/a/x.vsm", "/1/b/x.vsm"], ["1/a/x.vsm", "2/a/x.vsm", "b/x.vsm"]),
                              (["/x.vsm", "/a/x.vsm"], ["x.vsm", "a/x.vsm"]),
                              (["/a/../x.vsm", "/b/x.vsm"], ["x.vsm", "b/x.vsm"]),
                              (["/a/x.vsm", "/b/x.vsm", "/c/a_x.vsm"], ["a/x.vsm", "b/x.vsm", "c/a_x.vsm"])):
            made = batch.make_labels([pathlib.Path(path) for path in paths])
            self.assertEqual([str(label) for label in made], labels)
        made = batch.make_labels([pathlib.Path(path) for path in ("a/x.vsm", "a/x.txt", "b/x.dat", "x.dat.gz", "y.dat")])
        self.assertEqual(batch.make_stems(made), ["x_vsm", "x_txt", "x_dat", "x_dat_gz", "y"])
        with self.assertRaisesRegex(HorizonError, "x.vsm is given twice"):
            batch.make_labels([pathlib.Path(path) for path in ("x.vsm", "./x.vsm")])

    def test_all_files_are_done(self):
        (self.folder / "bad.vsm").write_bytes(b"5 4\n")
        (self.folder / "good.vsm").write_bytes(TWO_HORIZONS)
        settings = pipeline.Settings(rough=None, error={}, horizons=[1])
        failures, messages, printed = self.run_batch([self.folder], settings)
        self.assertEqual((failures, len(messages)), (1, 1))
        self.assertIn("bad.vsm", messages[0])
        self.assertEqual(sorted(p.name for p in self.output.iterdir()), ["good_error.csv", "good_horizon_1.vtp"])
        self.assertTrue(printed.startswith("good.vsm: read in "), printed)
        self.assertEqual(len(printed.splitlines()), 13)

    def test_no_results_no_folder(self):
        (self.folder / "bad.vsm").write_bytes(b"5 4\n")
        self.assertEqual(self.run_batch([self.folder])[0], 1)
        self.assertFalse(self.output.exists())

    def test_all_results_or_none(self):
        """A horizon that cannot be done takes the others of its file with it."""
        self.output.mkdir()
        really_write = writing.write_data

        def fail_at_the_second(mesh, path, name, direction):
            if path.stem.endswith("2"):
                raise OSError("disk full")
            really_write(mesh, path, name, direction)
            self.assertTrue(path.is_file())
            return []

        path = write("two.vsm", b"5 4 9\n" + b"3 1 1 0.5 4.0 6 2 1 0.5 8.0\n" * 20)
        with mock.patch.object(writing, "write_data", fail_at_the_second):
            self.assertEqual(self.run_batch([path])[:2], (1, ["error: disk full"]))
        self.assertEqual(list(self.output.iterdir()), [])

    def test_signal_while_results_are_written(self):
        """None of them appear, and the folders made for them go."""
        listen(self)
        self.output = self.output / "below"
        really_write = writing.write_data

        def write_data(mesh, path, name, direction):
            really_write(mesh, path, name, direction)
            os.kill(os.getpid(), signal.SIGINT)
            return []

        with mock.patch.object(writing, "write_data", write_data), self.assertRaises(SystemExit) as raised:
            self.run_batch([write("plane.vsm", PLANE)])
        self.assertEqual(raised.exception.code, 130)
        self.assertFalse(self.output.parent.exists())


if __name__ == "__main__":
    unittest.main(argv=["modules_test"], verbosity=2)
