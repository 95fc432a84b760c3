# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How much memory horizons take, and what is done at a time so that a limit holds.

Horizons are read as many at once as fit, in their order, and those before are given back. One that does not fit alone
is cut into parts, windows of rows (parts.py).
"""

import os
import re

from .stage import HorizonError

# Bytes per point, measured on 2 to 10 million points: those of a point that was read, and those of one that is meshed,
# its own included (73 to 76, and 213 to 221).
HELD = 80
WORKED = 240
# The program beside its horizons, above what it has at the start: buffers of the reader, meshes that wait to be joined.
SPARE = 96 << 20
# Without a limit, this part of the memory that the machine has left is one.
SHARE = 0.75
# Bytes of a file per point, at least: shorter lines than files have. Compressed ones have as many more.
FILE_BYTES = 16
COMPRESSED_BYTES = 2
# How many rows before its end a part may end, where a row has more points.
ROWS_TO_CHOOSE = 8

UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}


def size_text(size):
    """Bytes as a text for reading."""
    for unit in ("T", "G", "M"):
        if size >= UNITS[unit]:
            number = size / UNITS[unit]
            return "%.0f%s" % (number, unit) if number >= 999.5 else "%.3g%s" % (number, unit)
    return "%dK" % -(-size // UNITS["K"])


class Budget:
    """What may be used for horizons: the limit less what the program takes itself. `limit` is None for a part of what
    the machine has left."""

    def __init__(self, limit=None):
        self.is_given = limit is not None
        self.limit = limit
        available = _available()
        if limit is not None:
            self.left = limit - _resident() - SPARE
        else:
            self.left = None if available is None else int(SHARE * available) - SPARE

    def fits(self, worked, held=0):
        """Whether so many points can be worked on while others are held."""
        return self.left is None or WORKED * worked + HELD * held <= self.left

    def fits_file(self, path):
        """Whether whatever is in a file surely fits; also where there is none, as its reader tells that."""
        least = COMPRESSED_BYTES if path.suffix == ".gz" else FILE_BYTES
        try:
            return self.fits(os.path.getsize(path) // least)
        except OSError:
            return True

    def most_points(self):
        """How many points can be worked on at a time."""
        return max(0, self.left // WORKED)

    def require(self, worked, what, held=0):
        """Raises HorizonError where so many points do not fit while others are held."""
        size = WORKED * worked + HELD * held
        self.require_bytes(size, "%s: %d points take %s" % (what, worked + held, size_text(size)))

    def require_bytes(self, size, taking, advice=""):
        """Raises HorizonError where so many bytes do not fit; the message begins with what takes them."""
        if self.left is not None and size > self.left:
            raise HorizonError("%s, expected at most the %s that are left of %s%s" % (
                taking, size_text(max(self.left, 0)), self.limit_text(), advice))

    def limit_text(self):
        return "--memory %s" % size_text(self.limit) if self.is_given else "the memory of this machine"


def make_groups(sizes, budget):
    """Puts horizons of some sizes, in their order, together in groups that fit at once, as lists of their numbers. One
    that does not fit is a group of its own."""
    groups = []
    for number, size in enumerate(sizes):
        group = groups[-1] + [number] if groups else None
        largest = max(sizes[n] for n in group) if group else 0
        if group and budget.fits(largest, sum(sizes[n] for n in group) - largest):
            groups[-1] = group
        else:
            groups.append([number])
    return groups


def make_windows(row_sizes, most_points):
    """Cuts rows with so many points into windows of about equally many, `most_points` at most, as (first, last). The
    last row of each is the first one of the next, and has many points beside its neighbours. None when two rows are too
    many."""
    rows = [row for row, size in enumerate(row_sizes) if size]
    count = -(-sum(row_sizes) // max(1, most_points))
    while rows and count < len(row_sizes):
        windows = _cut(row_sizes, rows[0], rows[-1], count)
        if all(sum(row_sizes[first:last + 1]) <= most_points for first, last in windows):
            return windows
        count += 1 + count // 8
    return None


def _cut(row_sizes, first, last, count):
    """Windows of about an equal part of the points each, and of two rows at least."""
    share = sum(row_sizes) / count
    windows = []
    done = 0
    begin = first
    for row in range(first, last):
        done += row_sizes[row]
        if done >= share * (len(windows) + 1) and row > begin:
            candidates = range(max(begin + 1, row - ROWS_TO_CHOOSE + 1), row + 1)
            cut = max(candidates, key=lambda candidate: (row_sizes[candidate], candidate))
            windows.append((begin, cut))
            begin = cut
    return windows + [(begin, last)]


def _resident():
    """Bytes of memory that this program has; 0 where that is not known."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError):
        return 0


def _available():
    """Bytes of memory that the machine has left; None where that is not known."""
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            found = re.search(r"^MemAvailable:\s*(\d+) kB", file.read(), re.MULTILINE)
    except OSError:
        return None
    return int(found.group(1)) << 10 if found else None
