#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the error of filled holes: removes columns from horizons, fills the holes by several methods, and compares.
Prints a table of Documentation/StageTables.md: for each horizon and each width of holes in columns, the root mean square
error of Method Automatic in lattice units, and in brackets its ratio to the smallest error of the other methods. With
--methods each method has a column.

    hole_filling.py [--methods] [--real FOLDER] [--widths W...] [--size COLUMNS] [--repeat N] [--processes N]

Generated horizons have waves of all lengths and a deviation of 12 vertical indices; their errors are measured from the
surface without noise. Errors of real horizons include noise, in units of the median of the nonzero steps between adjacent
columns. Our methods besides Automatic: "plate" has RimSmoothing 1, "exact plate" 0, "smooth plate" 16 with RimWidth 5.
The spline is a thin-plate spline through some columns of the rim, six wide; the smoothing spline has smoothing 10 in
SciPy's RBFInterpolator. Triangles are linear over our mesh. Inverse distance is squared, from a rim three columns wide.

Needs the package seismichorizons in PYTHONPATH, and numpy. Horizons in FOLDER are files *.ijz with lines "i j z".
"""

import argparse
import multiprocessing
import pathlib

import numpy as np
import seismichorizons as sh
from seismichorizons_command.data import empty, to_vtk
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkDelaunay2D, vtkProbeFilter
from vtkmodules.vtkFiltersPoints import (vtkGaussianKernel, vtkGeneralizedKernel, vtkPointInterpolator,
                                         vtkShepardKernel, vtkVoronoiKernel)

from text import report, table

MARGIN = 12  # known columns around each hole
MOST_PLACES = 4000  # compared positions: kernels are slow in the middle of wide holes
NEAREST = 32  # points of a kernel
MOST_CENTRES = 3000  # of a spline, whose matrix is dense
OURS = ("automatic", "plate", "exact plate", "smooth plate", "membrane")
KERNELS = {"Voronoi": vtkVoronoiKernel, "Shepard": vtkShepardKernel, "Gaussian": vtkGaussianKernel}


# ---- Horizons, as two arrays by column: whether there is a point, and its height ----

def generated(random, size, roughness):
    """Returns a surface of waves of all lengths, with amplitude increasing with length; roughness is the fraction of short
    waves."""
    frequencies = np.hypot(np.fft.fftfreq(size)[:, None], np.fft.rfftfreq(size)[None, :])
    height = np.zeros((size, size))
    for power, shortest, deviation in ((2.5, 16.0, 12.0), (1.7, 2.0, 12.0 * roughness)):
        spectrum = random.standard_normal(frequencies.shape) + 1j * random.standard_normal(frequencies.shape)
        spectrum /= np.maximum(frequencies, 1.0 / 400.0) ** power
        spectrum[(frequencies == 0.0) | (frequencies > 1.0 / shortest)] = 0.0
        waves = np.fft.irfft2(spectrum, (size, size))
        height += deviation * waves / waves.std()
    return height


def read_real(path):
    """Returns the columns of a file; the vertical index is the median of the steps between neighbours if that is larger."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    values = np.array([line.split() for line in lines[1:] if len(line.split()) == 3], float)
    i, j = (values[:, axis].astype(int) - int(values[:, axis].min()) for axis in (0, 1))
    height = np.full((j.max() + 1, i.max() + 1), np.nan)
    height[j, i] = values[:, 2]
    return height


def cut_holes(random, there, width, number):
    """Returns the number of a hole for each column, 0 elsewhere: lobed discs surrounded by known columns."""
    holes = np.zeros(there.shape, int)
    reach = int(0.65 * width) + MARGIN
    rows, columns = there.shape
    if min(rows, columns) <= 2 * reach + 1:
        return holes
    for _ in range(200 * number):
        if holes.max() == number:
            break
        y, x = random.integers(reach, rows - reach), random.integers(reach, columns - reach)
        window = np.s_[y - reach:y + reach + 1, x - reach:x + reach + 1]
        if there[window].mean() < 0.97 or holes[window].any():
            continue
        v, u = np.mgrid[-reach:reach + 1, -reach:reach + 1]
        lobes = 1.0 + 0.15 * np.sin(3.0 * np.arctan2(v, u) + random.uniform(0.0, 6.3))
        holes[window][np.hypot(u, v) <= 0.5 * width * lobes] = holes.max() + 1
    return holes


