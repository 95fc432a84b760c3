# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package as functions: sources, stages, errors, warnings, progress, Ctrl-C, and the examples of their texts.

Arguments: the folder of the sample, a folder for files.
"""

import contextlib
import doctest
import inspect
import io
import os
import pathlib
import shutil
import signal
import sys
import threading
import types
import unittest
import warnings
from unittest import mock

import numpy as np
import seismichorizons as sh
from seismichorizons import calls, figures, functions, heights, making, stages
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

DATA = pathlib.Path(sys.argv[1]).resolve()
FOLDER = pathlib.Path(sys.argv[2]).resolve()
ROWS, COLUMNS = 40, 60
SECONDS_UNTIL_INTERRUPT = 0.3


def dome(rows=ROWS, columns=COLUMNS):
    j, i = np.mgrid[0:rows, 0:columns]
    return 1000.0 + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


def places(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def least_angles(mesh):
    """The smallest angle of each triangle on the lattice, in degrees."""
    matrix = sh.details(mesh).lattice_to_world
    on_lattice = (places(mesh) - matrix[:3, 3]) @ np.linalg.inv(matrix[:3, :3]).T
    return figures._smallest_angles(on_lattice[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)][:, :, :2])


def without(*names):
    """Such modules cannot be imported within the block."""
    return mock.patch.dict(sys.modules, {name: None for name in names})


class SourcesTest(unittest.TestCase):
    def test_grid(self):
        """Each value is at its place; columns follow the azimuth, rows are to the left of it."""
        z = dome()
        z[3, 4], z[5, 6] = np.nan, -999.0
        top = sh.horizon(z, origin=(5e5, 6e6), spacing=(25.0, 50.0), azimuth=120.0, nodata=-999.0, vertical_unit="ms")
        self.assertEqual(top.GetNumberOfPoints(), ROWS * COLUMNS - 2)
        matrix = sh.details(top).lattice_to_world
        angle = np.radians(-30.0)
        np.testing.assert_allclose(matrix[:2, 0], 25.0 * np.array((np.cos(angle), np.sin(angle))), atol=1e-9)
        np.testing.assert_allclose(matrix[:2, 1], 50.0 * np.array((-np.sin(angle), np.cos(angle))), atol=1e-9)
        np.testing.assert_allclose(matrix[:2, 3], (5e5, 6e6), atol=1e-6)
        column, row = vtk_to_numpy(top.GetPointData().GetArray("Column"))[:, :2].T
        np.testing.assert_allclose(places(top)[:, 2], -z[row, column])
        up = sh.horizon(dome(), vertical_direction="Up")
        self.assertGreater(places(up)[:, 2].min(), 0.0)

    def test_margins(self):
        """The lattice is that of the array, whatever is empty along its sides."""
        z = dome()
        z[:7], z[-5:], z[:, :3], z[:, -9:] = np.nan, np.nan, np.nan, np.nan
        top = sh.horizon(z, origin=(100.0, 200.0), spacing=(25.0, 50.0), vertical_step=1.0)
        self.assertEqual(sh.details(top).lattice_dimensions[:2].tolist(), [COLUMNS, ROWS])
        np.testing.assert_allclose(sh.details(top).lattice_to_world[:2, 3], (100.0, 200.0), atol=1e-9)
        self.assertEqual(sh.surface(top, largest_error=1.0).GetNumberOfLines(), 1)
        column = vtk_to_numpy(top.GetPointData().GetArray("Column"))
        np.testing.assert_allclose(places(top)[:, :2], column * (25.0, 50.0) + (100.0, 200.0))
        whole = sh.hole_filling(top, extrapolation_distance=100)
        self.assertEqual(whole.GetNumberOfPoints(), ROWS * COLUMNS)

    def test_sheets(self):
        """Both sides of a reverse fault, by names."""
        j, i = np.mgrid[0:40, 0:60]
        points = np.vstack([np.column_stack((i[:, part].ravel(), j[:, part].ravel(), np.full(1400, z)))
                            for part, z in ((slice(0, 35), 100.0), (slice(25, 60), 130.0))])
        for name, names in ((None, ["Horizon 1", "Horizon 1 (2)"]), ("Top", ["Top", "Top (2)"])):
            found = sh.horizon_from_points(points, name, duplicate_policy="Sheets")
            self.assertEqual(list(found), names)
            self.assertEqual(sum(data.GetNumberOfPoints() for data in found.values()), 2800)
        with self.assertWarnsRegex(UserWarning, "."):
            self.assertEqual(sh.horizon_from_points(points).GetNumberOfPoints(), 2400)

    def test_meshes_and_nothing(self):
        """Stages of points refuse meshes by name, and all functions what is empty."""
        mesh = sh.surface(sh.horizon(dome(), vertical_step=1.0), largest_error=1.0)
        for name in ("despiking", "hole_filling", "faults", "exterior_boundary", "boundary_simplification",
                     "rough_simplification", "elaborate_simplification"):
            with self.assertRaisesRegex(ValueError, "a mesh of %d triangles, expected the points of a horizon" % mesh.GetNumberOfPolys()):
                getattr(sh, name)(mesh)
        empty = vtkPolyData()
        calls_ = [lambda function=function: function(empty) for function in (*(getattr(sh, name) for name in stages.STAGES), sh.surface)]
        for call in (*calls_, lambda: sh.distance(empty, mesh), lambda: sh.layers([mesh, empty]), lambda: sh.crossings({"A": empty})):
            with self.assertRaisesRegex(ValueError, "without points, expected some"):
                call()

    def test_points(self):
        grid = sh.horizon(dome(), spacing=(25, 25))
        found = sh.horizon_from_points(places(grid) * (1.0, 1.0, -1.0))
        self.assertEqual(places(found).tobytes(), places(grid).tobytes())
        scattered = np.random.default_rng(1).random((500, 3)) * (1000.0, 1000.0, 10.0)
        with self.assertRaisesRegex(ValueError, "without a lattice.*gridding"):
            sh.horizon_from_points(scattered)
        self.assertGreater(sh.horizon_from_points(scattered, gridding="Plate").GetNumberOfPoints(), 100)

    def test_file(self):
        horizons = sh.read(DATA / "blobs.vsm")
        self.assertEqual(list(horizons), ["Horizon 1", "Horizon 2", "Horizon 3"])
        self.assertEqual(list(sh.read(str(DATA / "blobs.vsm"), horizons=[2])), ["Horizon 2"])
        path = FOLDER / "picks.dat"
        sh.write(horizons["Horizon 1"], path, "Top")
        self.assertEqual(list(sh.read(path, vertical_unit="m")), ["picks"])

    def test_cube(self):
        cube = vtkImageData()
        cube.SetDimensions(20, 20, 30)
        cube.AllocateScalars(10, 1)
        vtk_to_numpy(cube.GetPointData().GetScalars())[:] = np.repeat(np.sin(np.arange(30.0)), 400)
        found = sh.extract(cube, smallest_size=50, largest_number=3)
        self.assertEqual(len(found), 3)
        with self.assertRaisesRegex(TypeError, "read_cube"):
            sh.extract("cube.sgy")


class StagesTest(unittest.TestCase):
    def test_every_stage_is_a_function(self):
        classes = [name for name in dir(sh) if name.startswith("vtkHorizon") and issubclass(getattr(sh, name), sh.vtkHorizonStage)]
        for name in classes:
            stem = calls.snake(name[len("vtkHorizon"):])
            try:
                getattr(sh, name)()
            except (NotImplementedError, TypeError):
                continue
            function = getattr(sh, "distance" if stem == "surface_distance" else stem)
            self.assertIn(stem if stem != "surface_distance" else "distance", sh.functions.__all__)
            self.assertIn("Parameters\n", inspect.cleandoc(function.__doc__))
        self.assertEqual(inspect.signature(sh.hole_filling).parameters["largest_hole_size"].default, 2500)
        self.assertEqual(inspect.signature(sh.exterior_boundary).parameters["growth_strategy"].default,
                         ["Distance", "Clockwise"][sh.vtkHorizonExteriorBoundary().GetGrowthStrategy()])
        self.assertIn("lattice", sh.exterior_boundary.__doc__)

    def test_types(self):
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            stages.print_types()
        lines = [line for line in told.getvalue().splitlines() if line.startswith("def ")]
        self.assertEqual(len(lines), len(stages.STAGES))
        compile(told.getvalue(), "stages.pyi", "exec")
        self.assertIn("maximum_error: float | str = ...", next(line for line in lines if "decimation" in line))

    def test_old_keywords(self):
        top = sh.horizon(dome())
        with self.assertWarnsRegex(FutureWarning, "thread_width, expected spur_width"):
            narrow = sh.despiking(top, thread_width=64)
        self.assertEqual(narrow.GetNumberOfPoints(), sh.despiking(top, spur_width=64).GetNumberOfPoints())
        with self.assertWarnsRegex(FutureWarning, "elevation, expected z_from"):
            found = sh.read(DATA / "blobs.vsm", horizons=[2], elevation="RealZ")
        named = sh.read(DATA / "blobs.vsm", horizons=[2], z_from="RealZ")
        self.assertEqual(places(found["Horizon 2"]).tobytes(), places(named["Horizon 2"]).tobytes())
        with self.assertRaisesRegex(TypeError, "thread_width, expected one of"):
            sh.surface(top, thread_width=2)

    def test_chain(self):
        top = sh.horizon(dome(), vertical_unit="ms")
        mesh = sh.triangulation(sh.rough_simplification(sh.boundary_simplification(sh.exterior_boundary(top, radius=2))))
        self.assertGreater(mesh.GetNumberOfPolys(), 10)
        decimated = sh.decimation(sh.exterior_boundary(top), maximum_error=0.5)
        self.assertLessEqual(sh.details(decimated).largest_error, 0.5)

    def test_errors_have_units(self):
        top = sh.horizon(dome(), vertical_unit="ms", vertical_step=0.5)
        mesh = sh.surface(top, largest_error="2 ms")
        plain = sh.surface(top, largest_error=4.0)
        self.assertEqual(places(mesh).tobytes(), places(plain).tobytes())
        self.assertEqual(places(sh.surface(top, largest_error="0.002 s")).tobytes(), places(plain).tobytes())
        self.assertLessEqual(sh.distance(top, mesh, unit="World").figures["reference to mesh"]["largest"], 2.0 + 1e-9)
        self.assertGreater(sh.distance(top, mesh).percentile_95, 0.0)

    def test_errors_are_told_in_their_unit(self):
        """In that of the user, whatever that of z; without a unit in vertical indices."""
        top = sh.horizon(dome(), vertical_unit="ms", vertical_step=0.5)
        plain = sh.details(sh.surface(top, largest_error=4.0))
        for error, unit, per_index in (("2 ms", "ms", 0.5), ("0.002 s", "s", 0.0005)):
            mesh = sh.surface(top, largest_error=error)
            found = sh.details(mesh)
            self.assertEqual(str(found.chosen_maximum_error), str(heights.Height(error)))
            for name in ("largest_error", "mean_error", "largest_loop_error", "chosen_distance_threshold"):
                self.assertEqual(getattr(found, name).unit, unit)
                self.assertAlmostEqual(getattr(found, name), per_index * getattr(plain, name))
            self.assertEqual(found.chosen_outline_tolerance, plain.chosen_outline_tolerance)
            distance = sh.distance(top, mesh)
            self.assertEqual(distance.vertical.unit, unit)
            self.assertAlmostEqual(distance.vertical, found.largest_error)
            self.assertEqual(list(vars(distance))[0], "vertical")
            self.assertTrue(repr(distance).startswith("Distance(vertical=%.6g %s, largest=" % (distance.vertical, unit)))
        unknown = sh.surface(sh.horizon(dome(), vertical_step=0.5), largest_error="2 m")
        self.assertEqual(str(sh.details(unknown).chosen_maximum_error), "2 m")
        self.assertEqual(sh.details(sh.despiking(top, threshold="3 ms")).spike_threshold.unit, "ms")
        self.assertIs(type(sh.details(sh.surface(sh.despiking(top, threshold="3 ms"), 4.0)).largest_error), float)
        stack = {"Top": top, "Base": sh.horizon(dome() + 50.0, vertical_unit="ms", vertical_step=0.5)}
        made = sh.layers(stack, largest_error="2 ms")
        self.assertEqual(sh.details(made.horizons["Base"]).largest_error.unit, "ms")
        self.assertIs(type(sh.details(sh.layers(stack, 4.0).horizons["Base"]).largest_error), float)

    def test_automatic_error(self):
        """Six times the noise, whatever the vertical step; an error of 0 is one that can be asked for."""
        noise = np.random.default_rng(5).normal(0.0, 0.2, (200, 300))
        errors = []
        for step in (0.1, 1.0):
            top = sh.horizon(dome(200, 300) + noise, vertical_step=step)
            found = sh.details(sh.surface(top))
            errors.append(step * found.chosen_maximum_error)
            self.assertLess(found.triangle_count, 0.06 * 2 * top.GetNumberOfPoints())
            self.assertLessEqual(found.largest_error, found.chosen_maximum_error + 1e-9)
            self.assertAlmostEqual(6.0 * found.height_noise, found.chosen_maximum_error)
            self.assertFalse(hasattr(found, "height_rounding"))
        self.assertAlmostEqual(errors[0], errors[1], delta=1e-6)
        self.assertAlmostEqual(errors[0], 1.2, delta=0.1)
        self.assertEqual(sh.details(sh.surface(sh.horizon(dome()), 0.0)).chosen_maximum_error, 0.0)
        self.assertEqual(sh.details(sh.decimation(sh.exterior_boundary(top))).chosen_maximum_error, errors[1])
        base = sh.horizon(dome(200, 300) + 90.0 + 2.0 * noise, vertical_step=1.0)
        made = sh.layers({"Top": top, "Base": base})
        self.assertAlmostEqual(sh.details(made.cells).chosen_maximum_error, 2.4, delta=0.2)
        self.assertAlmostEqual(sh.details(made.cells).height_noise, 0.4, delta=0.04)
        for given in ({"largest_error": 1.0}, {"triangles": 500}):
            self.assertFalse({"height_noise", "height_rounding"} & vars(sh.details(sh.surface(top, **given))).keys())
        j, i = np.mgrid[0:30, 0:40]
        plane = sh.details(sh.surface(sh.horizon(1000.0 + 0.1 * i + 0.2 * j, vertical_step=1.0)))
        self.assertAlmostEqual(plane.height_rounding, 0.1 / 12.0 ** 0.5)
        self.assertAlmostEqual(6.0 * plane.height_rounding, plane.chosen_maximum_error)
        self.assertFalse(hasattr(plane, "height_noise"))

    def test_smallest_angle(self):
        """With the effort Fast, points are inserted beside slivers; the few that outlines leave are counted."""
        j, i = np.mgrid[0:100, 0:120]
        z = 1000.0 + 20.0 * np.sin(i / 9.0) * np.cos(j / 8.0)
        top, base = sh.horizon(z, vertical_step=1.0), sh.horizon(z + 40.0, vertical_step=1.0)
        counts = []
        for angle in (0.0, 20.0):
            found = sh.details(sh.surface(top, 1.0, smallest_angle=angle, effort="Fast"))
            self.assertLessEqual(found.largest_error, 1.0 + 1e-9)
            counts.append(found.triangle_count)
        self.assertGreater(counts[1], counts[0])
        self.assertLess(found.sliver_count, 0.01 * counts[1])
        angles = [least_angles(sh.layers({"Top": top, "Base": base}, 1.0, effort="Fast", smallest_angle=angle).horizons["Top"])
                  for angle in (0.0, 20.0)]
        self.assertLess(np.sum(angles[1] < 20.0), 0.7 * np.sum(angles[0] < 20.0))  # outlines are kept as they are

    def test_distance_leaves_open_what_the_mesh_does(self):
        """The horizon as read has the holes of its mesh, over which nothing is measured, and its radius."""
        row, column = np.mgrid[:60, :70]
        heights = 1000.0 + 0.3 * row + 40.0 * np.exp(-((column - 40) ** 2 + (row - 30) ** 2) / 60.0)
        heights[26:35, 36:45] = np.nan
        for spread in (heights, np.where(row % 2 == 0, heights, np.nan)):
            top = sh.horizon(spread)
            mesh = sh.surface(top, largest_error=0.5)
            self.assertEqual(sh.details(mesh).number_of_holes, 1)
            self.assertLessEqual(sh.distance(top, mesh).largest, 0.5 + 1e-9)
        self.assertLessEqual(sh.surface(top, triangles=50).GetNumberOfPolys(), 50)
        self.assertIs(type(sh.details(mesh).largest_error), float)

    def test_writing(self):
        mesh = sh.surface(sh.horizon(dome(), spacing=(25, 25)))
        grids = [form for form in functions.writing.GRID_FORMATS if form != "tif"]  # which takes GDAL
        for form in [*functions.writing.MESH_FORMATS, *grids]:
            sh.write(mesh, FOLDER / ("top." + form))
            self.assertGreater((FOLDER / ("top." + form)).stat().st_size, 100)
        top = sh.horizon(dome(), spacing=(25, 25))
        for form in grids:
            sh.write(top, FOLDER / ("points." + form))
            (points,) = sh.read(FOLDER / ("points." + form)).values()
            self.assertEqual(points.GetNumberOfPoints(), top.GetNumberOfPoints())
        (name, found), = sh.read(FOLDER / "top.ts").items()
        self.assertEqual((name, found.GetNumberOfPolys()), ("top", mesh.GetNumberOfPolys()))

    def test_pyvista(self):
        """Results are PyVista's once that is imported, and not before."""
        top = sh.horizon(dome())
        wrapped = mock.Mock(wrap=lambda data: ("wrapped", data))
        with mock.patch.dict(sys.modules, {"pyvista": wrapped}):
            self.assertEqual(sh.surface(top)[0], "wrapped")
        with without("pyvista"):
            self.assertIsInstance(sh.surface(top), vtkPolyData)


