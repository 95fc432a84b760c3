# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons from what Python people have in hand: the sense of z, and arrays and tables that are read by names."""

import sys
import types
import unittest

import numpy as np
import seismichorizons as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

ROWS, COLUMNS = 40, 60


def dome(rows=ROWS, columns=COLUMNS):
    j, i = np.mgrid[0:rows, 0:columns]
    return 1000.0 + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


def places(data):
    return vtk_to_numpy(data.GetPoints().GetData())


class MakingTest(unittest.TestCase):
    def test_sense_of_z(self):
        """z of one sign says where it counts to, the same in each function."""
        z = dome()
        xyz = np.column_stack([n.ravel() for n in np.meshgrid(25.0 * np.arange(COLUMNS), 25.0 * np.arange(ROWS))] + [z.ravel()])
        for sign, direction in ((1.0, -1), (-1.0, 1)):
            for top in (sh.horizon(sign * z), sh.horizon_from_points(xyz * (1, 1, sign))):
                self.assertEqual(sh.details(top).vertical_direction, direction)
                self.assertLess(places(top)[:, 2].max(), 0.0)
        cube = vtkImageData()  # as of read_cube: time in ms, downwards
        cube.SetDimensions(8, 6, 40)
        cube.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, -1)
        amplitudes = np.zeros((40, 6, 8))
        amplitudes[25] = 5.0
        cube.GetPointData().SetScalars(numpy_to_vtk(amplitudes.ravel(), deep=True))
        for z in (25.0, -25.0):
            (top,) = sh.extract(cube, {"Top": [[3, 2, z]]}).values()
            self.assertEqual(set(places(top)[:, 2]), {-25.0})

    def test_masked(self):
        z = np.ma.masked_array(dome(), mask=np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS) % 2 == 0)
        self.assertEqual(sh.horizon(z).GetNumberOfPoints(), ROWS * COLUMNS // 2)

    def test_nulls(self):
        """Points that are nan, infinite or `nodata`, also in single precision, are left out and counted."""
        for null in (np.nan, np.inf, -999.9, -32767.1):
            for kind in (np.float32, np.float64):
                z = dome()
                z[3, 4:9] = np.float32(null)
                top = sh.horizon(z.astype(kind), nodata=[-999.9, -32767.1])
                self.assertEqual((top.GetNumberOfPoints(), sh.details(top).dropped_nulls), (z.size - 5, 5))
        for column in (0, 2):
            for null in (np.nan, np.inf):
                xyz = np.column_stack([n.ravel() for n in np.meshgrid(np.arange(12.0), np.arange(10.0))] + [np.full(120, 9.0)])
                xyz[5:25, column] = null
                top = sh.horizon_from_points(xyz)
                self.assertEqual((top.GetNumberOfPoints(), sh.details(top).dropped_nulls), (100, 20))

    def test_xtgeo(self):
        """Whose values are by columns."""
        values = np.ma.masked_invalid(dome().T)
        for flip in (1, -1):
            surface = types.SimpleNamespace(xori=1e5, yori=2e5, xinc=25.0, yinc=50.0, rotation=30.0, yflip=flip, values=values)
            matrix = sh.details(sh.horizon(surface)).lattice_to_world
            angle = np.radians(30.0)
            np.testing.assert_allclose(matrix[:2, 0], 25.0 * np.array((np.cos(angle), np.sin(angle))), atol=1e-9)
            np.testing.assert_allclose(matrix[:2, 1], 50.0 * flip * np.array((-np.sin(angle), np.cos(angle))), atol=1e-9)
            with self.assertRaisesRegex(ValueError, "origin for a surface of xtgeo"):
                sh.horizon(surface, origin=(0, 0))

    def test_tables(self):
        """Columns by their names, in any order; others are attributes."""
        class Frame(dict):
            columns = property(lambda self: list(self))

        x, y = (n.ravel() for n in np.meshgrid(25.0 * np.arange(6), 40.0 * np.arange(5)))
        top = sh.horizon_from_points(Frame(Z=1000.0 + x, Y=y, X=x, Amp=x + y, note=np.array(["a"] * 30)))
        np.testing.assert_allclose(top.GetBounds(), (0.0, 125.0, 0.0, 160.0, -1125.0, -1000.0), atol=1e-9)
        np.testing.assert_allclose(vtk_to_numpy(top.GetPointData().GetArray("Amp")), places(top)[:, :2].sum(axis=1), atol=1e-9)
        up = sh.horizon_from_points(Frame(Elevation=1000.0 + x, Y=y, X=x))
        self.assertGreater(places(up)[:, 2].min(), 0.0)
        again = sh.horizon_from_points(up)
        self.assertEqual(again.GetNumberOfPoints(), 30)
        with self.assertRaisesRegex(ValueError, "arrays a, b, expected Z"):
            sh.horizon_from_points(Frame(a=x, b=y))
        with self.assertRaisesRegex(ValueError, "no points, expected those of a horizon at least: all 30 are without z"):
            sh.horizon_from_points(np.column_stack((x, y, 0.0 * x - 999.0)), null_values="-999")

    def test_dimensions(self):
        """A DataArray is read by the names of its dimensions, in any order."""
        class Array(types.SimpleNamespace):
            pass

        z = 1000.0 + np.arange(30.0)[:, None] + 100.0 * np.arange(20.0)
        x, y = 10.0 * np.arange(30.0), 50.0 - np.arange(20.0)
        along = sh.horizon(Array(dims=("x", "y"), coords={"x": x, "y": y}, values=z, attrs={}))
        across = sh.horizon(Array(dims=("band", "Northing", "Easting"), coords={"Easting": x, "Northing": y},
                                  values=z.T[None], attrs={}))
        for top in (along, across):
            self.assertEqual(top.GetBounds()[:4], (0.0, 290.0, 31.0, 50.0))
            np.testing.assert_allclose(places(top)[:, 2], -1000.0 - 0.1 * places(top)[:, 0] - 100.0 * (50.0 - places(top)[:, 1]))
        lines = {"iline": 100.0 + 2.0 * np.arange(30), "xline": 300.0 + np.arange(20)}
        survey = sh.horizon(Array(dims=("xline", "iline"), coords=lines, values=z.T, attrs={}))
        self.assertEqual(list(sh.details(survey).line_numbers), [100.0, 2.0, 300.0, 1.0])
        self.assertEqual(survey.GetBounds()[:4], (300.0, 319.0, 100.0, 158.0))
        grid = dict(zip(("cdp_x", "cdp_y"), np.meshgrid(x, y, indexing="ij")))
        placed = sh.horizon(Array(dims=("iline", "xline"), values=z, attrs={}, coords={**lines, **{
            name: Array(dims=("iline", "xline"), values=values) for name, values in grid.items()}}))
        np.testing.assert_allclose(placed.GetBounds()[:4], (0.0, 290.0, 31.0, 50.0), atol=1e-9)
        self.assertEqual(list(sh.details(placed).line_numbers), [100.0, 2.0, 300.0, 1.0])
        with self.assertRaisesRegex(ValueError, "dimensions a, b, expected two, named x and y, or inline and crossline"):
            sh.horizon(Array(dims=("a", "b"), coords={}, values=z, attrs={}))
        with self.assertRaisesRegex(ValueError, "a Dataset of top, base, expected one variable"):
            sh.horizon(Array(dims=("x", "y"), coords={}, data_vars={"top": z, "base": z}))

    def test_xarray(self):
        class Array(types.SimpleNamespace):
            pass

        array = Array(dims=("y", "x"), coords={"y": 6e6 - 50.0 * np.arange(ROWS), "x": 5e5 + 25.0 * np.arange(COLUMNS)},
                      values=dome(), attrs={"_FillValue": 1000.0})
        top = sh.horizon(array)
        self.assertEqual(top.GetNumberOfPoints(), np.count_nonzero(dome() != 1000.0))
        self.assertEqual(sh.details(top).lattice_to_world[1, 1], -50.0)
        array.coords["x"] = np.arange(COLUMNS) ** 2.0
        with self.assertRaisesRegex(ValueError, "unequal steps.*gridding"):
            sh.horizon(array)
        del array.coords["x"]
        with self.assertRaisesRegex(ValueError, "without coordinates along x"):
            sh.horizon(array)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
