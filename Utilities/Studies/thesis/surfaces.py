# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated surfaces similar to the surfaces of the thesis: the same number of points, in a box of the same proportions,
equally filled, and equally rough in patches."""

from functools import lru_cache
import pathlib
from statistics import median
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import reported, stages

HEIGHT_OF_CUBE = 1.85  # relative to the height of the surface inside it
DROPOUTS = 0.01
NOISE_HEIGHT = 3  # voxels
NOISE_GAPS = 0.5  # fraction of voxels
POINTS_TO_TRY = 20000  # points of small surfaces
SQUARENESS_STEPS = 8
NOISE_STEPS = 6
WAVES = 24
SQUARE_HEIGHT = 4.0  # height of the longest wave

# Two surfaces of table 5.1 and some in figures have no box; they use the box and noise of the surface with the next
# number of points.
BOX_OF = {5830: 15626, 23559: 32402, 53660: 60511, 98231: 148317, 886639: 664582}


def box_of(points):
    return reported.SURFACES[BOX_OF.get(points, points)]


def size_of_box(horizon):
    bounds = horizon.GetBounds()
    return [round(bounds[2 * axis + 1] - bounds[2 * axis]) + 1 for axis in range(3)]


def occupancy(points, box):
    """Returns the fraction of the columns of a box that is filled."""
    return points / (box[0] * box[1])


def generate(generator, points, size, squareness, noise, path):
    """Writes a surface, without holes and islands if its shape has no room for them."""
    command = [generator, "--size", *size, "--points", points, "--horizons", 1, "--dropouts", DROPOUTS,
               "--squareness", squareness, "--noise", noise, "--noise-height", NOISE_HEIGHT, "--noise-gaps", NOISE_GAPS,
               path]
    command = [str(word) for word in command]
    for features in ([], ["--holes", "0", "--islands", "0"]):
        if subprocess.run(command + features, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0:
            return stages.read(path)
    raise SystemExit("generate_horizons failed: %s" % " ".join(command))


def bisect(low, high, steps, is_too_low):
    for _ in range(steps):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_too_low(middle) else (low, middle)
    return 0.5 * (low + high)


def make_with_noise(generator, points, noise, folder, points_to_make=None):
    """Makes a surface whose outline fills its box to the same degree as the surface of the thesis, as determined on small
    surfaces of that shape. `points_to_make` may be another number of points."""
    path = pathlib.Path(folder) / "surface.vsm"
    box = box_of(points)
    size = (round(box[0]), round(box[1]), round(HEIGHT_OF_CUBE * box[2]))
    wanted = occupancy(BOX_OF.get(points, points), box)

    def is_too_empty(squareness):
        horizon = generate(generator, POINTS_TO_TRY, size, squareness, noise, path)
        return occupancy(horizon.GetNumberOfPoints(), size_of_box(horizon)) < wanted

    squareness = bisect(-1.0, 1.0, SQUARENESS_STEPS, is_too_empty)
    return generate(generator, points_to_make or points, size, round(squareness, 2), noise, path)


@lru_cache(maxsize=None)
def find_noise(generator, points, folder):
    """Returns the fraction of the area in patches of noise at which the rough simplification leaves as many points as in
    the thesis: the median of the ratios for three cell sizes becomes 1."""

    def is_too_smooth(noise):
        horizon = make_with_noise(generator, points, noise, folder)
        straight = stages.straighten(stages.outline(stages.start(horizon)))
        return median(stages.rough(straight, size).points / thesis[0]
                      for size, thesis in reported.ROUGH[points].items()) < 1.0

    return round(bisect(0.0, 1.0, NOISE_STEPS, is_too_smooth), 2) if is_too_smooth(0.0) else 0.0


def make(generator, points, folder):
    """Returns a surface of the thesis, by its number of points, and the fraction of its area in patches of noise."""
    noise = find_noise(generator, BOX_OF.get(points, points), folder)
    return make_with_noise(generator, points, noise, folder), noise


def make_square(side):
    """Returns a full square with a sum of waves, whose height increases with length, in whole heights."""
    numbers = np.random.default_rng(1)
    i, j = (axis.ravel() for axis in np.meshgrid(np.arange(side), np.arange(side)))
    heights = np.zeros(side * side)
    for waves in np.geomspace(1.0, 20.0, WAVES):  # number of waves across the square
        angle, phase = numbers.uniform(0.0, 2.0 * np.pi, 2)
        way = (i * np.cos(angle) + j * np.sin(angle)) / side
        heights += SQUARE_HEIGHT / waves * np.sin(2.0 * np.pi * waves * way + phase)
    places = np.column_stack([i, j, np.rint(heights - heights.min())])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    horizon = vtkPolyData()
    horizon.SetPoints(points)
    lattice = {"LatticeDimensions": np.array([[side, side, 1 + int(places[:, 2].max())]], dtype=np.int32),
               "LatticeToWorld": np.eye(4).reshape(1, 16)}
    for name, values in lattice.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        horizon.GetFieldData().AddArray(array)
    return horizon
