# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes for several machines give the same bytes on one process and on several, and say what is wrong.

Arguments: the folder of the recipes, that of the data, one for results, the path of pvbatch, and the recipe to test.
"""

import csv
import math
import pathlib
import shutil
import subprocess
import sys

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import mesh_checks
from seismichorizons.vtk import make, update

RECIPES, DATA, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:4])
PVBATCH, RECIPE = sys.argv[4:6]
SAMPLE = DATA / "blobs.vsm"


def run(ranks, *arguments, fails=False):
    """What a recipe says on a number of processes."""
    command = ["mpirun", "-np", str(ranks), PVBATCH, str(RECIPES / (RECIPE + ".py"))]
    done = subprocess.run(command + [str(argument) for argument in arguments], capture_output=True, text=True,
                          timeout=100, check=False)
    assert (done.returncode != 0) == fails, (done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_extracts():
    """The same files on one process and on two."""
    for ranks in (1, 2):
        run(ranks, SAMPLE, FOLDER / str(ranks))
    files = sorted(path.relative_to(FOLDER / "1") for path in (FOLDER / "1").rglob("*") if path.is_file())
    assert len(files) == 5, files  # a mesh for each horizon, what holds them together, and the table
    for file in files:
        if file.suffix != ".csv":
            assert (FOLDER / "1" / file).read_bytes() == (FOLDER / "2" / file).read_bytes(), file
        if file.suffix == ".vtp":
            mesh = mesh_checks.read(FOLDER / "2" / file)
            assert mesh_checks.check_mesh(mesh) > 0 and len(mesh_checks.array(mesh, "Distance"))
    # ParaView sorts columns where there are several processes.
    tables = [rows(FOLDER / ranks / "distances.csv") for ranks in "12"]
    assert len(tables[0]) == 27 and tables[0] == tables[1], tables
    said = run(2, "none.vsm", FOLDER / "2", fails=True)
    assert said.count("extracts: none.vsm: no such file") == 1, said


def meshes_alone(step):
    """The meshes of a time step of ParaView's small simulation, by the classes of the package."""
    volume = vtkRTAnalyticSource()
    volume.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    volume.SetMaximum(255 + 200 * math.sin(step))
    horizons = make("vtkSeismicReflectionExtraction", LargestNumber=4)
    horizons.SetInputConnection(volume.GetOutputPort())
    surface = make("vtkHorizonSurface", MaximumError=1.0)
    surface.SetInputConnection(horizons.GetOutputPort())
    update(surface)
    found = surface.GetOutputDataObject(0)
    return [found.GetPartition(number, 0) for number in range(found.GetNumberOfPartitionedDataSets())]


def test_in_situ():
    """Meshes at each time step of a simulation that knows of nothing but Catalyst."""
    command = [sys.executable, "-m", "paraview.demos.wavelet_miniapp", "--timesteps", "3", "--size", "41", "-s",
               str(RECIPES / "in_situ.py")]
    done = subprocess.run(command, cwd=FOLDER, capture_output=True, text=True, timeout=180, check=False)
    said = done.stdout + done.stderr
    assert done.returncode == 0 and "ERR|" not in said and "Traceback" not in said, said
    for step in range(3):
        name = "meshes_%06d" % step
        assert (FOLDER / "extracts" / (name + ".vtpc")).is_file(), said
        expected = meshes_alone(step)
        files = sorted((FOLDER / "extracts" / name).glob("*.vtp"))
        assert len(files) == len(expected) > 1, files
        for file, alone in zip(files, expected):
            mesh = mesh_checks.read(file)
            assert mesh_checks.check_mesh(mesh) > 0, file
            assert (mesh_checks.coordinates(mesh) == mesh_checks.coordinates(alone)).all(), file
            assert (mesh_checks.triangles(mesh) == mesh_checks.triangles(alone)).all(), file


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    if RECIPE == "in_situ":
        test_in_situ()
    else:
        test_extracts()


main()
