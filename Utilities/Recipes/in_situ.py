# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
# script-version: 2.0
"""A Catalyst script for a simulation: meshes of the reflections in its volume at every time step.

    PV_PLUGIN_PATH=PLUGINS python3 -m paraview.demos.wavelet_miniapp --timesteps 3 --size 41 -s in_situ.py

Writes extracts/meshes_000000.vtpc and so on, with a mesh for each horizon in a folder of that name. The line that begins
with "script-version" is required; otherwise ParaView assumes an older kind of script and does not run it.
"""

from paraview import catalyst, simple

CHANNEL = "input"  # name of the volume in the simulation
AMPLITUDES = "RTData"  # its point array

volume = simple.TrivialProducer(registrationName=CHANNEL)
# The array must be named, because the volume is still empty at this point.
horizons = simple.SeismicReflectionExtraction(Input=volume, AmplitudeArray=["POINTS", AMPLITUDES], LargestNumber=4)
surface = simple.HorizonSurface(Input=horizons, MaximumError=1.0)
meshes = simple.CreateExtractor("VTPC", surface, registrationName="meshes")
meshes.Writer.FileName = "meshes_{timestep:06d}.vtpc"
meshes.Writer.DataMode = "Binary"  # some readers of VTK fail on appended data

options = catalyst.Options()
options.ExtractsOutputDirectory = "extracts"
options.GlobalTrigger = "TimeStep"
