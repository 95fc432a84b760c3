# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the thesis with results, repeated with our surfaces: the numbers in their captions, and panels."""

import os

import seismichorizons.vtk as sh
from seismichorizons_command import pictures
from seismichorizons_command.data import from_vtk

from . import partners, stages, surfaces
from .worth import errors, measure

SQUARE = 257  # columns; 66049 points, 1024 on the boundary
SMALL = 600  # points, with an outline about as long as in figure 3.24
SMALL_SIDE = 30  # columns of a square, for the same figure


class Figure:
    """`numbers` are the figure numbers in the thesis; `rows` are (what, thesis, here)."""

    def __init__(self, numbers, title, text):
        self.numbers = numbers
        self.title = title
        self.text = text
        self.rows = []
        self.panels = []

    def row(self, what, thesis, here):
        self.rows.append([what, thesis, here])

    def panel(self, title, caption, data, style, behind=None):
        self.panels.append(pictures.Panel(title, caption, from_vtk(data), style, behind and from_vtk(behind)))

    def picture(self):
        return "Thesis%s.png" % self.numbers[0]

    def draw(self, folder):
        pictures.write(pictures.draw([self.panels]), folder / self.picture())


def count(number, whole=None):
    return "{:,}".format(number) if whole is None else "{:,} ({:.0f} %)".format(number, 100.0 * number / whole)


def both(largest, mean):
    return "%.4f, %.5f" % (largest, mean)


class Simplified:
    """A mesh of simplified points, and its distance from the mesh of all points."""

    def __init__(self, full, mesh):
        self.mesh = mesh
        self.points = mesh.GetNumberOfPoints()
        meter = measure(full, mesh)
        self.largest, self.mean = errors(meter)
        self.colored = meter.GetOutputDataObject(0)  # all points, coloured by distance

    def panel(self, figure, title):
        figure.panel(title, "%s points, mean error %.5f" % (count(self.points), self.mean), self.colored,
                     pictures.DISTANCE)

    def rows(self, figure, what, whole, thesis):
        """`thesis` is points left (or None), largest error, mean error."""
        points, largest, mean = thesis
        figure.row("%s: left" % what, points or "-", count(self.points, whole))
        figure.row("%s: errors" % what, "%g, %g" % (largest, mean), both(self.largest, self.mean))


class Prepared:
    """A surface with its outline, and the mesh of all its points."""

    def __init__(self, horizon):
        self.points = horizon.GetNumberOfPoints()
        self.outlined = stages.outline(stages.start(horizon))
        self.straight = stages.straighten(self.outlined)
        self.full = stages.mesh(self.outlined).data

    def rough(self, cell_size):
        return Simplified(self.full, stages.mesh(stages.rough(self.straight, cell_size)).data)

    def elaborate(self, flatness):
        return Simplified(self.full, stages.mesh(stages.elaborate(self.straight, 8, flatness)).data)

    def merged(self, distance, folder):
        """Returns the mesh merged by MeshLab; None without it."""
        peer = partners.Partners(self.full, self.outlined, folder, partners.Pace()).merge(distance)
        return peer and Simplified(self.full, peer.mesh)

    def show(self, figure, title):
        figure.panel(title, "%s points" % count(self.points), self.full, pictures.MESH)


def outline_panel(figure, title, outlined, text="%s outline points"):
    figure.panel(title, text % count(stages.outline_points(outlined.data)), outlined.data, pictures.OUTLINE,
                 outlined.data)


def outline_rows(figure, outlined, thresholds, thesis):
    """`thesis` is the number of all outline points, and the number for each threshold."""
    whole = stages.outline_points(outlined.data)
    figure.row("outline points, k = 1", count(thesis[0]), count(whole))
    figure.row("bends in plan among them, which stay", "at most %s" % count(thesis[-1]), count(stages.bends(outlined)))
    outline_panel(figure, "All", outlined)
    for threshold, points in zip(thresholds, thesis[1:]):
        straight = stages.straighten(outlined, threshold)
        figure.row("left with t = %g" % threshold, count(points, thesis[0]),
                   count(stages.outline_points(straight.data), whole))
        outline_panel(figure, "t = %g" % threshold, straight)


def smoother_row(figure, what, horizon, threshold):
    """Adds the same row for a surface with fewer bends."""
    outlined = stages.outline(stages.start(horizon))
    whole = stages.outline_points(outlined.data)
    left = stages.outline_points(stages.straighten(outlined, threshold).data)
    figure.row("%s, with %s points and %s bends: left with t = %g" % (
        what, count(whole), count(stages.bends(outlined)), threshold), "-", count(left, whole))


def outline_of_surface(generator, make, folder):
    figure = Figure(["3.23"], "An outline, simplified",
                    "Bends in map view are kept for any t; noise gives ours more of them.")
    outline_rows(figure, make(15626).outlined, (0.4,), (1025, 660))
    smoother_row(figure, "without noise", surfaces.make_with_noise(generator, 15626, 0.0, folder), 0.4)
    return figure


def outline_of_small_surface(generator, folder):
    figure = Figure(["3.24"], "A short outline",
                    "The thesis states neither the surface nor t; ours has more bends.")
    horizon = surfaces.make_with_noise(generator, 15626, 0.0, folder, SMALL)
    outline_rows(figure, stages.outline(stages.start(horizon)), (1.0,), (118, 24))
    smoother_row(figure, "a square", surfaces.make_square(SMALL_SIDE), 1.0)
    return figure


def outline_of_square(square):
    figure = Figure(["3.26"], "The outline of a square",
                    "257 by 257 columns: the 66,049 points of figure 4.16.")
    outline_rows(figure, square.outlined, (0.3, 0.5), (1024, 381, 106))
    return figure