def horizon(there, height):
    return sh.horizon(np.where(there, height, np.nan), direction="up", vertical_step=1.0)


# ---- Methods: each returns the heights at the removed positions (row, column) ----

def fill(there, height, places, **options):
    return sh.fill_holes(horizon(there, height), there.size, **options).grid()[places]


def triangles(there, height, places):
    """Linear interpolation over the triangles of the mesh, which closes holes."""
    mesh = sh.triangulation(sh.exterior_boundary(horizon(there, height)))
    corners = mesh.triangles.ravel()
    return probe(flat(mesh.points, polygons=(np.arange(0, len(corners) + 1, 3), corners)), places)


def flat(points, **cells):
    """Returns points in plan view, with their heights as an array, for VTK."""
    return to_vtk({**empty(), "places": points * (1.0, 1.0, 0.0), "point_data": {"Height": points[:, 2]}, **cells})


def flat_columns(there, height):
    """Does the same for columns."""
    row, column = np.nonzero(there)
    return flat(np.column_stack([column, row, height[there]]))


def at_places(places):
    return to_vtk({**empty(), "places": np.column_stack([places[1], places[0], np.zeros(len(places[0]))])})


def probe(mesh, places):
    sample = vtkProbeFilter()
    sample.SetInputData(at_places(places))
    sample.SetSourceData(mesh)
    sample.Update()
    found = vtk_to_numpy(sample.GetOutput().GetPointData().GetArray("Height"))
    # VTK's Delaunay triangles leave gaps between collinear points, where the nearest point is used.
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    heights = vtk_to_numpy(mesh.GetPointData().GetArray("Height"))
    for n in np.nonzero(vtk_to_numpy(sample.GetOutput().GetPointData().GetArray("vtkValidPointMask")) == 0)[0]:
        away = np.hypot(points[:, 0] - places[1][n], points[:, 1] - places[0][n])
        found[n] = heights[away.argmin()]
    return found


def rim(there, holes, width=3):
    """Returns the known columns near holes."""
    near = holes > 0
    for _ in range(width):
        near = near | np.roll(near, 1, 0) | np.roll(near, -1, 0)
        near = near | np.roll(near, 1, 1) | np.roll(near, -1, 1)
    return near & there


def delaunay(there, height, holes, places):
    """Linear interpolation over VTK's Delaunay triangles between the columns around holes."""
    mesher = vtkDelaunay2D()
    mesher.SetInputData(flat_columns(rim(there, holes), height))
    mesher.Update()
    return probe(mesher.GetOutput(), places)


def kernel(kind, there, height, holes, places):
    """ParaView's point interpolator, from the columns near holes."""
    interpolator = vtkPointInterpolator()
    interpolator.SetInputData(at_places(places))
    interpolator.SetSourceData(flat_columns(rim(there, holes, 6), height))
    chosen = kind()
    if isinstance(chosen, vtkGeneralizedKernel):
        chosen.SetKernelFootprintToNClosest()
        chosen.SetNumberOfPoints(NEAREST)
        chosen.SetRadius(1e9)
    interpolator.SetKernel(chosen)
    interpolator.SetNullPointsStrategyToClosestPoint()
    interpolator.Update()
    return vtk_to_numpy(interpolator.GetOutput().GetPointData().GetArray("Height"))


