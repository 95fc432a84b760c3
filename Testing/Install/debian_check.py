# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView reads a file of horizons and meshes it, though nobody told it of a plugin. Argument: the file."""

import os
import sys

from paraview import simple

assert not any(name.startswith("PV_PLUGIN") for name in os.environ)
horizons = simple.OpenDataFile(sys.argv[1])
surface = simple.HorizonSurface(Input=horizons, MaximumError=1)
surface.UpdatePipeline()
triangles = surface.GetDataInformation().GetNumberOfCells()
assert triangles > 100, triangles
print("%d triangles" % triangles)
