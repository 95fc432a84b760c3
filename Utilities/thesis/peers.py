# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What others make of the same surface with as many vertices: MeshLab's merging of close vertices, which the thesis
compares with, and filters of VTK. All but vtkDelaunay2D take the mesh with all points; that it has to be made before is
not counted."""

import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (
    vtkBinnedDecimation, vtkDecimatePro, vtkDelaunay2D, vtkProbeFilter, vtkQuadricClustering, vtkQuadricDecimation)
from vtkmodules.vtkFiltersHybrid import vtkGreedyTerrainDecimation

from . import stages
from .meshlab import MeshLab, is_installed, to_polydata
from .worth import arrays_of

MOST_SECONDS = 5.0  # a partner that would take longer on a surface is left out of it
GROWTH = 1.3  # with this power of the points, going by the surface before
MOST_TRIALS = 4  # to get as many vertices as we have
NEAR_ENOUGH = 0.03

# First guesses, found by trying: a distance for a cell of size 1, triangles for one of ours, and those of a whole image
# for one inside the outline, whose number grows faster than that of all.
MERGE_PER_CELL = 0.95
PRO_PER_TRIANGLE = 0.6
TERRAIN_PER_TRIANGLE = 1.5
TERRAIN_POWER = 0.8

MERGE = "MeshLab Merge Close Vertices"


class Peer:
    """A mesh from another program, and the seconds it took."""

    def __init__(self, mesh, seconds):
        self.mesh = mesh
        self.seconds = seconds
        self.vertices = len(np.unique(arrays_of(mesh)[1])) if mesh.GetNumberOfPolys() > 0 else 0


def run(algorithm, mesh):
    algorithm.SetInputData(mesh)
    start = time.perf_counter()
    algorithm.Update()
    return Peer(algorithm.GetOutput(), time.perf_counter() - start)


def divisions(mesh, cell_size):
    """Cubic cells."""
    bounds = mesh.GetBounds()
    return [max(1, round((bounds[2 * axis + 1] - bounds[2 * axis]) / cell_size)) for axis in range(3)]


def quadric_clustering(mesh, cell_size):
    """With cells as high as the surface some of its points fly far off."""
    algorithm = vtkQuadricClustering()
    algorithm.AutoAdjustNumberOfDivisionsOff()
    algorithm.SetNumberOfDivisions(divisions(mesh, cell_size))
    algorithm.UseFeatureEdgesOn()
    return run(algorithm, mesh)


def binned_decimation(mesh, cell_size):
    """With cells as the rough simplification has them, square in plan and as high as the surface: cubic ones led to a
    larger error for its vertices."""
    algorithm = vtkBinnedDecimation()
    algorithm.AutoAdjustNumberOfDivisionsOff()
    algorithm.SetNumberOfDivisions(divisions(mesh, cell_size)[:2] + [1])
    algorithm.SetPointGenerationModeToBinAverages()
    return run(algorithm, mesh)


def quadric_decimation(mesh, triangles):
    algorithm = vtkQuadricDecimation()
    algorithm.SetTargetReduction(max(0.0, 1.0 - triangles / mesh.GetNumberOfPolys()))
    return run(algorithm, mesh)


def decimate_pro(mesh, triangles):
    algorithm = vtkDecimatePro()
    algorithm.SetTargetReduction(max(0.0, 1.0 - triangles / mesh.GetNumberOfPolys()))
    return run(algorithm, mesh)


def delaunay(points):
    algorithm = vtkDelaunay2D()
    algorithm.SetTolerance(0.0)
    return run(algorithm, points)


def ball_pivoting(mesh, folder):
    """Of the points of a mesh; None where MeshLab did not get to the end."""
    found, seconds = MeshLab(mesh, folder).ball_pivoting()
    return found and Peer(found, seconds)


class Terrain:
    """A surface as vtkGreedyTerrainDecimation needs it: an image without blanked pixels. Columns without a point are
    filled smoothly; what the filter makes of them is cut off along the outline."""

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
    """Gaps take the mean of what is near: from an image of half the size, whose gaps are filled in the same way."""
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
    """Means of three by three pixels."""
    rows, columns = image.shape
    framed = np.pad(image, 1, mode="edge")
    return sum(framed[i:i + rows, j:j + columns] for i in range(3) for j in range(3)) / 9.0


def match(work, parameter, correct, target):
    """The run of `work` whose number of vertices is nearest to the target. `correct` makes a better parameter of one
    and of the vertices it led to."""
    best = None
    for _ in range(MOST_TRIALS):
        peer = work(parameter)
        if peer is None or peer.vertices == 0:
            break
        if best is None or abs(peer.vertices - target) < abs(best.vertices - target):
            best = peer
        if abs(peer.vertices - target) <= NEAR_ENOUGH * target:
            break
        parameter = correct(parameter, peer.vertices)
    return best


class Partners:
    """All partners for one surface. `pace` is kept from one surface to the next, and knows who is too slow."""

    def __init__(self, full, folder, pace):
        self.full = stages.triangles_only(full)
        self.terrain = Terrain(self.full)
        self.meshlab = MeshLab(self.full, folder) if is_installed() else None
        self.pace = pace

    def with_vertices(self, ours):
        """Their meshes with as many vertices as ours, by name."""
        target = ours.points
        cell = (self.full.GetNumberOfPoints() / target) ** 0.5
        triangles = ours.triangles

        def by_power(work, first, power):
            return match(work, first, lambda size, vertices: size * (target / vertices) ** power, target)

        def by_difference(work):
            """A vertex more is two triangles more."""
            return match(work, triangles, lambda number, vertices: number + 2 * (target - vertices), target)

        works = {
            MERGE: lambda: by_power(self.merge, MERGE_PER_CELL * cell, -0.5),
            "vtkQuadricClustering": lambda: by_power(lambda size: quadric_clustering(self.full, size), cell, -0.5),
            "vtkBinnedDecimation": lambda: by_power(lambda size: binned_decimation(self.full, size), cell, -0.5),
            "vtkDecimatePro": lambda: by_power(lambda number: decimate_pro(self.full, number),
                                               PRO_PER_TRIANGLE * triangles, 1.0),
            "vtkQuadricDecimation": lambda: by_difference(lambda number: quadric_decimation(self.full, number)),
            "vtkGreedyTerrainDecimation": lambda: by_power(self.terrain.decimate, TERRAIN_PER_TRIANGLE * triangles,
                                                           TERRAIN_POWER),
            "vtkDelaunay2D of our points": lambda: delaunay(stages.triangles_only(ours.data))}
        found = {}
        for name, work in works.items():
            result = self.pace.allow(name, self.full.GetNumberOfPoints()) and work()
            if result:
                self.pace.note(name, self.full.GetNumberOfPoints(), result.seconds)
                found[name] = result
        return found

    def series(self, ours):
        """Their meshes with about as many vertices as each of ours, by name."""
        cells = [(self.full.GetNumberOfPoints() / mesh.points) ** 0.5 for mesh in ours]
        triangles = [mesh.triangles for mesh in ours]
        runs = {
            MERGE: [self.merge(MERGE_PER_CELL * cell) for cell in cells],
            "vtkQuadricClustering": [quadric_clustering(self.full, cell) for cell in cells],
            "vtkBinnedDecimation": [binned_decimation(self.full, cell) for cell in cells],
            "vtkDecimatePro": [decimate_pro(self.full, PRO_PER_TRIANGLE * n) for n in triangles],
            "vtkQuadricDecimation": [quadric_decimation(self.full, n) for n in triangles],
            "vtkGreedyTerrainDecimation": [self.terrain.decimate(TERRAIN_PER_TRIANGLE * n) for n in triangles]}
        return {name: results for name, results in runs.items() if all(results)}

    def merge(self, distance):
        if not self.meshlab:
            return None
        mesh, seconds = self.meshlab.merge(distance)
        return mesh and Peer(mesh, seconds)


class Pace:
    """Who takes how long, and so who is left out of which surface."""

    def __init__(self, most_seconds=MOST_SECONDS):
        self.most_seconds = most_seconds
        self.last = {}
        self.left_out = {}

    def allow(self, name, points):
        before = self.last.get(name)
        fits = before is None or before[1] * (points / before[0]) ** GROWTH <= self.most_seconds
        if not fits:
            self.left_out.setdefault(name, set()).add(points)
        return fits

    def note(self, name, points, seconds):
        self.last[name] = (points, seconds)
