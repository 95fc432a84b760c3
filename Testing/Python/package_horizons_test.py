# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons that the Python package makes of what people have: places and directions, and what is left out.

It needs numpy alone: objects of other packages are stood in for where these are not installed. Argument: a folder for files.
"""

import importlib.util
import pathlib
import sys
import types
import unittest
import warnings

import numpy as np
import seismichorizons as sh

FOLDER = pathlib.Path(sys.argv[1]).resolve()
ROWS, COLUMNS = 40, 60


class PlainArray:
    """As much of a DataArray of xarray as horizons are made of."""

    def __init__(self, values, dims, coords=None, attrs=None):
        self.values, self.dims, self.attrs = np.asarray(values), tuple(dims), attrs or {}
        self.sizes, self.dtype = dict(zip(self.dims, self.values.shape)), self.values.dtype
        self.coords = {}
        for name, own in (coords or {}).items():
            along, numbers = own if isinstance(own, tuple) else ((name,), own)
            self.coords[name] = numbers if isinstance(numbers, PlainArray) else PlainArray(numbers, along)

    def __getitem__(self, name):
        return self.coords[name]

    def __array__(self, *arguments, **keywords):
        return np.asarray(self.values)

    def squeeze(self, dims):
        places = tuple(self.dims.index(dim) for dim in dims)
        return PlainArray(self.values.squeeze(places), [dim for dim in self.dims if dim not in dims], self.coords, self.attrs)

    def transpose(self, *dims):
        return PlainArray(self.values.transpose([self.dims.index(dim) for dim in dims]), dims, self.coords, self.attrs)


if importlib.util.find_spec("xarray"):
    from xarray import DataArray
else:
    DataArray = PlainArray


def dome(rows=ROWS, columns=COLUMNS):
    j, i = np.mgrid[0:rows, 0:columns]
    return 1000.0 + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


def places_of(z, spacing=(25.0, 25.0)):
    """x, y and z of the values of a grid."""
    j, i = np.mgrid[0:z.shape[0], 0:z.shape[1]]
    return np.column_stack((spacing[0] * i.ravel(), spacing[1] * j.ravel(), z.ravel()))


class PlacesTest(unittest.TestCase):
    def test_azimuth(self):
        """Each value is at its place; columns follow the azimuth, rows are to the left of it."""
        z = dome()
        z[3, 4], z[5, 6] = np.nan, -999.0
        top = sh.horizon(z, origin=(5e5, 6e6), spacing=(25.0, 50.0), azimuth=120.0, nodata=-999.0, vertical_unit="ms")
        self.assertEqual((len(top), top.left_out), (ROWS * COLUMNS - 2, {"without z": 2}))
        angle = np.radians(-30.0)
        np.testing.assert_allclose(top.lattice.column_step, 25.0 * np.array((np.cos(angle), np.sin(angle))), atol=1e-9)
        np.testing.assert_allclose(top.lattice.row_step, 50.0 * np.array((-np.sin(angle), np.cos(angle))), atol=1e-9)
        np.testing.assert_allclose(top.lattice.origin, (5e5, 6e6), atol=1e-6)
        column, row = top.columns.T
        np.testing.assert_array_equal(top.z, z[row, column])
        np.testing.assert_allclose(top.x, 5e5 + top.lattice.column_step[0] * column + top.lattice.row_step[0] * row, atol=1e-6)
        np.testing.assert_allclose(top.y, 6e6 + top.lattice.column_step[1] * column + top.lattice.row_step[1] * row, atol=1e-6)

    def test_margins(self):
        """The lattice is that of the array, whatever is empty along its sides; extrapolation fills it."""
        z = dome()
        z[:7], z[-5:], z[:, :3], z[:, -9:] = np.nan, np.nan, np.nan, np.nan
        top = sh.horizon(z, origin=(100.0, 200.0), spacing=(25.0, 50.0), vertical_step=1.0)
        self.assertEqual((top.lattice.shape, top.lattice.origin), (z.shape, (100.0, 200.0)))
        np.testing.assert_array_equal(top.grid(), z)
        self.assertEqual(len(sh.surface(top, 1.0).outlines), 1)
        np.testing.assert_allclose(np.column_stack((top.x, top.y)), top.columns * (25.0, 50.0) + (100.0, 200.0))
        whole = sh.fill_holes(top, extrapolation_distance=100)
        self.assertEqual((len(whole), set(whole.filled)), (ROWS * COLUMNS, {0, 2}))

    def test_points(self):
        """Points are found to be on the lattice that they are from; others take gridding."""
        z = dome()
        grid, found = sh.horizon(z, spacing=(25, 25)), sh.horizon(points=places_of(z))
        for name in ("x", "y", "z"):
            np.testing.assert_array_equal(getattr(found, name), getattr(grid, name))
        scattered = np.random.default_rng(1).random((500, 3)) * (1000.0, 1000.0, 10.0)
        with self.assertRaisesRegex(ValueError, 'without a lattice.*gridding="plate"'):
            sh.horizon(points=scattered)
        for gridding in ("plate", "nearest"):
            self.assertGreater(len(sh.horizon(points=scattered, gridding=gridding, direction="down")), 100)

    def test_duplicates(self):
        """Both sides of a reverse fault are sheets, by names; otherwise there is one z in a column, and a warning."""
        points = np.vstack([places_of(np.full((40, 35), z)) + (x, 0.0, 0.0) for x, z in ((0.0, 100.0), (625.0, 130.0))])
        for name, names in (("", ["horizon", "horizon (2)"]), ("Top", ["Top", "Top (2)"])):
            found = sh.horizon(points=points, name=name, duplicates="sheets")
            self.assertEqual(list(found), names)
            self.assertEqual([(len(one), len(set(one.z))) for one in found.values()], [(1400, 1)] * 2)
        with self.assertWarnsRegex(UserWarning, "400 of 2400 columns have several z, up to 30 apart: duplicates chooses which is kept"):
            kept = sh.horizon(points=points)
        self.assertEqual((len(kept), kept.left_out), (2400, {"duplicates": 400}))
        for policy, z in (("topmost", 100.0), ("lowest", 130.0), ("mean", 115.0)):
            one = sh.horizon(points=points, duplicates=policy)
            overlap = (one.x >= 625.0) & (one.x < 875.0)
            self.assertEqual((int(overlap.sum()), set(one.z[overlap])), (400, {z}), policy)

    def test_nulls(self):
        """Points that are nan, infinite or `nodata`, also in single precision, are left out and counted."""
        for null in (np.nan, np.inf, -999.9, -32767.1):
            for kind in (np.float32, np.float64):
                z = dome()
                z[3, 4:9] = np.float32(null)
                top = sh.horizon(z.astype(kind), nodata=[-999.9, -32767.1])
                self.assertEqual((len(top), top.left_out), (z.size - 5, {"without z": 5}))
        for column, reason in ((0, "without a place"), (2, "without z")):
            for null in (np.nan, np.inf):
                xyz = places_of(np.full((10, 12), 9.0))
                xyz[5:25, column] = null
                with self.subTest(null=null, reason=reason):
                    top = sh.horizon(points=xyz)
                    self.assertEqual((len(top), top.left_out), (100, {reason: 20}))
        with self.assertRaisesRegex(ValueError, "expected"):
            sh.horizon(points=places_of(np.full((10, 12), -999.0)), nodata=-999.0)

    def test_directions(self):
        """z of one sign says where it increases to, as grids and as points; the world has it below 0 either way."""
        z = dome()
        for sign, direction in ((1.0, "down"), (-1.0, "up")):
            for top in (sh.horizon(sign * z, spacing=(25, 25)), sh.horizon(points=places_of(sign * z))):
                self.assertEqual(top.direction, direction)
                self.assertLess(sh.surface(top, 5.0).points[:, 2].max(), 0.0)
        z = -z
        z[0, 0] = 1.0
        with self.assertWarnsRegex(UserWarning, "2399 of 2400 z are negative, so z may be elevation or depth"):
            self.assertEqual(sh.horizon(z).direction, "down")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sh.surface(sh.horizon(dome()))
            sh.horizon(z, direction="down")


class ObjectsTest(unittest.TestCase):
    def test_xtgeo(self):
        """Values of xtgeo are by columns; it may turn, and its rows may be flipped."""
        for flip in (1, -1):
            surface = types.SimpleNamespace(xori=1e5, yori=2e5, xinc=25.0, yinc=50.0, rotation=30.0, yflip=flip, ncol=COLUMNS, nrow=ROWS,
                                            name="Reek", values=np.ma.masked_invalid(dome().T))
            top = sh.horizon(surface)
            angle = np.radians(30.0)
            np.testing.assert_allclose(top.lattice.column_step, 25.0 * np.array((np.cos(angle), np.sin(angle))), atol=1e-9)
            np.testing.assert_allclose(top.lattice.row_step, 50.0 * flip * np.array((-np.sin(angle), np.cos(angle))), atol=1e-9)
            np.testing.assert_array_equal(top.grid(), dome())
            self.assertEqual(top.name, "Reek")
            with self.assertRaisesRegex(ValueError, "origin for a surface of xtgeo, which has its own position, expected none"):
                sh.horizon(surface, origin=(0, 0))

    def test_tables(self):
        """Columns are known by their names, in any order; others are attributes."""
        x, y, _ = places_of(np.zeros((5, 6)), (25.0, 40.0)).T
        top = sh.horizon({"Z": 1000.0 + x, "Y": y, "X": x, "Amp": x + y, "note": np.array(["a"] * 30)})
        self.assertEqual(top.lattice.shape, (5, 6))
        np.testing.assert_allclose(top.lattice.spacing, (25.0, 40.0))
        np.testing.assert_allclose(top.z, 1000.0 + top.x, atol=1e-9)
        np.testing.assert_allclose(top["Amp"], top.x + top.y, atol=1e-9)
        self.assertEqual(list(top), ["Amp"])
        two = sh.horizon({"Horizon": ["Base"] * 30 + ["Top"] * 30, "X": np.tile(x, 2), "Y": np.tile(y, 2),
                          "Z": np.repeat((90.0, 50.0), 30)})
        self.assertEqual({name: (len(one), set(one.z)) for name, one in two.items()}, {"Base": (30, {90.0}), "Top": (30, {50.0})})
        with self.assertRaisesRegex(ValueError, "the columns a, b, expected X, Y and Z"):
            sh.horizon({"a": x, "b": y})

    def test_elevations(self):
        """z of that name increases upwards, as in files."""
        x, y, _ = places_of(np.zeros((5, 6)), (25.0, 40.0)).T
        rows = ("%g %g %g\n" % row for row in zip(x, y, x + 1000.0))
        (FOLDER / "elevations.txt").write_text("X Y Elevation\n" + "".join(rows), encoding="ascii")
        for top in (sh.read(FOLDER / "elevations.txt")["elevations"], sh.horizon({"Elevation": 1000.0 + x, "Y": y, "X": x})):
            self.assertEqual(top.direction, "up", top.taken)

    def test_dimensions(self):
        """An array of xarray is read by the names of its dimensions, in any order."""
        z = 1000.0 + np.arange(30.0)[:, None] + 100.0 * np.arange(20.0)
        x, y = 10.0 * np.arange(30.0), 50.0 - np.arange(20.0)
        along = sh.horizon(DataArray(z, dims=("x", "y"), coords={"x": x, "y": y}))
        across = sh.horizon(DataArray(z.T[None], dims=("band", "Northing", "Easting"), coords={"Easting": x, "Northing": y}))
        for top in (along, across):
            self.assertEqual((top.x.min(), top.x.max(), top.y.min(), top.y.max()), (0.0, 290.0, 31.0, 50.0))
            np.testing.assert_allclose(top.z, 1000.0 + 0.1 * top.x + 100.0 * (50.0 - top.y))
        lines = {"iline": 100.0 + 2.0 * np.arange(30), "xline": 300.0 + np.arange(20)}
        survey = sh.horizon(DataArray(z.T, dims=("xline", "iline"), coords=lines))
        self.assertEqual(survey.lattice.lines, (100.0, 2.0, 300.0, 1.0))
        np.testing.assert_allclose(survey.z, 1000.0 + (survey.inlines - 100.0) / 2.0 + 100.0 * (survey.crosslines - 300.0))
        grid = {name: (("iline", "xline"), own) for name, own in zip(("cdp_x", "cdp_y"), np.meshgrid(x, y, indexing="ij"))}
        placed = sh.horizon(DataArray(z, dims=("iline", "xline"), coords={**lines, **grid}))
        np.testing.assert_allclose((placed.x.min(), placed.x.max(), placed.y.min(), placed.y.max()), (0.0, 290.0, 31.0, 50.0), atol=1e-9)
        self.assertEqual(placed.lattice.lines, (100.0, 2.0, 300.0, 1.0))
        with self.assertRaisesRegex(ValueError, "dimensions a, b, expected y and x, or inline and crossline"):
            sh.horizon(DataArray(z, dims=("a", "b")))

    def test_coordinates(self):
        """Arrays of xarray say what is no data, and may run southwards; their steps are equal."""
        coords = {"y": 6e6 - 50.0 * np.arange(ROWS), "x": 5e5 + 25.0 * np.arange(COLUMNS)}
        top = sh.horizon(DataArray(dome(), dims=("y", "x"), coords=coords, attrs={"_FillValue": 1000.0}))
        self.assertEqual(len(top), np.count_nonzero(dome() != 1000.0))
        self.assertEqual(top.lattice.row_step, (0.0, -50.0))
        with self.assertRaisesRegex(ValueError, "without equal steps"):
            sh.horizon(DataArray(dome(), dims=("y", "x"), coords={**coords, "x": np.arange(COLUMNS) ** 2.0}))


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
