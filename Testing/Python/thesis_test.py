# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page beside the thesis, made with its smallest surface: all tables have their rows, all figures are sound.

Arguments: the program reproduce_thesis.py, the program generate_horizons, a folder for the page.
"""

import math
import os
import pathlib
import re
import subprocess
import sys

# Rows for one surface, by what its heading says.
ROWS = {"The surfaces": 1, "(tables 4.1, 4.2 and 4.4)": 4, "(table 4.3)": 4, "(table 4.4)": 3, "(table 4.5)": 3,
        "(table 4.6)": 3, "(table 5.1": 1, "What a vertex buys": 8, "What is different from the thesis": 12}
MOST = {"largest": 0.02, "mean": 0.002}  # of our meshes; the thesis has up to 0.048 and 0.0007
MOST_OUTLINE = 0.5


def tables_of(page):
    """(heading, column names, rows) of each table."""
    heading, lines = "", page.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("#"):
            heading = line
        if line.startswith("|") and not lines[number - 1].startswith("|"):
            block = [row for row in lines[number:] if row.startswith("|") or not row][:1000]
            block = block[:block.index("")] if "" in block else block
            cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in block]
            yield heading, cells[0], cells[2:]


def numbers(cell):
    return [float(text) for text in re.findall(r"-?\d+\.?\d*(?:e[+-]?\d+)?|nan|inf", cell)]


def check_row(heading, heads, row):
    assert len(row) == len(heads), "%s: %s" % (heading, row)
    for head, cell in zip(heads, row):
        sound = all(math.isfinite(value) and value >= 0.0 for value in numbers(cell))
        assert sound, "%s, %s: %s" % (heading, head, cell)


def check_errors(heads, row):
    """The columns that follow those of the thesis."""
    for what, most in MOST.items():
        first = heads.index(what + ", thesis") + 1
        ours = [cell for head, cell in zip(heads[first:], row[first:]) if head in ("here", "alone", "after rough")]
        value = numbers(ours[0])[0]
        assert 0.0 < value < most, "%s error %g, at most %g allowed: %s" % (what, value, most, row)


def check_partners(heads, rows):
    ours = dict(zip(heads, rows[0]))
    assert ours["mesh"] == "ours"
    assert float(ours["outline, columns"]) <= MOST_OUTLINE
    for row in rows[1:]:
        partner = dict(zip(heads, row))
        assert 0.7 < float(partner["vertices / ours"]) < 1.4, row
        assert float(partner["time / ours"]) > 0.0, row


def check_pictures(folder):
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        print("no Matplotlib, pictures not checked")
        return
    for name in ("BoundaryTime", "BoundaryRate", "TriangulationTime", "VertexWorth"):
        assert (folder / (name + ".png")).stat().st_size > 10000, name


def check_figures(page, behind):
    """Each with numbers of the thesis and of our own, and a section of its own."""
    (heads, rows), = ((heads, rows) for heading, heads, rows in tables_of(behind) if "Captions" in heading)
    assert heads == ["figure", "what", "thesis", "here"]
    for figure in ("3.23", "3.24", "3.26", "4.14", "4.16 and 5.21", "5.19", "5.20"):
        assert "(figure%s %s)" % ("s" if " " in figure else "", figure) in page, figure
        mine = [row for row in rows if row[0] == figure]
        assert mine or figure == "5.19", figure
        for _, what, _, here in mine:
            values = numbers(here.replace(",", ""))
            assert values and all(math.isfinite(value) and value > 0.0 for value in values), (figure, what, here)
    # The outline of a square is known, and so is what becomes of it.
    assert ["3.26", "outline points, k = 1", "1,024", "1,024"] in rows


def main():
    program, generator, folder = sys.argv[1:4]
    folder = pathlib.Path(folder)
    # Without an X server MeshLab is left out.
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    behind = folder.with_name(folder.name + "-rows.md")
    subprocess.run([sys.executable, program, generator, str(folder), "--surfaces", "1", "--tables", str(behind)], check=True,
                   env=environment)
    page = (folder / "Tables.md").read_text(encoding="utf-8")
    seen = set()
    rows_behind = behind.read_text(encoding="utf-8")
    for heading, heads, rows in (*tables_of(page), *tables_of(rows_behind)):
        for row in rows:
            check_row(heading, heads, row)
            if "largest, thesis" in heads and "merged" not in row[1]:
                check_errors(heads, row)
        for title, number in ROWS.items():
            if title in heading:
                seen.add(title)
                assert len(rows) == number, "%s has %d rows, expected %d" % (heading, len(rows), number)
        if "What a vertex buys" in heading:
            check_partners(heads, rows)
    assert seen == set(ROWS), "no table for %s" % (set(ROWS) - seen)
    check_figures(page, rows_behind)
    check_pictures(folder / "Pictures")


main()
