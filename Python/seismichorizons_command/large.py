# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons larger than memory, whose rows are read while they are meshed. The mesh is the same as from all points."""

from . import memory


class LargeHorizon:
    """A horizon given by its place in a file of sparse voxels with an overview (reading.SparseSource). Raises HorizonError if
    it does not fit in memory by rows."""

    def __init__(self, source, place, budget):
        self.name = source.names[place]
        self.unit = source.unit  # of z
        self.number_of_points = source.sizes[place]
        self._source, self._place = source, place
        self._most_at_once = budget.most_at_once()
        size = memory.bytes_by_rows(*source.extent(place), self.number_of_points)
        budget.require_bytes(size, "%s: %d points, meshed by rows, take %s" % (
            self.name, self.number_of_points, memory.size_text(size)))

    def mesh(self, options, progress):
        """Returns the mesh, and warnings, with options of the core for the surface."""
        return self._source.surface(self._place, options, self._most_at_once, progress)
