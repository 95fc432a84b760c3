# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
# script-version: 2.0
"""What a simulation leaves to Catalyst: meshes of the reflections in its volume, at every time step.

    PV_PLUGIN_PATH=PLUGINS python3 -m paraview.demos.wavelet_miniapp --timesteps 3 --size 41 -s in_situ.py

Writes extracts/meshes_000000.vtpc and so on, with a mesh for each horizon in a folder of that name. The line that begins
with "script-version" has to be there, as ParaView takes the script for one of an older kind otherwise, and runs none of it.
"""

from paraview import catalyst, simple

CHANNEL = "input"  # what the simulation calls its volume
AMPLITUDES = "RTData"  # the point array in it

volume = simple.TrivialProducer(registrationName=CHANNEL)
# The array is named, as there is none in the volume yet that could be found.
horizons = simple.SeismicReflectionExtraction(Input=volume, AmplitudeArray=["POINTS", AMPLITUDES], LargestNumber=4)
surface = simple.HorizonSurface(Input=horizons, MaximumError=1.0)
meshes = simple.CreateExtractor("VTPC", surface, registrationName="meshes")
meshes.Writer.FileName = "meshes_{timestep:06d}.vtpc"
meshes.Writer.DataMode = "Binary"  # some readers of VTK stumble over appended data

options = catalyst.Options()
options.ExtractsOutputDirectory = "extracts"
options.GlobalTrigger = "TimeStep"
