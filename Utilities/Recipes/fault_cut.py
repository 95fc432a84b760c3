# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes a faulted horizon before and after its faults are cut, and measures the error of each mesh.

    pvpython fault_cut.py survey.vsm results --throw 4 --triangles 400

Writes before.vtpc and after.vtpc, with the same number of triangles, and the fault lines with their throw, faults.vtpc.
The plugin must be loaded.
"""

import argparse
import os
import pathlib
import sys

from paraview import simple


def main():
    parser = argparse.ArgumentParser(prog="fault_cut", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE", help="the horizons, in any format that is read")
    parser.add_argument("folder", metavar="FOLDER", help="where results go")
    parser.add_argument("--throw", metavar="T", type=float, default=4.0, help="as SmallestThrow of Horizon Faults")
    parser.add_argument("--triangles", metavar="N", type=int, default=2000, help="how many triangles each mesh may have")
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.file).is_file():
        sys.exit("fault_cut: %s: no such file" % arguments.file)
    os.makedirs(arguments.folder, exist_ok=True)
    horizons = simple.OpenDataFile(arguments.file)
    faults = simple.HorizonFaults(Input=horizons, SmallestThrow=arguments.throw)
    for name, points in (("before", horizons), ("after", faults)):
        surface = simple.HorizonSurface(
            Input=points, Target="Number Of Triangles", MaximumNumberOfTriangles=arguments.triangles)
        surface.UpdatePipeline()
        surface.UpdatePropertyInformation()
        print("%s: %s" % (name, surface.Results))  # includes the largest error
        simple.SaveData(os.path.join(arguments.folder, name + ".vtpc"), surface, DataMode="Binary")
    simple.SaveData(os.path.join(arguments.folder, "faults.vtpc"), simple.OutputPort(faults, 1), DataMode="Binary")


main()
