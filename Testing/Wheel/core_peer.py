# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the VTK classes, for core_test.py to compare. Argument: a folder for files."""

import pathlib
import sys

import numpy as np
from seismichorizons.vtk import apply, horizons_of, make
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable

FOLDER = pathlib.Path(sys.argv[1])
FOLDER.mkdir(parents=True, exist_ok=True)
for seed, error in ((1, 1.0), (2, 4.0), (3, 0.25)):
    random = np.random.default_rng(seed)
    j, i = np.mgrid[0:140, 0:180]
    z = 1200.0 + 50.0 * np.sin(i / 13.0) * np.cos(j / 19.0) + random.normal(0.0, 0.5, i.shape) + 30.0 * (i > 90 + j / 4)
    z[random.random(z.shape) < 0.02] = np.nan
    z[40:60, 50:80] = np.nan
    value = random.normal(size=z.shape)
    known = np.isfinite(z)
    step = 0.5
    table = {"X": 1e5 + 12.5 * i[known], "Y": 6e6 + 25.0 * j[known], "Z": z[known], "value": value[known]}
    columns = vtkTable()
    for name, numbers in table.items():
        array = numpy_to_vtk(np.ascontiguousarray(numbers), deep=True)
        array.SetName(name)
        columns.AddColumn(array)
    source = make("vtkHorizonFromPoints", LatticeSource="OriginAndSteps", Origin=(1e5, 6e6), ColumnStep=(12.5, 0.0),
                  RowStep=(0.0, 25.0), VerticalStep=step, VerticalDirection="Down")
    points, = horizons_of(apply(source, columns)).values()
    mesh = apply(make("vtkHorizonSurface", MaximumError=error / step), points)
    lines = mesh.GetNumberOfLines()
    faulted = apply(make("vtkHorizonFaults"), points).GetFieldData()
    np.savez(FOLDER / ("%d.npz" % seed), z=z, value=value, error=error, step=step, points=vtk_to_numpy(mesh.GetPoints().GetData()),
             triangles=vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3),
             errors=vtk_to_numpy(mesh.GetCellData().GetArray("Error"))[lines:],
             links=vtk_to_numpy(faulted.GetArray("FaultedLinks")), throws=vtk_to_numpy(faulted.GetArray("FaultThrow")) * step,
             means=vtk_to_numpy(mesh.GetPointData().GetArray("value")))
