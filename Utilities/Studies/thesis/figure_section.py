# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The end of the page Tables.md: the figures of the thesis, with our surfaces."""

from text import table

from .words import listing

SECTION = """\
## Figures of the thesis

Since the surfaces differ, compare sizes, not places. Colours show distances at the input points, from pale (0) to dark
(the 99th percentile of the row). Further figures: [outlines](HorizonExteriorBoundary.md), [elaborate
simplification](HorizonCellSimplification.md#elaborate-simplification).{missing}

{figures}"""


def shown(figure):
    numbers = "figure%s %s" % ("s" if len(figure.numbers) > 1 else "", listing(figure.numbers))
    return "![%s](Pictures/%s)\n\n*%s (%s). %s*\n" % (numbers.capitalize(), figure.picture(), figure.title, numbers, figure.text)


def rows(figures):
    """Returns the numbers in the captions of the thesis, and ours."""
    return table(["figure", "what", "thesis", "here"],
                 [[listing(figure.numbers)] + row for figure in figures for row in figure.rows])


def section(figures, with_meshlab):
    return SECTION.format(
        missing="" if with_meshlab else "\nMeshLab was not found, and is missing in figures 4.14, 4.15 and 4.18.",
        figures="\n".join(map(shown, figures)))
