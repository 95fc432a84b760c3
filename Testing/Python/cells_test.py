# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells of one size, of which VTK stores no offsets: points keep them, and meshes are measured. Argument: a folder for a
file. Exits with 77 where VTK has no such cells, before 9.6."""

import pathlib
import sys

from seismichorizons import vtk as sh
from seismichorizons.vtk import apply
from seismichorizons_command import tables
from vtkmodules.vtkCommonDataModel import vtkCellArray

import vtk_inputs

FOLDER = pathlib.Path(sys.argv[1]).resolve()
ROUNDING = 1e-12  # of the meter's real numbers; distances here are 0


def read_plane():
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / "plane.vsm"
    path.write_bytes(b"5 4 9\n" + b"3 1 1 0.5 4.0\n" * 20)
    (points,) = vtk_inputs.read(path).values()
    return points


def set_vertices(points):
    vertices = vtkCellArray()
    vertices.UseFixedSizeDefaultStorage(1)
    for point in range(points.GetNumberOfPoints()):
        vertices.InsertNextCell(1, [point])
    assert vertices.IsStorageFixedSize()
    points.SetVerts(vertices)
    return vertices


def main():
    if not hasattr(vtkCellArray, "UseFixedSizeDefaultStorage"):
        print("SKIPPED: this VTK stores the offsets of all cells")
        sys.exit(77)
    points = read_plane()
    vertices = set_vertices(points)
    outlined = apply(sh.vtkHorizonExteriorBoundary(), points)
    assert outlined.GetVerts() is vertices
    mesh = apply(sh.vtkHorizonTriangulation(), outlined)
    assert mesh.GetPolys().ConvertToFixedSizeDefaultStorage() and mesh.GetPolys().IsStorageFixedSize()
    meter = sh.vtkHorizonSurfaceDistance()
    apply(meter, outlined, mesh)
    largest = meter.GetOutputDataObject(2).GetValueByName(tables.TWO_SIDED, "LargestDistance").ToDouble()
    assert largest < ROUNDING, largest
    vertices.ReplaceCellAtId(2, 1, [3])  # no longer one for each point
    assert apply(sh.vtkHorizonExteriorBoundary(), points).GetVerts() is not vertices


main()
