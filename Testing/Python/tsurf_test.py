# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of GOCAD that the program meshes anew: what is no height field is refused with the place, and errors are measured
from the triangles of the file.

Arguments: program, folder of the data, work folder, then the interpreter.
"""

import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import mesh_checks
import numpy as np
import seismichorizons as sh
from seismichorizons_command import overlay, pipeline, reading, volumes, writing
from seismichorizons_command.core import HorizonError

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
INTERPRETER = sys.argv[4:]
REFUSED = r"z (\S+) and (\S+) at x (\S+), y (\S+), expected one z at each position: a closed body, a fold or a wall is not a horizon"


def lattice(height, n=12, step=10.0):
    """Vertices and triangles of a surface over n x n places."""
    x, y = (step * axis.ravel() for axis in np.meshgrid(np.arange(n), np.arange(n)))
    first = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    corners = np.concatenate([np.stack((first, first + 1, first + n), axis=1),
                              np.stack((first + 1, first + n + 1, first + n), axis=1)])
    return np.stack((x, y, height(x, y)), axis=1), corners


def joined(*surfaces):
    """Surfaces as parts of one."""
    begins = np.cumsum([0] + [len(vertices) for vertices, _ in surfaces])
    return (np.concatenate([vertices for vertices, _ in surfaces]),
            np.concatenate([corners + begin for (_, corners), begin in zip(surfaces, begins)]))


def ball(n=24, radius=100.0, center=(500.0, 500.0, 500.0)):
    """A closed body."""
    around, down = np.meshgrid(np.arange(n), np.arange(n + 1))
    angles = 2.0 * np.pi * around.ravel() / n + 0.01, np.pi * down.ravel() / n
    vertices = radius * np.stack((np.cos(angles[0]) * np.sin(angles[1]), np.sin(angles[0]) * np.sin(angles[1]),
                                  np.cos(angles[1])), axis=1) + center
    first = np.arange(n * n)
    right = first - first % n + (first + 1) % n
    return vertices, np.concatenate((np.stack((first, right, first + n), axis=1), np.stack((right, right + n, first + n), axis=1)))


def divided(mesh, n):
    """The same surface in triangles whose edges are an n-th as long, as points and triangles."""
    upward = [((i, j), (i + 1, j), (i, j + 1)) for i in range(n) for j in range(n - i)]
    downward = [((i + 1, j), (i + 1, j + 1), (i, j + 1)) for i in range(n) for j in range(n - i - 1)]
    parts = np.array(upward + downward) / n
    weights = np.concatenate((1.0 - parts.sum(axis=2, keepdims=True), parts), axis=2)
    places = np.einsum("tcw,mwx->mtcx", weights, mesh.points[mesh.triangles]).reshape(-1, 3)
    return places, np.arange(len(places)).reshape(-1, 3)


def dome(x, y):
    return 1000.0 + 0.02 * ((x - 50.0) ** 2 + (y - 60.0) ** 2)


class SurfaceTest(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def write(self, *surfaces, depth=False, change=str):
        """A file of surfaces, which are named Top, Top2 and so on."""
        lines = []
        for number, (vertices, corners) in enumerate(surfaces):
            lines += ["GOCAD TSurf 1", "HEADER {", "name: Top%s" % (number + 1 if number else ""), "}",
                      "GOCAD_ORIGINAL_COORDINATE_SYSTEM", "NAME Default", 'AXIS_NAME "X" "Y" "Z"', 'AXIS_UNIT "m" "m" "m"',
                      "ZPOSITIVE " + ("Depth" if depth else "Elevation"), "END_ORIGINAL_COORDINATE_SYSTEM", "TFACE",
                      *("VRTX %d %.4f %.4f %.4f" % (n + 1, *vertex) for n, vertex in enumerate(vertices)),
                      *("TRGL %d %d %d" % tuple(triangle + 1) for triangle in corners), "END"]
        path = self.folder / "surfaces.ts"
        path.write_text("".join(change(line) + "\n" for line in lines), encoding="utf-8")
        return path

    def run_program(self, *arguments):
        done = subprocess.run([*INTERPRETER, str(PROGRAM), "--no-pictures", "--output-folder", str(self.folder / "results"),
                               *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100)
        self.assertNotIn("Traceback", done.stderr)
        return done.returncode, done.stderr, done.stdout

    def refused(self, path, *arguments):
        """Both z, x and y of the message."""
        code, told, _ = self.run_program(*arguments, path)
        self.assertEqual(code, 1)
        self.assertFalse((self.folder / "results").exists())
        found = re.search(REFUSED, told)
        self.assertTrue(found, told)
        return tuple(map(float, found.groups()))

    def test_closed_body(self):
        for depth in (False, True):
            z, other, x, y = self.refused(self.write(ball(), depth=depth))
            away = math.hypot(x - 500.0, y - 500.0)
            self.assertLess(away, 100.0)
            half = math.sqrt(100.0 ** 2 - away ** 2)
            self.assertLess(abs(sorted((z, other))[0] - (500.0 - half)), 5.0)
            self.assertLess(abs(sorted((z, other))[1] - (500.0 + half)), 5.0)

    def test_fold(self):
        """A surface that turns back over itself, as at a reverse fault: x runs to and fro along it."""
        vertices, corners = lattice(lambda x, y: 3.0 * x)
        along = vertices[:, 0]
        vertices[:, 0] = np.where(along > 60.0, 120.0 - along, along)
        z, other, x, y = self.refused(self.write((vertices, corners)))
        self.assertLess(max(abs(min(z, other) - 3.0 * x), abs(max(z, other) - 3.0 * (120.0 - x))), 1e-2)
        self.assertTrue(0.0 <= y <= 110.0)

    def test_wall(self):
        """Two levels and the triangles between them."""
        vertices, corners = lattice(lambda x, y: np.where(x > 55.0, 80.0, 20.0))
        vertices[:, 0] = np.where((vertices[:, 0] > 55.0), vertices[:, 0] - 10.0, vertices[:, 0])
        z, other, x, y = self.refused(self.write((vertices, corners)))
        self.assertEqual((sorted((z, other)), x), ([20.0, 80.0], 50.0))

    def test_parts_over_each_other(self):
        high = lattice(lambda x, y: 900.0 + 0 * x)
        for part in ((high[0] + (55.0, 55.0, 0.0), high[1]), (high[0] * (0.01, 0.01, 1.0) + (31.0, 42.0, 0.0), high[1])):
            z, other, x, y = self.refused(self.write(joined(lattice(dome), part)))
            self.assertEqual(max(0.0, 900.0 - min(z, other)), 0.0)
            self.assertLess(abs(max(z, other) - dome(x, y)), 1.0)
        # Side by side, at faults too, and one over the other at the same height, they are one horizon.
        for part in ((high[0] + (120.0, 0.0, 0.0), high[1]), (high[0] + (110.0, 0.0, 0.0), high[1]), lattice(dome)):
            code, told, _ = self.run_program(self.write(joined(lattice(dome), part)))
            self.assertEqual(code, 0, told)

    def test_only_chosen_surfaces_count(self):
        path = self.write(lattice(dome), ball())
        self.refused(path)
        code, told, _ = self.run_program("--horizons", "Top", "--", path)
        self.assertEqual(code, 0, told)
        with self.assertRaisesRegex(HorizonError, "surfaces.ts: Top2: " + REFUSED):
            reading.read(path)
        self.assertEqual([name for name, _ in reading.read(path, ["Top"])[0]], ["Top"])
        for chosen in ((), ("--horizons", "Top", "Top2")):
            code, told, table = self.run_program("--json", "--leave-out-invalid", path, *chosen)
            self.assertEqual((code, len(json.loads(table)["files"][0]["horizons"])), (0, 1))
            self.assertRegex(told, "warning: .*surfaces.ts: Top2: " + REFUSED + "; it is left out")

    def error_from_file(self, path):
        """The largest vertical distance between the mesh and the triangles of the file, by many places on these."""
        mesh = mesh_checks.read(next((self.folder / "results").glob("*.vtp")))
        found = sh.distance(divided(sh.read_mesh(path)["Top"], 20), (mesh_checks.coordinates(mesh), mesh_checks.triangles(mesh)))
        return max(np.nanmax(np.abs(vertical)) for vertical in (found.vertical_of_reference, found.vertical_of_mesh))

    def test_error_is_that_of_the_file(self):
        """A rough surface of few vertices: the columns of a lattice miss them."""
        rng = np.random.default_rng(7)
        vertices, corners = lattice(lambda x, y: 1000.0 + 30.0 * rng.standard_normal(x.shape))
        path = self.write((vertices, corners))
        for steps in ((), ("--column-step", "7", "0", "--row-step", "0", "7")):
            shutil.rmtree(self.folder / "results", ignore_errors=True)
            code, told, table = self.run_program("--json", "--largest-error", "5m", *steps, path)
            self.assertEqual(code, 0, told)
            horizon = json.loads(table)["files"][0]["horizons"][0]
            error = horizon["vertical_error"]["largest"] * horizon["vertical_step"]
            found = self.error_from_file(path)
            self.assertGreaterEqual(error, found * (1.0 - 1e-9))
            self.assertLess(error, 1.2 * found)
            self.assertGreater(error, 5.0)
            self.assertRegex(told, r"warning: surfaces.ts: Top: error %.4g m at x \S+, y \S+ of the file's triangles, and \S+ at "
                             "the columns of the lattice: shorter --column-step" % error)

    def test_exact_surfaces_are_told_so(self):
        code, told, table = self.run_program("--json", self.write(lattice(lambda x, y: 5.0 + 0.25 * x - 0.5 * y)))
        self.assertEqual((code, told), (0, ""))
        horizon = json.loads(table)["files"][0]["horizons"][0]
        self.assertLess(horizon["vertical_error"]["largest"] * horizon["vertical_step"], 1e-6)

    def test_fine_lattices_keep_the_error(self):
        code, told, table = self.run_program("--json", "--largest-error", "2m", self.write(lattice(dome)))
        self.assertEqual((code, told), (0, ""))
        horizon = json.loads(table)["files"][0]["horizons"][0]
        self.assertLess(horizon["vertical_error"]["largest"] * horizon["vertical_step"], 2.2)

    def test_more_triangles(self):
        vertices = np.array([(0.0, 0.0, 0.0), (100.0, 0.0, 40.0), (0.0, 100.0, 0.0), (100.0, 100.0, 0.0)])
        path = self.write((vertices, np.array([(0, 1, 2), (1, 3, 2)])))
        code, told, _ = self.run_program("--column-step", "3", "0", "--row-step", "0", "3", "--largest-error", "0.01m", path)
        self.assertEqual(code, 0)
        self.assertRegex(told, r"Top: \d+ triangles, and 2 in the file: a larger error or cell size makes fewer")
        self.assertRegex(told, r"Top: \S+ % of the area of the file's triangles is left out")

    def test_measured_error(self):
        """That of --measure-error is from the file, too."""
        path = self.write(lattice(dome))
        code, told, table = self.run_program("--json", "--measure-error", path)
        self.assertEqual(code, 0, told)
        horizon = json.loads(table)["files"][0]["horizons"][0]
        self.assertLessEqual(horizon["vertical_error"]["largest"], 3.0)
        self.assertIsNotNone(horizon["error"])

    def test_small_letters(self):
        path = self.write(lattice(dome), change=str.lower)
        code, told, table = self.run_program("--json", path)
        self.assertEqual(code, 0, told)
        self.assertEqual(json.loads(table)["files"][0]["horizons"][0]["name"], "top")


class GridTest(unittest.TestCase):
    def test_closed_bodies(self):
        """No format of one z in a column takes a body, which has two."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        top, base = (sh.horizon(np.full((20, 30), z) + slope * np.arange(30), spacing=(25, 25))
                     for z, slope in ((-10.0, 0.0), (-30.0, -0.5)))
        horizons = {"Top": top, "Base": base}
        body, = sh.layers(horizons).bodies.values()
        points = FOLDER / "horizons.dat"
        sh.write(horizons, points)
        found = dict(reading.read(points, VerticalDirection="Up")[0])
        made, _ = volumes.of_points(found, pipeline.Settings(layers={}), points.name)
        for form in ("irap", "gri", "zmap", "dat"):
            path = FOLDER / ("body." + form)
            path.unlink(missing_ok=True)
            with self.assertRaisesRegex(ValueError, "Top to Base.*no lattice"):
                sh.write(body, path)
            with self.assertRaisesRegex(HorizonError, r"heights \S+ and \S+ \(vertical indices\) of a mesh in column"):
                writing.write_data(made.bodies["Top to Base"], path, "Top to Base")
            self.assertFalse(path.exists())
            sh.write(sh.surface(top), path)


