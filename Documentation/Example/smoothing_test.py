# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The stage of the example between those of the project. Arguments: a file of horizons, and the plugin of the example."""

import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def heights(proxy):
    proxy.UpdatePipeline()
    horizon = simple.servermanager.Fetch(simple.MergeBlocks(Input=proxy, OutputDataSetType="Polygonal Mesh"))
    return vtk_to_numpy(horizon.GetPoints().GetData())[:, 2]


path, plugin = sys.argv[1:3]
simple.LoadPlugin(plugin, ns=globals())
horizons = simple.OpenDataFile(path)
same = heights(HorizonSmoothing(Input=horizons, Radius=0))
assert abs(same - heights(horizons)).max() < 1e-9
smooth = HorizonSmoothing(Input=horizons)
assert heights(smooth).std() < same.std()
mesh = simple.HorizonSurface(Input=smooth, MaximumError=1)
mesh.UpdatePipeline()
print("%d triangles" % mesh.GetDataInformation().GetNumberOfCells())
smooth.Radius = -1  # one error, and no half result
smooth.UpdatePipeline()
assert smooth.GetDataInformation().GetNumberOfPoints() == 0
