# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Picks come in right from texts as many programs lay them out, or are refused; and so do files of these that were
damaged. What comes in is compared with what was written, pick by pick, by nothing of the reader's own.

Arguments: a folder for files, and how often each layout is damaged (20,000 files: 300).
"""

import pathlib
import random
import re
import sys

import numpy as np
from seismichorizons_command import data, reading
from seismichorizons_command.core import HorizonError

FOLDER = pathlib.Path(sys.argv[1])
DAMAGES = int(sys.argv[2])
STEPS = 25.0, 12.5  # of crosslines and inlines, in metres


class Survey:
    """The picks of a dome with a hole on a turned survey: what files have, by the names of columns."""

    def __init__(self, columns=20, rows=16, first=(900, 1200), line_steps=(1, 2), origin=(431000.0, 6348000.0),
                 azimuth=30.0, steps=STEPS, depth=1500.0):
        i, j = (n.ravel() for n in np.meshgrid(np.arange(columns), np.arange(rows)))
        kept = (i - 7) ** 2 + (j - 9) ** 2 > 6
        i, j = i[kept], j[kept]
        c, s = np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))
        x, y = steps[0] * i, steps[1] * j
        self.values = {
            "x": np.round(origin[0] + x * c - y * s, 2), "y": np.round(origin[1] + x * s + y * c, 2),
            "xl": first[0] + line_steps[0] * i, "il": first[1] + line_steps[1] * j,
            "z": np.round(depth + 0.31 * ((i - 9) ** 2 + (j - 7) ** 2) + 0.07 * i, 2),
            "amp": np.round(1000.0 * np.sin(0.7 * i + 0.3 * j), 3), "id": np.arange(1, len(i) + 1)}
        self.values["xy"] = ["%.2f%.2f" % place for place in zip(self.values["x"], self.values["y"])]
        self.values["names"] = ["H%d" % n for n in self.values["id"]]
        self.values["some"] = ["Top" if n % 2 else "" for n in self.values["id"]]

    def __len__(self):
        return len(self.values["x"])


class Layout:
    """How a file has its picks, and what a reader should find there."""

    def __init__(self, columns, head="", separator=" ", foot="", end="\n", survey=None, points=("x", "y"), refused=None,
                 encoding="utf-8", mark=b"", options=None, formats=None, names=None, rounded=0.0, ends="", is_up=None):
        self.columns, self.head, self.separator, self.foot, self.end = columns.split(), head, separator, foot, end
        self.survey, self.points, self.refused, self.names = survey or Survey(), points, refused, names
        self.encoding, self.mark, self.options, self.formats = encoding, mark, options or {}, formats or {}
        self.ends = ends
        self.is_up = (self.survey.values["z"] <= 0.0).all() if is_up is None else is_up
        self.rounded = rounded  # how far places may be off

    def field(self, column, n):
        if column not in self.survey.values:
            return column % n if "%" in column else column
        value = self.survey.values[column][n]
        form = self.formats.get(column)
        if callable(form):
            return form(value)
        return form % value if form else str(value) if column in ("xl", "il", "id", "some") else "%.2f" % value

    def lines(self):
        return [self.separator.join(self.field(column, n) for column in self.columns) + self.ends
                for n in range(len(self.survey))]

    def text(self, lines):
        head = self.head.splitlines()
        return self.mark + self.end.join([*head, *lines, *self.foot.splitlines(), ""]).encode(self.encoding)

    def expected(self):
        return np.column_stack([self.survey.values[name] for name in (*self.points, "z")]).astype(float)


def read(path, **options):
    """All picks of a file with z as in the file, the names of its horizons, how many were dropped, and whether z counts
    upwards in the world."""
    horizons = reading.read(path, **options)[0]
    sign = data.vertical_direction(horizons[0][1])
    points = [horizon["places"] * (1.0, 1.0, sign) for _, horizon in horizons]
    dropped = sum(data.value(horizon, name) for _, horizon in horizons for name in ("DroppedDuplicates", "DroppedNulls"))
    return np.concatenate(points), [name for name, _ in horizons], dropped, sign > 0


def count_missing(expected, points, tolerance):
    """How many picks are not there, place and z."""
    missing = 0
    for pick in expected:
        near = np.abs(points[:, :2] - pick[:2]).max(axis=1) <= tolerance
        missing += not (np.abs(points[near, 2] - pick[2]) <= 0.006).any()
    return missing


def comma(value):
    return ("%.2f" % value).replace(".", ",")


LINES = ("xl", "il")
WHOLE = {"x": "%.0f", "y": "%.0f"}
NEAR = Survey(origin=(0.0, 0.0), azimuth=0.0)
LARGE = Survey(first=(100900, 201200))
FINE = Survey(steps=(6.25, 6.25))
UP = Survey(depth=-1500.0)  # all z are negative, which is upwards
EVEN = Survey(origin=(0.0, 0.0), azimuth=0.0, steps=(25.0, 10.0))
ALL = "il xl x y z"


def layouts():
    yield from plain_layouts()
    yield from layouts_of_programs()
    yield from layouts_with_headers()
    yield from refused_layouts()


def plain_layouts():
    """Numbers alone."""
    yield "x y z", Layout("x y z")
    yield "y x z: x and y are what the file has first", Layout("y x z", points=("y", "x"))
    yield "il xl z", Layout("il xl z", points=LINES)
    yield "il xl x y z", Layout(ALL)
    yield "xl il x y z", Layout("xl il x y z")
    yield "x y il xl z", Layout("x y il xl z")
    yield "x y z il xl", Layout("x y z il xl")
    yield "tabs", Layout("x y z", separator="\t")
    yield "commas", Layout("x y z", separator=",")
    yield "semicolons, one too many", Layout("x y z ", separator=";", ends=";")
    yield "fixed columns", Layout("x y z", formats={"x": "%14.2f", "y": "%14.2f", "z": "%10.2f"}, separator="")
    yield "exponents", Layout("x y z", formats={"x": "%.10e", "y": "%.10E", "z": "%.8e"})
    yield "np.savetxt", Layout("x y z", head="# x y z", formats={c: "%.18e" for c in "xyz"})
    yield "Fortran", Layout("x y z", formats={c: lambda v: ("%.10e" % v).replace("e", "D") for c in "xyz"})
    yield "whole metres", Layout("x y z", formats=WHOLE, rounded=0.6)
    yield "whole metres, bins of 6.25", Layout("x y z", survey=FINE, formats=WHOLE, rounded=0.8)
    yield "whole metres, bins of 6.25, lines", Layout(ALL, survey=FINE, formats=WHOLE, rounded=0.8)
    yield "lines above 99999", Layout(ALL, survey=LARGE)
    yield "lines with fractions", Layout(ALL, formats={"il": "%.1f", "xl": "%.1f"})
    yield "z negative", Layout("x y z", survey=UP)
    yield "z negative, lines", Layout("il xl z", survey=UP, points=LINES)
    yield "elevation", Layout("x y z", head="X Y Elevation", is_up=True)
    yield "whole local places, given", Layout("x y z", survey=EVEN, formats=WHOLE, options={"Columns": "X,Y,Z"})
    yield "local", Layout("x y z", survey=NEAR)
    yield "amplitude", Layout("x y z amp")
    yield "flags", Layout("x y z 0 1")


def layouts_of_programs():
    """About as these write them."""
    yield "id first, named", Layout("id x y z", head="OBJECTID,POINT_X,POINT_Y,POINT_Z", separator=",")
    yield "ids behind, named", Layout("x y z id", head="POINT_X;POINT_Y;DEPTH_MSL;FID", separator=";")
    yield "Petrel", Layout("x y z amp", head="# Petrel Points with attributes\n# Unit in depth: ms\nVERSION 1\nBEGIN HEADER\n"
                           "X\nY\nZ\nFLOAT,Amplitude\nEND HEADER")
    yield "Petrel, surface", Layout("x y z Top", head="# Petrel Points with attributes\nVERSION 1\nBEGIN HEADER\nX\nY\nZ\n"
                                    "STRING,Surface\nEND HEADER", names=["Top"])
    yield "Charisma", Layout("INLINE : il XLINE : xl x y z")
    yield "OpendTect", Layout("il xl z", head='# "Inline"\t"Crossline"\t"Z(ms)"\n# - - - - - -', separator="\t", points=LINES)
    yield "OpendTect, lines", Layout("il xl x y z", head="# 1: Inline\n# 2: Crossline\n# 3: X\n# 4: Y\n# 5: Z (ms)\n# - - -",
                                     separator="\t")
    yield "OpendTect, names", Layout('"Top" il xl z', head="# 1: Inline\n# 2: Crossline\n# 3: Z\n# - - -", separator="\t",
                                     points=LINES, names=["Top"])
    yield "OpenWorks", Layout(ALL, head="@File_Version: 4\n#Horizon_name____-> Top\n#Export_Z_Unit___-> ms\n"
                              "#End_of_Horizon_ASCII_Header_", foot="EOB", names=["Top"])
    yield "OpenWorks, remark", Layout(ALL, head="@File_Version: 4\n#Horizon_name____-> Top\n#Horizon_remark__-> by me in 2004\n"
                                      "1 2 3 4 5 6\nand more\n#End_of_Horizon_ASCII_Header_", foot="EOB", names=["Top"])
    yield "EarthVision", Layout("x y z xl il", head="# Type: scattered data\n# Field: 1 x meters\n# Field: 2 y meters\n"
                                "# Field: 3 z ms\n# Field: 4 column\n# Field: 5 row\n# End:")
    yield "RMS attributes", Layout("x y z amp", head="Float Amplitude")
    yield "RMS end", Layout("x y z", foot="999.0 999.0 999.0")
    yield "end -999", Layout("x y z", foot="-999.00 -999.00 -999.00")
    yield "end 1e30", Layout("x y z", foot="1.0E+30 1.0E+30 1.0E+30")
    yield "Kingdom", Layout("xl il x y z", head="Trace Line X Y Time(ms)")
    yield "Kingdom, names", Layout("Top il xl z", head="Horizon,Line,Trace,Time", separator=",", points=LINES, names=["Top"])
    yield "SeisWare", Layout("il xl x y z", head="Survey: North\nHorizon: Top\n\nINLINE_NO XLINE_NO X_COORD Y_COORD TWT_MS")
    yield "GMT", Layout("x y z", head="# @VGMT1.0 @GPOINT")
    yield "pandas", Layout("id x y z", head=",x,y,z", separator=",")
    yield "Excel, quoted", Layout("x y z", head='"X","Y","TWT (ms)"', separator=",", end="\r\n",
                                  formats={c: '"%.2f"' for c in "xyz"})
    yield "Excel, byte order mark", Layout("x y z", head="X;Y;Z", separator=";", end="\r\n", mark=b"\xef\xbb\xbf")
    yield "German", Layout("x y z", head="Rechtswert;Hochwert;Tiefe", separator=";")


def layouts_with_headers():
    """What people and scripts put around picks."""
    yield "units below", Layout("il xl x y z", head="Inline Xline X Y Time\n- - m m ms")
    yield "dashes below", Layout("x y z", head="X Y Z\n--------- --------- ------")
    yield "title", Layout("x y z", head="Horizon Top Chalk, final\nX Y Z")
    yield "two titles", Layout("x y z", head="Horizon Top Chalk\nexported by hand\nX Y Z")
    yield "title without names", Layout("x y z", head="Top Chalk final")
    yield "two titles without names", Layout("x y z", head="Top Chalk final\nof the northern survey")
    yield "title with a number", Layout("x y z", head="Survey 12, horizon 3", refused="HeaderLines skips")
    yield "title with a number left out", Layout("x y z", head="Survey 12, horizon 3", options={"HeaderLines": 1})
    yield "% comments", Layout("x y z", head="% exported\n% X Y Z")
    yield "* comments", Layout("x y z", head="* exported\n* X Y Z")
    yield "! comments", Layout("x y z", head="! exported\n! X Y Z")
    yield "names in upper case", Layout("x y z", head="EASTING NORTHING DEPTH")
    yield "HORIZON_TWT", Layout("il xl x y z", head="INLINE XLINE CDP_X CDP_Y HORIZON_TWT")
    yield "z first", Layout("z x y", head="Z,X,Y", separator=",")
    yield "one unknown name", Layout("id x y z", head="Nr;X;Y;TopChalk", separator=";")
    yield "unknown text", Layout("Top x y z", head="Reflektor;X;Y;Z", separator=";", names=["Top"])
    yield "Two Way Time", Layout("x y z", head="X Y Two Way Time")
    yield "a title that names x and y", Layout("x y z", head="# North East Frigg")
    yield "a title that names lines", Layout(ALL, head="# Inline Crossline of East survey")
    yield "decimal commas", Layout("x y z", head="Rechtswert;Hochwert;Z", separator=";", formats={c: comma for c in "xyz"})
    yield "decimal commas, blanks", Layout("il xl x y z", formats={c: comma for c in "xyz"})
    yield "decimal commas, tabs", Layout("x y z", separator="\t", formats={c: comma for c in "xyz"})
    yield "decimal commas in z", Layout("id x y z", head="Nr;X;Y;Z", separator=";", formats={**WHOLE, "z": comma}, rounded=0.6)
    yield "dates", Layout("il xl x y z 2019-11-21")
    yield "units again", Layout(ALL, head="IL XL X Y Z\n- - m m ms", foot="IL XL X Y Z\n- - m m ms")
    yield "1e20", Layout("x y z 1e20")
    yield "text last", Layout("il xl x y z Top", names=["Top"])
    yield "text first", Layout("Top x y z", names=["Top"])
    yield "two words of text", Layout("Top x y z final", names=["Top"])
    yield "formation", Layout("x y z Top", head="x,y,z,formation", separator=",", names=["Top"])
    yield "thickness", Layout("x y z amp", head="X Y DEPTH THICKNESS")
    yield "Latin-1", Layout("H\u00f6he x y z", encoding="latin-1", names=["H\u00f6he"])
    yield "null amplitudes", Layout("x y z -999.25")
    yield "blank lines and spaces", Layout("  x y z  ", head="\n\n", foot="\n\n")
    yield "header lines given", Layout("x y z", head="12 20 3\n1 2 3", options={"HeaderLines": 2})
    yield "columns given", Layout("z x amp y", options={"Columns": "Z,X,-,Y"})


def refused_layouts():
    """With a remedy."""
    yield "UTF-16", Layout("x y z", encoding="utf-16", refused="UTF-16")
    yield "UTF-16 without a mark", Layout("x y z", encoding="utf-16-le", refused="UTF-16")
    yield "old line ends", Layout("x y z", end="\r", refused="carriage returns")
    yield "commas of thousands", Layout("x y z", separator=";", formats={c: "{:,.0f}".format for c in "xyz"}, refused="")
    yield "commas of thousands or decimals", Layout("il xl z", points=LINES, formats={"z": "{:,.0f}".format},
                                                    refused="decimal commas or thousands separators")
    yield "decimal commas between commas", Layout("il xl z", separator=",", points=LINES, formats={"z": comma},
                                                  refused="decimal commas")
    yield "several unknown names", Layout("il xl x y z", head="Ligne;Trace;X;Y;Valeur", separator=";",
                                          refused="could both be Z")
    yield "a counter first", Layout("id il xl x y z", refused="look like line numbers")
    yield "a counter first, lines alone", Layout("id il xl z", points=LINES, refused="numbers the lines")
    yield "a counter before z", Layout("il xl id z", points=LINES, refused="numbers the lines")
    yield "a constant before z", Layout("il xl x y 1 z", refused="the same in all lines")
    yield "a zero between lines and places", Layout("il xl 0 x y z", refused="like their coordinates")
    yield "z between lines and places", Layout("il xl z x y", refused="like their coordinates")
    yield "whole local places", Layout("x y z", survey=EVEN, formats=WHOLE, refused="line numbers or coordinates")
    yield "line numbers by tens", Layout("il xl z", survey=Survey(line_steps=(1, 10)), points=LINES,
                                         refused="steps of 10")
    yield "touching", Layout("il xl xy z", formats={"xy": str}, refused="expected blanks between numbers")
    yield "a name in each line", Layout("names x y z", head="horizon x y z", formats={"names": str}, refused="several picks")
    yield "a name in some lines", Layout("some x y z", head="horizon,x,y,z", separator=",", refused="no name of a horizon")
    yield "a line that counts", Layout("il xl z", head="16 20 299", points=LINES, refused="seems to be the number",
                                       survey=Survey(first=(1, 1), line_steps=(1, 1)))
    yield "many columns", Layout("x y z " + 1000 * "7 ", refused="at most 1000")
    yield "two candidates for z", Layout("x y z amp", head="X Y TWT DEPTH", refused="expected one")
    yield "z beyond 99999", Layout("x y id z", formats={"id": lambda v: str(500000 + v)}, refused="")


def damage(lines, random_number):
    """Lines with one damage, and the numbers of the lines it has touched: any of them, or what they should have been, may
    be wrong afterwards."""
    lines = list(lines)
    n, m = random_number.randrange(len(lines)), random_number.randrange(len(lines))
    words = re.split(r"(\s+|[,;\t])", lines[n])
    kind = random_number.randrange(10)
    if kind == 0:
        words.pop(random_number.randrange(len(words)))
        lines[n] = "".join(words)
    elif kind == 1:
        lines.insert(n, lines[n])
        return lines, []
    elif kind == 2:
        text = "\n".join(lines)
        cut = random_number.randrange(len(text) // 2, len(text))
        lines = text[:cut].split("\n")
        return lines, range(len(lines) - 1, 10**9)
    elif kind == 3:
        lines[n], lines[m] = lines[m], lines[n]
        return lines, []
    elif kind == 4:
        places = [k for k, c in enumerate(lines[n]) if c.isdigit()]
        k = random_number.choice(places)
        lines[n] = lines[n][:k] + str(random_number.randrange(10)) + lines[n][k + 1:]
    elif kind == 5:
        lines[n] = random_number.choice(("no pick", "-999.25", "*****", "x y z", "\x1a", "1 2", "0 0 0"))
    elif kind == 6:
        k = random_number.randrange(len(words))
        words[k] = random_number.choice(("nan", "abc", "-", "1e30", "", "0", "-1"))
        lines[n] = "".join(words)
    elif kind == 7:
        lines.insert(n, random_number.choice(("", "   ", "# remark", "! remark", "\t")))
        return lines, []
    elif kind == 8:
        del lines[n]
    else:
        a, b = random_number.randrange(len(words)), random_number.randrange(len(words))
        words[a], words[b] = words[b], words[a]
        lines[n] = "".join(words)
    return lines, [n]


def check(name, layout, path):
    """What is wrong with an undamaged file; None where nothing is."""
    path.write_bytes(layout.text(layout.lines()))
    try:
        points, names, _, is_up = read(path, **layout.options)
    except HorizonError as error:
        if layout.refused is None or layout.refused not in str(error):
            return "refused: %s" % error
        return None
    if layout.refused is not None:
        return "%d points, expected a refusal" % len(points)
    missing = count_missing(layout.expected(), points, max(layout.rounded, 0.02))
    if missing or len(points) != len(layout.survey):
        return "%d of %d picks, %d of them wrong" % (len(points), len(layout.survey), missing)
    if is_up != layout.is_up:
        return "z counts %s" % ("upwards" if is_up else "downwards")
    if layout.names and names != layout.names:
        return "names %s" % names
    return None


def check_damaged(layout, path, random_number):
    """Picks of lines that were not touched come in right, or the file is refused."""
    lines, touched = damage(layout.lines(), random_number)
    path.write_bytes(layout.text(lines))
    try:
        points, _, dropped, _ = read(path, **layout.options)
    except HorizonError as error:
        return None if re.search("expected|choose|name|cannot", str(error)) else "no remedy: %s" % error
    expected = layout.expected()
    whole = [n for n in range(len(expected)) if n not in touched]
    # A place that is off by less than the tolerance moves the lattice by a little.
    missing = count_missing(expected[whole], points, max(layout.rounded, 0.2))
    extra = len(points) - len(expected)
    if missing > dropped or extra > max(len(lines) - len(expected), 0) + len(touched if isinstance(touched, list) else []):
        return "%d points of %d, %d of the untouched wrong, %d dropped" % (len(points), len(expected), missing, dropped)
    return None


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    random_number = random.Random(4711)
    faults, files = [], 0
    for number, (name, layout) in enumerate(layouts()):
        path = FOLDER / ("%d.dat" % number)
        fault = check(name, layout, path)
        files += 1
        if fault:
            faults.append("%s (%s): %s" % (name, path, fault))
            continue
        for n in range(0 if layout.refused is not None else DAMAGES):
            path = FOLDER / ("%d_%d.dat" % (number, n))
            fault = check_damaged(layout, path, random_number)
            files += 1
            if fault:
                faults.append("%s (%s): %s" % (name, path, fault))
            else:
                path.unlink()
    print("%d files of %d layouts" % (files, number + 1))
    assert not faults, "\n".join(faults)


main()
