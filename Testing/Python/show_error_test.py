# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipe that draws the error, as a user runs it. Arguments: recipe, folder of the data, work folder, pvbatch."""

import pathlib
import subprocess
import sys

from seismichorizons.writing import write_mesh

import image_compare
import mesh_checks
import pipelines

RECIPE, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
PVBATCH = sys.argv[4]


def draw(name, *arguments):
    picture = FOLDER / name
    picture.unlink(missing_ok=True)
    done = subprocess.run([PVBATCH, str(RECIPE), *(str(a) for a in arguments), str(picture)], capture_output=True,
                          text=True, timeout=100)
    return done, image_compare.load(picture) if picture.is_file() else None


def colors(picture):
    return len(set(map(tuple, picture[::5, ::5].reshape(-1, 3))))


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    sample, mesh = DATA / "sample.vsm", FOLDER / "mesh.vtp"
    write_mesh(mesh_checks.blocks(pipelines.with_classes(sample)[-1])["Horizon 2"], mesh)
    done, picture = draw("one.png", "--horizon", 2, sample, mesh)
    assert done.returncode == 0 and "ERR|" not in done.stderr, done.stderr
    assert picture.shape[:2] == (780, 900) and colors(picture) > 500, (picture.shape, colors(picture))
    done, picture = draw("two.png", "--horizon", 2, "--array", "VerticalDistance", "--unit", "World", "--edges",
                         "--titles", "One", "Two", "--", sample, mesh, mesh)
    assert done.returncode == 0 and "ERR|" not in done.stderr, done.stderr
    assert picture.shape[:2] == (780, 1800) and colors(picture) > 500, (picture.shape, colors(picture))
    done, picture = draw("none.png", "--horizon", 7, sample, mesh)
    assert done.returncode != 0 and picture is None
    assert "Horizon 7" in done.stderr and "Horizon 1, Horizon 2" in done.stderr, done.stderr


main()