def inverse_distance(there, height, holes, places):
    """Average weighted by the inverse square of the distance to all columns of the hole's rim."""
    result = np.empty(len(places[0]))
    numbers = holes[places]
    for number in range(1, holes.max() + 1):
        own = rim(there, np.where(holes == number, 1, 0))
        row, column = np.nonzero(own)
        for part in np.array_split(np.nonzero(numbers == number)[0], max(1, (numbers == number).sum() // 2000)):
            squared = ((places[0][part][:, None] - row) ** 2 + (places[1][part][:, None] - column) ** 2).astype(float)
            weights = 1.0 / squared
            result[part] = weights @ height[own] / weights.sum(axis=1)
    return result


def thin_plate(places, centres):
    """The kernel of a thin-plate spline: r^2 log r."""
    squared = ((places[:, None] - centres[None]) ** 2).sum(axis=2)
    return 0.5 * squared * np.log(np.where(squared > 0.0, squared, 1.0))


def spline_of_hole(known, heights, places, smoothing):
    """Thin-plate spline with a plane (Duchon 1977) through, or near, given positions and heights."""
    middle, scale = known.mean(axis=0), max(1.0, np.ptp(known))
    known, places = (known - middle) / scale, (places - middle) / scale
    count = len(known)
    plane = np.column_stack([np.ones(count), known])
    matrix = np.zeros((count + 3, count + 3))
    matrix[:count, :count] = thin_plate(known, known) + smoothing / scale**2 * np.eye(count)
    matrix[:count, count:], matrix[count:, :count] = plane, plane.T
    base = heights.mean()
    weights = np.linalg.solve(matrix, np.concatenate([heights - base, np.zeros(3)]))
    parts = [thin_plate(part, known) @ weights[:count] + np.column_stack([np.ones(len(part)), part]) @ weights[count:]
             for part in np.array_split(places, max(1, len(places) // 500))]
    return base + np.concatenate(parts)


def spline(there, height, holes, places, smoothing):
    """Thin-plate spline of each hole."""
    result = np.empty(len(places[0]))
    numbers = holes[places]
    for number in np.unique(numbers):
        own = np.argwhere(rim(there, np.where(holes == number, 1, 0), 6))
        own = own[np.linspace(0, len(own) - 1, min(len(own), MOST_CENTRES)).astype(int)]
        some = numbers == number
        wanted = np.column_stack([axis[some] for axis in places]).astype(float)
        result[some] = spline_of_hole(own.astype(float), height[own[:, 0], own[:, 1]], wanted, smoothing)
    return result


def methods(there, height, holes, places):
    """Returns the heights of all methods by name."""
    yield "automatic", fill(there, height, places)
    yield "plate", fill(there, height, places, method="plate")
    yield "exact plate", fill(there, height, places, method="plate", rim_smoothing=0.0)
    yield "smooth plate", fill(there, height, places, method="plate", rim_smoothing=16.0, rim_width=5)
    yield "membrane", fill(there, height, places, method="membrane")
    yield "spline", spline(there, height, holes, places, 0.0)
    yield "smoothing spline", spline(there, height, holes, places, 10.0)
    yield "triangles", triangles(there, height, places)
    yield "vtkDelaunay2D", delaunay(there, height, holes, places)
    yield "inverse distance", inverse_distance(there, height, holes, places)
    for name, kind in KERNELS.items():
        yield name, kernel(kind, there, height, holes, places)


# ---- The table ----

def errors(random, truth, noisy, width, number):
    """Returns the root mean square error of each method; empty if no hole fits."""
    there = np.isfinite(noisy)
    holes = cut_holes(random, there, width, number)
    places = np.nonzero((holes > 0) & there)
    if not len(places[0]):
        return None
    some = random.permutation(len(places[0]))[:MOST_PLACES]
    places = tuple(axis[some] for axis in places)
    known = there & (holes == 0)
    return {name: np.sqrt(np.mean((found - truth[places]) ** 2))
            for name, found in methods(known, noisy, holes, places)}


NOISES = {"no noise": lambda random, height: height,
          "noise 1": lambda random, height: height + random.standard_normal(height.shape),
          "whole numbers": lambda random, height: np.round(height)}


def number_of_holes(width):
    return max(4, 2000 // width**2 + 100 // width)  # fewer if there is no room


def errors_of_generated(options, noise, width, seed):
    random = np.random.default_rng(seed)
    truth = generated(random, options.size, options.roughness)
    return errors(random, truth, NOISES[noise](random, truth), width, number_of_holes(width))


def errors_of_real(_, path, width, seed):
    height = read_real(path)
    scale = np.nanmedian(np.abs(np.diff(height, axis=1))[np.abs(np.diff(height, axis=1)) > 0.0])
    height = height / max(scale, 1e-12)
    return errors(np.random.default_rng(seed), height, height, width, number_of_holes(width))


def run(job):
    name, width, measure, arguments = job
    report("%s, width %d" % (name, width))
    return measure(*arguments)


def jobs_of(options):
    """Returns the table rows to compute, as (name, width, function, its arguments)."""
    for width in options.widths:
        for noise in NOISES:
            for seed in range(options.repeat):
                yield "generated, %s" % noise, width, errors_of_generated, (options, noise, width, seed)
    for path in sorted(options.real.rglob("*.ijz")) if options.real else []:
        for width in options.widths:
            for seed in range(options.repeat):
                yield "%s, %s" % (path.parent.name, path.stem), width, errors_of_real, (None, path, width, seed)


def least_of_others(errors, *without):
    return min(error for method, error in errors.items() if method not in (*OURS, *without))


def method_table(errors_by_hole):
    heads = ["horizon", "width", *next(iter(errors_by_hole.values())), "ours / best other"]
    return table(heads, [[name, str(width), *("%.2f" % error for error in errors.values()),
                          "%.2f" % (errors["automatic"] / least_of_others(errors))]
                         for (name, width), errors in errors_by_hole.items()])


def horizon_table(errors_by_hole, widths):
    def cell(name, width):
        errors = errors_by_hole.get((name, width))
        return "%.2f (%.2f)" % (errors["automatic"], errors["automatic"] / least_of_others(errors)) if errors else "-"

    names = dict.fromkeys(name for name, _ in errors_by_hole)
    return table(["horizon", *("%d columns" % width for width in widths)],
                 [[name, *(cell(name, width) for width in widths)] for name in names])


def summary(errors_by_hole):
    ratios = [errors["automatic"] / least_of_others(errors) for errors in errors_by_hole.values()]
    plain = [errors["automatic"] / least_of_others(errors, "smoothing spline") for errors in errors_by_hole.values()]
    return "In brackets: %.2f on average, at most %.2f; without the smoothing spline %.2f and %.2f." % (
        np.mean(ratios), max(ratios), np.mean(plain), max(plain))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--methods", action="store_true", help="a column for each method")
    parser.add_argument("--real", type=pathlib.Path)
    parser.add_argument("--widths", type=int, nargs="+", default=[5, 50, 150, 500])
    parser.add_argument("--size", type=int, default=768, help="columns along a side of generated horizons")
    parser.add_argument("--roughness", type=float, default=0.1, help="part of short waves in generated horizons")
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    options = parser.parse_args()
    jobs = list(jobs_of(options))
    with multiprocessing.Pool(options.processes) as pool:
        measured = pool.map(run, jobs, 1)
    found_of = {}
    for (name, width, _, _), found in zip(jobs, measured):
        if found:
            found_of.setdefault((name, width), []).append(found)
    errors_by_hole = {hole: {method: np.sqrt(np.mean([one[method] ** 2 for one in found])) for method in found[0]}
                      for hole, found in found_of.items()}
    print(method_table(errors_by_hole) if options.methods else horizon_table(errors_by_hole, options.widths))
    print(summary(errors_by_hole))


if __name__ == "__main__":
    main()
