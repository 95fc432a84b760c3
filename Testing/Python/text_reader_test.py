# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: text files of horizons are opened as such, others are not, one becomes a surface, and several a
series.

Argument: a folder for the files.
"""

import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

import mesh_checks
from paraview import simple

PLACES = [(1000.5 + 25 * i - 3 * j, 2000.25 + 3 * i + 25 * j) for j in range(12) for i in range(15)]
PICKS = "".join("%.3f %.3f %.2f\n" % (x, y, 500 + 0.01 * x + 0.02 * y) for x, y in PLACES)
OPENDTECT = '# "X"\t"Y"\t"Z"\n# - - - - - - - - - -\n' + PICKS.replace(" ", "\t")
SCATTER = "".join("%d.%d %d.%d 3\n" % (n * n % 97, n * 7 % 10, n * n * n % 89, n * 3 % 10) for n in range(50))


def write(path, text):
    path.write_text(text, encoding="utf-8")
    return str(path)


def check_factory(folder):
    """Files are looked into, and those of others stay theirs."""
    vset = "GOCAD VSet 1\nHEADER {name:top}\n%s\nEND\n" % "\n".join("VRTX %d %s" % line for line in enumerate(PICKS.splitlines()))
    for name, text, is_ours in [("top.vs", vset, True), ("top.dat", OPENDTECT, True), ("top.xyz", PICKS, True), ("top.pts", PICKS, True),
                                ("top.csv", PICKS.replace(" ", ","), True), ("scatter.txt", SCATTER, False),
                                ("letter.txt", "Dear all,\nsee you at 10 o'clock\n", False)]:
        reader = simple.OpenDataFile(write(folder / name, text))
        assert (type(reader).__name__ == "HorizonTextReader") == is_ours, (name, reader)


def check_panel(reader):
    """What was found, and properties of the bases."""
    reader.UpdatePipeline()
    reader.UpdatePipelineInformation()
    assert reader.WhatWasFound.startswith("OpendTect, separated by tabs: X, Y, Z\n15 x 12 columns from (1000.5, "), \
        reader.WhatWasFound
    assert list(reader.HorizonStatus) == ["top"]
    reader.VerticalStep = 0.25
    reader.VerticalUnit = "ms"
    reader.VerticalDirection = "Up"
    reader.UpdatePipeline()
    data = mesh_checks.blocks(reader.GetClientSideObject().GetOutputDataObject(0))["top"].GetFieldData()
    assert data.GetAbstractArray("VerticalUnit").GetValue(0) == "ms"
    assert data.GetArray("LatticeToWorld").GetValue(10) == 0.25


def check_names_tell_units(folder):
    """Unit and domain in the name of z: (name, unit, domain)."""
    for name, unit, domain in (("TWT_ms", "ms", "time"), ("TVDSS (ft)", "ft", "depth"), ("DEPTH_MSL", None, "depth"),
                               ("Time", None, "time"), ("Z", None, None)):
        path = folder / "named.xyz"
        path.write_text("Inline\tCrossline\tX\tY\t%s\n" % name + "".join(
            "%d\t%d\t%d\t%d\t%d\n" % (row, column, 25 * column, 25 * row, 900 + row + column)
            for row in range(9) for column in range(9)))
        reader = simple.HorizonTextReader(FileName=[str(path)])
        reader.UpdatePipeline()
        data = mesh_checks.blocks(reader.GetClientSideObject().GetOutputDataObject(0))["named"].GetFieldData()
        told = [data.GetAbstractArray(array) for array in ("VerticalUnit", "VerticalDomain")]
        assert [text and text.GetValue(0) for text in told] == [unit, domain], (name, told)


def check_lines(folder):
    """Lines of other kinds are left out and counted; a matrix of heights has the places that it is given."""
    path = write(folder / "kinds.csv", "X,Y,Z,kind\n" + "".join(
        "%s,top\nbad,,,fault\n" % line.replace(" ", ",") for line in PICKS.splitlines()))
    reader = simple.HorizonTextReader(Where="kind=top", FileName=[path])
    reader.UpdatePipeline()
    assert "; %d lines of other kinds left out\n" % len(PLACES) in reader.WhatWasFound, reader.WhatWasFound
    assert list(mesh_checks.blocks(reader.GetClientSideObject().GetOutputDataObject(0))) == ["top"]
    matrix = "".join(" ".join(str(1500 + 5 * i + j) for i in range(16)) + "\n" for j in range(9))
    reader = simple.HorizonTextReader(FileName=[write(folder / "matrix.txt", matrix)],
                                      LatticeSource="Origin And Steps", Origin=[500, 900], ColumnStep=[25, 0], RowStep=[0, -50])
    reader.UpdatePipeline()
    bounds = mesh_checks.blocks(reader.GetClientSideObject().GetOutputDataObject(0))["matrix"].GetBounds()
    assert bounds == (500, 875, 500, 900, -1583, -1500), bounds


def check_surface(reader):
    surface = simple.HorizonSurface(Input=reader)
    surface.UpdatePipeline()
    mesh = mesh_checks.blocks(surface.GetClientSideObject().GetOutputDataObject(0))["top"]
    assert 2 <= len(mesh_checks.triangles(mesh)) < len(PLACES)
    bounds = mesh.GetBounds()
    assert bounds[0] == min(x for x, y in PLACES) and bounds[3] == max(y for x, y in PLACES), bounds


def check_series(folder):
    """Filters follow the time, and the animation has the times of the files."""
    files = [write(folder / ("series_%d.xyz" % time), PICKS.replace(" 5", " %d" % (time + 5))) for time in range(3)]
    reader = simple.OpenDataFile(files)
    assert list(reader.FileName) == files and list(reader.TimestepValues) == [0, 1, 2], reader.TimestepValues
    surface = simple.HorizonSurface(Input=reader)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    assert list(scene.TimeKeeper.TimestepValues) == [0, 1, 2]
    simple.Show(surface)
    heights = []
    for move in (scene.GoToFirst, scene.GoToNext, scene.GoToLast, scene.GoToFirst):
        move()
        simple.Render()
        heights.append(-surface.GetDataInformation().GetBounds()[5])
    assert [round(height / 100) for height in heights] == [6, 7, 8, 6], heights
    reader.FileName = files[0]
    reader.UpdatePipeline()
    assert len(reader.TimestepValues) == 0


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    check_factory(folder)
    reader = simple.OpenDataFile(str(folder / "top.dat"))
    check_panel(reader)
    check_surface(reader)
    check_lines(folder)
    check_series(folder)
    check_names_tell_units(folder)


main()
