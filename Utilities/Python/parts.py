# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes a horizon larger than memory in windows of rows that share their edge rows, and joins the meshes."""

from vtkmodules.vtkCommonDataModel import vtkFieldData

from . import memory
from .stage import HorizonError, make, update

SURFACE = "vtkHorizonSurface"
JOIN = "vtkHorizonSurfaceJoin"
ALL_ROWS = (0, -1)


class Windows:
    """The windows of a horizon, given by name, of a reader with LeastMemory. Raises HorizonError if no windows fit in
    memory."""

    def __init__(self, reader, name, budget):
        self.name = name
        self.unit = reader.GetVerticalUnit() or ""  # of z
        self.noise = vtkFieldData()  # what an automatic error is six times of, once it is chosen
        self._reader = reader
        row_sizes = [reader.GetNumberOfPointsInRows(name, row, row) for row in range(reader.GetNumberOfRows())]
        self.number_of_points = sum(row_sizes)
        self.rows = memory.make_windows(row_sizes, budget.most_points())
        if self.rows is None:
            raise HorizonError("%s: rows of up to %d points, expected at most %d points in two rows for %s" % (
                name, max(row_sizes), budget.most_points(), budget.limit_text()))
        self._sizes = [sum(row_sizes[first:last + 1]) for first, last in self.rows]

    def read(self, number, label=""):
        """Returns the points of a window."""
        self._reader.SetRowRange(*self.rows[number])
        update(self._reader, label)
        output = self._reader.GetOutputDataObject(0)
        return output.GetPartition(0, 0)

    def largest(self):
        """Returns the number of the window with the most points."""
        return self._sizes.index(max(self._sizes))

    def choose(self, properties, label=""):
        """Returns surface properties with the radius and the largest error, unless given, chosen for the window with the
        most points."""
        stage = make(SURFACE)
        is_error_given = "MaximumError" in properties
        if not properties.get("AutomaticRadius", True) and is_error_given:
            return properties
        points = self.read(self.largest(), label)
        radius = stage.ChooseRadius(points) if properties.get("AutomaticRadius", True) else properties["Radius"]
        if radius < 1:
            raise HorizonError("%s: no radius can be chosen, expected points on a lattice" % self.name)
        error = {} if is_error_given else {
            "MaximumError": stage.ChooseMaximumError(points, self.noise), "ErrorUnit": "Lattice"}
        return {**properties, "AutomaticRadius": False, "Radius": radius, **error}

    def close(self):
        """Restores the settings of the reader and releases its data."""
        self._reader.SetRowRange(*ALL_ROWS)
        self._reader.GetOutputDataObject(0).Initialize()


def mesh_window(windows, number, properties, label="", warnings=None):
    """Returns the mesh of one window for vtkHorizonSurfaceJoin. The properties must include the radius and the error.
    Raises HorizonError."""
    last = len(windows.rows) - 1
    step = "%s: window %d of %d" % (label, number + 1, last + 1)
    first_row, last_row = windows.rows[number]
    seams = (-1 if number == 0 else first_row, -1 if number == last else last_row)
    stage = make(SURFACE, **properties, SeamRows=seams)
    stage.SetInputDataObject(0, windows.read(number, step))
    update(stage, step, warnings)
    return stage.GetOutputDataObject(0)


def mesh(windows, properties, label="", warnings=None):
    """Returns the mesh of a horizon from its windows, with properties of vtkHorizonSurface. Raises HorizonError."""
    given = windows.choose(dict(properties), "%s: reading" % label)
    smallest_patch = given.pop("MinimumPatchSize", 1)
    join = make(JOIN, MinimumPatchSize=smallest_patch)
    for number in range(len(windows.rows)):
        join.AddInputDataObject(mesh_window(windows, number, given, label, warnings))
    windows.close()
    update(join, "%s: joining" % label, warnings)
    joined = join.GetOutputDataObject(0)
    joined.GetFieldData().PassData(windows.noise)
    return joined
