# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes meshes of all horizons of a file and their distances from the horizons by ParaView's extractors.

    mpirun -np 4 pvbatch extracts.py survey.vsm results --largest-error 1

The results are meshes.vtpc, with the distances as point data, and distances.csv. The plugin must be in PV_PLUGIN_PATH.
"""

import argparse
import os
import pathlib
import sys

from paraview import simple


def make_parser():
    parser = argparse.ArgumentParser(prog="extracts", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("folder", metavar="FOLDER", help="where results go")
    parser.add_argument("--largest-error", metavar="E", type=float, default=1.0, help="as MaximumError of Horizon Surface")
    return parser


def main():
    arguments = make_parser().parse_args()
    if not pathlib.Path(arguments.file).is_file():
        sys.exit("extracts: %s: no such file" % arguments.file)
    horizons = simple.OpenDataFile(arguments.file)
    surface = simple.HorizonSurface(Input=horizons, MaximumError=arguments.largest_error)
    distance = simple.HorizonSurfaceDistance(Reference=horizons, Mesh=surface)
    meshes = simple.CreateExtractor("VTPC", simple.OutputPort(distance, 1), registrationName="meshes")
    meshes.Writer.FileName = "meshes.vtpc"
    meshes.Writer.DataMode = "Binary"  # some readers of VTK fail on appended data
    table = simple.CreateExtractor("CSV", simple.OutputPort(distance, 2), registrationName="distances")
    table.Writer.FileName = "distances.csv"
    os.makedirs(arguments.folder, exist_ok=True)
    simple.SaveExtracts(ExtractsOutputDirectory=arguments.folder)


main()
