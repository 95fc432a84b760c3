# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of Documentation/Limits.md: up to them it works, and beyond there is one error that has the number.

Arguments: the folder of the source, and a folder for files.
"""

import pathlib
import sys
import unittest

import numpy as np
from seismichorizons.vtk import apply, make, update
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

SOURCE, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
LINES = (SOURCE / "Documentation" / "Limits.md").read_text(encoding="utf-8").splitlines()
LIMITS = {cells[0]: cells[1] for cells in ([cell.strip() for cell in line.strip("|").split("|")]
                                           for line in LINES if line.startswith("| "))}
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], float)


def named(name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def horizon(places, columns=2, to_world=np.eye(4)):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places))
    data = vtkPolyData()
    data.SetPoints(points)
    data.GetFieldData().AddArray(named("LatticeDimensions", np.array([columns, 2, 1], np.int32)))
    data.GetFieldData().AddArray(named("LatticeToWorld", to_world.ravel()))
    return data


def read(class_name, name, lines, **properties):
    path = FOLDER / name
    path.write_text("\n".join(lines) + "\n")
    reader = make(class_name, FileName=str(path), **properties)
    update(reader)
    return reader.GetOutputDataObject(0)


class LimitsTest(unittest.TestCase):
    def check(self, row, number, message, work, least):
        """That the row has the number, that work(least) is refused with it, and that it was the least."""
        self.assertIn(number, LIMITS[row])
        work(least - 1)
        with self.assertRaisesRegex(ValueError, message):
            work(least)

    def test_points(self):
        self.assertIn("less than 2^29", LIMITS["points of a horizon"])
        path = FOLDER / "many"
        with open(path, "wb") as file:
            file.truncate(12 << 29)  # of no bytes on most disks
        try:
            places = np.memmap(path, np.float32, "r", shape=(1 << 29, 3))
            with self.assertRaisesRegex(ValueError, r"536870912 points, expected less than 2\^29"):
                apply(make("vtkHorizonSurface"), horizon(places))
        finally:
            path.unlink()

    def test_columns(self):
        row = "columns of a lattice"

        def mesh(columns):
            far = np.vstack([SQUARE, [columns - 1, 0, 0]])
            self.assertGreater(apply(make("vtkHorizonSurface"), horizon(far, columns)).GetNumberOfPoints(), 0)

        self.check(row, "less than 2^28", r"less than 2\^28 columns a side", mesh, 1 << 28)

        def pick(columns):
            places = ((0, 0), (1, 0), (0, 1), (1, 1), (columns - 1, 0))
            read("vtkHorizonTextReader", "far.dat", ["Inline Crossline Z", *("%d %d 5" % place for place in places)])

        with self.assertRaisesRegex(ValueError, r"expected less than 2\^28 along a side"):
            pick(1 << 28)
        self.check("columns that picks span", "2^20", "expected at most 1000 columns a pick", pick, (1 << 19) + 1)
        with self.assertRaisesRegex(ValueError, r"expected nX and nY below 2\^28"):
            read("vtkVerneySparseMatrixReader", "wide.vsm", ["%d 1 1" % (1 << 28)])

    def test_heights(self):
        row = "vertical indices"

        def outline(height):
            places = SQUARE.copy()
            places[3, 2] = -height
            apply(make("vtkHorizonExteriorBoundary"), horizon(places))

        self.check(row, "up to 2^50", r"point 3 at .* at most 2\^50 vertical indices", outline, (1 << 50) + 1)
        self.check(row, "less than 2^31", r"below 2\^31", lambda size: read(
            "vtkVerneySparseMatrixReader", "high.vsm", ["1 1 %d" % size, "%d 1 1 1 1" % (size - 1)]), 1 << 31)

    def test_coordinates(self):
        self.assertIn("up to 1e16", LIMITS["coordinates"])

        def measure(origin):
            to_world = np.diag([1e6, 1e6, 1, 1])
            to_world[0, 3] = origin
            mesh = apply(make("vtkHorizonSurface"), horizon(1e6 * SQUARE + [origin, 0, 0], to_world=to_world))
            self.assertGreater(mesh.GetNumberOfPolys(), 0)
            apply(make("vtkHorizonSurfaceDistance"), mesh, mesh)

        measure(9e15)
        with self.assertRaisesRegex(ValueError, r"expected finite coordinates of at most 1e\+16"):
            measure(1e16)

    def test_horizons(self):
        """One less takes a gigabyte, and is not tried."""
        self.assertIn("at most 32,768 horizons", LIMITS["picks of a table"])
        with self.assertRaisesRegex(ValueError, "picks of 32769 horizons, expected at most 32768"):
            read("vtkHorizonTextReader", "many.dat", ["Name Inline Crossline Z", *(
                "h%d %d %d 5" % (n % 32769, n % 200, n // 200) for n in range(2 * ((1 << 15) + 1)))])

    def test_radius(self):
        self.check("radius of the boundary", "32", "radius 33, expected 1 to 32", lambda radius: apply(
            make("vtkHorizonExteriorBoundary", Radius=radius), horizon(SQUARE)), 33)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
