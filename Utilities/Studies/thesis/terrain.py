# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface as vtkGreedyTerrainDecimation needs it, and the result of that filter."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkFiltersHybrid import vtkGreedyTerrainDecimation

from .meshlab import to_polydata
from .peers import Peer, run
from .worth import arrays_of


class Terrain:
    """An image without blanked pixels. Columns without a point are filled smoothly, and their triangles are cut off along
    the outline."""

    def __init__(self, mesh):
        self.flat = to_polydata(arrays_of(mesh)[0] * (1.0, 1.0, 0.0), arrays_of(mesh)[1])
        points = np.rint(arrays_of(mesh)[0]).astype(int)
        low = points.min(axis=0)
        columns, rows = (points.max(axis=0) - low + 1)[:2]
        heights = np.full((rows, columns), np.nan)
        heights[points[:, 1] - low[1], points[:, 0] - low[0]] = arrays_of(mesh)[0][:, 2]
        self.image = vtkImageData()
        self.image.SetDimensions(columns, rows, 1)
        self.image.SetOrigin(low[0], low[1], 0.0)
        self.image.AllocateScalars(VTK_DOUBLE, 1)
        self.image.GetPointData().GetScalars().DeepCopy(numpy_to_vtk(fill(heights).ravel()))

    def decimate(self, triangles):
        algorithm = vtkGreedyTerrainDecimation()
        algorithm.SetErrorMeasureToNumberOfTriangles()
        algorithm.SetNumberOfTriangles(max(4, int(triangles)))
        result = run(algorithm, self.image)
        return Peer(self._cut(result.mesh), result.seconds)

    def _cut(self, mesh):
        points, triangles = arrays_of(mesh)
        middles = points[triangles].mean(axis=1) * (1.0, 1.0, 0.0)
        probe = vtkProbeFilter()
        probe.SetInputData(to_polydata(middles, np.empty((0, 3), int)))
        probe.SetSourceData(self.flat)
        probe.Update()
        inside = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("vtkValidPointMask")) > 0
        return to_polydata(points, triangles[inside])


def fill(heights):
    """Fills gaps with the mean of nearby heights, from an image of half the size whose gaps are filled recursively."""
    known = np.isfinite(heights)
    if known.all():
        return heights
    rows, columns = heights.shape
    even = np.pad(heights, ((0, rows % 2), (0, columns % 2)), constant_values=np.nan)
    blocks = even.reshape(even.shape[0] // 2, 2, even.shape[1] // 2, 2)
    numbers = np.isfinite(blocks).sum(axis=(1, 3))
    halves = np.where(numbers > 0, np.nansum(blocks, axis=(1, 3)) / np.maximum(numbers, 1), np.nan)
    return np.where(known, heights, smooth(fill(halves).repeat(2, axis=0).repeat(2, axis=1))[:rows, :columns])


def smooth(image):
    """Returns means of three by three pixels."""
    rows, columns = image.shape
    framed = np.pad(image, 1, mode="edge")
    return sum(framed[i:i + rows, j:j + columns] for i in range(3) for j in range(3)) / 9.0
