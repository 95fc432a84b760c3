# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the studies say, and how they write and read tables."""

import sys


def report(text):
    """How far a study is, beside what it prints as its result."""
    print(text, file=sys.stderr, flush=True)


def table(heads, rows):
    """A table in Markdown."""
    lines = ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def cells(line):
    """The cells of a line of such a table."""
    return [cell.strip() for cell in line.strip("| \n").split("|")]