class ErrorsTest(unittest.TestCase):
    def test_first_errors(self):
        top = sh.horizon(dome(), vertical_unit="ms")
        bare = vtkPolyData()
        bare.SetPoints(top.GetPoints())
        for kind, words, call in (
                (ValueError, r"z of shape \(3,\), expected \(rows, columns\); horizon_from_points", lambda: sh.horizon(np.zeros(3))),
                (ValueError, r"points of shape \(3, 2\), expected \(n, 3\)", lambda: sh.horizon_from_points(np.zeros((3, 2)))),
                (ValueError, "z without a single value", lambda: sh.horizon(np.full((3, 3), np.nan))),
                (ValueError, "no points", lambda: sh.horizon_from_points(np.full((3, 3), np.nan))),
                (TypeError, r"ndarray, expected a horizon.*horizon\(z\) makes one", lambda: sh.surface(dome())),
                (ValueError, "LatticeDimensions.*horizon_from_points", lambda: sh.surface(bare)),
                (ValueError, "2 m for z in ms, expected ms or s .vertical_unit", lambda: sh.surface(top, "2 m")),
                (ValueError, "'two', expected a number", lambda: sh.surface(top, "two")),
                (ValueError, "expected at least 0, or -1 for automatic", lambda: sh.surface(top, -2.0)),
                (ValueError, "expected one of them", lambda: sh.surface(top, 1.0, 10)),
                (TypeError, "larget, expected one of", lambda: sh.surface(top, larget=1.0)),
                (ValueError, "distance_unit 'm', expected one of Lattice, World", lambda: sh.distance(top, sh.surface(top), "m")),
                (TypeError, r"^radius \(", lambda: sh.surface(top, radius="a")),
                (TypeError, "3 datasets, expected horizon", lambda: sh.decimation(top, top, top)),
                (FileNotFoundError, "nothing.dat: no such file", lambda: sh.read("nothing.dat")),
                (OSError, "a directory, expected a file", lambda: sh.read(FOLDER)),
                (ValueError, "set columns", lambda: sh.read(__file__)),
                (ValueError, "there is no horizon 9", lambda: sh.read(DATA / "blobs.vsm", horizons=[9])),
                (ValueError, "the extension .foo, expected one of", lambda: sh.write(top, "x.foo")),
                (ValueError, "expected a mesh: surface", lambda: sh.write(top, "x.ts")),
                (FileNotFoundError, "does not exist", lambda: sh.write(top, "/no/such/folder/x.dat"))):
            with self.subTest(words=words), self.assertRaisesRegex(kind, words):
                call()

    def test_memory(self):
        with mock.patch.object(calls, "update", side_effect=calls.HorizonError("more data than memory, expected less")):
            with self.assertRaises(MemoryError):
                sh.surface(sh.horizon(dome()))

    def test_warnings(self):
        with self.assertWarnsRegex(UserWarning, "2399 of 2400 z are negative, so that these may be elevations or depths"):
            z = -dome()
            z[0, 0] = 1.0
            sh.horizon(z)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sh.surface(sh.horizon(dome()))