class OverlayTest(unittest.TestCase):
    """Random triangles, on whole numbers too, against each pair for itself."""

    def random(self, rng, whole):
        size = int(rng.integers(1, 60))
        triangles = 5.0 * rng.normal(size=(size, 1, 3)) + rng.normal(size=(size, 3, 3)) * 10.0 ** rng.uniform(-3, 1, (size, 1, 1))
        triangles = np.round(triangles) if whole else triangles
        return overlay.turned_left(triangles[overlay.doubled_areas(triangles) != 0.0])

    def test_pairs(self):
        rng = np.random.default_rng(1)
        for trial in range(40):
            one, other = self.random(rng, trial % 2), self.random(rng, trial % 2)
            low = np.maximum(one[:, None, :, :2].min(axis=2), other[None, :, :, :2].min(axis=2))
            high = np.minimum(one[:, None, :, :2].max(axis=2), other[None, :, :, :2].max(axis=2))
            expected = set(map(tuple, np.argwhere((low <= high).all(axis=2))))
            found = [tuple(pair) for pairs in overlay.pairs(one, other) for pair in pairs]
            self.assertEqual((len(found), set(found)), (len(expected), expected))
            twice = {tuple(pair) for pairs in overlay.pairs(one, one) for pair in pairs}
            own = [tuple(sorted(pair)) for pairs in overlay.pairs(one) for pair in pairs]
            self.assertEqual((len(own), set(own)), (len(set(own)), {pair for pair in twice if pair[0] < pair[1]}))

    def test_areas_and_gaps(self):
        rng = np.random.default_rng(2)
        for whole in (False, True):
            one, other = rng.normal(size=(500, 3, 3)), rng.normal(size=(500, 3, 3))
            if whole:
                one, other = rng.integers(0, 4, one.shape).astype(float), rng.integers(0, 4, one.shape).astype(float)
            wide = (overlay.doubled_areas(one) != 0.0) & (overlay.doubled_areas(other) != 0.0)
            one, other = overlay.turned_left(one[wide]), overlay.turned_left(other[wide])
            common = overlay.Common(one, other)
            places = [clipped(a, b) for a, b in zip(one, other)]
            areas = np.array([polygon_area(place) for place in places])
            self.assertLess(np.abs(common.areas - areas).max(), 1e-12)
            gaps = common.gaps().max(axis=1)
            for a, b, place, area, gap in zip(one, other, places, areas, gaps):
                if area > 1e-9:
                    self.assertAlmostEqual(gap, max(abs(plane(a, *p) - plane(b, *p)) for p in place), delta=1e-6 * (1 + gap))


def clipped(triangle, window):
    """The corners of what two triangles have in common, one edge of the window after the other."""
    places = [tuple(corner[:2]) for corner in triangle]
    for n in range(3):
        (ax, ay), (bx, by) = window[n, :2], window[(n + 1) % 3, :2]
        sides = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in places]
        kept = []
        for k, (place, side) in enumerate(zip(places, sides)):
            before, other = places[k - 1], sides[k - 1]
            if (side >= 0.0) != (other >= 0.0):
                part = other / (other - side)
                kept.append(tuple(b + part * (p - b) for b, p in zip(before, place)))
            if side >= 0.0:
                kept.append(place)
        places = kept
    return places


def polygon_area(places):
    return 0.5 * abs(sum(places[k - 1][0] * places[k][1] - places[k - 1][1] * places[k][0] for k in range(len(places))))


def plane(triangle, x, y):
    slopes = np.linalg.solve(triangle[1:, :2] - triangle[0, :2], triangle[1:, 2] - triangle[0, 2])
    return triangle[0, 2] + slopes @ ((x, y) - triangle[0, :2])


if __name__ == "__main__":
    unittest.main(argv=["tsurf_test"], verbosity=2)
