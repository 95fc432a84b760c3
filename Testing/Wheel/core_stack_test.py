# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package for numpy: stages of several horizons, lines, cubes and the stages of the thesis, measured with numpy alone.

Argument: a folder for files.
"""

import pathlib
import sys
import unittest

import numpy as np
import seismichorizons as sh

FOLDER = pathlib.Path(sys.argv[1])
PLACE = {"origin": (4e5, 6e6), "column_step": (24.0, 7.0), "row_step": (-7.0, 24.0)}
BIN = 24.0**2 + 7.0**2


def noisy(seed, rows=60, columns=80):
    random = np.random.default_rng(seed)
    j, i = np.mgrid[0:rows, 0:columns]
    return 1500.0 + 40.0 * np.sin(i / 13.0) * np.cos(j / 9.0) + random.normal(0.0, 0.3, i.shape)


def cube(seed=1, rows=30, columns=40, samples=100):
    """A cube with one event, of amplitude 1, and its z."""
    random = np.random.default_rng(seed)
    j, i = np.mgrid[0:rows, 0:columns]
    event = 1180.0 + 20.0 * np.sin(i / 9.0) + 10.0 * np.cos(j / 7.0)
    z = 1000.0 + 4.0 * np.arange(samples)
    values = np.exp(-(((z - event[..., None]) / 10.0) ** 2)) + 0.05 * random.normal(size=(rows, columns, samples))
    lattice = sh.Lattice((rows, columns), first_z=1000.0, vertical_step=4.0, indices=samples, lines=(100.0, 1.0, 200.0, 2.0), **PLACE)
    return sh.Cube(values.astype(np.float32), lattice, vertical_unit="ms"), event


def volume_of(mesh):
    """The volume inside a closed surface that faces outwards, by the divergence theorem."""
    a, b, c = (mesh.points[mesh.triangles[:, n]] - mesh.points.mean(axis=0) for n in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0


class StackTest(unittest.TestCase):
    def test_layers(self):
        top, middle = noisy(1), noisy(2) + 30.0
        base = middle + 25.0 - 0.4 * np.arange(80)  # pinches out, and crosses
        top[20:26, 30:40] = np.nan
        horizons = {name: sh.horizon(z, name=name, **PLACE) for name, z in (("Top", top), ("Middle", middle), ("Base", base))}
        made = sh.layers(horizons, 0.5, crossings=["mean", "upper_wins"])
        self.assertEqual(made.names, ["Top to Middle", "Middle to Base"])
        for number, body in enumerate(made.bodies.values()):
            edges = np.concatenate([body.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]).tolist()
            self.assertEqual(sorted(map(tuple, edges)), sorted((b, a) for a, b in edges))  # closed, and turned one way
            self.assertAlmostEqual(volume_of(body), made.figures["volume"][number], delta=1e-6 * made.figures["volume"][number])
            cells = sum(made.volume[size][made.layer[size] == number].sum() for size in made.cells)
            self.assertAlmostEqual(cells, made.figures["volume"][number], delta=1e-6 * made.figures["volume"][number])
        inner = np.clip(np.minimum(base - middle, 1e9), 0.0, None)[1:-1, 1:-1].sum() * BIN
        self.assertLess(abs(made.figures["volume"][1] / inner - 1.0), 0.12)  # outer columns count by half
        for ending in ("msh", "inp", "disv"):
            made.write(FOLDER / ("layers." + ending))
            self.assertGreater((FOLDER / ("layers." + ending)).stat().st_size, 1000)
        with self.assertRaisesRegex(ValueError, "expected mean"):
            sh.layers(horizons, crossings="both")
        with self.assertRaisesRegex(ValueError, "expected at least 2"):
            sh.layers({"Top": horizons["Top"]})

    def test_contact(self):
        z = np.full((20, 30), 1000.0)
        made = sh.layers({"a": sh.horizon(z, spacing=(25, 25)), "b": sh.horizon(z + 40.0, spacing=(25, 25))}, contact=1010.0)
        self.assertAlmostEqual(made.figures["volume_above_contact"][0] / made.figures["volume"][0], 0.25)

    def test_crossings(self):
        upper, lower = noisy(3), noisy(4) + 2.0 * np.cos(np.arange(80) / 5.0)
        made = sh.crossings({"a": sh.horizon(upper, **PLACE), "b": sh.horizon(lower, **PLACE)}, order="as_given")
        a, b = made["a"].grid(), made["b"].grid()
        crossed = upper > lower
        np.testing.assert_allclose(a, np.where(crossed, (upper + lower) / 2.0, upper), atol=1e-9)
        np.testing.assert_allclose(b, np.where(crossed, (upper + lower) / 2.0, lower), atol=1e-9)
        np.testing.assert_allclose(made["a"].grid("Moved"), a - upper, atol=1e-9)

    def test_distance(self):
        """Vertical distances are those of the heights under a mesh; somebody else's mesh may be arrays."""
        horizon = sh.horizon(noisy(5), **PLACE)
        mesh = sh.surface(horizon, 2.0)
        found = sh.distance(horizon, mesh)
        self.assertAlmostEqual(np.nanmax(np.abs(found.vertical_of_reference)), mesh.largest_error, delta=1e-6)
        self.assertLessEqual(np.abs(found.of_reference).max(), np.nanmax(np.abs(found.vertical_of_reference)) + 1e-9)
        lifted = sh.distance((mesh.points, mesh.triangles), (mesh.points + (0.0, 0.0, 3.0), mesh.triangles))
        np.testing.assert_allclose(lifted.vertical_of_reference, -3.0, atol=1e-6)  # it is below
        self.assertLessEqual(lifted.largest, 3.0 + 1e-6)


