# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The horizons of a file, as many at a time as memory allows.

    for name, points in Supply("survey.vsm", None, memory.Budget(2 << 30)):
        ...
"""

import pathlib
import time

from . import cubes, heights, memory, reading
from .core import HorizonError
from .large import LargeHorizon


class Supply:
    """Yields (name, points) once for each horizon. With `by_rows`, a horizon that does not fit alone is yielded as a
    LargeHorizon in place of points. `horizons`, `left_out` and properties are passed to reading.open_file. Raises
    HorizonError.

    `names` and `sizes` are the names and numbers of points of all horizons, `seconds` the time spent on reading so far,
    `is_whole` whether all horizons are in memory at once, `origin` the result of reading.describe, and `surfaces` the
    triangles from which horizons were sampled, by name.
    """

    def __init__(self, path, horizons, budget, by_rows=False, left_out=None, **properties):
        self._path = pathlib.Path(path)
        self._budget = budget
        self._by_rows = by_rows
        self._source = None
        self._found = []
        is_large = budget.is_given or not budget.fits_file(self._path)
        source = reading.open_file(self._path, horizons, left_out, with_overview=is_large, **properties)
        self.surfaces = source.surfaces
        if isinstance(source, cubes.CubeSource):
            source.require(budget)
        self.seconds = 0.0
        if isinstance(source, reading.SparseSource) and is_large:
            self._list(source, horizons)
        else:
            self._found, self.seconds = reading.read_source(source, horizons)
            self.names = [name for name, _ in self._found]
            self.sizes = [len(points["places"]) for _, points in self._found]
            self._groups = [list(range(len(self._found)))]
        self.origin = reading.describe(source)
        self.is_whole = len(self._groups) == 1 and not self._is_large(self._groups[0])

    def __iter__(self):
        for group in self._groups:
            if self._is_large(group):
                yield self.names[group[0]], self._large(group)
                continue
            if self._budget.is_given:
                self._require(group)
            found = self._read(group) if self._source else self._found
            while found:
                yield found.pop(0)

    def units(self):
        """Returns names of horizons with their units of z; one name if they are read in groups, as then the file has a
        single unit."""
        if self._source:
            return [(self.names[0], self._source.unit)]
        return [(name, heights.unit_of(points)) for name, points in self._found]

    def _require(self, group):
        """Raises HorizonError if a horizon cannot be processed while the rest of its group is in memory."""
        for number in group:
            self._budget.require(self.sizes[number], "%s: %s" % (self._path.name, self.names[number]))
        largest = max(self.sizes[number] for number in group)
        held = sum(self.sizes[number] for number in group) - largest
        self._budget.require(largest, "%s: all horizons, with the largest" % self._path.name, held)

    def _list(self, source, horizons):
        """Lists the horizons of a file without their points."""
        start = time.monotonic()
        source.list("%s: listing horizons" % self._path.name)
        self._places = reading.choose(source.names, horizons, self._path)
        self.names = [source.names[place] for place in self._places]
        if not self.names:
            raise HorizonError("%s: no points, expected those of a horizon" % self._path)
        self.sizes = [source.sizes[place] for place in self._places]
        self._groups = memory.make_groups(self.sizes, self._budget)
        self._source = source
        self.seconds = time.monotonic() - start

    def _is_large(self, group):
        return bool(self._source and self._by_rows and not self._budget.fits(self.sizes[group[0]]))

    def _large(self, group):
        try:
            return LargeHorizon(self._source, self._places[group[0]], self._budget)
        except HorizonError as error:
            raise HorizonError("%s: %s" % (self._path.name, error)) from None

    def _read(self, group):
        start = time.monotonic()
        found = self._source.read([self._places[number] for number in group], "%s: reading" % self._path.name)
        self.seconds += time.monotonic() - start
        return found
