# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts a file of horizons to one file with their meshes, as GOCAD surfaces or in another format.

    pvpython file_to_mesh.py survey.vsm meshes.ts --largest-error 1

The extension of the second file selects the format: .ts, .vtpc, .stl, .ply or .obj. The plugin must be loaded.
"""

import argparse
import pathlib
import sys

from paraview import simple


def main():
    parser = argparse.ArgumentParser(prog="file_to_mesh", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("meshes", metavar="MESHES", help="the file to write")
    parser.add_argument("--largest-error", metavar="E", type=float, default=1.0, help="as MaximumError of Horizon Surface")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.file).is_file():
        sys.exit("file_to_mesh: %s: no such file" % arguments.file)
    horizons = simple.OpenDataFile(arguments.file)
    surface = simple.HorizonSurface(Input=horizons, MaximumError=arguments.largest_error)
    surface.UpdatePipeline()
    surface.UpdatePropertyInformation()
    print(surface.Results)
    simple.SaveData(arguments.meshes, simple.OutputPort(surface, 0))


main()