class LinesTest(unittest.TestCase):
    def setUp(self):
        self.horizon = sh.horizon(noisy(6), spacing=(25, 25))

    def test_traces_cut(self):
        line = np.array([(1012.5, -100.0, 0.0), (1012.5, 3000.0, 0.0)])  # between columns 40 and 41
        found = sh.faults(self.horizon, lines=[line])
        self.assertEqual((len(found), set(found.links[:, 0]), set(found.links[:, 2]), len(found.links)), (1, {40}, {0}, 60))
        open_mesh = sh.surface(self.horizon, 2.0, faults=found)
        east = (open_mesh.columns[:, 0] > 40)[open_mesh.triangles].sum(axis=1)
        self.assertTrue(np.isin(east, (0, 3)).all())
        closed = sh.surface(self.horizon, 2.0, faults=found, close_faults=True)
        self.assertEqual(len(closed), len(open_mesh) + closed.details["fault_triangle_count"])

    def test_polygons_blank(self):
        square = np.array([(500, 400, 0), (800, 400, 0), (800, 700, 0), (500, 700, 0), (500, 400, 0)], float) + 1.0
        found = sh.faults(self.horizon, lines=[square])
        x, y = self.horizon.x, self.horizon.y
        inside = (x > 501) & (x < 801) & (y > 401) & (y < 701)
        self.assertEqual(len(found.horizon), len(self.horizon) - int(inside.sum()))
        self.assertEqual(len(sh.faults(self.horizon, lines=[square], polygons="cut").horizon), len(self.horizon))

    def test_files(self):
        path = FOLDER / "faults.pl"
        path.write_text("GOCAD PLine 1\nHEADER {\nname:F1\n}\nILINE\nVRTX 1 1012.5 -100 -1500\nVRTX 2 1012.5 3000 -1500\nSEG 1 2\nEND\n")
        lines = sh.read_faults(path)
        self.assertEqual((len(lines), lines.names[0].split()[0]), (1, "F1"))
        self.assertEqual(len(sh.faults(self.horizon, lines=lines).links), 60)
        with self.assertWarnsRegex(UserWarning, "none of 1 fault polylines"):
            sh.faults(self.horizon, lines=[np.array([(9e6, 9e6, 0.0), (9e6, 9.1e6, 0.0)])])


class CubeTest(unittest.TestCase):
    def test_the_event_is_found(self):
        seismic, event = cube()
        found = sh.extract(seismic, largest_number=3)
        first = next(iter(found.values()))
        self.assertEqual(len(first), event.size)
        np.testing.assert_allclose(first.grid(), event, atol=3.0)
        self.assertGreater(sh.amplitudes(seismic, first)["CubeAmplitude"].min(), 0.7)
        np.testing.assert_array_equal(first.inlines, 100.0 + first.columns[:, 1])

    def test_guides_and_limits(self):
        seismic, event = cube(2)
        x, y = seismic.lattice.places(np.array([5, 20, 35]), np.array([5, 15, 25]))
        picks = np.column_stack((x, y, event[[5, 15, 25], [5, 20, 35]]))
        guided = sh.extract(seismic, {"Top": picks})
        self.assertEqual(list(guided), ["Top"])
        np.testing.assert_allclose(guided["Top"].grid(), event, atol=3.0)
        self.assertEqual(int((guided["Top"]["Origin"] == 0).sum()), 3)
        below = sh.horizon(event + 40.0, vertical_unit="ms", **PLACE)
        for one in sh.extract(seismic, limits=[below], limit_side="below").values():
            self.assertTrue((one.z >= (event + 40.0)[one.columns[:, 1], one.columns[:, 0]]).all())

    def test_missing_samples(self):
        seismic, event = cube(3)
        known = np.ones(seismic.values.shape, bool)
        known[10:20, 10:20] = False
        seismic.known = known
        first = next(iter(sh.extract(seismic, largest_number=1).values()))
        self.assertTrue(np.isnan(first.grid()[10:20, 10:20]).all())


