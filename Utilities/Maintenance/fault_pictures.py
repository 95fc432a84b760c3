#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on faults: a faulted horizon with the lines found; its meshes without and with cuts, which
are closed in the second one; and horizons cut by the surface between fault sticks.

    fault_pictures.py FOLDER

Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys
import tempfile

import numpy as np
import seismichorizons as sh
from seismichorizons import _core
from seismichorizons_command import core, data, pictures
from seismichorizons_command.reading import read_first

SIZE = (150, 110)
PANEL_SIZE = (440, 360)
CLOSED_SIZE = (660, 480)
LARGEST_ERROR = 1.5


def heights():
    """Returns a fold with two tapered faults, the second with both tips inside, in whole vertical indices."""
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    fold = 60.0 + 9.0 * np.sin(x / 26.0) + 7.0 * np.cos((x + 2.0 * y) / 45.0)
    first = 20.0 * np.clip(y / 45.0, 0.25, 1.0) * (x > 55.0 + 0.35 * y + 4.0 * np.sin(y / 14.0))
    along = (x - 78.0) / 58.0
    taper = np.where(np.abs(2.0 * along - 1.0) < 1.0, 1.0 - (2.0 * along - 1.0) ** 2, 0.0)
    second = 14.0 * taper * (y < 30.0 + 0.3 * (x - 78.0) + 3.0 * np.sin(x / 9.0))
    noise = np.random.default_rng(5).normal(0.0, 0.3, x.shape)
    return np.rint(fold + first + second + noise).astype(int)


def write(path):
    """Writes a horizon with a point in all columns except a ragged margin."""
    x, y = np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1]))
    from_middle = np.hypot((x - 75.0) / 75.0, (y - 55.0) / 55.0)
    is_there = from_middle < 0.98 + 0.12 * np.sin(5.0 * np.arctan2(y - 55.0, x - 75.0))
    lines = ["%d 1 1 1 %d" % (height, height) if there else "" for height, there
             in zip(heights().ravel(), is_there.ravel())]
    path.write_text("%d %d 200\n%s\n" % (*SIZE, "\n".join(lines)))


def surface(points, **options):
    (mesh, _), _ = core.run(_core.surface, points, {"maximum_error": LARGEST_ERROR, **options})
    return mesh


def triangles_panel(title, mesh):
    return pictures.Panel(title, "%d triangles" % data.count_polygons(mesh), mesh, pictures.MESH)


def draw_closed(cut, within):
    """Draws the mesh with its faults open, and closed."""
    closed = surface(cut, close_faults=True)
    walls = data.value(closed, "FaultTriangleCount")
    row = [triangles_panel("Open", within), pictures.Panel("Closed", "%d more" % walls, closed, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=CLOSED_SIZE), pathlib.Path(sys.argv[1]) / "ClosedFaults.png")


def fault_x(y, depth):
    """Returns x of a curved fault that dips towards larger x."""
    return 48.0 + 0.3 * y + 6.0 * np.sin(y / 16.0) + 0.45 * depth


def make_sticks():
    """Returns sticks on every eleventh row in random order; one ends early."""
    rows = np.random.default_rng(3).permutation(np.arange(-2, SIZE[1] + 10, 11))
    sticks = [np.array([(fault_x(row, depth), row, -depth) for depth in (-6.0, 20.0, 34.0 if row == 53 else 62.0)])
              for row in rows]
    return sh.Lines(["Fault %d" % row for row in rows], sticks)


def of_three(numbers):
    """Returns cells of three points each, as offsets and points."""
    return np.arange(0, np.size(numbers) + 1, 3), np.ravel(numbers)


def draw_surfaces():
    """Draws two horizons, the surface of a fault between its sticks, and both together."""
    sticks, meshes = make_sticks(), []
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    for depth in (10.0, 40.0):
        fold = 3.0 * np.sin(x / 26.0) + 2.0 * np.cos((x + 2.0 * y) / 45.0)
        z = -(depth + fold + 9.0 * (x > fault_x(y, depth + fold + 4.5)))
        horizon = sh.horizon(x, y, z, direction="up")
        faults = sh.faults(horizon, lines=sticks, are_sticks=True)
        meshes.append(sh.surface(faults.horizon, LARGEST_ERROR / 3.0 * horizon.lattice.vertical_step, faults=faults))
    meshes.append(faults.surfaces)
    firsts = np.cumsum([0] + [len(mesh.points) for mesh in meshes])
    together = {
        **data.empty(), "places": np.concatenate([mesh.points for mesh in meshes]),
        "polygons": of_three(np.concatenate([mesh.triangles + first for mesh, first in zip(meshes, firsts)])),
        "cell_data": {"Fault": np.repeat([0, 0, 1], list(map(len, meshes)))}}
    lines = {"places": np.concatenate(sticks.lines), "lines": of_three(np.arange(3 * len(sticks))),
             "point_data": {"Throw": np.ones(3 * len(sticks))}}
    row = [pictures.Panel("Sticks", "%d, in no order" % len(sticks), lines, pictures.FAULTS),
           pictures.Panel("Their surface", "cuts two horizons", together, pictures.MESH)]
    pictures.write(pictures.draw([row], panel_size=CLOSED_SIZE), pathlib.Path(sys.argv[1]) / "FaultSurfaces.png")


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "faulted.vsm"
        write(path)
        points = read_first(path)
    (cut, lines, _), _ = core.run(_core.faults, points, None, {})
    within = surface(cut)
    row = [pictures.Panel("Fault lines", "%d lines, %d faulted links" % (
               data.count_lines(lines), len(cut["field_data"]["FaultedLinks"])), lines, pictures.FAULTS, points),
           triangles_panel("Not cut", surface(points)), triangles_panel("Cut", within)]
    pictures.write(pictures.draw([row], panel_size=PANEL_SIZE), pathlib.Path(sys.argv[1]) / "Faults.png")
    draw_closed(cut, within)
    draw_surfaces()


if __name__ == "__main__":
    main()
