# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What layers must have where horizons are missing, from arrays of heights alone: which columns are filled, which follow another
horizon, what the ledger is, and how large the layers are. It shares no code with what it checks.

A stack is an array (horizon, row, column) of heights, the uppermost first and upwards, nan where a horizon has no point.
"""

import numpy as np

NONE, KNOWN, FILLED, FOLLOWS = range(4)
ENTRY = {KNOWN: 0, FILLED: 1, FOLLOWS: 3}  # in the ledger: Known, Filled, Bridged, Extrapolated, LeftOut
LEFT_OUT = 4


def areas_of(mask):
    """Numbers, from 1, of the areas of a mask that are connected side by side, 0 elsewhere, and how many there are."""
    numbers = np.zeros(mask.shape, int)
    count = 0
    for start in zip(*np.nonzero(mask)):
        if numbers[start]:
            continue
        count += 1
        numbers[start] = count
        waiting = [start]
        while waiting:
            j, i = waiting.pop()
            for other in ((j + 1, i), (j - 1, i), (j, i + 1), (j, i - 1)):
                if 0 <= other[0] < mask.shape[0] and 0 <= other[1] < mask.shape[1] and mask[other] and not numbers[other]:
                    numbers[other] = count
                    waiting.append(other)
    return numbers, count


def closed_holes(known, largest):
    """Columns of the holes of at most so many columns that known ones enclose."""
    numbers, count = areas_of(np.pad(~known, 1, constant_values=True))
    sizes = np.bincount(numbers.ravel(), minlength=count + 1)
    is_closed = sizes <= largest
    is_closed[[0, numbers[0, 0]]] = False  # what is known, and the outside
    return is_closed[numbers][1:-1, 1:-1]


def closed_gaps(known, widest):
    """Columns between two of a row or of a column of the lattice with at most so many empty ones between them."""
    closed = np.zeros_like(known)
    for lines, result in ((known, closed), (known.T, closed.T)):
        for line, own in zip(lines, result):
            places = np.flatnonzero(line)
            for a, b in zip(places[:-1], places[1:]):
                if 1 < b - a <= widest + 1:
                    own[a + 1:b] = True
    return closed


def origins_of(stack, largest_hole, widest_gap):
    """Where heights come from with Missing Follow."""
    origins = np.where(np.isnan(stack), NONE, KNOWN)
    for own in origins:
        own[closed_holes(own == KNOWN, largest_hole)] = FILLED
        for _ in range(2):
            own[closed_gaps(own != NONE, widest_gap)] = FILLED
    present = origins != NONE
    for n in range(1, len(stack) - 1):
        origins[n][~present[n] & present[:n].any(axis=0) & present[n + 1:].any(axis=0)] = FOLLOWS
    return origins


def fill_planes(stack, origins, planes):
    """A stack whose horizons are planes, with filled heights."""
    return np.where(origins == FILLED, planes, np.where(origins == KNOWN, stack, np.nan))


def follow(heights, origins):
    """Puts the heights of horizons that follow others in; those filled are there."""
    result = heights.copy()
    for n in range(1, len(heights) - 1):
        above, below = np.full((2, *heights[n].shape), np.nan)
        for other in range(n):
            above = np.where(np.isnan(heights[other]), above, heights[other])
        for other in range(len(heights) - 1, n, -1):
            below = np.where(np.isnan(heights[other]), below, heights[other])
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.clip((above - heights[n]) / (above - below), 0.0, 1.0)
        numbers, count = areas_of(origins[n] == FOLLOWS)
        for number in range(1, count + 1):
            area = numbers == number
            shares = []
            for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
                beside = np.roll(np.pad(area, 1), step, axis)[1:-1, 1:-1] & ~area
                shares.extend(share[beside & np.isfinite(share)])
            goes_up = bool(shares) and np.mean(shares) < 0.5
            result[n][area] = (above if goes_up else below)[area]
            if shares and abs(np.mean(shares) - 0.5) < 1e-6:
                return None  # a tie
    for n in range(1, len(result)):  # of two that follow others across each other, the lower one stays below
        upper = np.fmin.reduce(result[:n], axis=0)
        result[n] = np.where(np.isnan(upper), result[n], np.fmin(result[n], upper) + 0.0 * result[n])
    return result


class Region:
    """The blocks of four columns, and halves of blocks of three, that each layer has."""

    def __init__(self, present):
        """`present` is (layer, row, column)."""
        corners = np.stack([present[:, :-1, :-1], present[:, :-1, 1:], present[:, 1:, :-1], present[:, 1:, 1:]], axis=1)
        count = corners.sum(axis=1)
        missing = np.argmin(corners, axis=1)
        half = count == 3
        is_rising = (missing == 0) | (missing == 3)  # the corner that is missing is on one of the two diagonals
        taken = np.zeros(half[0].shape, bool)
        first = np.zeros(half[0].shape, bool)
        self.conflicts = np.zeros(len(present), int)  # halves that a layer lacks, as one above has it cut the other way
        for n in range(len(present)):
            conflict = half[n] & taken & (first != is_rising[n])
            first = np.where(half[n] & ~taken, is_rising[n], first)
            taken |= half[n]
            half[n] &= ~conflict
            self.conflicts[n] = np.count_nonzero(conflict)
        self.area = np.where(count == 4, 1.0, np.where(half, 0.5, 0.0))
        self.corners = corners & (self.area > 0.0)[:, None]

    def covered(self, shape):
        """The columns of each layer that have a part of a block."""
        result = np.zeros((len(self.area), *shape), bool)
        for corner, (j, i) in enumerate(((0, 0), (0, 1), (1, 0), (1, 1))):
            result[:, j:shape[0] - 1 + j, i:shape[1] - 1 + i] |= self.corners[:, corner]
        return result

    def volumes(self, layer, thickness):
        """The least and the largest one of a layer: blocks of four columns are divided along either diagonal."""
        t = np.nan_to_num(np.stack([thickness[:-1, :-1], thickness[:-1, 1:], thickness[1:, :-1], thickness[1:, 1:]]))
        t = t * self.corners[layer]
        pairs = np.stack([t[0] + t[3], t[1] + t[2]])
        whole = (pairs.sum(axis=0) + np.stack([pairs.min(axis=0), pairs.max(axis=0)])) / 6.0
        own = np.where(self.area[layer] == 1.0, whole, np.where(self.area[layer] == 0.5, pairs.sum(axis=0) / 6.0, 0.0))
        return own.sum(axis=(1, 2))


def present_layers(origins, policy):
    """(layer, row, column), whether both horizons are there with Missing Void (0), Interpolate (1) or Follow (2)."""
    there = (origins != NONE) & (origins <= (KNOWN, FILLED, FOLLOWS)[policy])
    return there[:-1] & there[1:]


def ledger_of(origins, policy):
    """For each layer its columns by entry, in the domain EachLayer."""
    whole = present_layers(origins, 2)
    covered = Region(present_layers(origins, policy)).covered(origins.shape[1:])
    ledgers = np.zeros((len(whole), 5), int)
    for layer in range(len(whole)):
        worst = np.maximum(origins[layer], origins[layer + 1])
        for origin, entry in ENTRY.items():
            ledgers[layer, entry] = np.count_nonzero(covered[layer] & (worst == origin))
        ledgers[layer, LEFT_OUT] = np.count_nonzero(whole[layer] & ~covered[layer])
    return ledgers
