# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes a horizon larger than memory in windows of rows that share their edge rows, and joins the meshes."""

from seismichorizons import _core

from . import core, memory
from .core import HorizonError
from .data import with_fields

SURFACE = "vtkHorizonSurface"


class Windows:
    """The windows of a horizon, given by its place in a file of sparse voxels with an overview (reading.SparseSource). Raises
    HorizonError if no windows fit in memory."""

    def __init__(self, source, place, budget):
        self.name = source.names[place]
        self.unit = source.unit  # of z
        self.noise = {}  # figures that an automatic error is six times of, once it is chosen
        self._source, self._place = source, place
        row_sizes = [source.count_points(place, row, row) for row in range(source.rows)]
        self.number_of_points = sum(row_sizes)
        self.rows = memory.make_windows(row_sizes, budget.most_points())
        if self.rows is None:
            raise HorizonError("%s: rows of up to %d points, expected at most %d points in two rows for %s" % (
                self.name, max(row_sizes), budget.most_points(), budget.limit_text()))
        self._sizes = [sum(row_sizes[first:last + 1]) for first, last in self.rows]

    def read(self, number, label=""):
        """Returns the points of a window."""
        return self._source.read([self._place], label, self.rows[number])[0][1]

    def largest(self):
        """Returns the number of the window with the most points."""
        return self._sizes.index(max(self._sizes))

    def choose(self, properties, label=""):
        """Returns surface properties with the radius and the largest error, unless given, chosen for the window with the
        most points."""
        if "Radius" in properties and "MaximumError" in properties:
            return properties
        points = self.read(self.largest(), label)
        chosen = {}
        with core.errors("%s: " % self.name):
            if "Radius" not in properties:
                chosen["Radius"] = _core.choose_radius(points)
                if chosen["Radius"] < 1:
                    raise HorizonError("no radius can be chosen, expected points on a lattice")
            if "MaximumError" not in properties:
                chosen["MaximumError"], self.noise = _core.choose_error(points)
        return {**properties, **chosen}


def mesh_window(windows, number, properties, label="", warnings=None):
    """Returns the mesh of one window, to be joined. The properties must include the radius and the error. Raises
    HorizonError."""
    last = len(windows.rows) - 1
    step = "%s: window %d of %d" % (label, number + 1, last + 1)
    first_row, last_row = windows.rows[number]
    options = core.options(properties)
    options["seam_rows"] = [-1 if number == 0 else first_row, -1 if number == last else last_row]
    points = windows.read(number, step)
    with core.errors("%s: " % windows.name):
        (made, _), messages = core.run(_core.surface, points, options, label=step)
    if warnings is not None:
        warnings += ["%s: %s" % (windows.name, text) for text in filter(None, messages)]
    return made


def mesh(windows, properties, label="", warnings=None):
    """Returns the mesh of a horizon from its windows, with properties of the surface. Raises HorizonError."""
    given = windows.choose(dict(properties), "%s: reading" % label)
    smallest_patch = given.pop("MinimumPatchSize", 1)
    made = [mesh_window(windows, number, given, label, warnings) for number in range(len(windows.rows))]
    with core.errors("%s: " % windows.name):
        joined = core.run(_core.join, made, smallest_patch, label="%s: joining" % label)
    return with_fields(joined, windows.noise)
