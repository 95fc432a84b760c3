# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of results, for reading: a row for each horizon."""

from vtkmodules.vtkCommonCore import VTK_DOUBLE

from . import triangles
from .pipeline import chosen_parameters
from .reading import short_name

COLUMNS = ("horizon", "points in", "loops", "loop points", "after", "points out", "triangles", "reduction",
           "boundary s", "simplify s", "rough s", "elaborate s", "mesh s")
# Parameters of a surface, by the names of the properties.
CHOSEN_COLUMNS = {"Radius": "radius", "SmallestHoleSize": "smallest hole", "OutlineTolerance": "tolerance"}
# Of what comes before the stages: what was found, told by an array of the mesh, and the time.
PREPARATION_COLUMNS = {
    "despiked": ("spikes", "despike s"),
    "torn": ("cut links", "faults s"),
    "filled": ("filled", "fill s")}
FAULT_COLUMNS = ("fault triangles",)  # where a mesh has any
# Of meshes within an error, by the names of the field data: the vertical error that was asked for first.
VERTICAL_COLUMNS = {"LargestError": "vertical error", "LargestLoopError": "at outlines", "NumberOfOutsidePoints": "outside"}
# Of the measure: distances in space, both ways.
ERROR_COLUMNS = ("Hausdorff", "mean distance", "outlines off", "error s")
TWO_SIDED = 2  # the row of the figures in lattice units for both directions


def row(result, has_fault_triangles=False):
    """The cells of one horizon as texts; triangles that close faults only on request, parameters only where they were
    chosen, the error where it was measured."""
    before = result.number_of_points
    after = result.data["mesh"].GetNumberOfPoints()
    loops, loop_points = result.loops or (result.simplified[0], None)
    seconds = [result.seconds.get(name) for name in ("boundary", "simplified", "rough", "elaborate", "mesh")]
    return (short_name(result.name), "%d" % before, "%d" % loops, "-" if loop_points is None else "%d" % loop_points,
            "%d" % result.simplified[1], "%d" % after,
            "%d" % triangles.count_surface(result.data["mesh"]), "%.1f %%" % (100.0 * (before - after) / before),
            *("-" if s is None else "%.2f" % s for s in seconds), *_preparation_cells(result),
            *(["%d" % triangles.count_at_faults(result.data["mesh"])] if has_fault_triangles else []),
            *_chosen_cells(result), *_vertical_cells(result), *_error_cells(result))


def _preparation_cells(result):
    cells = []
    for name in PREPARATION_COLUMNS:
        if name in result.seconds:
            cells += ["%d" % prepared_number(result.data["mesh"].GetFieldData(), name), "%.2f" % result.seconds[name]]
    return tuple(cells)


def prepared_number(figures, name):
    """How many spikes, cut links or filled points there are, which the mesh still tells."""
    if name == "torn":
        links = figures.GetArray("CutLinks")
        return 0 if links is None else links.GetNumberOfTuples()
    found = figures.GetArray("NumberOfSpikes" if name == "despiked" else "NumberOfFilledPoints")
    return 0 if found is None else found.GetValue(0)


def _chosen_cells(result):
    chosen = chosen_parameters(result.data["mesh"])
    return tuple(("%d" if isinstance(chosen[name], int) else "%.3f") % chosen[name]
                 for name in CHOSEN_COLUMNS if name in chosen)


def _vertical_cells(result):
    data = result.data["mesh"].GetFieldData()
    arrays = [data.GetArray(name) for name in _vertical_columns(result)]
    return tuple("-" if array is None else "%.3f" % array.GetTuple1(0) if array.GetDataType() == VTK_DOUBLE else
                 "%d" % array.GetTuple1(0) for array in arrays)


def _vertical_columns(result):
    return VERTICAL_COLUMNS if result.data["mesh"].GetFieldData().HasArray("LargestError") else {}


def _error_cells(result):
    if result.figures is None:
        return ()
    figures = [result.figures.GetValueByName(TWO_SIDED, name).ToDouble()
               for name in ("LargestDistance", "MeanDistance", "OutlineDistance")]
    return (*("%.3f" % figure for figure in figures), "%.2f" % result.seconds["error"])


def table(results):
    """Heads, a rule and a row for each result, as lines of text."""
    chosen = tuple(CHOSEN_COLUMNS.values()) if chosen_parameters(results[0].data["mesh"]) else ()
    prepared = sum((names for name, names in PREPARATION_COLUMNS.items() if name in results[0].seconds), ())
    closed = any(triangles.count_at_faults(result.data["mesh"]) for result in results)
    vertical = tuple(_vertical_columns(results[0]).values())
    columns = COLUMNS + prepared + (FAULT_COLUMNS if closed else ()) + chosen + vertical + (
        ERROR_COLUMNS if results[0].figures is not None else ())
    return align([columns] + [row(result, closed) for result in results])


def align(rows):
    """Lines with the cells of rows one below the other, to the right, and a rule below the first row."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(text.rjust(width) for text, width in zip(cells, widths)) for cells in rows]
    return [lines[0], "  ".join("-" * width for width in widths), *lines[1:]]