def rough_and_merged(make, folder):
    figure = Figure(["4.14"], "Rough simplification and merging",
                    "Cells of 6 and a distance of 6, on our surface of 15,626 points.")
    surface = make(15626)
    surface.show(figure, "All")
    compare(figure, surface, folder, ("rough, s = 6", surface.rough(6), (None, 0.0142, 0.0004)),
            (6, (None, 0.0296, 0.0009)))
    return figure


def elaborate_and_merged(make, folder):
    figure = Figure(["4.15"], "Elaborate simplification and merging",
                    "The thesis states neither flatness nor distance; ours are 0.12 and 6.")
    surface = make(23559)
    surface.show(figure, "All")
    compare(figure, surface, folder, ("elaborate, s = 8", surface.elaborate(0.12), ("2305 (10 %)", 0.007, 0.0007)),
            (6, ("801 (3 %)", 0.015, 0.003)))
    return figure


def elaborate_and_merged_8(make, folder):
    figure = Figure(["4.18"], "Elaborate simplification and merging, both with 8",
                    "The thesis states file sizes: at 40.8 bytes per point, as in figure 5.21, 53,660 points.")
    surface = make(53660)
    surface.show(figure, "All")
    compare(figure, surface, folder,
            ("elaborate, s = 8, flatness 0.12", surface.elaborate(0.12), ("309 of 2136 kB (14 %)", 0.015, 0.0005)),
            (8, ("46 of 2136 kB (2 %)", 0.034, 0.0014)))
    return figure


def compare(figure, surface, folder, ours, theirs):
    what, simplified, thesis = ours
    simplified.panel(figure, "Ours: " + what)
    simplified.rows(figure, what, surface.points, thesis)
    distance, thesis = theirs
    merged = surface.merged(distance, folder)
    if merged:
        merged.panel(figure, "MeshLab: merged, %d" % distance)
        merged.rows(figure, "merged, %d" % distance, surface.points, thesis)


def square_simplified(square):
    figure = Figure(["4.16", "5.21"], "A square, simplified from its outline inwards",
                    "Ours is a sum of waves whose height fits the outline of figure 3.26. Inner cubes are flat: only the "
                    "boundary thresholds divide them.")
    simplified = stages.elaborate(square.straight, 8, 0.09)
    mesh = Simplified(square.full, stages.mesh(simplified).data)
    square.show(figure, "All")
    figure.panel("Left, by halvings of their cells", count(simplified.points) + " points", simplified.data,
                 pictures.LEVELS)
    figure.panel("Mesh", count(mesh.mesh.GetNumberOfPolys()) + " triangles", mesh.mesh, pictures.MESH)
    mesh.panel(figure, "Distance")
    mesh.rows(figure, "elaborate, s = 8, flatness 0.09", square.points, ("1840 (3 %)", 0.018, 0.002))
    whole = stages.apply(sh.vtkHorizonElaborateSimplification(), square.straight, FlatnessThreshold=0.09,
                         BoundaryDensityThreshold=0.0, BoundaryExtentThreshold=0.0)
    figure.row("the same, boundary thresholds 0: left", "-", count(whole.points, square.points))
    return figure


def large_surface(make):
    figure = Figure(["4.17"], "A large surface", "664,582 points.")
    surface = make(664582)
    surface.show(figure, "All")
    simplified = surface.elaborate(0.15)
    simplified.panel(figure, "Elaborate, s = 8, flatness 0.15")
    simplified.rows(figure, "elaborate, s = 8, flatness 0.15", surface.points, ("(11 %)", 0.0248, 0.0004))
    return figure


def outside_triangles(make):
    figure = Figure(["5.19"], "Triangles beyond the outline",
                    "The thesis removes these triangles at the end; our method never creates them (right).")
    simplified = stages.rough(make(15626).straight, 8)
    outline_panel(figure, "Points", simplified)

    def mesh(title, **properties):
        data = stages.apply(sh.vtkHorizonTriangulation(), simplified, **properties).data
        triangles = count(data.GetNumberOfPolys())
        figure.panel(title, triangles + " triangles", data, pictures.MESH)

    mesh("Convex hull", ConvexHull=True)
    mesh("Hull, angles up to 120 degrees", ConvexHull=True, MaximumBoundaryAngle=120.0)
    mesh("Inside the outline")
    return figure


def small_surface(make):
    figure = Figure(["5.20"], "A small surface", "232 kB correspond to about 5830 points.")
    surface = make(5830)
    surface.show(figure, "All")
    simplified = surface.elaborate(0.12)
    figure.panel("Mesh", count(simplified.mesh.GetNumberOfPolys()) + " triangles", simplified.mesh, pictures.MESH)
    simplified.panel(figure, "Elaborate, s = 8, flatness 0.12")
    simplified.rows(figure, "elaborate, s = 8, flatness 0.12", surface.points, ("18 of 232 kB (8 %)", 0.020, 0.0006))
    return figure


def figures(generator, folder, largest):
    """Returns all figures with surfaces of up to `largest` points, in the order of the thesis."""

    def make(points):
        return Prepared(surfaces.make(generator, points, folder)[0])

    square = Prepared(surfaces.make_square(SQUARE))
    works = [(15626, lambda: outline_of_surface(generator, make, folder)), (0, lambda: outline_of_small_surface(generator, folder)),
             (0, lambda: outline_of_square(square)), (15626, lambda: rough_and_merged(make, folder)),
             (23559, lambda: elaborate_and_merged(make, folder)), (0, lambda: square_simplified(square)),
             (664582, lambda: large_surface(make)), (53660, lambda: elaborate_and_merged_8(make, folder)),
             (15626, lambda: outside_triangles(make)), (5830, lambda: small_surface(make))]
    return [work() for points, work in works if points <= largest]


def can_draw():
    return "DISPLAY" in os.environ
