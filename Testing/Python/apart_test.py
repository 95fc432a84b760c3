# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Two patches far apart take the memory of two patches, in each stage and writer.

Argument: a folder for files.
"""

import os
import pathlib
import sys
import unittest

import numpy as np
from seismichorizons import _core, vtk
from seismichorizons_command import core, data, writing
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

FOLDER = pathlib.Path(sys.argv[1]).resolve()
MOST = 80 << 10  # kB; half as much again as any takes, as versions of compilers and libraries differ
CLEAR = "/proc/self/clear_refs"


def named(name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def two_squares(i, j):
    """Squares of 12 x 12 points, the second of which is so many columns and rows from the first."""
    first = np.argwhere(np.ones((12, 12)))
    columns = np.vstack([first, first + [i, j]]).astype(float)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([columns, 20.0 + np.round(3.0 * np.sin(columns[:, 0]))]), deep=1))
    horizon = vtkPolyData()
    horizon.SetPoints(points)
    horizon.GetPointData().AddArray(named("SurfaceId", np.full(len(columns), 3, np.int32)))
    horizon.GetFieldData().AddArray(named("LatticeDimensions", np.array([i + 12, j + 12, 100], np.int32)))
    horizon.GetFieldData().AddArray(named("LatticeToWorld", np.eye(4).ravel()))
    return horizon


def apply(name, *inputs):
    return vtk.apply(vtk.make("vtkHorizon" + name), *inputs)


def simplified(points):
    return apply("BoundarySimplification", apply("ExteriorBoundary", points))


# What comes before a stage, where it does not take points.
BEFORE = {
    "BoundarySimplification": lambda points: apply("ExteriorBoundary", points),
    "RoughSimplification": simplified,
    "ElaborateSimplification": simplified,
    "Decimation": simplified,
    "Triangulation": lambda points: apply("ElaborateSimplification", simplified(points)),
    "SurfaceDistance": lambda points: apply("Surface", points),
}
STAGES = ["ExteriorBoundary", "Despiking", "Faults", "HoleFilling", "Surface", *BEFORE]


# The same stages as the command runs them.
FUNCTIONS = {"ExteriorBoundary": _core.boundary, "BoundarySimplification": _core.boundary_simplification, "Despiking": _core.despike,
             "RoughSimplification": _core.rough_simplification, "ElaborateSimplification": _core.elaborate_simplification,
             "Decimation": _core.decimation, "Triangulation": _core.triangulation, "HoleFilling": _core.fill_holes,
             "Surface": _core.surface, "Faults": lambda points, *rest: _core.faults(points, None, *rest),
             "SurfaceDistance": lambda mesh, *rest: _core.distance(mesh, mesh, *rest)}


def run(name, points):
    before = BEFORE.get(name, lambda same: same)(points)
    inputs = [before, before] if name == "SurfaceDistance" else [before]
    return lambda: apply(name, *inputs)


def run_for_command(name, points):
    before = data.from_vtk(BEFORE.get(name, lambda same: same)(points))
    return lambda: core.run(FUNCTIONS[name], before, {})


def write_for_command(extension, points):
    path = FOLDER / ("%d.%s" % (os.getpid(), extension))
    given = data.from_vtk(points)

    def work():
        try:
            writing.write_data(given, path, "a horizon")
        finally:
            path.unlink(missing_ok=True)
    return work


def write(class_name, points):
    writer = vtk.make(class_name, FileName=str(FOLDER / (class_name + str(os.getpid()))))
    writer.SetInputDataObject(points)

    def work():
        try:
            vtk.update(writer)
        finally:
            pathlib.Path(writer.GetFileName()).unlink(missing_ok=True)
    return work


def peak():
    status = pathlib.Path("/proc/self/status").read_text()
    return int(status.split("VmHWM:")[1].split()[0])


def grown(prepare, *arguments):
    """By how many kB of memory what prepare(*arguments) returns grows a process of its own, or the error it ends in."""
    read, to_write = os.pipe()
    process = os.fork()
    if process == 0:
        try:
            work = prepare(*arguments)
            pathlib.Path(CLEAR).write_text("5")  # the peak is what is taken now
            before = peak()
            work()
            answer = str(peak() - before)
        except BaseException as error:  # the process must not run the tests that follow
            answer = str(error)
        os.write(to_write, answer.encode())
        os._exit(0)
    os.close(to_write)
    with os.fdopen(read) as stream:
        answer = stream.read()
    os.waitpid(process, 0)
    return int(answer) if answer.isdigit() else answer


@unittest.skipUnless(os.access(CLEAR, os.W_OK), "no %s here" % CLEAR)
class ApartTest(unittest.TestCase):
    def check(self, prepare, *arguments):
        answer = grown(prepare, *arguments)
        self.assertIsInstance(answer, int, answer)
        self.assertLess(answer, MOST)

    def test_stages(self):
        for name in STAGES:
            for apart in (20000, 80000):
                for i, j in ((apart, 0), (0, apart), (apart, apart)):
                    with self.subTest(stage=name, i=i, j=j):
                        self.check(run, name, two_squares(i, j))
                        self.check(run_for_command, name, two_squares(i, j))

    def test_lists(self):
        """Files that list the points of a horizon; those of a mesh its vertices."""
        for i, j in ((20000, 0), (0, 80000), (80000, 80000)):
            points = two_squares(i, j)
            with self.subTest(i=i, j=j):
                self.check(write, "vtkHorizonTextWriter", points)
                for writer in ("vtkGOCADTSurfWriter", "vtkHorizonDXFWriter"):
                    self.check(lambda given, name=writer: write(name, apply("Surface", given)), points)
                self.check(write_for_command, "dat", points)
                for extension in ("ts", "dxf", "stl", "vtp"):
                    self.check(lambda given, name=extension: write_for_command(name, apply("Surface", given)), points)

    def test_grids(self):
        """Files with something for each column of the lattice: a band is written, a square is refused with its size."""
        for prepare, writer in ((write, "vtkHorizonGridWriter"), (write, "vtkVerneySparseMatrixWriter"), (write_for_command, "gri"),
                                (write_for_command, "irap"), (write_for_command, "zmap"), (write_for_command, "vsm")):
            for i, j in ((80000, 0), (0, 80000)):
                with self.subTest(writer=writer, i=i, j=j):
                    self.check(prepare, writer, two_squares(i, j))
            self.assertIn("lattice of 80012 x 80012 columns, expected less than 2^31",
                          str(grown(prepare, writer, two_squares(80000, 80000))))
        for prepare, writer in ((write, "vtkHorizonGridWriter"), (write_for_command, "gri")):
            self.assertIn("lattice of 20012 x 20012 columns, of which the horizon has 288, expected at least one in 10000",
                          str(grown(prepare, writer, two_squares(20000, 20000))))


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
