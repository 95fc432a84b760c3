#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints a table of Documentation/StageTables.md: surfaces of real horizons with the automatic error, and with 5,000
triangles. Seconds are elapsed times, the shortest of three runs.

    real_surfaces.py FOLDER

Needs the package seismichorizons in PYTHONPATH. FOLDER has real horizons as files *.ijz with lines "i j z".
"""

import pathlib
import sys
import time
import warnings

import seismichorizons as sh
from hole_filling import read_real
from text import table

TRIANGLES = 5000
RUNS = 3
# Title, unit, and factor from the numbers of the file to the unit.
HORIZONS = {
    "penobscot/seabed": ("Penobscot, sea bed", "ms", 4.0),
    "penobscot/horizon_b": ("Penobscot, horizon B", "ms", 1.0),
    "st_helens/horizon": ("Mount St Helens", "m", 1.0),
    "geoprobe/channels": ("channels in deep water", "m", 1.0),
    "geoprobe/seafloor": ("sea floor in deep water", "m", 1.0),
    "f3/F3_Demo_4_Truncation": ("F3, a truncation", "ms", 1.0),
}


def measure(horizon, **target):
    seconds = []
    for _ in range(RUNS):
        start = time.monotonic()
        mesh = sh.surface(horizon, **target)
        seconds.append(time.monotonic() - start)
    return mesh, min(seconds)


def rows(folder):
    for name, (title, unit, factor) in HORIZONS.items():
        horizon = sh.horizon(factor * read_real(folder / (name + ".ijz")), vertical_unit=unit, direction="down")
        points = len(horizon)
        noise = None
        for target in ({}, {"triangles": TRIANGLES}):
            mesh, seconds = measure(horizon, **target)
            noise = noise or mesh.details["height_noise"]
            kept = len(mesh.points)
            yield ["" if target else title, "" if target else str(points), "" if target else "%.2g %s" % (noise, unit),
                   "%d triangles" % TRIANGLES if target else "automatic", "%.3g %s" % (mesh.largest_error, unit),
                   "%.2f" % (mesh.mean_error / noise), str(kept), str(len(mesh)), "%.1f %%" % (100.0 * (1.0 - kept / points)),
                   "%.2f" % seconds]


def main():
    warnings.simplefilter("ignore")
    titles = ["Horizon", "Points", "Noise", "Target", "Largest error", "Mean error / noise", "Points left", "Triangles",
              "Reduction", "Seconds"]
    print(table(titles, list(rows(pathlib.Path(sys.argv[1])))))


main()
