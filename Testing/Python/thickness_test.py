# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Thickness between horizons of a file, beside sums that are made here from coordinates. Argument: the folder Data."""

import pathlib
import sys
import unittest
import warnings

import mesh_checks
import numpy as np
import vtk_inputs
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

SAMPLE = str(pathlib.Path(sys.argv[1]) / "blobs.vsm")


def ledger(known, left_out):
    """What details say of a thickness, of which nothing is filled in."""
    return {"known": known, "filled": 0, "bridged": 0, "extrapolated": 0, "left_out": left_out}


def moved(horizon, shift, rows=slice(None)):
    """Some points of a horizon elsewhere."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    for place in (vtk_to_numpy(horizon.GetPoints().GetData()) + shift)[rows]:
        data.GetPoints().InsertNextPoint(place)
    return data


class ThicknessTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.horizons = list(vtk_inputs.read(SAMPLE, ColumnStep=(3.0, 4.0), RowStep=(-8.0, 6.0)).values())

    def check(self, first, other, has_neighbours=True):
        found = vtk_inputs.thickness(first, other)
        known = {(round(x, 3), round(y, 3)): z for x, y, z in vtk_to_numpy(other.GetPoints().GetData())}
        expected = [(z - known[round(x, 3), round(y, 3)]) for x, y, z in vtk_to_numpy(first.GetPoints().GetData())
                    if (round(x, 3), round(y, 3)) in known]
        self.assertGreater(len(expected), 1000)
        isochore = vtk_to_numpy(found.GetPointData().GetArray("Isochore"))
        np.testing.assert_allclose(isochore, np.abs(expected), atol=1e-9)  # these do not cross
        fields = {name: found.GetFieldData().GetArray("Isochore" + name).GetTuple1(0)
                  for name in ("Least", "Mean", "Largest", "Volume", "Crossings")}
        np.testing.assert_allclose([fields["Least"], fields["Mean"], fields["Largest"], fields["Volume"]],
                                   [isochore.min(), isochore.mean(), isochore.max(), 50.0 * isochore.sum()])
        self.assertEqual(fields["Crossings"], 0.0)
        isopach = vtk_to_numpy(found.GetPointData().GetArray("Isopach"))
        self.assertTrue(np.all((isopach <= isochore + 1e-9) | np.isnan(isopach)))
        self.assertEqual(np.mean(np.isfinite(isopach)) > 0.9, has_neighbours)

    def test_sample(self):
        """Either way, and beside parts of the other horizon."""
        top, base = self.horizons[:2]
        self.check(top, base)
        self.check(base, top)
        self.check(top, moved(base, (0.0, 0.0, 0.0), slice(0, None, 2)), False)
        lower = vtk_inputs.thickness(top, moved(top, (0.0, 0.0, -7.5)))
        np.testing.assert_allclose(vtk_to_numpy(lower.GetPointData().GetArray("Isochore")), 7.5)

    def test_lines(self):
        """A column of a horizon on every second line stands for two; those of another number are left out, and told."""
        j, i = np.mgrid[0:40, 0:60]
        z = 1000.0 + 10.0 * np.sin(i / 9.0) * np.cos(j / 8.0)
        known = {"VerticalStep": 1.0, "VerticalUnit": "m", "HorizontalUnit": "m"}
        top = vtk_inputs.horizon(z, spacing=(25.0, 12.5), **known)
        area = 25.0 * 12.5
        for rows, columns in ((1, 2), (2, 1), (2, 3)):
            own = vtk_inputs.horizon(z[::rows, ::columns] + 50.0, spacing=(25.0 * columns, 12.5 * rows), **known)
            holed = np.full(z.shape, np.nan)
            holed[::rows, ::columns] = z[::rows, ::columns] + 50.0
            for other in (own, vtk_inputs.horizon(holed, spacing=(25.0, 12.5), **known)):
                for first, second in ((top, other), (other, top)):
                    with warnings.catch_warnings():
                        warnings.simplefilter("error")
                        found = vtk_inputs.details(vtk_inputs.thickness(first, second))
                    self.assertAlmostEqual(found.isochore_volume, 50.0 * z.size * area, delta=1e-3)
                    bin_ = abs(np.linalg.det(found.lattice_to_world[:2, :2]))
                    self.assertEqual(vars(found.ledger_columns), ledger(round(z.size * area / bin_), 0))
                    self.assertEqual(vars(found.ledger_area), ledger(z.size * area, 0))
        holed = z + 50.0
        holed[5:9, 10:20] = np.nan
        with self.assertWarnsRegex(UserWarning, "one horizon alone is in 40 of 2400 columns, an area of 12500, expected both"):
            found = vtk_inputs.details(vtk_inputs.thickness(top, vtk_inputs.horizon(holed, spacing=(25.0, 12.5), **known)))
        self.assertEqual(vars(found.ledger_columns), ledger(2360, 40))
        self.assertEqual(vars(found.ledger_area), ledger(2360 * area, 40 * area))

    def test_meshes(self):
        """To a mesh, and of one, is measured where its triangles are, not at its vertices."""
        j, i = np.mgrid[0:60, 0:80]
        z = 1000.0 + 10.0 * np.sin(i / 9.0) * np.cos(j / 8.0)
        top, base = (vtk_inputs.horizon(z + depth, spacing=(30, 30), VerticalStep=1.0, VerticalUnit="m") for depth in (0.0, 50.0))
        true = vtk_inputs.details(vtk_inputs.thickness(top, base))
        self.assertEqual(vars(true.ledger_columns), ledger(z.size, 0))
        meshes = [vtk_inputs.surface(points, MaximumError=0.5) for points in (top, base)]
        self.assertLess(meshes[1].GetNumberOfPoints(), 0.2 * base.GetNumberOfPoints())
        for first, second in ((top, meshes[1]), (meshes[0], base), meshes):
            points = vtk_inputs.thickness(first, second)
            found = vtk_inputs.details(points)
            self.assertEqual(points.GetNumberOfPoints(), z.size)
            self.assertEqual(found.ledger_columns, true.ledger_columns)
            np.testing.assert_allclose(found.isochore_volume, true.isochore_volume, rtol=0.01)
            self.assertLess(abs(vtk_to_numpy(points.GetPointData().GetArray("Isochore")) - 50.0).max(), 1.0 + 1e-9)
            self.assertEqual(sh.apply(sh.make("vtkHorizonExteriorBoundary"), points).GetNumberOfLines(), 1)  # a horizon as any other
        flat = sh.vtkHorizonThickness()
        flat.SetInputDataObject(0, meshes[0])
        flat.SetInputDataObject(1, meshes[1])
        flat.Update()
        self.assertEqual(flat.GetMap().GetDimensions(), (80, 60, 1))

    def test_apart(self):
        """Two parts far apart have no map."""
        square = np.argwhere(np.ones((12, 12)))
        near = vtk_inputs.horizon(np.full((24, 12), 100.0), VerticalStep=1.0)
        vtk_to_numpy(near.GetFieldData().GetArray("LatticeDimensions"))[..., :2] = 20012
        vtk_to_numpy(near.GetPoints().GetData())[:, :2] = np.vstack((square, square + 20000))
        top, base = (moved(near, (0.0, 0.0, depth)) for depth in (0.0, 9.0))
        top.GetFieldData().PassData(near.GetFieldData())
        with self.assertWarnsRegex(UserWarning, "the map is left out: an image of 20012 x 20012 pixels for 288 columns, expected at most 64"):
            self.assertEqual(vtk_inputs.thickness(top, base).GetNumberOfPoints(), 288)

    def test_map(self):
        """An image of the same, in its place; none of a lattice that is sheared."""
        top, base = self.horizons[:2]
        filter = sh.vtkHorizonThickness()
        filter.SetInputDataObject(0, top)
        filter.SetInputDataObject(1, base)
        filter.Update()
        points, made = filter.GetPolyDataOutput(), filter.GetMap()
        known = {(round(x, 3), round(y, 3)): pair for (x, y, _), pair in zip(
            vtk_to_numpy(points.GetPoints().GetData()), zip(*(vtk_to_numpy(points.GetPointData().GetArray(name))
                                                              for name in ("Isochore", "Isopach"))))}
        isochore, isopach, ghosts = (vtk_to_numpy(made.GetPointData().GetArray(name)) for name in (
            "Isochore", "Isopach", "vtkGhostType"))
        shown = np.flatnonzero(ghosts == 0)
        self.assertEqual(len(shown), len(known))
        for pixel in shown:
            x, y, z = made.GetPoint(pixel)
            np.testing.assert_array_equal((isochore[pixel], isopach[pixel]), known[round(x, 3), round(y, 3)])
            self.assertEqual(z, 0.0)
        self.assertTrue(np.all(np.isnan(isochore[ghosts != 0])))
        self.assertEqual(filter.GetPolyDataOutput().GetFieldData().GetArray("IsochoreMean").GetTuple1(0),
                         made.GetFieldData().GetArray("IsochoreMean").GetTuple1(0))
        sheared = list(vtk_inputs.read(SAMPLE, ColumnStep=(3.0, 4.0), RowStep=(-8.0, 7.0)).values())
        with self.assertWarnsRegex(UserWarning, "the map is left out: ColumnStep and RowStep that are not perpendicular"):
            self.assertGreater(vtk_inputs.thickness(*sheared[:2]).GetNumberOfPoints(), 1000)

    def test_two_at_one_input(self):
        reader = sh.vtkVerneySparseMatrixReader()
        reader.SetFileName(SAMPLE)
        reader.UpdateInformation()
        reader.SetHorizonStatus("Horizon 3", 0)
        filter = sh.vtkHorizonThickness()
        filter.SetInputConnection(reader.GetOutputPort())
        filter.Update()
        self.assertEqual(filter.GetOutputDataObject(0).GetNumberOfPartitionedDataSets(), 2)
        maps = [filter.GetOutputDataObject(1).GetPartition(n, 0) for n in range(2)]
        self.assertEqual([made.GetClassName() for made in maps], ["vtkImageData"] * 2)
        np.testing.assert_array_equal(*(vtk_to_numpy(made.GetPointData().GetArray("Isochore")) for made in maps))
        self.assertIn("mean thickness", filter.GetResults())
        collection = filter.GetOutputDataObject(0)
        self.assertGreater(sum(collection.GetPartition(n, 0).GetNumberOfPoints() for n in range(2)), 2000)

    def test_two_inputs(self):
        """As of two sources that are selected in ParaView."""
        top, base = self.horizons[:2]
        filter = sh.vtkHorizonThickness()
        filter.SetInputData(top)
        filter.AddInputDataObject(base)
        filter.Update()
        expected = vtk_inputs.thickness(top, base)
        np.testing.assert_array_equal(*(vtk_to_numpy(found.GetPointData().GetArray("Isochore"))
                                        for found in (filter.GetOutputDataObject(0), expected)))

    def test_time(self):
        """Times have no true thickness and no volume."""
        top, base = self.horizons[:2]
        copy = mesh_checks.with_text(top, "VerticalDomain", "time")
        found = vtk_inputs.thickness(copy, base)
        self.assertIsNotNone(found.GetPointData().GetArray("Isochore"))
        self.assertIsNone(found.GetPointData().GetArray("Isopach"))
        self.assertIsNone(found.GetFieldData().GetArray("IsochoreVolume"))

    def test_errors(self):
        top, base = self.horizons[:2]
        for other, message in ((None, "0 other horizons with points, expected one as the input Other"),
                               (moved(base, (1.0, 0.5, 0.0)), "which is not on a column of the first one, expected points on one lattice"),
                               (moved(base, (3000.0, 4000.0, 0.0)), "no column with points of both horizons")):
            with self.assertRaises(ValueError, msg=message) as caught:
                vtk_inputs.thickness(top) if other is None else vtk_inputs.thickness(top, other)
            self.assertIn(message, str(caught.exception))
        holed = moved(base, (0.0, 0.0, 0.0))
        vtk_to_numpy(holed.GetPoints().GetData())[5, 2] = np.nan
        with self.assertRaisesRegex(ValueError, "a point of the other horizon at .*, expected finite numbers"):
            vtk_inputs.thickness(top, holed)
        vtk_to_numpy(holed.GetPoints().GetData())[5, 2] = 1e30  # as single precision has it
        with self.assertRaisesRegex(ValueError, "a point of the other horizon at .*, expected at most 2\\^50 vertical indices"):
            vtk_inputs.thickness(top, holed)
        for name, what, value, other in (("VerticalDomain", "z in", "time", "depth"), ("VerticalUnit", "z in", "ms", "s"),
                                         ("CoordinateSystem", "the coordinate system", "EPSG:23031", "EPSG:32631")):
            with self.assertRaisesRegex(ValueError, 'the other horizon with %s "%s", expected "%s" as in the first one: convert one of them'
                                        % (what, other, value)):
                vtk_inputs.thickness(mesh_checks.with_text(top, name, value), mesh_checks.with_text(base, name, other))
        with self.assertWarnsRegex(UserWarning, "the horizons cross in .* columns, expected few"):
            mean = np.mean(vtk_to_numpy(top.GetPoints().GetData())[:, 2] - 0.0)
            flat = moved(top, (0.0, 0.0, 0.0))
            places = vtk_to_numpy(flat.GetPoints().GetData())
            places[:, 2] = mean
            vtk_inputs.thickness(top, flat)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
