# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The package beside PyVista, xtgeo and xarray as they are.

Arguments: the folder of the sample, a folder for files.
"""

import os
import pathlib
import re
import sys
import unittest
from unittest import mock

import numpy as np
import pyvista as pv
import seismichorizons as sh
import xarray
import xtgeo

DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])


def dome():
    j, i = np.mgrid[0:40, 0:60]
    return 1000.0 + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


class PyVistaTest(unittest.TestCase):
    def test_results(self):
        top = sh.horizon(dome(), spacing=(25, 25), vertical_unit="ms")
        mesh = sh.surface(top, "1 ms")
        self.assertIsInstance(top, pv.PolyData)
        self.assertIsInstance(mesh, pv.PolyData)
        self.assertEqual(top["Column"].shape, (2400, 2))
        self.assertEqual(mesh.field_data["VerticalUnit"][0], "ms")
        self.assertIsInstance(sh.distance(top, mesh).mesh, pv.PolyData)

    def test_changed_by_pyvista(self):
        """Points stay a horizon when PyVista has chosen some of them."""
        top = sh.horizon(dome(), spacing=(25, 25))
        part = top.extract_points(top.points[:, 0] < 700.0, include_cells=False).extract_surface(algorithm=None)
        self.assertGreater(sh.surface(part).n_cells, 2)

    def test_accessor(self):
        top = sh.horizon(dome(), spacing=(25, 25))
        mesh = top.horizon.surface(1.0)
        self.assertEqual(mesh.points.tobytes(), sh.surface(top, 1.0).points.tobytes())
        self.assertGreater(top.horizon.exterior_boundary(radius=2).n_lines, 0)
        self.assertLess(top.horizon.distance(mesh).rms, 1.0)
        self.assertLessEqual(mesh.horizon.details().largest_error, 1.0)
        self.assertIn("Parameters", pv.PolyData.horizon.hole_filling.__doc__)

    def test_files(self):
        mesh = sh.surface(sh.horizon(dome(), spacing=(25, 25)))
        mesh.save(FOLDER / "top.ts")
        blocks = pv.read(FOLDER / "top.ts")
        self.assertEqual(blocks.keys(), ["top"])
        self.assertEqual(blocks["top"].n_points, mesh.n_points)
        self.assertEqual(pv.read(DATA / "blobs.vsm").keys(), list(sh.read(DATA / "blobs.vsm")))


class PageTest(unittest.TestCase):
    def test_code(self):
        """That of Documentation/InPython.md, as it stands there."""
        page = (DATA.parent / "Documentation" / "InPython.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S)
        self.assertGreater(len(blocks), 2)
        os.chdir(FOLDER)
        picks = ["Top\t%.1f\t%.1f\t%.2f\n" % (25 * i, 25 * j, z) for (j, i), z in np.ndenumerate(dome())]
        (FOLDER / "picks.dat").write_text("Name\tX\tY\tZ (ms)\n" + "".join(picks))
        sh.write(sh.horizon(dome()), FOLDER / "top.vsm")
        known = {}
        with mock.patch.object(pv, "OFF_SCREEN", True):
            for block in blocks:
                exec(block, known)
        self.assertTrue((FOLDER / "top.ts").exists())


class SurfacesOfOthersTest(unittest.TestCase):
    def test_xtgeo(self):
        for flip in (1, -1):
            surface = xtgeo.RegularSurface(ncol=60, nrow=40, xinc=25.0, yinc=50.0, xori=5e5, yori=6e6, rotation=30.0, yflip=flip,
                                           values=dome().T)
            surface.values[3, 4] = np.ma.masked
            top = sh.horizon(surface)
            self.assertEqual(top.n_points, 2399)
            x, y, z = (np.ma.filled(values, np.nan) for values in (*surface.get_xy_values(), surface.values))
            expected = np.column_stack((x.ravel(), y.ravel(), -z.ravel()))[np.isfinite(z.ravel())]
            order, found = np.lexsort(expected[:, :2].round(3).T), top.points[np.lexsort(top.points[:, :2].round(3).T)]
            np.testing.assert_allclose(found, expected[order], atol=1e-3)

    def test_xarray(self):
        array = xarray.DataArray(dome(), dims=("y", "x"), coords={"y": 6e6 - 50.0 * np.arange(40), "x": 25.0 * np.arange(60)})
        top = sh.horizon(array.where(array < 1010.0))
        self.assertEqual(top.n_points, int((array < 1010.0).sum()))
        self.assertEqual(top.bounds[3], 6e6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
