# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page Figures.md: what the figures of the thesis show, with our surfaces."""

import textwrap

from text import table

from .words import listing

WIDTH = 120

PAGE = """\
# Figures of the thesis

`Utilities/Studies/reproduce_thesis.sh` makes this page and [Tables.md](Tables.md), which explains the surfaces and the
errors (largest and mean, both ways, as fractions of the diagonal of the bounding box). The table has what the captions
of the thesis say, and ours. The surfaces differ: compare sizes, not places. Distances are shown at the points of the
input, from pale (0) to dark (the 99th percentile of the row).

{table}
The curves of figures 3.18, 3.19 and 5.18 are in [Tables.md](Tables.md); outlines of several radii (3.20 to 3.22, 3.25
and 3.27) in [HorizonExteriorBoundary.md](HorizonExteriorBoundary.md); meshes after the rough simplification (4.13) and
cells by their size (4.12) in [HorizonElaborateSimplification.md](HorizonElaborateSimplification.md).{missing}
{figures}"""


def section(figure):
    heading = "## %s (figure%s %s)\n" % (figure.title, "s" if len(figure.numbers) > 1 else "",
                                         listing(figure.numbers))
    caption = textwrap.fill("*%s*" % figure.text, WIDTH)
    return "%s\n![%s](Pictures/%s)\n\n%s\n" % (heading, figure.title, figure.picture(), caption)


def page(figures, with_meshlab):
    rows = [[listing(figure.numbers)] + row for figure in figures for row in figure.rows]
    return PAGE.format(
        table=table(["figure", "what", "thesis", "here"], rows),
        missing="" if with_meshlab else "\nMeshLab was not found, and is missing in figures 4.14, 4.15 and 4.18.",
        figures="\n" + "\n".join(map(section, figures)))
