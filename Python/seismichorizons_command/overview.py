# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of all stages: a row for each horizon, a panel for each stage."""

from . import pictures, triangles
from .data import count_lines, count_points
from .pictures import FAULTS, MESH, OUTLINE, POINTS, Panel
from .pipeline import count_loops

MOST_ROWS = 8


def write(results, path):
    """Writes the picture as PNG. Raises HorizonError if that fails."""
    pictures.write(pictures.draw([panels(result) for result in results[:MOST_ROWS]]), path)


def panels(result):
    """Returns the panels of all stages, or of the mesh alone if the other data were released."""
    if "points" not in result.data:
        mesh = result.data["mesh"]
        return [Panel(result.name, "%s, %s" % (_count(result.number_of_points, "point"), _count_triangles(mesh)), mesh,
                      MESH)]
    points = result.data["points"]
    loops, loop_points = count_loops(result.data["boundary"])
    mesh = result.data["mesh"]
    row = [Panel(result.name, _count(count_points(points), "point"), points, POINTS)]
    if "despiked" in result.data:
        known, points = points, result.data["despiked"]
        row.append(Panel("Despiking", _count(count_points(known) - count_points(points), "point") + " removed",
                         points, POINTS))
    if "torn" in result.data:
        points, lines = result.data["torn"], result.data["faults"]
        row.append(Panel("Faults", _count(count_lines(lines), "line"), lines, FAULTS, points))
    if "filled" in result.data:
        known, points = points, result.data["filled"]
        row.append(Panel("Hole filling", _count(count_points(points) - count_points(known), "new point"),
                         points, POINTS))
    row.append(Panel("Exterior boundary", "%s, %s" % (_count(loops, "loop"), _count(loop_points, "point")),
                     result.data["boundary"], OUTLINE, points))
    if "simplified" in result.data:
        straight = result.data["simplified"]
        row.append(Panel("Simplified boundary", _count(count_loops(straight)[1], "point"), straight, OUTLINE, points))
    for name, title in (("rough", "Rough simplification"), ("elaborate", "Elaborate simplification")):
        if name in result.data:
            thinned = result.data[name]
            row.append(Panel(title, _count(count_points(thinned), "point"), thinned, POINTS))
    row.append(Panel("Mesh", _count_triangles(mesh), mesh, MESH))
    return row


def _count_triangles(mesh):
    shown = _count(triangles.count_surface(mesh), "triangle")
    closing = triangles.count_at_faults(mesh)
    return "%s, %s" % (shown, _count(closing, "fault triangle")) if closing else shown


def _count(number, noun):
    return "{:,} {}{}".format(number, noun, "" if number == 1 else "s")
