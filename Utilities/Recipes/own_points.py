# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes points that a script has made or fetched from elsewhere, in world coordinates and in any order.

    python3 own_points.py mesh.vtp

Needs the Python package seismichorizons. Replace make_points by your arrays: the points must lie on a lattice, which may be
rotated; it is found automatically.
"""

import argparse
import math
import random

import numpy as np
import seismichorizons as sh


def make_points():
    """Returns picks of a dome on a rotated survey of 25 m by 12.5 m, in random order, with a hole."""
    angle = math.radians(30)
    along, across = (np.array((math.cos(angle), math.sin(angle))), np.array((-math.sin(angle), math.cos(angle))))
    picks = []
    for i in range(80):
        for j in range(100):
            if (i - 30) ** 2 + (j - 60) ** 2 > 60:
                x, y = np.array((431000.0, 6348000.0)) + 25.0 * i * along + 12.5 * j * across
                picks.append((x, y, 1500.0 + 0.06 * ((i - 40) ** 2 + (j - 50) ** 2)))
    random.Random(1).shuffle(picks)
    return np.array(picks)


def main():
    parser = argparse.ArgumentParser(prog="own_points", description=__doc__.splitlines()[0])
    parser.add_argument("mesh", metavar="MESH.vtp", help="the file to write, in this or another format of sh.write")
    arguments = parser.parse_args()
    horizon = sh.horizon(points=make_points(), name="Dome", vertical_unit="m", horizontal_unit="m")
    mesh = sh.surface(horizon, "1 m")
    print(horizon, mesh, sep="\n")
    sh.write(mesh, arguments.mesh)


main()
