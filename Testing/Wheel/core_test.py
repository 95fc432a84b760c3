# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package for numpy: what it takes, and whether its promises hold, measured with numpy alone.

Arguments: the folder of the sample data, a folder for files, and optionally one with the meshes of the VTK classes
(core_peer.py).
"""

import doctest
import importlib
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time
import types
import unittest
import warnings

import numpy as np
import seismichorizons as sh

DATA, FOLDER = map(pathlib.Path, sys.argv[1:3])
PEER = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
X, Y = np.meshgrid(25.0 * np.arange(30), 25.0 * np.arange(20))
Z = 1000.0 + 0.01 * X


def rough(seed, rows=120, columns=150, **place):
    """A horizon with noise, steep flanks, holes, islands and an attribute."""
    random = np.random.default_rng(seed)
    j, i = np.mgrid[0:rows, 0:columns]
    z = 1500.0 + 60.0 * np.sin(i / 11.0) * np.cos(j / 17.0) + random.normal(0.0, 0.4, i.shape) + 40.0 * (i > 70 + j / 5)
    z[random.random(z.shape) < 0.03] = np.nan
    z[30:50, 40:60] = np.nan
    z[:, 100:104] = np.nan
    return sh.horizon(z, attributes={"amplitude": random.normal(size=z.shape), "count": np.arange(z.size).reshape(z.shape)}, **place)


def heights_under(mesh, columns):
    """Heights of the mesh at columns, by plane equations of triangles in columns of the lattice; nan outside."""
    found = np.full(len(columns), np.nan)
    order = {tuple(column): n for n, column in enumerate(columns.tolist())}
    for corners in mesh.triangles:
        places = mesh.columns[corners].astype(float)
        base = np.column_stack((places[1] - places[0], places[2] - places[0]))
        low, high = places.min(axis=0).astype(int), places.max(axis=0).astype(int)
        for i in range(low[0], high[0] + 1):
            for j in range(low[1], high[1] + 1):
                n = order.get((i, j))
                if n is None:
                    continue
                u, v = np.linalg.solve(base, np.subtract((i, j), places[0]))
                if min(u, v, 1.0 - u - v) >= -1e-9:
                    z = mesh.z[corners]
                    found[n] = z[0] + u * (z[1] - z[0]) + v * (z[2] - z[0])
    return found


class DoorTest(unittest.TestCase):
    def same(self, made):
        """The horizon of X, Y and Z, and nothing else."""
        self.assertEqual((made.lattice.shape, len(made)), ((20, 30), 600))
        np.testing.assert_allclose(made.grid() if made.lattice.column_step[0] > 0 and made.lattice.row_step[1] > 0 else None, Z)
        np.testing.assert_allclose(made.x, X[made.columns[:, 1], made.columns[:, 0]], atol=1e-6)
        np.testing.assert_allclose(made.y, Y[made.columns[:, 1], made.columns[:, 0]], atol=1e-6)
        return made

    def test_arrays(self):
        self.same(sh.horizon(Z, spacing=(25, 25)))
        self.same(sh.horizon(grid=Z.tolist(), column_step=(25, 0), row_step=(0, 25)))
        self.same(sh.horizon(X, Y, Z))
        self.same(sh.horizon(X.ravel(), Y.ravel(), Z.ravel()))
        self.same(sh.horizon(X[0], Y[:, 0], Z))
        self.same(sh.horizon(points=np.column_stack((X.ravel(), Y.ravel(), Z.ravel()))))
        self.same(sh.horizon({"Easting": X.ravel(), "Northing": Y.ravel(), "TWT (ms)": Z.ravel()}))

    def test_masks_and_nulls(self):
        masked = np.ma.masked_greater(Z, 1005.0)
        for made in (sh.horizon(masked, spacing=(25, 25)), sh.horizon(np.where(Z > 1005.0, 1e30, Z), spacing=(25, 25), nodata=1e30)):
            self.assertEqual((len(made), made.lattice.shape), (int((Z <= 1005.0).sum()), (20, 30)))
            self.assertEqual(made.left_out["without z"], int((Z > 1005.0).sum()))

    def test_whole_numbers_stay_whole(self):
        made = sh.horizon({"X": X.ravel(), "Y": Y.ravel(), "Z": Z.ravel(), "id": np.arange(600), "amp": Z.ravel(), "who": ["me"] * 600})
        self.assertEqual((made["id"].dtype.kind, made["amp"].dtype.kind, set(made.attributes)), ("i", "f", {"id", "amp"}))
        np.testing.assert_array_equal(made["id"], made.columns[:, 0] + 30 * made.columns[:, 1])
        self.assertIn("no numbers: who", made.taken[0])
        self.assertEqual(sh.surface(made, 1.0)["id"].dtype.kind, "i")

    def test_two_readings_are_refused(self):
        for call, words in (
                (lambda: sh.horizon(np.zeros((9, 3))), "horizon(points=...) or horizon(grid=...)"),
                (lambda: sh.horizon({"x": X.ravel(), "y": Y.ravel(), "twt": Z.ravel(), "depth": Z.ravel()}), 'columns={"z": "twt"}'),
                (lambda: sh.horizon(Z, spacing=(25, 25), column_step=(1, 0)), "column_step and row_step"),
                (lambda: sh.horizon("top.dat"), "read(path)"),
                (lambda: sh.horizon(np.full((3, 4), np.nan)), "not nan"),
                (lambda: sh.horizon(X, z=Z), "expected x, y and z"),
                (lambda: sh.horizon(np.random.default_rng(1).uniform(0, 1e3, (500, 3))[:, 0], *np.random.default_rng(2).uniform(0, 1e3, (2, 500))),
                 'gridding="plate"'),
                (lambda: sh.surface(sh.horizon(Z), "2 ms"), 'vertical_unit="ms"'),
                (lambda: sh.surface(sh.horizon(Z, vertical_unit="m"), "2 ms"), "a time"),
                (lambda: sh.surface(sh.horizon(Z), 1.0, triangles=9), "one of them"),
                (lambda: sh.surface(sh.horizon(Z), -1.0), "largest_error -1.0, expected a finite number, at least 0"),
                (lambda: sh.faults(sh.horizon(Z), -3.0), "smallest_throw -3.0"),
                (lambda: sh.surface(sh.horizon(Z), 1.0, faults=[1]), "faults(horizon)"),
                (lambda: sh.horizon(Z, origin=(1.0,)), "two numbers"),
                (lambda: sh.horizon(Z + 1j), "expected numbers"),
                (lambda: sh.horizon(Z, spacing=(0.0, 1.0)), "spacing (0.0, 1.0)"),
                (lambda: sh.horizon(Z, azimuth=np.nan), "azimuth nan"),
                (lambda: sh.horizon(Z, vertical_unit="furlong"), "vertical_unit 'furlong', expected one of ms, s, m, ft"),
                (lambda: sh.horizon(Z.astype("M8[D]")), "datetime64[D], expected numbers"),
                (lambda: sh.horizon(Z > 1000.0), "bool, expected numbers"),
                (lambda: sh.horizon(np.zeros((0, 3))), "expected heights"),
                (lambda: sh.horizon(np.zeros((3, 3), complex)), "complex128, expected numbers"),
                (lambda: sh.horizon(X[0], 0.0 * X[0], Z[0]), "row_step= give it"),
                (lambda: sh.surface(Z), "horizon(data)"),
                (lambda: sh.write(sh.horizon(Z), FOLDER / "a.ts"), "a mesh")):
            with self.assertRaises((ValueError, TypeError)) as caught:
                call()
            self.assertIn(words, str(caught.exception))

    def test_units_and_directions(self):
        self.assertAlmostEqual(sh.surface(sh.horizon(Z / 1000.0, vertical_unit="s"), "2 ms").details["chosen_maximum_error"], 0.002)
        self.assertEqual(sh.horizon(-Z).direction, "up")
        self.assertEqual(sh.horizon(Z, direction="up").taken[-1], "z increases upwards, as direction says")
        down, up = sh.surface(sh.horizon(Z, spacing=(25, 25)), 1.0), sh.surface(sh.horizon(Z, spacing=(25, 25), direction="up"), 1.0)
        self.assertLess(down.points[:, 2].max(), 0.0)
        self.assertGreater(up.points[:, 2].min(), 0.0)
        np.testing.assert_allclose(sorted(down.z), sorted(up.z))

    def test_others(self):
        """Objects of packages that are here."""
        for package, make in (
                ("pandas", lambda pd: sh.horizon(pd.DataFrame({"Z": Z.ravel(), "X": X.ravel(), "Y": Y.ravel(), "amp": X.ravel()}))),
                ("xarray", lambda xr: sh.horizon(xr.DataArray(Z[None], dims=("band", "y", "x"), coords={"x": X[0], "y": Y[:, 0]}))),
                ("xtgeo", lambda xtgeo: sh.horizon(xtgeo.RegularSurface(ncol=30, nrow=20, xinc=25, yinc=25, values=Z.T))),
                ("geopandas", lambda gp: sh.horizon(gp.GeoDataFrame(geometry=gp.points_from_xy(X.ravel(), Y.ravel(), Z.ravel())))),
                ("pyvista", lambda pv: sh.horizon(pv.StructuredGrid(X, Y, Z)))):
            try:
                module = importlib.import_module(package)
            except ImportError:
                continue
            made = self.same(make(module))
            back = {"xarray": lambda: made.to_xarray()["z"].values, "xtgeo": lambda: made.to_xtgeo().values.T,
                    "pandas": lambda: made.to_dataframe()["Z"].to_numpy().reshape(20, 30),
                    "pyvista": lambda: made.to_pyvista().points[:, 2].reshape(20, 30)}.get(package)
            if back:
                np.testing.assert_allclose(back(), Z)


class MeshTest(unittest.TestCase):
    def check(self, horizon, mesh, error):
        """The error, the direction of triangles, outlines, and the account of columns."""
        under = heights_under(mesh, horizon.columns)
        inside = np.isfinite(under)
        distances = np.abs(under - horizon.z)[inside]
        self.assertLessEqual(distances.max(), error * (1.0 + 1e-9) + 1e-9)
        self.assertLessEqual(distances.max(), mesh.largest_error + 1e-9)
        self.assertGreater(distances.max(), 0.8 * mesh.details["largest_inner_error"])  # That of a dropped point may be larger.
        self.assertLessEqual(mesh.largest_error, error * (1.0 + 1e-9) + 1e-9)
        self.assertEqual(mesh.ledger.known, int(inside.sum()))
        self.assertEqual(mesh.ledger.left_out, len(horizon) - int(inside.sum()))
        a, b, c = (mesh.points[mesh.triangles[:, n]] for n in range(3))
        self.assertGreater(np.cross(b - a, c - a)[:, 2].min(), 0.0)
        edges = np.concatenate([mesh.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
        directed = {tuple(edge) for edge in edges.tolist()}
        self.assertEqual(len(directed), len(edges))
        border = {edge for edge in directed if edge[::-1] not in directed}
        lined = {edge for loop in mesh.outlines for edge in zip(loop.tolist(), np.roll(loop, -1).tolist())}
        lined = {edge for edge in lined if edge[::-1] not in lined}  # Spurs have both.
        self.assertIn(border, (lined, {edge[::-1] for edge in lined}))
        self.assertTrue(((mesh.errors >= 0.0) & (mesh.errors <= error + 1e-9)).all())

    def test_rough_horizons(self):
        turned = {"origin": (461234.5, 6801500.25), "column_step": (24.0, 7.0), "row_step": (-7.0, 24.0)}
        mirrored = {"origin": (461234.5, 6801500.25), "column_step": (24.0, 7.0), "row_step": (7.0, -24.0)}
        for seed, place in ((1, {}), (2, turned), (3, mirrored), (4, {**turned, "direction": "up", "vertical_unit": "m"})):
            horizon = rough(seed, **place)
            self.check(horizon, sh.surface(horizon, 2.0), 2.0)
            self.check(horizon, sh.surface(horizon, 6.0, effort="fast", smallest_angle=0.0), 6.0)
            mesh = sh.surface(horizon, triangles=900)
            self.assertLessEqual(len(mesh), 900)
            self.check(horizon, mesh, mesh.largest_error)

    def test_attributes(self):
        horizon = rough(5)
        mesh = sh.surface(horizon, 3.0)
        self.assertEqual(set(mesh.attributes), {"amplitude", "count"})
        values = horizon["amplitude"]
        self.assertTrue(((mesh["amplitude"] >= values.min()) & (mesh["amplitude"] <= values.max())).all())
        flat = sh.horizon(Z, attributes={"one": np.ones_like(Z)})
        np.testing.assert_array_equal(sh.surface(flat, 1.0)["one"], 1.0)

    def test_filling_and_despiking(self):
        horizon = rough(6)
        filled = sh.fill_holes(horizon, 5000)
        self.assertEqual(int(filled.filled.sum()), np.isnan(horizon.grid()).sum() - np.isnan(filled.grid()).sum())
        np.testing.assert_array_equal(filled.z[:len(horizon)], horizon.z)
        self.assertFalse(np.isnan(filled.grid()[35:45, 45:55]).any())
        self.assertTrue(np.isfinite(filled["amplitude"]).all())
        grid = Z.copy()
        grid[5, 7] += 300.0
        spiked = sh.despike(sh.horizon(grid), 50.0)
        self.assertEqual((spiked.left_out["spikes"], len(spiked)), (1, 599))
        self.assertTrue(np.isnan(spiked.grid()[5, 7]))

    def test_sticks_as_arrays(self):
        """They are those of one fault, whose surface cuts the horizon along a line."""
        top = sh.horizon(np.where(np.arange(80) < 40, 1000.0, 1030.0) + np.zeros((60, 1)), spacing=(25, 25))
        sticks = [np.array([[987.5, 25.0 * j, -900.0], [987.5, 25.0 * j, -1100.0]]) for j in range(-2, 70, 6)]
        found = sh.faults(top, lines=sticks, are_sticks=True)
        self.assertEqual((len(found), len(found.links)), (1, 60))

    def test_faults_stay_open(self):
        """No triangle crosses the cut of a fault through the whole horizon."""
        j, i = np.mgrid[0:80, 0:100]
        z = 1000.0 + 0.3 * j + np.random.default_rng(1).normal(0.0, 0.2, i.shape) + 40.0 * (i >= 50)
        horizon = sh.horizon(z, spacing=(25, 25))
        found = sh.faults(horizon)
        self.assertEqual((len(found), set(found.links[:, 0].tolist()), len(found.links)), (1, {49}, 80))
        mesh = sh.surface(horizon, 2.0, faults=found)
        for one, is_open in ((mesh, True), (sh.surface(horizon, 2.0), False)):
            east = (one.columns[:, 0] >= 50)[one.triangles].sum(axis=1)
            self.assertEqual(bool(np.isin(east, (0, 3)).all()), is_open)

    def test_thickness(self):
        place = {"origin": (4e5, 6e6), "column_step": (24.0, 7.0), "row_step": (-7.0, 24.0)}
        random = np.random.default_rng(3)
        z = 1000.0 + 10.0 * random.random((40, 50))
        below = z + random.uniform(-2.0, 30.0, z.shape)
        below[random.random(z.shape) < 0.1] = np.nan
        shifted = {**place, "origin": (4e5 + 24 * 5 - 7 * 3, 6e6 + 7 * 5 + 24 * 3)}  # from column 5, row 3 on
        found = sh.thickness(sh.horizon(z, **place), sh.horizon(below[3:, 5:], **shifted))
        expected = np.full(z.shape, np.nan)
        expected[3:, 5:] = (below - z)[3:, 5:]
        np.testing.assert_allclose(found.horizon.grid("Isochore"), expected, atol=1e-6)
        known = expected[np.isfinite(expected)]
        self.assertEqual((found.columns, found.crossings, found.left_out), (known.size, int((known < 0).sum()), z.size - known.size))
        self.assertAlmostEqual(found.volume, known.clip(0.0).sum() * (24.0**2 + 7.0**2), delta=1.0)
        up = sh.thickness(sh.horizon(-z, direction="up", **place), sh.horizon(-below, direction="up", **place))
        self.assertAlmostEqual(up.largest, np.nanmax(below - z), places=6)
        for other in ({**place, "origin": (4e5 + 12.0, 6e6)}, {**place, "column_step": (25.0, 7.0)}, {**place, "direction": "up"}):
            with self.assertRaisesRegex(ValueError, "expected"):
                sh.thickness(sh.horizon(z, **place), sh.horizon(z, **other))
        level = sh.thickness(sh.horizon(z * 0.0 + 2.0 * np.arange(50), spacing=(25, 25)), sh.horizon(z * 0.0 + 2.0 * np.arange(50) + 10.0, spacing=(25, 25)))
        np.testing.assert_allclose(level.horizon["Isopach"], 10.0 * np.cos(np.arctan(2.0 / 25.0)), rtol=1e-9)

    def test_same_as_the_classes(self):
        """The vertices and triangles of the VTK classes, to the bit."""
        if PEER is None:
            self.skipTest("no meshes of the classes")
        for path in sorted(PEER.glob("*.npz")):
            peer = np.load(path)
            horizon = sh.horizon(peer["z"], attributes={"value": peer["value"]}, origin=(1e5, 6e6), spacing=(12.5, 25.0), direction="down",
                                 vertical_step=float(peer["step"]))
            mesh, found = sh.surface(horizon, float(peer["error"])), sh.faults(horizon)
            self.assertGreater(len(found.links), 50)
            for name, values in (("links", found.links), ("throws", found.throws), ("points", mesh.points), ("triangles", mesh.triangles), ("means", mesh["value"]), ("errors", mesh.errors / peer["step"])):
                np.testing.assert_array_equal(values, peer[name], "%s: %s" % (path.name, name))


class FilesTest(unittest.TestCase):
    def test_sparse_voxels(self):
        found = sh.read(DATA / "sample.vsm", vertical_unit="ms")
        self.assertEqual({name: len(one) for name, one in found.items()}, {"Horizon 1": 25460, "Horizon 2": 18264})
        self.assertTrue(1200.0 < found["Horizon 1"].z.min() < found["Horizon 2"].z.max() < 1700.0)
        self.assertEqual(set(found["Horizon 1"].attributes), {"Thickness", "Amplitude"})
        with self.assertRaisesRegex(ValueError, "no horizon Horizon 3, expected one of Horizon 1, Horizon 2"):
            sh.read(DATA / "sample.vsm", horizons="Horizon 3")

    def test_rows(self):
        """Parts of the rows have the points of the whole, those of the row that they share twice."""
        whole = sh.read(DATA / "sample.vsm")["Horizon 1"]
        parts = [sh.read(DATA / "sample.vsm", "Horizon 1", rows=rows)["Horizon 1"] for rows in ((0, 70), (70, 149))]
        self.assertEqual(sum(map(len, parts)), len(whole) + np.count_nonzero(whole.columns[:, 1] == 70))
        with self.assertRaisesRegex(ValueError, "rows of sheets"):
            sh.read(DATA / "sample.vsm", rows=(0, 70), duplicates="sheets")

    def test_grids_come_back(self):
        horizon = rough(7, origin=(461000.0, 6801000.0), spacing=(25.0, 12.5), name="Top")
        for ending in ("irap", "gri", "zmap", "dat"):
            path = FOLDER / ("top." + ending)
            sh.write(horizon, path)
            back = next(iter(sh.read(path, direction="down").values()))
            places = {(round(x, 3), round(y, 3)): z for x, y, z in zip(back.x, back.y, back.z)}
            self.assertEqual(len(places), len(horizon))
            single = ending == "gri"
            for x, y, z in zip(horizon.x, horizon.y, horizon.z):
                self.assertAlmostEqual(places[round(x, 3), round(y, 3)], z, delta=1e-3 if single else 1e-6)

    def test_rounding_is_said(self):
        horizon = sh.horizon(Z, origin=(461000.5, 6800000.25), spacing=(25.0, 12.5))
        with self.assertWarnsRegex(UserWarning, r"rounded.*by up to 0.25; IRAP text keeps them"):
            sh.write(horizon, FOLDER / "rounded.gri")

    def test_meshes(self):
        mesh = sh.surface(rough(8), 3.0)
        for ending, words, times in (("ts", "\nTRGL ", len(mesh)), ("obj", "\nf ", len(mesh)), ("stl", "facet normal ", len(mesh)),
                                     ("dxf", "\n3DFACE", len(mesh)), ("ply", "\nelement face %d\n" % len(mesh), 1)):
            path = FOLDER / ("mesh." + ending)
            sh.write(mesh, path)
            self.assertEqual(path.read_bytes().count(words.encode()), times, ending)

    def test_refusals_leave_files_alone(self):
        path = FOLDER / "kept.ts"
        path.write_text("mine")
        mesh = sh.surface(sh.horizon(Z), 1.0)
        mesh.points[0, 0] = np.inf
        with self.assertRaisesRegex(ValueError, "expected a finite number"):
            sh.write(mesh, path)
        self.assertEqual((path.read_text(), [one.name for one in FOLDER.iterdir() if one.name.startswith(".kept")]), ("mine", []))
        with self.assertRaises(FileNotFoundError):
            sh.read(FOLDER / "nothing.dat")
        (FOLDER / "cut.irap").write_text("-996 20 25 25\n0 725 0 475\n30")
        with self.assertRaisesRegex(ValueError, "cut.irap: line"):
            sh.read(FOLDER / "cut.irap")


class CallTest(unittest.TestCase):
    def test_other_threads_run(self):
        horizon = rough(9, 700, 700)
        ticks, is_done = [], threading.Event()

        def count():
            while not is_done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.005)

        thread = threading.Thread(target=count)
        thread.start()
        start = time.monotonic()
        sh.surface(horizon, 2.0)
        seconds = time.monotonic() - start
        is_done.set()
        thread.join()
        self.assertGreater(len(ticks), 0.25 * seconds / 0.005)  # On busy machines, too; with the lock held there is one.

    def test_interrupt(self):
        horizon = rough(10, 700, 700)
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            sh.surface(horizon, 0.2)
            time.sleep(5.0)

    def test_progress_stops(self):
        def stop(part):
            if part > 0.3:
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            sh.surface(rough(11, 400, 400), 1.0, progress=stop)

    def test_pickle(self):
        horizon = rough(12)
        mesh = sh.surface(horizon, 2.0)
        again = pickle.loads(pickle.dumps((horizon, mesh)))
        np.testing.assert_array_equal(again[0].z, horizon.z)
        np.testing.assert_array_equal(again[1].triangles, mesh.triangles)
        self.assertEqual(repr(again[1]), repr(mesh))

    def test_warnings_point_to_their_caller(self):
        top = rough(13)
        calls = (lambda: sh.surface(top, 30.0), lambda: sh.surface({"Top": top}, 30.0),
                 lambda: sh.layers({"Top": top, "Base": sh.horizon(top.grid() + 5.0, name="Base")}, 5.0))
        for one in calls:
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                one()
            self.assertTrue(found)
            self.assertEqual({warning.filename for warning in found}, {__file__})

    def test_needs_numpy_alone(self):
        code = "import sys; import numpy, seismichorizons; print(*{name.partition('.')[0] for name in sys.modules})"
        loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
        self.assertFalse({"vtk", "vtkmodules", "pandas", "xarray", "matplotlib", "pyvista"} & set(loaded))

    def test_examples(self):
        for module in [sh] + [one for name, one in sys.modules.items() if name.startswith("seismichorizons.") and isinstance(one, types.ModuleType)]:
            self.assertEqual(doctest.testmod(module).failed, 0, module.__name__)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], warnings="ignore")  # Ragged horizons leave points out.
