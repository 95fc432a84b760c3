# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Result tables for people, with a row for each horizon."""

from . import data, ledger, triangles
from .reading import short_name

WIDTH = 98  # characters; wider tables continue below
LONGEST_NAME = 32
# Results of the optional stages, counted by an array of the mesh.
PREPARATION_COLUMNS = {"despiked": "spikes", "torn": "faulted links"}
# Vertical errors of meshes by the names of field data; the bounded error comes first.
VERTICAL_COLUMNS = {"LargestError": "error", "LargestLoopError": "at outlines"}
# Measured distances in space, in both directions.
ERROR_COLUMNS = {"LargestDistance": "Hausdorff", "MeanDistance": "mean distance", "OutlineDistance": "outlines off"}
TWO_SIDED = 2  # row with the figures for both directions in lattice units


def row(result, has_fault_triangles=False, entries=()):
    """Returns the cells of one horizon as texts by column title. Triangles that close faults and ledger entries are
    included only on request, the error if it was requested or measured."""
    mesh = result.data["mesh"]
    before, after = result.number_of_points, data.count_points(mesh)
    cells = {"horizon": _short(short_name(result.name)), "points": "%d" % before}
    if result.loops and "simplified" in result.seconds:
        cells.update({"loops": "%d" % result.loops[0], "loop points": "%d" % result.loops[1],
                      "after": "%d" % result.simplified[1]})
    else:
        cells["loops"] = "%d" % result.simplified[0]
    cells.update({"kept": "%d" % after, "triangles": "%d" % triangles.count_surface(mesh),
                  "reduction": "%.1f %%" % (100.0 * (before - after) / before)})
    cells.update({head: "%d" % prepared_number(mesh, name) for name, head in PREPARATION_COLUMNS.items()
                  if name in result.seconds})
    if has_fault_triangles:
        cells["fault triangles"] = "%d" % triangles.count_at_faults(mesh)
    if data.value(mesh, "LargestError") is not None:
        unit = " (%s)" % result.height_unit if result.height_unit else ""
        cells.update({head + unit: _number(data.value(mesh, name), result.per_index) for name, head in VERTICAL_COLUMNS.items()})
        cells["outside"] = _number(data.value(mesh, "NumberOfOutsidePoints"))
    if result.figures is not None:
        cells.update({head: "%.3f" % result.figures[name][TWO_SIDED]
                      for name, head in ERROR_COLUMNS.items()})
    own = ledger.read(mesh) if entries else None
    cells.update({ledger.HEADS[entry] + " (area)": ledger.amount(own, entry) for entry in entries if own})
    cells["seconds"] = "%.2f" % sum(result.seconds.values())
    return cells


def _short(name):
    """Returns the beginning and the end of a name that is too long for a table."""
    half = LONGEST_NAME // 2 - 2
    return name if len(name) <= LONGEST_NAME else "%s...%s" % (name[:half], name[-half:])


def prepared_number(mesh, name):
    """Returns the number of spikes, faulted edges or filled points, from arrays of the mesh."""
    if name == "torn":
        return len(mesh["field_data"].get("FaultedLinks", ()))
    return data.value(mesh, "NumberOfSpikes" if name == "despiked" else "NumberOfFilledPoints") or 0


def _number(value, factor=1):
    if value is None:
        return "-"
    return ("%.3f" if isinstance(value, float) else "%d") % (factor * value)


def table(results):
    """Returns the titles, a rule and a row for each result as lines of text; columns that do not fit follow in another
    table below."""
    closed = any(triangles.count_at_faults(result.data["mesh"]) for result in results)
    rows = [row(result, closed, _entries(results)) for result in results]
    heads = list(max(rows, key=len))
    columns = [[head] + [cells.get(head, "-") for cells in rows] for head in heads]
    lines, shown = [], columns[:1]
    for column in columns[1:]:
        if sum(max(map(len, other)) + 2 for other in [*shown, column]) > WIDTH + 2 and len(shown) > 1:
            lines += [*align(list(zip(*shown))), ""]
            shown = columns[:1]
        shown.append(column)
    return lines + align(list(zip(*shown)))


def _entries(results):
    """Returns the ledger entries to show: none if all columns are known."""
    ledgers = filter(None, (ledger.read(result.data["mesh"]) for result in results))
    found = {entry for own in ledgers for entry, number in own["columns"].items() if number}
    if any("filled" in result.seconds for result in results):
        found.add("filled")
    return [entry for entry in ledger.ENTRIES if entry in found] if found - {"known"} else []


def align(rows):
    """Returns lines of right-aligned columns, with a rule below the first row."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(text.rjust(width) for text, width in zip(cells, widths)) for cells in rows]
    return [lines[0], "  ".join("-" * width for width in widths), *lines[1:]]
