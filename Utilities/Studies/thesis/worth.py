# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The quality of a mesh: its distance from the surface that it represents, and the shape of its triangles."""

import numpy as np
from seismichorizons.vtk import apply, vtkHorizonSurfaceDistance
from vtkmodules.util.numpy_support import vtk_to_numpy

SAMPLES_PER_POINT = 0.5  # more samples changed the largest error by less than 1 %, the mean by less than 0.2 %
BOTH_WAYS = 2  # tuple of the figures for both directions
LATTICE = 0  # component of the figures in lattice units
DIAGONAL = 2


class Worth:
    """Errors are divided by the diagonal of the reference; the outline error is in columns, angles are in degrees."""

    def __init__(self, reference, mesh):
        points, triangles = arrays_of(mesh)
        self.vertices = len(np.unique(triangles))
        self.triangles = len(triangles)
        meter = measure(reference, mesh)
        self.largest, self.mean = errors(meter)
        figures = meter.GetOutputDataObject(1).GetFieldData()
        self.outline = figures.GetArray("OutlineDistance").GetComponent(BOTH_WAYS, LATTICE)
        self.smallest_angle, self.quality = shape(points, triangles)


def measure(reference, mesh):
    """Returns the filter that measured, with its outputs."""
    meter = vtkHorizonSurfaceDistance()
    apply(meter, reference, mesh, SamplesPerPoint=SAMPLES_PER_POINT)
    return meter


def errors(meter):
    """Returns the largest and the mean error in both directions, divided by the diagonal."""
    figures = meter.GetOutputDataObject(1).GetFieldData()
    return [figures.GetArray(name).GetComponent(BOTH_WAYS, DIAGONAL) for name in ("LargestDistance", "MeanDistance")]


def arrays_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def shape(points, triangles):
    """Returns the smallest angle, and the mean quality of the thesis, eq. 5.10; in space, in lattice units."""
    corners = points[triangles].astype(float)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    doubled_area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    ordered = np.sort(sides, axis=1)
    # The smallest angle is between the two longer sides.
    widest = np.maximum(ordered[:, 1] * ordered[:, 2], np.finfo(float).tiny)
    angles = np.degrees(np.arcsin(np.minimum(doubled_area / widest, 1.0)))
    quality = 2.0 * np.sqrt(3.0) * doubled_area / np.maximum(ordered[:, 2] * sides.sum(axis=1), np.finfo(float).tiny)
    return float(angles.min()), float(quality.mean())
