# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Other programs that make meshes, each run once."""

import time

import numpy as np
from vtkmodules.vtkFiltersCore import (
    vtkBinnedDecimation, vtkDecimatePro, vtkDelaunay2D, vtkQuadricClustering, vtkQuadricDecimation)

from .meshlab import MeshLab
from .worth import arrays_of


class Peer:
    """A mesh from another program, and the seconds that it took."""

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
    """Returns the divisions for cubic cells."""
    bounds = mesh.GetBounds()
    return [max(1, round((bounds[2 * axis + 1] - bounds[2 * axis]) / cell_size)) for axis in range(3)]


def quadric_clustering(mesh, cell_size):
    """If cells were as high as the surface, some points would be far off."""
    algorithm = vtkQuadricClustering()
    algorithm.AutoAdjustNumberOfDivisionsOff()
    algorithm.SetNumberOfDivisions(divisions(mesh, cell_size))
    algorithm.UseFeatureEdgesOn()
    return run(algorithm, mesh)


def binned_decimation(mesh, cell_size):
    """Cells are as in the rough simplification, square in plan view and as high as the surface; cubic cells led to a larger
    error for the same vertices."""
    algorithm = vtkBinnedDecimation()
    algorithm.AutoAdjustNumberOfDivisionsOff()
    algorithm.SetNumberOfDivisions(divisions(mesh, cell_size)[:2] + [1])
    algorithm.SetPointGenerationModeToBinAverages()
    return run(algorithm, mesh)


def decimate(algorithm, mesh, triangles):
    """Decimates to a number of triangles."""
    algorithm.SetTargetReduction(max(0.0, 1.0 - triangles / mesh.GetNumberOfPolys()))
    return run(algorithm, mesh)


def quadric_decimation(mesh, triangles):
    return decimate(vtkQuadricDecimation(), mesh, triangles)


def decimate_pro(mesh, triangles):
    return decimate(vtkDecimatePro(), mesh, triangles)


def delaunay(points):
    algorithm = vtkDelaunay2D()
    algorithm.SetTolerance(0.0)
    return run(algorithm, points)


def ball_pivoting(mesh, folder):
    """Returns a mesh of the points of a mesh; None if MeshLab did not finish."""
    found, seconds = MeshLab(mesh, folder).ball_pivoting()
    return found and Peer(found, seconds)
