# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls of the core by the command, and of the VTK classes by seismichorizons.vtk. Argument: a folder for files."""

import contextlib
import io
import pathlib
import sys
import unittest
from unittest import mock

from seismichorizons import _core
from seismichorizons import vtk as sh
from seismichorizons_command import core, data, pipeline, progress
from seismichorizons_command.core import HorizonError

FOLDER = pathlib.Path(sys.argv[1]).resolve()
TWO_SIDED = 2  # row of figures of both directions, in lattice units
ROUNDING = 1e-12  # of the meter's real numbers; distances here are 0


def write_plane():
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / "plane.vsm"
    path.write_bytes(b"5 4 9\n" + b"3 1 1 0.5 4.0\n" * 20)
    return path


def plane():
    return pipeline.read_first(write_plane())


class ClassesTest(unittest.TestCase):
    """Classes of VTK."""

    def read(self):
        reader = sh.make("vtkVerneySparseMatrixReader", FileName=str(write_plane()))
        self.assertGreaterEqual(sh.update(reader), 0.0)
        return sh.horizons_of(reader.GetOutput())["Horizon 1"]

    def test_properties(self):
        reader = sh.make("vtkVerneySparseMatrixReader", FileName="RealZ", ZFrom="RealZ", Origin=[1.0, 2.0, 3.0])
        self.assertEqual(reader.GetFileName(), "RealZ")
        self.assertEqual(reader.GetZFrom(), sh.vtkVerneySparseMatrixReader.RealZ)
        self.assertEqual(reader.GetOrigin(), (1.0, 2.0, 3.0))
        sh.configure(reader, ZFrom=sh.vtkVerneySparseMatrixReader.VerticalIndex)
        self.assertEqual(reader.GetZFrom(), sh.vtkVerneySparseMatrixReader.VerticalIndex)
        with self.assertRaises(AttributeError):
            sh.configure(reader, NoSuchProperty=1)

    def test_apply(self):
        outlined = sh.apply(sh.vtkHorizonExteriorBoundary(), self.read())
        mesh = sh.apply(sh.vtkHorizonTriangulation(), outlined)
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()), (20, 24))
        meter = sh.vtkHorizonSurfaceDistance()
        sh.apply(meter, outlined, mesh)
        figures = meter.GetOutputDataObject(2)
        self.assertLess(figures.GetValueByName(TWO_SIDED, "LargestDistance").ToDouble(), ROUNDING)

    def test_error(self):
        """One line without the place in the source; nobody watches any more afterwards."""
        algorithm = sh.vtkHorizonRoughSimplification()
        with self.assertRaises(ValueError) as raised:
            sh.apply(algorithm, sh.apply(sh.vtkHorizonExteriorBoundary(), self.read()), CellSize=0)
        self.assertEqual(str(raised.exception), "Horizon 1: cell size 0, expected at least 1 column")
        self.assertFalse(algorithm.HasObserver("ErrorEvent"))
        self.assertFalse(algorithm.GetExecutive().HasObserver("ErrorEvent"))


class StageTest(unittest.TestCase):
    """Calls of the core."""

    def test_run(self):
        (outlined,), _ = core.run(_core.boundary, plane(), {})
        (mesh, _), _ = core.run(_core.triangulation, outlined, {})
        self.assertEqual((data.count_points(mesh), data.count_polygons(mesh)), (20, 24))
        _, _, figures = core.run(_core.distance, outlined, mesh, {})
        self.assertLess(figures["LargestDistance"][TWO_SIDED], ROUNDING)

    def test_error(self):
        """One line; what raises it names the horizon."""
        (outlined,), _ = core.run(_core.boundary, plane(), {})
        with self.assertRaises(HorizonError) as raised:
            core.run(_core.rough_simplification, outlined, {"cell_size": 0})
        self.assertEqual(str(raised.exception), "cell size 0, expected at least 1 column")

    def test_errors(self):
        """All of the core are those of the program, under the name of what they are about."""
        for error, text in ((ValueError("wrong"), "a file: wrong"), (OSError("no such file"), "a file: no such file"),
                            (HorizonError("wrong"), "a file: wrong"), (MemoryError(), "a file: " + core.NO_MEMORY)):
            with self.assertRaises(HorizonError) as raised, core.errors("a file: "):
                raise error
            self.assertEqual(str(raised.exception), text)

    def test_options(self):
        """Names and words of the core."""
        self.assertEqual(core.options({"CellSize": 3, "GrowthStrategy": "Distance", "DuplicatePolicy": "Lowest", "Threshold": 2.5}),
                         {"cell_size": 3, "growth": "distance", "duplicates": "lowest", "threshold": 2.5})

    def test_warnings(self):
        """The last one who listens hears them."""
        heard = [], []
        with core.heard_by(heard[0].append):
            with core.heard_by(heard[1].append):
                core.warn("first")
            core.warn("second")
        core.warn("nobody hears it")
        self.assertEqual(heard, (["second"], ["first"]))

    def test_progress(self):
        """Told of long work that has a label, on a terminal: as it goes on, and at its end with the rate and the time."""
        points = plane()
        for seconds, label, is_terminal, told in ((0.0, "a label", True, True), (1000.0, "a label", True, False),
                                                  (0.0, "", True, False), (0.0, "a label", False, False)):
            log = io.StringIO()
            log.isatty = lambda answer=is_terminal: answer
            with mock.patch.multiple(progress, LONG_WORK=seconds, BETWEEN=0.0), contextlib.redirect_stderr(log):
                core.run(_core.boundary, points, {}, label=label, work=(20, "points"))
            self.assertEqual(bool(log.getvalue()), told, log.getvalue())
            if told:
                self.assertRegex(log.getvalue(), r"\ra label: +\d+ %")
                self.assertRegex(log.getvalue().split("\r")[-1], r"^a label: done  .* points/s  0\.0 s\x1b\[K\n$")
                self.assertEqual(log.getvalue().count("\n"), 1)

    def test_line_of_progress(self):
        line = progress.Progress("x", (6000000, "points")).line
        self.assertEqual(line(0.25, 10.0), "x:  25 %  150 k points/s  30 s left")
        self.assertEqual(line(None, 125.0), "x: done  48 k points/s  2 min 05 s")
        self.assertEqual(line(0.0, 10.0), "x:   0 %")
        self.assertEqual(progress.Progress("x").line(0.5, 4.0), "x:  50 %  4.0 s left")
        self.assertEqual(progress.amount_text(12.5e6, "B"), "12.5 MB")
        self.assertEqual(progress.duration_text(7260), "2 h 01 min")


if __name__ == "__main__":
    unittest.main(argv=["calls_test"], verbosity=2)
