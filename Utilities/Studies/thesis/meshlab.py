# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""MeshLab's filters, to which the thesis compares; run by the program meshlabserver, which needs an X server."""

import os
import pathlib
import resource
import shutil
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader

from .worth import arrays_of

MOST_SECONDS = 120  # limit of a run
FILTERS = {
    "nothing": "",
    "merge": """
 <filter name="Merge Close Vertices">
  <Param type="RichAbsPerc" name="Threshold" value="%g" min="0" max="1000000"/>
 </filter>""",
    "ball pivoting": """
 <filter name="Surface Reconstruction: Ball Pivoting">
  <Param type="RichAbsPerc" name="BallRadius" value="0" min="0" max="1000000"/>
  <Param type="RichFloat" name="Clustering" value="20"/>
  <Param type="RichFloat" name="CreaseThr" value="90"/>
  <Param type="RichBool" name="DeleteFaces" value="false"/>
 </filter>"""}


def is_installed():
    return shutil.which("meshlabserver") is not None and "DISPLAY" in os.environ


def write_ply(path, points, triangles):
    header = "ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(points)
    header += "".join("property float %s\n" % axis for axis in "xyz")
    header += "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % len(triangles)
    faces = np.empty(len(triangles), dtype=[("corners", "u1"), ("ids", "<i4", 3)])
    faces["corners"] = 3
    faces["ids"] = triangles
    pathlib.Path(path).write_bytes(header.encode() + points.astype("<f4").tobytes() + faces.tobytes())


def read_ply(path):
    reader = vtkPLYReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class MeshLab:
    """Applies filters to one mesh or to its points. Seconds are processor time (MeshLab uses one thread), without reading
    and writing files."""

    def __init__(self, mesh, folder):
        self.folder = pathlib.Path(folder)
        self.points, self.triangles = arrays_of(mesh)
        self.overhead = {}

    def merge(self, distance):
        """Returns the mesh with vertices closer than the distance merged, and seconds; None for both if it failed."""
        return self._run(FILTERS["merge"] % distance, self.triangles)

    def ball_pivoting(self):
        """Returns a mesh of the points, and seconds; None for both if it failed."""
        return self._run(FILTERS["ball pivoting"], np.empty((0, 3), int))

    def _run(self, script, triangles):
        kind = len(triangles) > 0
        if kind not in self.overhead:
            write_ply(self.folder / ("in%d.ply" % kind), self.points, triangles)
            self.overhead[kind] = self._execute(kind, FILTERS["nothing"])
        seconds = self._execute(kind, script)
        if seconds is None:
            return None, None
        return read_ply(self.folder / "out.ply"), max(seconds - self.overhead[kind], 0.001)

    def _execute(self, kind, script):
        path = self.folder / "script.mlx"
        path.write_text("<!DOCTYPE FilterScript>\n<FilterScript>%s\n</FilterScript>\n" % script, encoding="utf-8")
        command = ["meshlabserver", "-i", str(self.folder / ("in%d.ply" % kind)), "-o", str(self.folder / "out.ply"),
                   "-s", str(path)]
        before = processor_seconds()
        try:
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                           timeout=MOST_SECONDS)
        except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
            return None
        return processor_seconds() - before


def to_polydata(points, triangles):
    data = vtkPolyData()
    array = vtkPoints()
    array.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(array)
    cells = vtkCellArray()
    offsets = np.arange(0, 3 * len(triangles) + 1, 3)
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles.ravel().astype(np.int64)), deep=True))
    data.SetPolys(cells)
    return data
