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
from seismichorizons_command import data, parts, reading

RECIPES, DATA, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:4])
PVBATCH, RECIPE = sys.argv[4:6]
SAMPLE = DATA / "blobs.vsm"


def run(ranks, *arguments, fails=False):
    """What a recipe says on a number of processes."""
    symmetric = ["--symmetric"] if RECIPE == "windows_on_ranks" else []
    command = ["mpirun", "-np", str(ranks), PVBATCH, *symmetric, str(RECIPES / (RECIPE + ".py"))]
    done = subprocess.run(command + [str(argument) for argument in arguments], capture_output=True, text=True,
                          timeout=100, check=False)
    assert (done.returncode != 0) == fails, (done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class WindowSize:
    def most_points(self):
        return 1500

    def limit_text(self):
        return "1500 points"


def mesh_alone():
    """The number of points of the largest horizon, and its mesh by the functions of the package."""
    source = reading.open_file(SAMPLE, with_overview=True)
    source.list()
    windows = parts.Windows(source, source.names.index("Horizon 1"), WindowSize())
    return windows.number_of_points, data.to_vtk(parts.mesh(windows, {"MaximumError": 1.0}))


def test_windows():
    contents = []
    for ranks in (1, 2):
        path = FOLDER / ("mesh%d.vtp" % ranks)
        said = run(ranks, SAMPLE, path, "--window-points", 1500)
        assert "7 windows, " in said, said
        contents.append(path.read_bytes())
    assert contents[0] == contents[1]
    points, expected = mesh_alone()
    mesh = mesh_checks.read(FOLDER / "mesh2.vtp")
    assert (mesh_checks.coordinates(mesh) == mesh_checks.coordinates(expected)).all()
    assert (mesh_checks.triangles(mesh) == mesh_checks.triangles(expected)).all()
    assert mesh_checks.check_mesh(mesh) > 0
    assert mesh_checks.array(mesh, "PointCount").sum() == points
    # A window with all of it needs no join; another horizon than the largest.
    run(2, SAMPLE, FOLDER / "whole.vtp", "--horizon", "Horizon 2")
    assert mesh_checks.check_mesh(mesh_checks.read(FOLDER / "whole.vtp")) > 0


def test_windows_errors():
    """One message, and an end of all processes."""
    for arguments, message in (
            ((SAMPLE, FOLDER / "x.vtp", "--horizon", "Top"), "no horizon 'Top', expected one of Horizon 1, Horizon 2,"),
            ((SAMPLE, FOLDER / "absent" / "x.vtp"), "x.vtp cannot be written")):
        said = run(2, *arguments, fails=True)
        assert said.count("windows_on_ranks: ") == 1 and message in said, said


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
    if RECIPE == "windows_on_ranks":
        test_windows()
        test_windows_errors()
    elif RECIPE == "in_situ":
        test_in_situ()
    else:
        test_extracts()


main()
