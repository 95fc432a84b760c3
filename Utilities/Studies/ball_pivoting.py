# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares ball pivoting by Open3D with our triangulation on surfaces of the sizes in table 5.1 of the thesis, and prints
Markdown.

Needs the package open3d (pip install open3d); ends without it. Open3D receives normals that all point up, so it need not
compute them. Argument: the program generate_horizons.
"""

import pathlib
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from thesis import reported, stages, surfaces

RADII = (1.0, 2.0, 4.0)  # radii of the balls in columns


def pivot(places):
    """Returns triangles and processor seconds."""
    import open3d

    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(places))
    cloud.normals = open3d.utility.Vector3dVector(np.tile([0.0, 0.0, 1.0], (len(places), 1)))
    start = time.process_time()
    mesh = open3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, open3d.utility.DoubleVector(RADII))
    return len(mesh.triangles), time.process_time() - start


def triangulate(horizon):
    """Returns the triangles of our triangulation, boundary included, and wall-clock seconds on all threads."""
    mesh = stages.mesh(stages.outline(stages.start(horizon)))
    return mesh.triangles, mesh.seconds


def main():
    try:
        import open3d  # noqa: F401
    except ImportError as error:
        sys.exit("no Open3D: %s" % error)
    print("| points | triangles, ours | ms | triangles of ball pivoting | ms | microseconds a point |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for points in sorted(set(reported.SURFACES) | set(surfaces.BOX_OF) - {5830, 23559, 53660}):
            horizon = surfaces.make_with_noise(sys.argv[1], points, 0.0, pathlib.Path(folder))
            places = vtk_to_numpy(horizon.GetPoints().GetData())
            triangles, seconds = pivot(places)
            ours, own = triangulate(horizon)
            print("| %d | %d | %.1f | %d | %.0f | %.1f |" % (
                len(places), ours, 1e3 * own, triangles, 1e3 * seconds, 1e6 * seconds / len(places)), flush=True)


main()