class ThesisTest(unittest.TestCase):
    def test_stages_one_by_one(self):
        z = noisy(7)
        z[20:30, 30:45] = np.nan
        horizon = sh.horizon(z, attributes={"amplitude": z, "count": np.arange(z.size).reshape(z.shape)}, **PLACE)
        outlined = sh.exterior_boundary(horizon, keep_holes=True)
        self.assertEqual([len(loop) for loop in outlined.outlines], [276, 50])  # inner corners are cut diagonally
        fewer = sh.boundary_simplification(outlined, method="fewest_points", distance_threshold=0.75, outline_tolerance=0.75)
        self.assertLess(sum(map(len, fewer.outlines)), 200)
        rough = sh.rough_simplification(fewer)
        self.assertEqual(int(rough.counts.sum()), len(horizon))
        elaborate = sh.elaborate_simplification(rough, flatness_threshold=0.1)
        self.assertLess(len(elaborate.points), len(rough.points))
        mesh = sh.triangulation(elaborate)
        self.assertEqual(len(mesh.points), len(elaborate.points))
        self.assertEqual(mesh["count"].dtype.kind, "i")
        for one in (sh.decimation(fewer, points=400), sh.decimation(fewer, reduction=0.9), sh.decimation(fewer, 1.0)):
            self.assertLess(len(one.points), 0.2 * len(horizon))
        self.assertLessEqual(sh.decimation(fewer, 1.0).details["largest_inner_error"], 1.0 + 1e-9)
        with self.assertRaisesRegex(ValueError, "before it is meshed"):
            sh.rough_simplification(mesh)


class SeveralTest(unittest.TestCase):
    def test_tiles_fit_at_their_border(self):
        j, i = np.mgrid[0:61, 0:50]
        z = 900.0 + 30.0 * np.sin(i / 7.0) * np.cos(j / 9.0) + np.random.default_rng(4).normal(0.0, 0.3, i.shape)

        def border(rows, **options):
            points = sh.surface(sh.horizon(np.where(rows(j), z, np.nan), spacing=(25.0, 25.0), vertical_step=0.5), 2.0, **options).points
            return np.array(sorted(map(tuple, points[points[:, 1] == 750.0])))

        for options, is_equal in (({"radius": 1, "outline_tolerance": 0, "distance_threshold": 0}, True), ({}, False)):
            one, other = (border(rows, **options) for rows in (lambda j: j <= 30, lambda j: j >= 30))
            self.assertEqual(np.array_equal(one, other) and len(one) == 50, is_equal)

    def test_one_file_of_several(self):
        two = {name: sh.horizon(noisy(seed), attributes={"amplitude": noisy(seed)}, vertical_unit="ms", **PLACE) for name, seed in (("Top", 1), ("Base", 2))}
        sh.write(two, FOLDER / "two.dat")
        back = sh.read(FOLDER / "two.dat")
        self.assertEqual(list(back), ["Top", "Base"])
        for name in two:
            np.testing.assert_allclose(back[name].grid(), two[name].grid(), atol=1e-9)
            np.testing.assert_array_equal(back[name]["amplitude"], two[name]["amplitude"])
        meshes = {name: sh.surface(one, "2 ms") for name, one in two.items()}
        sh.write(meshes, FOLDER / "two.ts")
        for name, mesh in sh.read_mesh(FOLDER / "two.ts").items():
            np.testing.assert_array_equal(mesh.points, meshes[name].points)
            np.testing.assert_array_equal(mesh.triangles, meshes[name].triangles)
            np.testing.assert_array_equal(mesh["amplitude"], meshes[name]["amplitude"])
        sh.write(two, FOLDER / "each.irap")
        self.assertEqual({path.name for path in FOLDER.glob("each*")}, {"each_Top.irap", "each_Base.irap"})
        with self.assertRaisesRegex(ValueError, "a mesh in the format of GOCAD"):
            sh.read(FOLDER / "two.ts")


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], warnings="ignore")
