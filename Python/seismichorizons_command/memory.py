# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Memory use of horizons, and groups of horizons that fit within a limit.

As many horizons as fit are read at a time, in order, and released before the next group. Of a horizon that does not fit
alone, rows are read while it is meshed (large.py).
"""

import os
import re

from seismichorizons import _core

from .core import HorizonError

# Bytes per point, measured on 2 to 10 million points: of a point that is held (73 to 76), and of a point that is meshed,
# including its own (213 to 221).
HELD = 80
WORKED = 240
# Bytes per column of a band of rows, of which one is meshed at a time, and per point of some bands, which are kept.
# Horizons below two bands are meshed at once, with so many bytes per point. The index of columns and the mesh come in
# addition.
COLUMN_BYTES = 80
KEPT_BYTES = 16
KEPT_BANDS = 5.25
AT_ONCE = 80
COLUMNS_PER_BYTE = 5
MESH_BYTES = 0.6  # per point, of which one in 20 is left
# Memory in addition to horizons and the program at its start: buffers of the reader.
SPARE = 96 << 20
# Fraction of the free memory of the machine that is used if there is no limit.
SHARE = 0.75
# Lower bound of the bytes per point in a file; lower if it is compressed.
FILE_BYTES = 16
COMPRESSED_BYTES = 2

UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}


def size_text(size):
    """Returns a number of bytes as readable text."""
    for unit in ("T", "G", "M"):
        if size >= UNITS[unit]:
            number = size / UNITS[unit]
            return "%.0f%s" % (number, unit) if number >= 999.5 else "%.3g%s" % (number, unit)
    return "%dK" % -(-size // UNITS["K"])


class Budget:
    """Memory available for horizons: the limit less the memory of the program itself. Without a `limit`, a fraction of the
    free memory of the machine. If there are several `jobs`, each has an equal share."""

    def __init__(self, limit=None, jobs=1):
        self.is_given = limit is not None
        self.limit = limit
        self._jobs = jobs
        available = _available()
        if limit is not None:
            self.left = limit // jobs - _resident() - SPARE
        else:
            self.left = None if available is None else int(SHARE * available / jobs) - SPARE

    def fits(self, worked, held=0):
        """Whether `worked` points can be processed while `held` points are in memory."""
        return self.left is None or WORKED * worked + HELD * held <= self.left

    def fits_file(self, path):
        """Whether any content of a file of this size is certain to fit; also true for a missing file, which its reader
        reports."""
        least = COMPRESSED_BYTES if path.suffix.lower() == ".gz" else FILE_BYTES
        try:
            return self.fits(os.path.getsize(path) // least)
        except OSError:
            return True

    def most_at_once(self):
        """Returns the number of points that can be meshed at once by rows."""
        return max(0, self.left // AT_ONCE)

    def require(self, worked, what, held=0):
        """Raises HorizonError if `worked` points do not fit while `held` points are in memory."""
        size = WORKED * worked + HELD * held
        self.require_bytes(size, "%s: %d points take %s" % (what, worked + held, size_text(size)))

    def require_bytes(self, size, taking, advice=""):
        """Raises HorizonError if `size` bytes do not fit; the message begins with `taking`."""
        if self.left is not None and size > self.left:
            raise HorizonError("%s, expected at most the %s that are left of %s%s" % (
                taking, size_text(max(self.left, 0)), self.limit_text(), advice))

    def limit_text(self):
        whole = "--memory %s" % size_text(self.limit) if self.is_given else "the memory of this machine"
        return whole + (" for each of %d jobs" % self._jobs if self._jobs > 1 else "")


def make_groups(sizes, budget):
    """Groups horizons of given sizes, in order, so that each group fits; returns lists of their numbers. A horizon that
    does not fit is a group of its own."""
    groups = []
    for number, size in enumerate(sizes):
        group = groups[-1] + [number] if groups else None
        largest = max(sizes[n] for n in group) if group else 0
        if group and budget.fits(largest, sum(sizes[n] for n in group) - largest):
            groups[-1] = group
        else:
            groups.append([number])
    return groups


def bytes_by_rows(columns, rows, points):
    """Returns the memory to mesh points in so many columns and rows by rows."""
    part = _core.columns_of_part(columns, rows)
    kept = int(points * min(1.0, KEPT_BANDS * part / (columns * rows)))
    held = AT_ONCE * points if part == columns * rows else COLUMN_BYTES * part + KEPT_BYTES * kept
    return held + columns * rows // COLUMNS_PER_BYTE + int(MESH_BYTES * points)


def _resident():
    """Returns the memory of this program in bytes; 0 if unknown."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError):
        return 0


def _available():
    """Returns the free memory of the machine in bytes; None if unknown."""
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            found = re.search(r"^MemAvailable:\s*(\d+) kB", file.read(), re.MULTILINE)
    except OSError:
        return None
    return int(found.group(1)) << 10 if found else None
