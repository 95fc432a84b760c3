# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints digests of what readers and stages make of blobs.vsm, as JSON: those of two builds have to be the same.

Arguments: the folder of the sample, a folder for files.
"""

import hashlib
import json
import pathlib
import sys

import numpy as np
import seismichorizons as sh
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

DATA, FOLDER = map(pathlib.Path, sys.argv[1:])
FORMATS = ("ts", "dxf", "irap", "gri", "zmap", "dat", "vsm")


def digest(data):
    """Of points, cells and their arrays, whatever VTK's version stores them as."""
    total = hashlib.sha256()
    total.update(vtk_to_numpy(data.GetPoints().GetData()).tobytes())
    for cells in (data.GetVerts(), data.GetLines(), data.GetPolys()):
        total.update(vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64).tobytes())
    for arrays in (data.GetPointData(), data.GetCellData()):
        for name in sorted(arrays.GetArrayName(number) for number in range(arrays.GetNumberOfArrays())):
            total.update(name.encode() + np.ascontiguousarray(vtk_to_numpy(arrays.GetArray(name))).tobytes())
    return total.hexdigest()


def reflections():
    """A cube with three folded reflections, as horizons."""
    cube = vtkImageData()
    cube.SetDimensions(40, 30, 60)
    cube.AllocateScalars(10, 1)
    k, j, i = np.mgrid[0:60, 0:30, 0:40]
    values = np.cos((k - 3.0 * np.sin(i / 9.0) - 0.1 * j) / 4.0)
    vtk_to_numpy(cube.GetPointData().GetScalars())[:] = values.ravel()
    return sh.extract(cube, largest_number=3)


def stages(name, points):
    """The digests of all stages of a horizon by their names."""
    made = {"points": points}
    made["despiking"] = sh.despiking(points)
    made["faults"] = sh.faults(points)
    made["hole filling"] = sh.hole_filling(points)
    made["boundary"] = sh.exterior_boundary(points, hole_boundaries=True)
    made["simplified"] = sh.boundary_simplification(made["boundary"])
    made["rough"] = sh.rough_simplification(made["simplified"])
    made["elaborate"] = sh.elaborate_simplification(made["rough"])
    made["triangulation"] = sh.triangulation(made["elaborate"])
    made["decimation"] = sh.decimation(made["boundary"])
    made["surface"] = sh.surface(points)
    made["distance"] = sh.distance(points, made["surface"]).reference
    return {"%s: %s" % (name, stage): digest(data) for stage, data in made.items()}


def files(name, points):
    """Those of files that are written, and of what is read from them."""
    found = {}
    mesh = sh.surface(points)
    for form in FORMATS:
        path = FOLDER / ("top." + form)
        sh.write(points if form in ("dat", "vsm") else mesh, path)
        found["%s: .%s" % (name, form)] = hashlib.sha256(path.read_bytes()).hexdigest()
        if form != "dxf":
            for read_name, data in sh.read(path).items():
                found["%s: .%s: %s" % (name, form, read_name)] = digest(data)
    return found


FOLDER.mkdir(parents=True, exist_ok=True)
digests = {}
for horizon_name, horizon in {**sh.read(DATA / "blobs.vsm"), **{"cube " + n: h for n, h in reflections().items()}}.items():
    digests.update(stages(horizon_name, horizon))
    digests.update(files(horizon_name, horizon))
print(json.dumps(digests, indent=1))
