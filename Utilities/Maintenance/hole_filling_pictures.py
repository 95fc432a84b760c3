#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture of the page on hole filling: the largest hole of the sample before and after filling.

    hole_filling_pictures.py SAMPLE FOLDER

SAMPLE is a .vsm file. Needs an X server, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import numpy as np
from seismichorizons import _core
from seismichorizons_command import core, pictures
from seismichorizons_command.data import count_points
from seismichorizons_command.reading import read_first

PANEL_SIZE = (420, 340)
WINDOW = ((58.0, 106.0), (28.0, 70.0))  # columns and rows around the hole


def window(data):
    """Returns the points in the window."""
    low, high = np.transpose(WINDOW)
    in_plan = data["places"][:, :2]
    kept = ((low <= in_plan) & (in_plan <= high)).all(axis=1)
    return {"places": data["places"][kept], "field_data": data["field_data"]}


def mesh(points):
    (outlined,), _ = core.run(_core.boundary, points, {})
    (made, _), _ = core.run(_core.triangulation, outlined, {})
    return made


def main():
    sample, folder = (pathlib.Path(argument) for argument in sys.argv[1:3])
    points = window(read_first(sample))
    panels = [pictures.Panel("Not filled", "the mesh closes holes with long triangles", mesh(points), pictures.MESH)]
    for method in ("Membrane", "Plate"):
        (filled,), _ = core.run(_core.fill_holes, points, {"method": method.lower()})
        caption = "%d new points" % (count_points(filled) - count_points(points))
        panels.append(pictures.Panel(method, caption, mesh(filled), pictures.MESH))
    pictures.write(pictures.draw([panels], panel_size=PANEL_SIZE), folder / "HoleFilling.png")


if __name__ == "__main__":
    main()
