#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the page on the exterior boundary.

    boundary_pictures.py SAMPLE FOLDER

SAMPLE is a .vsm file. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import numpy as np
from seismichorizons import _core
from seismichorizons_command import core, pictures
from seismichorizons_command.data import count_lines, value
from seismichorizons_command.reading import read_first

PANEL_SIZE = (420, 340)


def ragged(data):
    """Makes a corner of a horizon with less than half of its points, as left by automatic tracking in noise."""
    i, j, _ = data["places"].T.astype(np.uint64)
    # Any hash works that is the same on all machines.
    noise = (i * 73856093 ^ j * 19349663) * 2654435761 % 2**32 / 2**32
    kept = (30 <= i) & (i < 80) & (25 <= j) & (j < 65) & (noise < 0.45)
    return {"places": data["places"][kept], "field_data": data["field_data"]}


def outline_panel(data, rule, radius, holes):
    options = {"radius": radius, "growth": rule.lower(), "keep_holes": holes, "smallest_hole_size": 2}
    (outline,), _ = core.run(_core.boundary, data, options)
    counts = [value(outline, name) for name in ("NumberOfPatches", "NumberOfHoles")]
    points = len(outline["lines"][1]) - count_lines(outline)
    caption = "%d patches, %d boundary points" % (counts[0], points)
    if holes:
        caption = "%d patches, %d holes, %d boundary points" % (*counts, points)
    return pictures.Panel("%s, radius %d" % (rule, radius), caption, outline, pictures.OUTLINE, data)


def main():
    sample, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
    data = read_first(sample)
    for name, horizon, holes in (("Radius", ragged(data), False), ("Holes", data, True)):
        rows = [[outline_panel(horizon, rule, radius, holes) for radius in (1, 2, 3)]
                for rule in ("Distance", "Clockwise")]
        pictures.write(pictures.draw(rows, panel_size=PANEL_SIZE), folder / ("Boundary%s.png" % name))


if __name__ == "__main__":
    main()
