# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The horizons of a file, as many at a time as memory allows.

    for name, points in Supply("survey.vsm", None, memory.Budget(2 << 30)):
        ...
"""

import pathlib
import time

from . import cubes, heights, memory, reading
from .parts import Windows
from .progress import file_work
from .stage import HorizonError, update, watched


class Supply:
    """Yields (name, points) once for each horizon. With `cuts_large`, a horizon that does not fit alone is yielded as
    Windows in place of points. `horizons`, `left_out` and properties are passed to reading.open_file. Raises
    HorizonError.

    `names` and `sizes` are the names and numbers of points of all horizons, `seconds` the time spent on reading so far,
    `is_whole` whether all horizons are in memory at once, `origin` the result of reading.describe, and `surfaces` the
    triangles from which horizons were sampled, by name.
    """

    def __init__(self, path, horizons, budget, cuts_large=False, left_out=None, **properties):
        self._path = pathlib.Path(path)
        self._budget = budget
        self._cuts_large = cuts_large
        self._reader = None
        self._found = []
        self.seconds = 0.0
        reader = reading.open_file(self._path, horizons, left_out, **properties)
        self.surfaces = getattr(reader, "surfaces", {})
        if cubes.is_extraction(reader):
            cubes.require(reader, budget, self._path)
        if hasattr(reader, "SetLeastMemory") and (budget.is_given or not budget.fits_file(self._path)):
            self._list(reader, horizons)
        else:
            self._found, self.seconds = reading.read_source(reader, self._path, horizons)
            self.names = [name for name, _ in self._found]
            self.sizes = [points.GetNumberOfPoints() for _, points in self._found]
            self._groups = [list(range(len(self._found)))]
        self.origin = reading.describe(reader)
        self.is_whole = len(self._groups) == 1 and not self._is_cut(self._groups[0])

    def __iter__(self):
        for group in self._groups:
            if self._is_cut(group):
                yield self.names[group[0]], self._cut(group)
                continue
            if self._budget.is_given:
                self._require(group)
            found = self._read(group) if self._reader else self._found
            while found:
                yield found.pop(0)

    def units(self):
        """Returns names of horizons with their units of z; one name if they are read in groups, as then the file has a
        single unit."""
        if self._reader:
            return [(self.names[0], self._reader.GetVerticalUnit() or "")]
        return [(name, heights.unit_of(points)) for name, points in self._found]

    def _require(self, group):
        """Raises HorizonError if a horizon cannot be processed while the rest of its group is in memory."""
        for number in group:
            self._budget.require(self.sizes[number], "%s: %s" % (self._path.name, self.names[number]))
        largest = max(self.sizes[number] for number in group)
        held = sum(self.sizes[number] for number in group) - largest
        self._budget.require(largest, "%s: all horizons, with the largest" % self._path.name, held)

    def _list(self, reader, horizons):
        """Lists the horizons of a file without their points."""
        reader.SetLeastMemory(True)
        start = time.monotonic()
        if horizons is not None:
            reading.select(reader, horizons, self._path)
        with watched(reader, "%s: listing horizons" % self._path.name):
            reader.UpdateInformation()
        self.names = reading.selected(reader)
        if not self.names:
            raise HorizonError("%s: no points, expected those of a horizon at least" % self._path)
        last_row = reader.GetNumberOfRows() - 1
        self.sizes = [reader.GetNumberOfPointsInRows(name, 0, last_row) for name in self.names]
        self._groups = memory.make_groups(self.sizes, self._budget)
        self._reader = reader
        self.seconds = time.monotonic() - start

    def _is_cut(self, group):
        return bool(self._reader and self._cuts_large and not self._budget.fits(self.sizes[group[0]]))

    def _select(self, group):
        self._reader.DisableAllHorizons()
        for number in group:
            self._reader.SetHorizonStatus(self.names[number], 1)

    def _cut(self, group):
        self._select(group)
        try:
            return Windows(self._reader, self.names[group[0]], self._budget)
        except HorizonError as error:
            raise HorizonError("%s: %s" % (self._path.name, error)) from None

    def _read(self, group):
        self._select(group)
        self.seconds += update(self._reader, "%s: reading" % self._path.name, work=file_work(self._path))
        output = self._reader.GetOutputDataObject(0)
        found = reading.list_horizons(output)
        output.Initialize()  # points are released as soon as they are no longer used
        return found
