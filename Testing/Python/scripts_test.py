# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes for one machine do what Documentation/Recipes.md says of them.

Arguments: the folder of the recipes, that of the data, one for results, and the paths of pvbatch and python3.
"""

import csv
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np
import seismichorizons as sh
from vtkmodules.vtkIOImage import vtkPNGReader

import mesh_checks

RECIPES, DATA, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:4])
PVBATCH, PYTHON = sys.argv[4:6]
SAMPLE = DATA / "blobs.vsm"


def run(program, name, *arguments, code=0):
    """What a recipe says."""
    command = [program, str(RECIPES / (name + ".py")), *(str(argument) for argument in arguments)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def test_file_to_mesh():
    said = run(PVBATCH, "file_to_mesh", SAMPLE, FOLDER / "meshes.ts")
    assert "3 horizons" in said, said
    assert (FOLDER / "meshes.ts").read_text(encoding="utf-8").count("GOCAD TSurf 1") == 3
    said = run(PVBATCH, "file_to_mesh", "none.vsm", FOLDER / "none.ts", code=1)
    assert "file_to_mesh: none.vsm: no such file" in said, said


def test_many_horizons():
    """A file that is none does not stop the others."""
    wrong = FOLDER / "wrong.vsm"
    wrong.write_text("no horizons\n", encoding="utf-8")
    said = run(PYTHON, "many_horizons", FOLDER / "many", wrong, SAMPLE, code=1)
    assert said.startswith("many_horizons: ") and "wrong.vsm" in said, said
    with open(FOLDER / "many" / "meshes.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["horizon"] for row in rows] == ["Horizon 1", "Horizon 2", "Horizon 3"]
    for row in rows:
        mesh = mesh_checks.read(FOLDER / "many" / ("blobs_%s.vtp" % row["horizon"].replace(" ", "_")))
        assert mesh_checks.check_mesh(mesh) == int(row["triangles"]) > 100


def test_own_points():
    run(PYTHON, "own_points", FOLDER / "own.vtp")
    mesh = mesh_checks.read(FOLDER / "own.vtp")
    assert mesh_checks.check_mesh(mesh) > 50
    hole = sum((i - 30) ** 2 + (j - 60) ** 2 <= 60 for i in range(80) for j in range(100))
    assert mesh_checks.array(mesh, "PointCount").sum() == 80 * 100 - hole


def test_side_by_side():
    run(PVBATCH, "side_by_side", SAMPLE, FOLDER / "side.png", "MaximumError", 0.5, 4)
    reader = vtkPNGReader()
    reader.SetFileName(str(FOLDER / "side.png"))
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetDimensions()[:2] == (1040, 440)
    # Panels of one white background, with something on each.
    for first in (0, 520):
        reds = {picture.GetScalarComponentAsDouble(first + 5 * x, 5 * y, 0, 0) for x in range(104) for y in range(80)}
        assert len(reds) > 20, reds
    said = run(PVBATCH, "side_by_side", SAMPLE, FOLDER / "none.png", "Size", 1, code=1)
    assert "side_by_side: no property 'Size'" in said, said


def test_layers_apart():
    """Two bodies beside their curves."""
    said = run(PVBATCH, "layers_apart", SAMPLE, FOLDER / "apart.png", "--crossings", "LowerWins")
    assert "2 layers over " in said, said
    reader = vtkPNGReader()
    reader.SetFileName(str(FOLDER / "apart.png"))
    reader.Update()
    picture = reader.GetOutput()
    assert picture.GetDimensions()[:2] == (1100, 520)
    for first, most in ((0, 650), (670, 1100)):
        colors = {tuple(picture.GetScalarComponentAsDouble(x, y, 0, c) for c in range(3)) for x in range(first, most, 5)
                  for y in range(0, 520, 5)}
        assert len(colors) > 20, colors
    said = run(PVBATCH, "layers_apart", "none.vsm", FOLDER / "none.png", code=1)
    assert "layers_apart: none.vsm: no such file" in said, said


def test_well_tops():
    """Wells and their names are drawn; what a table lacks is said."""
    i, j = np.meshgrid(np.arange(40), np.arange(40))
    sh.write(sh.horizon(1000 + 0.05 * (i - 20.0) ** 2 + 0.3 * j, spacing=(25, 25)), FOLDER / "top.dat")
    tops = FOLDER / "tops.csv"
    tops.write_text("Well,X,Y,Depth\nA-1,500,250,990\nB-2,850,700,1000\n", encoding="utf-8")

    def reds(name):
        reader = vtkPNGReader()
        reader.SetFileName(str(FOLDER / name))
        reader.Update()
        picture = reader.GetOutput()
        pixels = [[picture.GetScalarComponentAsDouble(x, y, 0, c) for c in range(3)] for x in range(1100) for y in range(700)]
        return sum(red > 100 and green < 60 and blue < 60 for red, green, blue in pixels)

    said = run(PVBATCH, "well_tops", FOLDER / "top.dat", tops, FOLDER / "wells.png", "--exaggeration", 4)
    assert "2 well tops" in said and reds("wells.png") > 100, said
    tops.write_text("Well,X,Y,Depth\nA-1,500,250,-990\n", encoding="utf-8")
    assert "1 well tops" in run(PVBATCH, "well_tops", FOLDER / "top.dat", tops, FOLDER / "up.png", "--direction", "up")
    tops.write_text("\ufeffWell,X,Y,Depth\nA-1,500,250,990\nB-2,850,700,\n", encoding="utf-8")
    said = run(PVBATCH, "well_tops", FOLDER / "top.dat", tops, FOLDER / "none.png", code=1)
    assert "row 2 has '850', '700', '', expected three numbers" in said, said
    said = run(PVBATCH, "well_tops", FOLDER / "top.dat", tops, FOLDER / "none.png", "--columns", "Name,X,Y,Z", code=1)
    assert "no column Name, Z, expected columns Name, X, Y, Z and a row for each top" in said, said


def test_fault_cut():
    """Across a straight fault of a throw of 12, a mesh that is cut is near with few triangles, one that is not is far."""
    i, j = np.meshgrid(np.arange(60), np.arange(50))
    z = 1000 + 12.0 * (i + 0.31 * j > 30) + 0.1 * j
    sh.write(sh.horizon(z, spacing=(25, 25)), FOLDER / "faulted.vsm")
    said = run(PVBATCH, "fault_cut", FOLDER / "faulted.vsm", FOLDER / "cut", "--triangles", 60)
    before, after = (float(value) for value in re.findall(r"largest vertical error ([\d.e-]+)", said))
    assert after < 0.25 * before, said
    names = sorted(path.name for path in (FOLDER / "cut").iterdir())
    assert {"after.vtpc", "before.vtpc", "faults.vtpc"} <= set(names), names


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    test_file_to_mesh()
    test_many_horizons()
    test_own_points()
    test_side_by_side()
    test_layers_apart()
    test_well_tops()
    test_fault_cut()


main()
