# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated surfaces like those of the thesis: as many points, in a box of the same proportions that is as full."""

import pathlib
import subprocess

from seismichorizons.pipeline import read_first

from . import reported

HEIGHT_OF_CUBE = 1.85  # of that of the surface the generator puts into it
DROPOUTS = 0.01

# Table 5.1 has two surfaces without a box; theirs is that of the surface with the next number of points.
BOX_OF = {98231: 148317, 886639: 664582}


def box_of(points):
    return reported.SURFACES[BOX_OF.get(points, points)]


def generate(generator, points, size, squareness, path):
    """Writes a surface; without holes and islands where its shape has no room for them."""
    command = [generator, "--size", *map(str, size), "--points", str(points), "--horizons", "1", "--dropouts",
               str(DROPOUTS), "--squareness", str(squareness), path]
    for features in ([], ["--holes", "0", "--islands", "0"]):
        if subprocess.run(command + features, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0:
            return
    raise SystemExit("generate_horizons failed: %s" % " ".join(map(str, command)))


def size_of_box(horizon):
    bounds = horizon.GetBounds()
    return [round(bounds[2 * axis + 1] - bounds[2 * axis]) + 1 for axis in range(3)]


def occupancy(points, box):
    """The part of the columns of a box that is filled."""
    return points / (box[0] * box[1])


def find_squareness(generator, size, wanted, path):
    """The outline that fills its box as a surface of the thesis does: by bisection, on small surfaces of that shape."""
    low, high = -1.0, 1.0
    for _ in range(8):
        middle = 0.5 * (low + high)
        generate(generator, 20000, size, middle, path)
        horizon = read_first(path)
        if occupancy(horizon.GetNumberOfPoints(), size_of_box(horizon)) < wanted:
            low = middle
        else:
            high = middle
    return round(0.5 * (low + high), 2)


def make(generator, points, folder):
    """A surface of the thesis, by its number of points."""
    path = pathlib.Path(folder) / "surface.vsm"
    box = box_of(points)
    size = (round(box[0]), round(box[1]), round(HEIGHT_OF_CUBE * box[2]))
    filled = occupancy(BOX_OF.get(points, points), box)
    generate(generator, points, size, find_squareness(generator, size, filled, path), path)
    return read_first(path)
