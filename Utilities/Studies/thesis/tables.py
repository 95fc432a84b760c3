# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the thesis beside ours, as Markdown."""

from text import table

from . import reported
from .surfaces import box_of, occupancy

HEADS = ["points", "method", "left, thesis", "here", "largest, thesis", "here", "mean, thesis", "here", "ms, thesis",
         "here"]


def percent(part, whole):
    return "%d (%.1f)" % (part, 100.0 * part / whole)


def milliseconds(seconds):
    return "%.3g" % (1000.0 * seconds) if seconds < 1.0 else "%.0f" % (1000.0 * seconds)


def error(value, digits):
    return "%.*f" % (digits, value)


def filled(points, size):
    return "%.0f %%" % (100.0 * occupancy(points, size))


def surfaces(found):
    rows = [["%d" % s.size, filled(s.size, box_of(s.size)), "%d" % s.points, filled(s.points, s.box),
             "%.0f %%" % (100.0 * s.noise)] for s in found]
    return table(["points, thesis", "columns filled", "points, here", "columns filled", "area with noise"], rows)


def row(surface, method, thesis, here):
    """Returns thesis and our results side by side: points left, errors, milliseconds."""
    points, spent, largest, mean = thesis
    cells = ["%d" % surface.size, method, percent(points, surface.size)]
    if here is None:
        return cells + ["-", "%.3f" % largest, "-", "%.4f" % mean, "-", "%d" % spent, "-"]
    return cells + [percent(here.points, surface.points), "%.3f" % largest, error(here.worth.largest, 4), "%.4f" % mean,
                    error(here.worth.mean, 5), "%d" % spent, milliseconds(here.seconds)]


def rough_row(surface, size):
    return row(surface, "rough, s = %d" % size, reported.ROUGH[surface.size][size], surface.rough[size])


def cluster_row(surface, size):
    return row(surface, "merged, %d" % size, reported.CLUSTER[surface.size][size], surface.cluster.get(size))


def rough(found):
    """Returns tables 4.1 and 4.2, and the merging results of table 4.4."""
    return table(HEADS, [make(s, size) for s in found for make in (rough_row, cluster_row) for size in (6, 8)])


def both(found, size):
    """Returns tables 4.4 to 4.6."""
    return table([HEADS[0], "flatness", *HEADS[2:]], [
        row(s, "%.2f" % flatness, reported.GLOBAL[size][s.size][n], s.both[size][n])
        for s in found for n, flatness in enumerate(reported.FLATNESS)])


def elaborate(found):
    """Returns table 4.3."""
    heads = ["points", "method", "left, thesis", "alone", "after rough", "largest, thesis", "alone", "after rough",
             "mean, thesis", "alone", "after rough", "ms alone, thesis", "here", "ms after rough, thesis", "here"]
    rows = []
    for s in found:
        points, spent, largest, mean = reported.ROUGH[s.size][3]
        here = s.rough[3]
        rows.append(["%d" % s.size, "rough, s = 3", percent(points, s.size), percent(here.points, s.points), "",
                     "%.3f" % largest, error(here.worth.largest, 4), "", "%.4f" % mean, error(here.worth.mean, 5), "",
                     "%d" % spent, milliseconds(here.seconds), "", ""])
        rows += [elaborate_row(s, n) for n in range(len(reported.FLATNESS))]
    return table(heads, rows)


def elaborate_row(surface, n):
    points, spent_alone, spent_after, largest, mean = reported.ELABORATE[surface.size][n]
    alone, after = surface.alone[n], surface.after[n]
    return ["%d" % surface.size, "flatness %.2f" % reported.FLATNESS[n], percent(points, surface.size),
            percent(alone.points, surface.points), percent(after.points, surface.points), "%.3f" % largest,
            error(alone.worth.largest, 4), error(after.worth.largest, 4), "%.4f" % mean, error(alone.worth.mean, 5),
            error(after.worth.mean, 5), "%d" % spent_alone, milliseconds(alone.seconds), "%d" % spent_after,
            milliseconds(after.seconds)]


def table_5_1(meshings):
    heads = ["points", "triangles, thesis", "here", "VTS ms, thesis", "here", "ball pivoting ms, thesis", "here",
             "vtkDelaunay2D ms"]
    rows = []
    for m in meshings:
        thesis = reported.TRIANGULATION[m.size]
        rows.append(["%d" % m.size, "%d" % thesis["VTS"][0], "%d" % m.faces["VTS"], "%d" % thesis["VTS"][1],
                     milliseconds(m.seconds["VTS"]), "%d" % thesis["BP"][1],
                     milliseconds(m.seconds["BP"]) if "BP" in m.seconds else "-",
                     milliseconds(m.seconds["vtkDelaunay2D"]) if "vtkDelaunay2D" in m.seconds else "-"])
    return table(heads, rows)
