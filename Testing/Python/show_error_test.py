# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe that draws the error, as a user runs it. Arguments: recipe, folder of the data, work folder, pvbatch."""

import os
import pathlib
import shutil
import subprocess
import sys

from seismichorizons_command.data import from_vtk
from seismichorizons_command.writing import write_data

import image_compare
import mesh_checks
import pipelines

RECIPE, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
PVBATCH = sys.argv[4]


def draw(name, *arguments, recipe=RECIPE, **environment):
    picture = FOLDER / name
    picture.unlink(missing_ok=True)
    done = subprocess.run([PVBATCH, str(recipe), *(str(a) for a in arguments), str(picture)], capture_output=True,
                          text=True, timeout=100, env={**os.environ, **environment})
    return done, image_compare.load(picture) if picture.is_file() else None


def colors(picture):
    return len(set(map(tuple, picture[::5, ::5].reshape(-1, 3))))


def make_build_tree(folder):
    """A copy of the recipe above a build tree of some version of ParaView; returns the copy."""
    shutil.rmtree(folder, ignore_errors=True)
    plugins = folder / "build/release/lib/paraview-9.87/plugins"
    plugins.mkdir(parents=True)
    (plugins / "SeismicHorizons").symlink_to(os.environ["PV_PLUGIN_PATH"])
    utilities = folder / RECIPE.parent.name
    utilities.mkdir()
    shutil.copy(RECIPE.with_name("DistanceColors.json"), utilities)
    return pathlib.Path(shutil.copy(RECIPE, utilities))


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    sample, mesh = DATA / "blobs.vsm", FOLDER / "mesh.vtp"
    write_data(from_vtk(mesh_checks.blocks(pipelines.with_classes(sample)[-1])["Horizon 2"]), mesh, "Horizon 2")
    done, picture = draw("one.png", "--horizon", 2, sample, mesh)
    assert done.returncode == 0 and "ERR|" not in done.stderr, done.stderr
    assert picture.shape[:2] == (780, 900) and colors(picture) > 500, (picture.shape, colors(picture))
    done, picture = draw("two.png", "--horizon", 2, "--array", "VerticalDistance", "--unit", "World", "--edges",
                         "--titles", "One", "Two", "--", sample, mesh, mesh)
    assert done.returncode == 0 and "ERR|" not in done.stderr, done.stderr
    assert picture.shape[:2] == (780, 1800) and colors(picture) > 500, (picture.shape, colors(picture))
    recipe = make_build_tree(FOLDER / "tree")
    done, picture = draw("built.png", "--horizon", 2, sample, mesh, recipe=recipe, PV_PLUGIN_PATH="")
    assert done.returncode == 0 and picture is not None, done.stderr
    done, picture = draw("none.png", "--horizon", 7, sample, mesh)
    assert done.returncode != 0 and picture is None
    assert "Horizon 7" in done.stderr and "Horizon 1, Horizon 2" in done.stderr, done.stderr


main()
