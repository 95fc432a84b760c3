#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares even meshes with those of other programs that have about the same number of triangles. Prints a table of
Documentation/StageTables.md.

    even_meshes.py FOLDER [NAME...]

FOLDER has real horizons as files *.ijz with lines "i j z"; NAME chooses some of the horizons. Programs that are not
installed are left out: gmsh, mmgpy (Mmg), and pyvista with pyacvd, all from PyPI. Figures are in plan, in columns; errors
are vertical, at columns inside, in the unit of z. Gmsh and mmg2d get the simplified outlines, and pyacvd all triangles in
plan; heights are then those of the columns around each vertex. mmgs gets the surface, flattened to a mean slope of 0.3,
with the longest edge, and the error with which it has as many triangles. Gamma and SICN are Gmsh's qualities, 1 for
equilateral triangles: twice the radius of the inscribed circle over that of the circumscribed one, and the inverse
condition number, which is VTK's Shape. Seconds are elapsed times of one run.

Needs the package seismichorizons in PYTHONPATH, numpy, and VTK.
"""

import importlib.util
import pathlib
import sys
import time

import numpy as np
import seismichorizons as sh

from hole_filling import generated, read_real
from text import report, table

ANGLE = 25.0
FRONTAL_DELAUNAY = 6  # Gmsh's number of the algorithm with the best triangles
REACH = 8  # columns beyond known heights where vertices get some
SLOPE = 0.3  # the mean one of surfaces that mmgs gets, which measures in space
# File, title, unit, factor to the unit, largest error in the unit, and edge length in columns.
HORIZONS = {
    "penobscot/seabed": ("Penobscot, sea bed", "ms", 4.0, 12.0, 12.0),
    "penobscot/horizon_b": ("Penobscot, horizon B", "ms", 1.0, 12.0, 12.0),
    "st_helens/horizon": ("Mount St Helens", "m", 1.0, 25.0, 12.0),
    "f3/F3_Demo_4_Truncation": ("F3, a truncation", "ms", 1.0, 3.0, 8.0),
    "generated": ("generated", "", 1.0, 0.5, 12.0),
}


# ---- Meshes, as places (x, y, height) and triangles ----

def ours(horizon, error, length):
    mesh = sh.surface(horizon, error, edge_length=length)
    return mesh.points, mesh.triangles


def border(triangles):
    """Returns the edges of one triangle only, from corner to corner."""
    edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    _, first, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    return edges[first[count == 1]]


def adapted(size, number, make, power=0.5):
    """Calls make(size) until the number of triangles is within 2 % of the wanted one, five times at most; the size changes
    with this power of their ratio. Returns the mesh and the seconds of the last call."""
    for _ in range(5):
        start = time.monotonic()
        places, triangles = make(size)
        seconds = time.monotonic() - start
        if abs(len(triangles) - number) <= 0.02 * number:
            break
        size *= (len(triangles) / number) ** power
    return places, triangles, seconds


def by_gmsh(coarse, size):
    import gmsh
    points, triangles = coarse
    following = {}
    for a, b in border(triangles):
        following.setdefault(a, []).append(b)
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for name, value in (("Algorithm", FRONTAL_DELAUNAY), ("MeshSizeMin", size), ("MeshSizeMax", size),
                        ("MeshSizeFromPoints", 0), ("MeshSizeExtendFromBoundary", 0)):
        gmsh.option.setNumber("Mesh." + name, value)
    loops, tag_of = [], {}
    while following:
        first = next(iter(following))
        loop = [first]
        while True:
            ends = following[loop[-1]]
            end = ends.pop()
            if not ends:
                del following[loop[-1]]
            if end == first:
                break
            loop.append(end)
        for point in loop:  # loops touch
            place = tuple(points[point][:2])
            tag_of[place] = tag_of.get(place) or gmsh.model.geo.addPoint(*place, 0.0)
        corners = [tag_of[tuple(points[point][:2])] for point in loop]
        loops.append((points[loop][:, :2], gmsh.model.geo.addCurveLoop(
            [gmsh.model.geo.addLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])])))
    outer = {tag: places for places, tag in loops if area(places) > 0.0}
    holes_of = {tag: [] for tag in outer}
    for places, tag in loops:
        if tag not in outer:
            around = [one for one, other in outer.items() if is_inside(places[:2].mean(axis=0, keepdims=True), other)[0]]
            holes_of[min(around, key=lambda one: area(outer[one]))].append(tag)
    for tag, holes in holes_of.items():
        gmsh.model.geo.addPlaneSurface([tag, *holes])
    gmsh.model.geo.synchronize()
    gmsh.model.mesh.generate(2)
    tags, places, _ = gmsh.model.mesh.getNodes()
    number_of = np.zeros(int(tags.max()) + 1, int)
    number_of[tags.astype(int)] = np.arange(len(tags))
    found = number_of[gmsh.model.mesh.getElementsByType(2)[1].astype(int)].reshape(-1, 3)
    gmsh.finalize()
    return places.reshape(-1, 3)[:, :2], found


def area(loop):
    x, y = loop.T
    return 0.5 * (x * np.roll(y, -1) - np.roll(x, -1) * y).sum()


def is_inside(places, loop):
    (x, y), (x0, y0), (x1, y1) = places.T[:, :, None], loop.T[:, None], np.roll(loop, -1, axis=0).T[:, None]
    crossed = (y0 > y) != (y1 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        return (crossed & (x < x0 + (y - y0) / (y1 - y0) * (x1 - x0))).sum(axis=1) % 2 == 1


def by_mmg2d(coarse, size):
    import mmgpy
    mesh = mmgpy.MmgMesh2D(np.ascontiguousarray(coarse[0][:, :2]), np.ascontiguousarray(coarse[1], np.int32))
    mesh.remesh(hsiz=size, hgrad=-1.0, verbose=-1)
    return mesh.get_vertices(), mesh.get_triangles()


def by_mmgs(full, length, error, scale):
    import mmgpy
    mesh = mmgpy.MmgMeshS(full[0] * (1.0, 1.0, scale), np.ascontiguousarray(full[1], np.int32))
    mesh.remesh(hmax=length, hmin=0.5, hausd=error * scale, ar=180.0, verbose=-1)
    return mesh.get_vertices() / (1.0, 1.0, scale), mesh.get_triangles()


def by_pyacvd(full, wanted):
    import pyacvd
    import pyvista
    points, triangles = full
    flat = np.column_stack([points[:, :2], np.zeros(len(points))])
    surface = pyvista.PolyData.from_regular_faces(flat, triangles).clean()  # pyacvd fails on unused points
    clusters = pyacvd.Clustering(surface)
    clusters.cluster(int(wanted))
    mesh = clusters.create_mesh()
    return np.asarray(mesh.points)[:, :2], np.asarray(mesh.regular_faces)


def meshes(horizon, heights, error, length):
    """Yields the name, places, triangles and seconds of each mesh."""
    start = time.monotonic()
    points, triangles = ours(horizon, error, length)
    yield "ours", points, triangles, time.monotonic() - start
    number = len(triangles)
    mesh = sh.surface(horizon, error)
    coarse = mesh.points, mesh.triangles
    mesh = sh.triangulation(sh.exterior_boundary(horizon, keep_holes=True, smallest_hole_size=9))
    full = mesh.points, mesh.triangles
    if importlib.util.find_spec("gmsh"):
        places, found, seconds = adapted(0.7 * length, number, lambda size: by_gmsh(coarse, size))
        yield "Gmsh", lifted(places, heights), found, seconds
    if importlib.util.find_spec("mmgpy"):
        places, found, seconds = adapted(0.7 * length, number, lambda size: by_mmg2d(coarse, size))
        yield "mmg2d", lifted(places, heights), found, seconds
        scale = SLOPE / np.nanmean(np.hypot(*np.gradient(heights)))
        yield ("mmgs", *adapted(error, number, lambda bound: by_mmgs(full, length, bound, scale), 1.0))
    if importlib.util.find_spec("pyacvd"):
        places, found, seconds = adapted(0.5 * number, number, lambda wanted: by_pyacvd(full, wanted), -1.0)
        yield "pyacvd", lifted(places, heights), found, seconds


def lifted(places, heights):
    """Returns places with bilinear heights of the columns around them that have one, or else of columns beyond."""
    rows, columns = heights.shape
    for _ in range(REACH):
        near = np.pad(heights, 1, constant_values=np.nan)
        near = np.stack([near[1:-1, :-2], near[1:-1, 2:], near[:-2, 1:-1], near[2:, 1:-1]])
        known = ~np.isnan(near)
        mean = np.where(known, near, 0.0).sum(axis=0) / np.where(known.any(axis=0), known.sum(axis=0), np.nan)
        heights = np.where(np.isnan(heights), mean, heights)
    x, y = np.clip(places[:, 0], 0, columns - 1), np.clip(places[:, 1], 0, rows - 1)
    i, j = np.minimum(x.astype(int), columns - 2), np.minimum(y.astype(int), rows - 2)
    total, weights = np.zeros(len(places)), np.zeros(len(places))
    for dj in (0, 1):
        for di in (0, 1):
            height = heights[j + dj, i + di]
            weight = np.where(np.isnan(height), 0.0, abs(1 - di - (x - i)) * abs(1 - dj - (y - j)) + 1e-9)
            total += weight * np.nan_to_num(height)
            weights += weight
    return np.column_stack([places, np.where(weights > 0.0, total / np.maximum(weights, 1e-30), np.nan)])


# ---- Figures ----

def errors_of(points, triangles, heights):
    """Returns the vertical distance of the mesh from each column, nan outside it."""
    errors = np.full(heights.shape, np.nan)
    for a, b, c in points[triangles]:
        low = np.maximum(np.ceil(np.minimum(np.minimum(a, b), c)[:2] - 1e-9), 0).astype(int)
        high = np.floor(np.maximum(np.maximum(a, b), c)[:2] + 1e-9).astype(int)
        high = np.minimum(high, (heights.shape[1] - 1, heights.shape[0] - 1))
        y, x = np.mgrid[low[1]:max(high[1] + 1, low[1]), low[0]:max(high[0] + 1, low[0])]
        whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if not x.size or whole == 0.0:
            continue
        of_b = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / whole
        of_c = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / whole
        inside = (of_b >= -1e-9) & (of_c >= -1e-9) & (of_b + of_c <= 1.0 + 1e-9)
        mesh = a[2] + of_b * (b[2] - a[2]) + of_c * (c[2] - a[2])
        errors[y[inside], x[inside]] = abs(mesh - heights[y, x])[inside]
    return errors


def figures(points, triangles, heights, length):
    corners = points[triangles][:, :, :2]
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.hypot(sides[..., 0], sides[..., 1])
    crossed = abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    sines = crossed[:, None] / (np.roll(lengths, 1, axis=1) * lengths)
    angle = np.degrees(np.arcsin(np.clip(sines, 0.0, 1.0).min(axis=1)))
    gamma = 4.0 * sines.prod(axis=1) / np.maximum(sines.sum(axis=1), 1e-30)
    sicn = 2.0 * 3.0**0.5 * crossed / (lengths**2).sum(axis=1)
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, number, count = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    inner = count[number.ravel()] == 2
    errors = errors_of(points, triangles, heights)
    there = ~np.isnan(heights)
    outside = (there & np.isnan(errors)).sum() / there.sum()
    return [str(len(triangles)), "%.1f" % angle.min(), "%.2f" % (100.0 * (angle < ANGLE - 1e-9).mean()),
            "%.3f" % gamma.mean(), "%.3f" % sicn.mean(), "%.2f" % (lengths.ravel()[inner].max() / length),
            "%.3g" % np.nanmax(errors), "%.2g" % np.nanmean(errors), "%.2f" % (100.0 * outside)]


def rows(folder, names):
    for name in names:
        title, unit, factor, error, length = HORIZONS[name]
        if name == "generated":
            heights = generated(np.random.default_rng(1), 400, 0.1)
        else:
            heights = factor * read_real(folder / (name + ".ijz"))
        horizon = sh.horizon(heights, vertical_unit=unit or None, direction="up")
        asked = "%s, error %g%s, edges %g" % (title, error, unit and " " + unit, length)
        for mesh, points, triangles, seconds in meshes(horizon, heights, error, length):
            report("%s, %s" % (title, mesh))
            yield [asked, mesh, *figures(points, triangles, heights, length), "%.2f" % seconds]
            asked = ""


def main():
    heads = ["horizon", "mesh", "triangles", "smallest angle", "below 25 degrees, %", "gamma", "SICN", "longest / asked",
             "largest error", "mean error", "columns outside, %", "seconds"]
    print(table(heads, list(rows(pathlib.Path(sys.argv[1]), sys.argv[2:] or HORIZONS))))


main()
