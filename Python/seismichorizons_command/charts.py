# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Histograms as SVG drawings that are embedded in a page."""

import math

from .markup import Markup, fill, join

# Edges of the plot area; the size of the drawing is in parts.html.
LEFT, RIGHT, TOP, BOTTOM = 8.0, 392.0, 16.0, 126.0
GAP = 1.0  # between bars
MOST_TICKS = 6


def histogram(title, caption, counts, high, unit):
    """Draws a histogram of values from 0 to `high`, given the counts of equally wide bins."""
    total = sum(counts) or 1
    most = max(counts) or 1
    half = next(n for n in range(len(counts)) if 2 * sum(counts[:n + 1]) >= sum(counts))
    summary = "%s: from 0 to %.3g %s; half of them are below %.3g; at most %.2g %% in one of %d steps" % (
        title, high, unit, high * (half + 1) / len(counts), 100.0 * most / total, len(counts))
    return fill("chart", title=title, caption="%s; %s" % (caption, unit), summary=summary,
                most="%.2g %%" % (100.0 * most / total), bars=_bars(counts, most),
                ticks=join(_tick(value, high) for value in round_steps(high)))


def round_steps(high):
    """Returns a few round numbers from 0 up to `high`."""
    if not high > 0.0:
        return [0.0]
    unit = 10.0 ** math.floor(math.log10(high / MOST_TICKS))
    step = next(digit * unit for digit in (1.0, 2.0, 2.5, 5.0, 10.0, 20.0) if high / (digit * unit) <= MOST_TICKS)
    return [step * n for n in range(MOST_TICKS + 1) if step * n <= high * (1.0 + 1e-9)]


def _tick(value, high):
    x = LEFT + (RIGHT - LEFT) * value / (high or 1.0)
    anchor = "start" if value == 0.0 else "end" if x > RIGHT - 12.0 else "middle"
    return fill("tick", x="%.1f" % x, text="%.4g" % value, anchor=anchor)


def _bars(counts, most):
    """Returns one path for all bars; every bin that is not empty has a visible bar."""
    width = (RIGHT - LEFT) / len(counts)
    heights = [max((BOTTOM - TOP) * count / most, 0.75 if count else 0.0) for count in counts]
    return Markup("".join("M%.1f %.1fV%.1fH%.1fV%.1fZ" % (
        LEFT + n * width + GAP / 2, BOTTOM, BOTTOM - height, LEFT + (n + 1) * width - GAP / 2, BOTTOM)
        for n, height in enumerate(heights) if height))