class WatchingTest(unittest.TestCase):
    def test_progress(self):
        """By tqdm where it is, and as well without."""
        bars = []

        class Bar(mock.Mock):
            n = 0.0

            def update(self, step):
                self.n += step

        def tqdm(**given):
            bars.append(Bar(**given))
            return bars[-1]

        module = types.SimpleNamespace(tqdm=tqdm)
        with mock.patch.dict(sys.modules, {"tqdm": types.SimpleNamespace(auto=module), "tqdm.auto": module}):
            sh.surface(sh.horizon(dome()))
        self.assertEqual(bars[-1].desc, "surface")
        self.assertAlmostEqual(bars[-1].n, 1.0)
        with without("tqdm", "tqdm.auto"):
            sh.surface(sh.horizon(dome()))

    @unittest.skipIf(sys.platform == "win32", "no process can send itself Ctrl-C there")
    def test_interrupt(self):
        rough = np.random.default_rng(1).random((1500, 1500)) * 100.0
        top = sh.horizon(rough)
        before = signal.getsignal(signal.SIGINT)
        timer = threading.Timer(SECONDS_UNTIL_INTERRUPT, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            sh.surface(top, 0.01)
        timer.join()
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        self.assertGreater(sh.surface(sh.horizon(dome())).GetNumberOfPolys(), 0)

    def test_other_thread(self):
        results = []
        (thread := threading.Thread(target=lambda: results.append(sh.surface(sh.horizon(dome())).GetNumberOfPolys()))).start()
        thread.join()
        self.assertGreater(results[0], 0)


def load_tests(_loader, tests, _pattern):
    """With the examples of all texts."""
    for module in (functions, making, calls):
        tests.addTests(doctest.DocTestSuite(module))
    return tests


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    shutil.copy(DATA / "sample.vsm", FOLDER)
    os.chdir(FOLDER)
    unittest.main(argv=sys.argv[:1], verbosity=2)
