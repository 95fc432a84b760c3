# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages and Markdown tables of the studies."""

import sys
import textwrap

WIDTH = 120


def report(text):
    """Reports the progress of a study, separately from its printed result."""
    print(text, file=sys.stderr, flush=True)


def table(heads, rows):
    """Returns a table in Markdown."""
    lines = ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def cells(line):
    """Returns the cells of a line of such a table."""
    return [cell.strip() for cell in line.strip("| \n").split("|")]


def wrapped(page):
    """Rewraps the paragraphs and lists of a page with their indents; tables, headings and pictures are unchanged."""
    blocks = []
    for line in page.splitlines():
        stays = not line or line.startswith(("|", "#", "!"))
        begins = stays or line.startswith("- ") or not blocks or blocks[-1][0]
        if begins:
            blocks.append((stays, line))
        else:
            blocks[-1] = (False, blocks[-1][1] + " " + line.strip())
    return "".join((text if stays else textwrap.fill(text, WIDTH, subsequent_indent="  " if text.startswith("- ") else "",
                                                     break_long_words=False, break_on_hyphens=False)) + "\n"
                   for stays, text in blocks)
