# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package by what people ask of it: units, figures, files, errors, warnings and texts, with numpy alone.

Arguments: the folder of the sample data, a folder for files.
"""

import contextlib
import dataclasses
import importlib.util
import inspect
import os
import pathlib
import signal
import sys
import threading
import time
import unittest
import warnings

import numpy as np
import seismichorizons as sh

DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
ROWS, COLUMNS = 40, 60
SECONDS_UNTIL_INTERRUPT = 0.3
GRIDS = ("irap", "gri", "zmap", "cps3", "grd", "asc")


def dome(rows=ROWS, columns=COLUMNS):
    j, i = np.mgrid[0:rows, 0:columns]
    return 1000.0 + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


def least_angles(mesh):
    """The smallest angle of each triangle on the lattice, in degrees."""
    lattice = mesh.lattice
    steps = np.column_stack((lattice.column_step, lattice.row_step))
    plan = np.linalg.solve(steps, (mesh.points[:, :2] - lattice.origin).T).T[mesh.triangles]
    sides = np.stack([np.linalg.norm(plan[:, n] - plan[:, (n + 1) % 3], axis=1) for n in range(3)])
    a, b, c = np.sort(sides, axis=0)
    return np.degrees(np.arccos(np.clip((b**2 + c**2 - a**2) / (2.0 * b * c), -1.0, 1.0)))


@contextlib.contextmanager
def silent():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


class StagesTest(unittest.TestCase):
    def test_units(self):
        """Errors with a unit are those in the unit of z, whatever the vertical step, and all figures are in the unit of z."""
        top = sh.horizon(dome(), vertical_unit="ms", vertical_step=0.5)
        plain = sh.surface(top, 2.0)
        for error in ("2 ms", "0.002 s", "2ms", "2"):
            mesh = sh.surface(top, error)
            np.testing.assert_array_equal(mesh.points, plain.points)
            self.assertEqual(mesh.details["chosen_maximum_error"], 2.0)
        self.assertEqual(plain.largest_error, max(plain.details["largest_inner_error"], plain.details["largest_loop_error"]))
        self.assertAlmostEqual(np.nanmax(plain.errors), plain.details["largest_inner_error"])
        self.assertTrue(1.0 < plain.details["largest_inner_error"] <= 2.0)
        found = sh.distance(top, plain)
        self.assertLessEqual(found.largest, 2.0 + 1e-9)
        vertical = np.nanmax(np.abs(np.concatenate((found.vertical_of_reference, found.vertical_of_mesh))))
        self.assertAlmostEqual(vertical, plain.largest_error)
        self.assertIn("vertically up to %.4g" % plain.largest_error, repr(found))
        self.assertIn("largest error %.4g ms" % plain.largest_error, repr(plain))
        self.assertEqual(sh.faults(top, "3 ms").smallest_throw, 3.0)
        spiked = dome()
        spiked[5, 7] += 30.0
        for threshold in (20.0, "20 ms", "0.02 s"):
            spikes = sh.despike(sh.horizon(spiked, vertical_unit="ms", vertical_step=0.5), threshold)
            self.assertEqual((spikes.left_out["spikes"], len(spikes)), (1, ROWS * COLUMNS - 1))

    def test_units_of_layers(self):
        """A unit of one height leaves others as they are."""
        away = 5.0 * np.sin(np.arange(COLUMNS) / 3.0)
        stack = {name: sh.horizon(dome() + own, vertical_unit="m") for name, own in (("Top", 0.0), ("Base", away))}
        with silent():
            plain = sh.layers(stack, 0.75, minimum_thickness=1.0, order="as_given").figures
            for error, thin in (("0.75 m", 1.0), (0.75, "1 m"), ("0.75 m", "1 m")):
                for name, values in sh.layers(stack, error, minimum_thickness=thin, order="as_given").figures.items():
                    np.testing.assert_array_equal(values, plain[name])

    def test_automatic_error(self):
        """It is six times the noise, whatever the vertical step; an error of 0 is one that can be asked for."""
        noise = np.random.default_rng(5).normal(0.0, 0.2, (200, 300))
        errors = []
        for step in (0.1, 1.0):
            top = sh.horizon(dome(200, 300) + noise, vertical_step=step)
            mesh = sh.surface(top)
            errors.append(mesh.details["chosen_maximum_error"])
            self.assertLess(len(mesh), 0.06 * 2 * len(top))
            self.assertLessEqual(mesh.largest_error, errors[-1] + 1e-9)
            self.assertAlmostEqual(6.0 * mesh.details["height_noise"], errors[-1])
            self.assertNotIn("height_rounding", mesh.details)
        self.assertAlmostEqual(errors[0], errors[1], delta=1e-6)
        self.assertAlmostEqual(errors[0], 1.2, delta=0.1)
        self.assertEqual(sh.surface(sh.horizon(dome()), 0.0).details["chosen_maximum_error"], 0.0)
        self.assertEqual(sh.decimation(sh.exterior_boundary(top)).details["chosen_maximum_error"], errors[1])
        made = sh.layers({"Top": top, "Base": sh.horizon(dome(200, 300) + 90.0 + 2.0 * noise, vertical_step=1.0)})
        for mesh in made.horizons.values():
            self.assertTrue(1.5 < mesh.largest_error <= 2.6, mesh.largest_error)  # of the horizon that has the most noise
        for given in ({"largest_error": 1.0}, {"triangles": 500}):
            self.assertFalse({"height_noise", "height_rounding"} & sh.surface(top, **given).details.keys())
        j, i = np.mgrid[0:30, 0:40]
        plane = sh.surface(sh.horizon(1000.0 + 0.1 * i + 0.2 * j, vertical_step=1.0)).details
        self.assertAlmostEqual(plane["height_rounding"], 0.1 / 12.0**0.5)
        self.assertAlmostEqual(6.0 * plane["height_rounding"], plane["chosen_maximum_error"])
        self.assertNotIn("height_noise", plane)

    def test_smallest_angle(self):
        """With the effort "fast", points are inserted beside slivers; the few that outlines leave are counted."""
        j, i = np.mgrid[0:100, 0:120]
        z = 1000.0 + 20.0 * np.sin(i / 9.0) * np.cos(j / 8.0)
        top, base = sh.horizon(z, vertical_step=1.0), sh.horizon(z + 40.0, vertical_step=1.0)
        meshes = [sh.surface(top, 1.0, smallest_angle=angle, effort="fast") for angle in (0.0, 20.0)]
        for mesh in meshes:
            self.assertLessEqual(mesh.largest_error, 1.0 + 1e-9)
            self.assertAlmostEqual(least_angles(mesh).min(), mesh.details["smallest_angle"], places=6)
        self.assertGreater(len(meshes[1]), len(meshes[0]))
        self.assertEqual(meshes[1].details["sliver_count"], np.count_nonzero(least_angles(meshes[1]) < 20.0 - 1e-9))
        self.assertLess(meshes[1].details["sliver_count"], 0.01 * len(meshes[1]))
        angles = [least_angles(sh.layers({"Top": top, "Base": base}, 1.0, effort="fast", smallest_angle=angle).horizons["Top"])
                  for angle in (0.0, 20.0)]
        self.assertLess(np.sum(angles[1] < 20.0), 0.7 * np.sum(angles[0] < 20.0))  # outlines are kept as they are

    def test_distance_leaves_open_what_the_mesh_does(self):
        """The horizon as read has the hole of its mesh, across which the distance would be four columns."""
        row, column = np.mgrid[:60, :70]
        heights = 1000.0 + 0.3 * row + 40.0 * np.exp(-((column - 40) ** 2 + (row - 30) ** 2) / 60.0)
        heights[26:35, 36:45] = np.nan
        for spread in (heights, np.where(row % 2 == 0, heights, np.nan)):
            with silent():
                top = sh.horizon(spread)
                mesh = sh.surface(top, 0.5)
            self.assertEqual(mesh.details["number_of_holes"], 1)
            found = sh.distance(top, mesh)
            self.assertLess(found.largest, 1.5)
            self.assertLessEqual(np.nanmax(np.abs(found.vertical_of_reference)), 0.5 + 1e-9)
        with silent():
            self.assertLessEqual(len(sh.surface(top, triangles=50)), 50)

    def test_left_out_is_told(self):
        """A row of points has no triangles: it is left out, and a warning says so, once and with its share."""
        heights = np.full((40, 50), np.nan)
        heights[:30, :40] = 100.0
        heights[35, 5:25] = 103.0
        heights[10:13, 10:13] = np.nan
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            mesh = sh.surface(sh.horizon(heights, spacing=(25.0, 10.0)), 3.0)
        self.assertEqual((mesh.ledger.known, mesh.ledger.left_out, mesh.ledger.covered), (1191, 20, 1191))
        self.assertAlmostEqual(mesh.ledger.column_area, 250.0)
        self.assertEqual(len(told), 1, told)
        self.assertRegex(str(told[0].message), r"^horizon: 1,191 columns covered, 1\.65 % of the points left out;")

    def test_meshes_and_nothing(self):
        """Stages of points refuse meshes, and what is empty."""
        top = sh.horizon(dome(), vertical_step=1.0)
        mesh = sh.surface(top, 1.0)
        stages = ("despike", "fill_holes", "faults", "exterior_boundary", "surface")
        for name in stages:
            with self.subTest(name=name), self.assertRaisesRegex(TypeError, "of Mesh, expected a Horizon"):
                getattr(sh, name)(mesh)
        for name in ("boundary_simplification", "rough_simplification", "elaborate_simplification", "triangulation", "decimation"):
            with self.subTest(name=name), self.assertRaisesRegex(ValueError, "a mesh of %d triangles, " % len(mesh)):
                getattr(sh, name)(mesh)
        empty = dataclasses.replace(top, columns=top.columns[:0], z=top.z[:0], filled=top.filled[:0])
        calls = {name: (lambda function=getattr(sh, name): function(empty)) for name in stages}
        calls.update({"layers": lambda: sh.layers({"A": top, "B": empty}), "crossings": lambda: sh.crossings({"A": empty}),
                      "thickness": lambda: sh.thickness(top, empty)})
        for name, call in calls.items():
            with self.subTest(name=name), self.assertRaisesRegex(ValueError, "without points, expected some"):
                call()
        with self.assertRaisesRegex(ValueError, "0 points and no triangles, expected"):
            sh.distance(empty, mesh)

    def test_thread(self):
        """Stages run in any thread."""
        made = []
        thread = threading.Thread(target=lambda: made.append(sh.surface(sh.horizon(dome()), 1.0)))
        thread.start()
        thread.join()
        np.testing.assert_array_equal(made[0].points, sh.surface(sh.horizon(dome()), 1.0).points)

    @unittest.skipIf(sys.platform == "win32", "no process can send itself Ctrl-C there")
    def test_after_an_interrupt(self):
        """Ctrl-C is handled as before, and the same work can be done."""
        before = signal.getsignal(signal.SIGINT)
        rough = sh.horizon(np.random.default_rng(1).random((700, 700)) * 100.0)
        timer = threading.Timer(SECONDS_UNTIL_INTERRUPT, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with silent(), self.assertRaises(KeyboardInterrupt):
            sh.surface(rough, 0.01)
            time.sleep(5.0)  # where the work took less time than that
        timer.join()
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        self.assertGreater(len(sh.surface(sh.horizon(dome()), 1.0)), 0)

    def test_values_of_other_kinds(self):
        """Are refused, whatever takes them."""
        top = sh.horizon(dome())
        outline, line = sh.exterior_boundary(top), np.arange(6.0).reshape(2, 3)
        for call in (lambda: sh.exterior_boundary(top, minimum_patch_size=3.0), lambda: sh.rough_simplification(outline, cell_size=4.0),
                     lambda: sh.fill_holes(top, "5"), lambda: sh.exterior_boundary(top, growth=3), lambda: sh.Lines(["a"], [line, line]),
                     lambda: sh.Lines(["a", "b"], [line, line], ["1"]), lambda: sh.read(DATA / "blobs.vsm", rows=(0.0, 0.5)),
                     lambda: sh.cube(np.zeros((3, 4, 5)), corners=[(0, 0), (0, 200), (75, 0), (85, 200)])):
            self.assertRaises((ValueError, TypeError), call)

    def test_progress(self):
        """It grows, within what is a fraction."""
        told = []
        sh.surface(sh.horizon(dome(200, 300)), 1.0, progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertTrue(0.0 <= told[0] < 0.5 < told[-1] <= 1.0, told)


class FilesTest(unittest.TestCase):
    def test_names(self):
        """Horizons are read by the names that are asked for; a file of one, which has none, gives it its own."""
        self.assertEqual(list(sh.read(DATA / "blobs.vsm")), ["Horizon 1", "Horizon 2", "Horizon 3"])
        self.assertEqual(list(sh.read(str(DATA / "blobs.vsm"), horizons=["Horizon 3", "Horizon 1"])), ["Horizon 3", "Horizon 1"])
        one = sh.read(DATA / "blobs.vsm")["Horizon 1"]
        sh.write(one, FOLDER / "picks.dat", name="Top")
        self.assertEqual(list(sh.read(FOLDER / "picks.dat", vertical_unit="m")), ["picks"])
        sh.write(one, FOLDER / "map.irap")
        self.assertEqual(list(sh.read(FOLDER / "map.irap")), ["map"])
        with silent():
            sh.write(sh.surface(one, 2.0), FOLDER / "named.ts", name="Top")
        self.assertEqual(list(sh.read_mesh(FOLDER / "named.ts")), ["Top"])

    def test_grids_of_meshes(self):
        """A grid of a mesh has the columns under it, each within the error; that of points has the points."""
        z = dome()
        z[10:20, 15:30] = np.nan
        top = sh.horizon(z, spacing=(25, 25))
        with silent():
            mesh = sh.surface(top, 1.0)
        for form in GRIDS:
            for name, data in (("mesh", mesh), ("points", top)):
                path = FOLDER / ("%s.%s" % (name, form))
                sh.write(data, path)
                (back,) = sh.read(path).values()
                self.assertEqual(back.direction, "up" if form == "asc" else "down")
                self.assertEqual(len(back), mesh.ledger.covered if data is mesh else len(top), path)
                columns = np.rint(np.column_stack((back.x, back.y)) / 25.0).astype(int)
                off = np.abs((-back.z if form == "asc" else back.z) - z[columns[:, 1], columns[:, 0]])
                self.assertLessEqual(np.nanmax(off), 1e-3 + (mesh.largest_error if data is mesh else 0.0), path)
        sh.write(mesh, FOLDER / "top.ts")
        (back,) = sh.read_mesh(FOLDER / "top.ts").values()
        self.assertEqual((back.name, len(back)), ("horizon", len(mesh)))

    def test_lines_of_text(self):
        """Those of one kind, a matrix of heights with its places, points of GOCAD, and columns to skip."""
        z = dome()[:20, :15]
        rows = [(500 + 25 * i, 900 - 50 * j, z[j, i]) for j in range(20) for i in range(15)]
        (FOLDER / "kinds.csv").write_text("id,X,Y,Z,kind\n" + "".join("a,%d,%d,%.9f,top\nb,,,,\nc,bad,0,,fault\n" % row for row in rows))
        (FOLDER / "matrix.txt").write_text("\n".join(" ".join("%.9f" % value for value in row) for row in z) + "\n")
        (FOLDER / "points.vs").write_text("GOCAD VSet 1\nHEADER {name:top}\n%sEND\n" % "".join("VRTX %d %d %d %.9f\n" % (n, *row) for n, row in enumerate(rows)))
        lattice = {"origin": (500, 900), "column_step": (25, 0), "row_step": (0, -50)}
        for name, options in (("kinds.csv", {"where": "kind=top"}), ("kinds.csv", {"where": "kind=top", "columns": "_ X Y Z kind"}),
                              ("matrix.txt", lattice), ("points.vs", {})):
            (made,) = sh.read(FOLDER / name, direction="down", **options).values()
            found = {(round(x), round(y)): height for x, y, height in zip(made.x, made.y, made.z)}
            self.assertEqual(len(made), len(rows), name)
            for x, y, height in rows:
                self.assertAlmostEqual(found[x, y], height, 8)
        self.assertRegex(sh.read(FOLDER / "kinds.csv", where="kind=top")["top"].taken[0], "; 600 lines of other kinds left out$")
        for options, words in (({}, "set origin=, column_step= and row_step="), ({"where": "kind"}, 'where "kind", expected COLUMN=VALUE')):
            with self.assertRaisesRegex(ValueError, words):
                sh.read(FOLDER / "matrix.txt" if not options else FOLDER / "kinds.csv", **options)
        with self.assertRaisesRegex(ValueError, "where, origin, column_step or row_step for sparse voxels, expected none"):
            sh.read(DATA / "blobs.vsm", where="kind=top")

    def test_layers(self):
        """Cells are written for others by the extension, or not at all."""
        made = sh.layers({"A": sh.horizon(np.zeros((3, 4))), "B": sh.horizon(np.ones((3, 4)))}, 0.75)
        for form in ("vtu", "msh", "inp", "disv"):
            made.write(FOLDER / ("few." + form))
            self.assertGreater((FOLDER / ("few." + form)).stat().st_size, 100)
        with self.assertRaisesRegex(ValueError, "expected"):
            made.write(FOLDER / "few.stl")
        self.assertFalse((FOLDER / "few.stl").exists())
        with self.assertRaises(FileNotFoundError):
            made.write(FOLDER / "none" / "few.vtu")


class ErrorsTest(unittest.TestCase):
    def test_first_errors(self):
        top = sh.horizon(dome(), vertical_unit="ms")
        cube = sh.Cube(np.zeros((3, 4, 5), np.float32), sh.Lattice((3, 4), indices=5))
        for kind, words, call in (
                (ValueError, r"heights of shape \(3,\), expected \(rows, columns\); horizon\(x, y, z\)", lambda: sh.horizon(np.zeros(3))),
                (ValueError, r"points of shape \(3, 2\), expected \(n, 3\)", lambda: sh.horizon(points=np.zeros((3, 2)))),
                (ValueError, "heights without a single value", lambda: sh.horizon(grid=np.full((3, 3), np.nan))),
                (ValueError, "0 picks, expected at least 1", lambda: sh.horizon(points=np.full((3, 3), np.nan))),
                (TypeError, r"ndarray, expected a Horizon.*horizon\(data\) makes one", lambda: sh.surface(dome())),
                (ValueError, "largest_error '2 m', a length, for a horizon with z in ms", lambda: sh.surface(top, "2 m")),
                (ValueError, "largest_error 'two', expected a number", lambda: sh.surface(top, "two")),
                (ValueError, "smallest_angle|smallest angle 70", lambda: sh.surface(top, smallest_angle=70.0)),
                (ValueError, "effort", lambda: sh.surface(top, effort="most")),
                (TypeError, "larget", lambda: sh.surface(top, larget=1.0)),
                (TypeError, "extraction from str, expected a Cube: read_cube", lambda: sh.extract("cube.sgy")),
                (ValueError, r"guide Top of shape \(4, 2\), expected \(n, 3\)", lambda: sh.extract(cube, {"Top": np.zeros((4, 2))})),
                (ValueError, "expected", lambda: sh.extract(cube, {"Top": np.zeros((0, 3))})),
                (FileNotFoundError, "nothing.dat: no such file", lambda: sh.read("nothing.dat")),
                (FileNotFoundError, "nothing.sgy: no such file", lambda: sh.read_cube("nothing.sgy")),
                (OSError, "a directory, expected a file|no such file", lambda: sh.read(FOLDER)),
                (ValueError, "set columns", lambda: sh.read(__file__)),
                (ValueError, "no horizon 9, expected one of Horizon 1", lambda: sh.read(DATA / "blobs.vsm", horizons=["9"])),
                (ValueError, "x.foo: a horizon, expected one of the extensions .vtp", lambda: sh.write(top, "x.foo")),
                (TypeError, "writing ndarray, expected a Mesh or a Horizon", lambda: sh.write(dome(), "x.dat")),
                (FileNotFoundError, "no folder /no/such/folder", lambda: sh.write(top, "/no/such/folder/x.dat"))):
            with self.subTest(words=words), self.assertRaisesRegex(kind, words):
                call()

    def test_classes(self):
        """Classes of VTK are in a module of their own, and where there is none it is an ImportError as of any other."""
        folder = pathlib.Path(sh.__file__).parent
        if not (folder / "vtk.py").exists():
            with self.assertRaises(ImportError):
                from seismichorizons import vtk
        elif importlib.util.find_spec("vtkmodules"):
            from seismichorizons import vtk
            self.assertTrue(hasattr(vtk, "vtkHorizonSurface"))


class TextsTest(unittest.TestCase):
    def test_parameters(self):
        """Each function says what it takes: all its parameters, and no other."""
        for name in sh.__all__:
            function = getattr(sh, name)
            if not inspect.isfunction(function):
                continue
            text = inspect.cleandoc(function.__doc__)
            with self.subTest(name=name):
                self.assertIn("Parameters\n", text)
                section = text.partition("Parameters\n----------\n")[2].partition("\n\n")[0]
                said = [word.strip() for line in section.splitlines() if not line.startswith(" ")
                        for word in line.partition(" : ")[0].replace("*", "").split(",")]
                self.assertEqual(sorted(said), sorted(inspect.signature(function).parameters))


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
