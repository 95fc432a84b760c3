# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The stages of this project, as classes of VTK like the other programs, each timed."""

import time

import seismichorizons.vtk as sh
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData

DISTANCE_THRESHOLD = 0.4  # of the boundary simplification, as in the thesis
MOST_RUNS = 3  # the fastest run counts
ENOUGH_SECONDS = 1.0  # no further runs after this time


class Result:
    """Data, and the seconds from the input surface to it."""

    def __init__(self, data, seconds):
        self.data = data
        self.seconds = seconds
        self.points = data.GetNumberOfPoints()
        self.triangles = data.GetNumberOfPolys()


def set_threads(number):
    """Sets the number of threads of the stages; 0 means all processors."""
    # The default back-end of many VTK builds is sequential.
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(number)


def read(path):
    """Returns the first horizon of a file of sparse voxels."""
    horizons = sh.apply(sh.make("vtkVerneySparseMatrixReader", FileName=str(path)))
    return next(iter(sh.horizons_of(horizons).values()))


def time_update(algorithm):
    """Returns the seconds of the fastest of several runs."""
    best = float("inf")
    total = 0.0
    for _ in range(MOST_RUNS):
        algorithm.Modified()
        start = time.perf_counter()
        algorithm.Update()
        seconds = time.perf_counter() - start
        best = min(best, seconds)
        total += seconds
        if total > ENOUGH_SECONDS:
            break
    return best


def apply(algorithm, before, **properties):
    sh.configure(algorithm, **properties)
    algorithm.SetInputDataObject(0, before.data)
    seconds = time_update(algorithm)
    return Result(algorithm.GetPolyDataOutput(), before.seconds + seconds)


def start(horizon):
    return Result(horizon, 0.0)


def outline(before, **properties):
    return apply(sh.vtkHorizonExteriorBoundary(), before, **properties)


def straighten(before, threshold=DISTANCE_THRESHOLD):
    return apply(sh.vtkHorizonBoundarySimplification(), before, DistanceThreshold=threshold)


def rough(before, cell_size):
    return apply(sh.vtkHorizonRoughSimplification(), before, CellSize=cell_size)


def elaborate(before, cell_size, flatness, growth=1.0):
    return apply(sh.vtkHorizonElaborateSimplification(), before, CellSize=cell_size, FlatnessThreshold=flatness,
                 GrowthPerRing=growth)


def fewest_outline_points(before, tolerance):
    return apply(sh.vtkHorizonBoundarySimplification(), before, Method="FewestPoints", DistanceThreshold=tolerance,
                 OutlineTolerance=tolerance)


def decimate(before, points):
    return apply(sh.vtkHorizonDecimation(), before, Target="NumberOfPoints", MaximumNumberOfPoints=points)


def mesh(before, strategy="VoxelTraversal"):
    return apply(sh.vtkHorizonTriangulation(), before, SearchStrategy=strategy)


def outline_points(horizon):
    lines = horizon.GetLines()
    return lines.GetNumberOfConnectivityIds() - lines.GetNumberOfCells()


def bends(outlined):
    """Returns approximately the number of outline points that stay at any threshold: points where outlines turn in map
    view, and points that they visit more than once."""
    return outline_points(straighten(outlined, 1e6).data)


def triangles_only(data):
    """Removes lines and attributes, which some filters would process."""
    bare = vtkPolyData()
    bare.SetPoints(data.GetPoints())
    bare.SetPolys(data.GetPolys())
    return bare
