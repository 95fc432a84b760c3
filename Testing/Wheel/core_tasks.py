# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of a geoscientist from beginning to end, with the packages that they use. Argument: a folder for files.

Tasks whose packages are not there are skipped: pandas, xarray, xtgeo, geopandas, pyvista, trimesh.
"""

import concurrent.futures
import importlib
import pathlib
import sys
import unittest
import warnings

import numpy as np
import seismichorizons as sh

FOLDER = pathlib.Path(sys.argv[1])
X, Y = np.meshgrid(461000.0 + 25.0 * np.arange(60), 6800000.0 + 25.0 * np.arange(50))
Z = 1700.0 + 30.0 * np.sin((X - 461000.0) / 300.0) + 15.0 * np.cos((Y - 6800000.0) / 200.0)


def needs(*packages):
    def mark(test):
        def run(self):
            for package in packages:
                try:
                    importlib.import_module(package)
                except ImportError:
                    self.skipTest("no " + package)
            test(self)
        return run
    return mark


def mesh_of_many(number):
    horizon = sh.horizon(Z + number, spacing=(25, 25), name="H%d" % number)
    return len(sh.surface(horizon, 1.0))


class TaskTest(unittest.TestCase):
    def test_1_a_grid_to_gocad(self):
        sh.write(sh.horizon(X, Y, Z, name="Top"), FOLDER / "top.irap")
        top = sh.read(FOLDER / "top.irap", vertical_unit="m")["top"]
        mesh = sh.surface(top, "2 m")
        sh.write(mesh, FOLDER / "top.ts")
        self.assertIn("m", repr(mesh))
        self.assertLessEqual(mesh.largest_error, 2.0 + 1e-9)
        self.assertEqual(len(sh.read_mesh(FOLDER / "top.ts")["top"]), len(mesh))

    def test_2_meshgrids_with_nan(self):
        z = Z.copy()
        z[10:20, 10:20] = np.nan
        self.assertEqual(len(sh.horizon(X, Y, z)), Z.size - 100)

    @needs("pandas")
    def test_3_a_table_with_attributes(self):
        import pandas

        j, i = np.mgrid[0:50, 0:60]
        table = pandas.DataFrame({"Inline": 100 + j.ravel(), "Crossline": 200 + i.ravel(), "X": X.ravel(), "Y": Y.ravel(), "TWT (ms)": Z.ravel(),
                                  "amplitude": Z.ravel() ** 2})
        mesh = sh.surface(sh.horizon(table), "1 ms")
        self.assertEqual(len(mesh["amplitude"]), len(mesh.points))
        np.testing.assert_allclose(mesh["amplitude"], mesh.z**2, rtol=0.02)

    @needs("xarray")
    def test_4_a_raster_upwards(self):
        import xarray

        raster = xarray.DataArray(Z[None].astype(np.float32), dims=("band", "y", "x"), coords={"y": Y[:, 0], "x": X[0]}, attrs={"_FillValue": -9999.0})
        terrain = sh.horizon(raster, direction="up", vertical_unit="m")
        self.assertGreater(sh.surface(terrain, "1 m").points[:, 2].min(), 1600.0)

    @needs("xtgeo")
    def test_5_thickness_of_two_horizons_of_a_file(self):
        sh.write({"Top": sh.horizon(X, Y, Z), "Base": sh.horizon(X, Y, Z + 40.0 + (X - X[0, 0]) / 100.0)}, FOLDER / "both.dat")
        both = sh.read(FOLDER / "both.dat", vertical_unit="m")
        found = sh.thickness(both["Top"], both["Base"])
        np.testing.assert_allclose(found.horizon.grid("Isochore"), 40.0 + (X - X[0, 0]) / 100.0, atol=1e-6)
        surface = found.horizon.to_xtgeo("Isochore")
        np.testing.assert_allclose(surface.values.T, found.horizon.grid("Isochore"), atol=1e-6)

    @needs("xtgeo")
    def test_surfaces_of_xtgeo_return(self):
        import xtgeo

        for turn, flip in ((0.0, 1), (30.0, 1), (117.3, -1)):
            surface = xtgeo.RegularSurface(ncol=60, nrow=50, xinc=25.0, yinc=12.5, xori=461000.0, yori=6800000.0, rotation=turn, yflip=flip,
                                           values=Z.T, name="Reek")
            surface.values[3, 4] = np.ma.masked
            top = sh.horizon(surface)
            self.assertEqual((top.name, len(top)), ("Reek", 2999))
            back = top.to_xtgeo()
            self.assertTrue(surface.compare_topology(back), turn)
            np.testing.assert_allclose(back.values.filled(0.0), surface.values.filled(0.0))

    @needs("geopandas")
    def test_6_faults_of_files(self):
        for n in range(3):
            x = 461000.0 + 312.5 + 300.0 * n
            (FOLDER / ("F%d.pl" % n)).write_text("GOCAD PLine 1\nHEADER {\nname:F%d\n}\nILINE\nVRTX 1 %r 6800300 -1700\nVRTX 2 %r 6800900 -1700\nSEG 1 2\nEND\n" % (n, x, x))
        lines = [sh.read_faults(path) for path in sorted(FOLDER.glob("F?.pl"))]
        top = sh.horizon(X, Y, Z)
        found = sh.faults(top, lines=lines)
        self.assertEqual(len(found), 3)
        frame = found.traces.to_geodataframe()
        self.assertEqual((len(frame), set(frame.geom_type)), (3, {"LineString"}))
        self.assertGreater(sh.surface(top, 1.0, faults=found, close_faults=True).details["fault_triangle_count"], 0)

    def test_7_holes_filled_and_flagged(self):
        z = Z.copy()
        z[10:16, 10:16] = np.nan
        filled = sh.fill_holes(sh.horizon(X, Y, z, name="Top"))
        self.assertEqual(int(filled.filled.sum()), 36)
        sh.write(filled, FOLDER / "filled.irap")
        back = sh.read(FOLDER / "filled.irap", direction="down")["filled"].grid()
        np.testing.assert_allclose(back[np.isfinite(z)], z[np.isfinite(z)], atol=1e-9)
        np.testing.assert_allclose(back, Z, atol=1.0)

    @needs("pyvista", "trimesh")
    def test_8_layers_and_bodies(self):
        horizons = {name: sh.horizon(X, Y, Z + shift, vertical_unit="m", horizontal_unit="m") for name, shift in (("Top", 0.0), ("Middle", 30.0), ("Base", 80.0))}
        made = sh.layers(horizons, "1 m")
        grid = made.to_pyvista()
        self.assertAlmostEqual(grid.volume, made.figures["volume"].sum(), delta=1e-6 * grid.volume)
        for name, body in made.bodies.items():
            solid = body.to_trimesh()
            self.assertTrue(solid.is_watertight and solid.is_winding_consistent)
            self.assertAlmostEqual(solid.volume, made.figures["volume"][made.names.index(name)], delta=1e-6 * solid.volume)
            self.assertTrue(body.to_pyvista().is_manifold)

    def test_9_a_horizon_from_five_picks(self):
        z = 1600.0 + 4.0 * np.arange(80)
        values = np.exp(-(((z - Z[..., None]) / 12.0) ** 2)) + 0.05 * np.random.default_rng(1).normal(size=(*Z.shape, len(z)))
        lattice = sh.Lattice(Z.shape, (X[0, 0], Y[0, 0]), (25.0, 0.0), (0.0, 25.0), z[0], 4.0, len(z))
        seismic = sh.Cube(values.astype(np.float32), lattice, vertical_unit="ms")
        j, i = np.array([5, 10, 25, 40, 45]), np.array([5, 50, 30, 10, 55])
        top = sh.extract(seismic, {"Top": np.column_stack((X[j, i], Y[j, i], Z[j, i]))})["Top"]
        self.assertGreater(len(top), 0.95 * Z.size)
        self.assertLess(np.nanpercentile(np.abs(top.grid() - Z), 99), 4.0)

    def test_10_many_horizons(self):
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            numbers = list(threads.map(mesh_of_many, range(20)))
        with concurrent.futures.ProcessPoolExecutor(2) as processes:
            self.assertEqual(list(processes.map(mesh_of_many, range(20))), numbers)

    @needs("pyvista")
    def test_11_further_with_pyvista(self):
        data = sh.surface(sh.horizon(X, Y, Z, attributes={"amplitude": Z}), 1.0).to_pyvista()
        self.assertTrue(data.is_all_triangles)
        self.assertLess(data.decimate(0.5).n_cells, data.n_cells)
        self.assertEqual(data.subdivide(1).n_cells, 4 * data.n_cells)
        self.assertLess(data.clip("x").n_cells, data.n_cells)

    @needs("pyvista")
    def test_12_the_mesh_of_somebody_else(self):
        import pyvista

        top = sh.horizon(X, Y, Z)
        coarse = np.ix_([*range(0, 50, 5), 49], [*range(0, 60, 5), 59])
        other = pyvista.StructuredGrid(X[coarse], Y[coarse], -Z[coarse]).extract_surface().triangulate()
        found = sh.distance(top, other)
        self.assertLess(found.mean, np.nanmax(np.abs(found.vertical_of_reference)))
        self.assertGreater(np.nanmax(np.abs(found.vertical_of_reference)), 1.0)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore")
    unittest.main(argv=sys.argv[:1], warnings="ignore")
