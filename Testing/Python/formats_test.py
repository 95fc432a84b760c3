# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each entry of the table of programs in Formats.md is true: a file laid out as the program writes it is read, with the right z at
each place, and what is written for it is in its format, and read again as it was.

Arguments: the page, and a folder for files.
"""

import importlib.util
import pathlib
import re
import struct
import sys
import unittest
import warnings

import numpy as np
import seismichorizons as sh

PAGE, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
COLUMNS, ROWS = 6, 5
I, J = (n.ravel() for n in np.meshgrid(np.arange(COLUMNS), np.arange(ROWS)))
X, Y = 456000.0 + 50.0 * I, 6782000.0 + 25.0 * J
Z = 1500.0 + 2.0 * I + 3.25 * J
GRID = Z.reshape(ROWS, COLUMNS)
STICKS = [("F%d" % fault, stick, [(456010.5 + 120 * fault + 3 * node, 6782005.25 + 31 * stick, 1400.0 + 60.5 * node) for node in range(3 + stick)])
          for fault in (1, 2) for stick in range(3)]
HAS_GDAL = importlib.util.find_spec("osgeo") is not None


def picks(line, head="", foot=""):
    rows = (line.format(x=x, y=y, z=z, i=100 + i, j=2000 + j) for x, y, z, i, j in zip(X, Y, Z, I, J))
    return (head + "\n".join(rows) + "\n" + foot).encode()


def values(grid, form="%.2f"):
    return "\n".join(" ".join(form % z for z in row) for row in grid) + "\n"


def irap_binary():
    def record(content):
        return struct.pack(">i", len(content)) + content + struct.pack(">i", len(content))

    return (record(struct.pack(">iifffffff", -996, ROWS, X[0], X[-1], Y[0], Y[-1], 50.0, 25.0, 0.0)[:32]) +
            record(struct.pack(">ifff", COLUMNS, 0.0, X[0], Y[0])) + record(struct.pack(">7i", *[0] * 7)) +
            b"".join(record(row.astype(">f4").tobytes()) for row in GRID))


EARTHVISION = "# Type: scattered data\n# Field: 1 x\n# Field: 2 y\n# Field: 3 z meters\n"
LIMITS = "%.1f %.1f %.1f %.1f" % (X[0], X[-1], Y[0], Y[-1])
# By name: what is said of the file, and its content.
HORIZONS_IN = {
    "table": ("plain text", picks("{x:.2f} {y:.2f} {z:.2f}")),
    "CSV": ("plain text", picks("{x:.2f},{y:.2f},{z:.2f}", "X,Y,Z\n")),
    "Petrel points": ("Petrel points", picks("{x:.2f} {y:.2f} -{z:.2f} 7", "# Petrel Points with attributes\nVERSION 1\nBEGIN HEADER\nX\nY\nZ\n"
                                             "FLOAT,\"Dip\"\nEND HEADER\n")),
    "OpendTect": ("OpendTect", picks('"Top"\t{x:.2f}\t{y:.2f}\t{i}\t{j}\t{z:.2f}', "# 1: X\n# 2: Y\n# 3: Inline\n# 4: Crossline\n# 5: Z\n# - - -\n")),
    "IESX": ("IESX", picks("{x:16.8E}{y:16.8E}  0 14{z:9.2f}{j:10.2f}{j:10.2f}{j:5d} 5.3956040E+03 I{i:7d} XX",
                           "PROFILE Top Chalk        TYPE 1  4                                              3d_ci7m.ifdf     m ms\nSNAPPING PARAMETERS 5     0 1\n",
                           "EOD\n")),
    "Charisma": ("Charisma", picks("INLINE :    {i} XLINE :    {j}    {x:.2f}  {y:.2f}   {z:.2f}")),
    "OpenWorks": ("OpenWorks", picks(" {i}.0  {j}   {x:.2f}   {y:.2f}   {z:.2f}", "@Project_Unit_is: meters , ED50 , PROJECTED\n#Horizon_name____-> Top\n"
                                     "#Export_Z_Unit_-> meters\n#End_of_Horizon_ASCII_Header_\n", "EOB\n")),
    "RMS attributes": ("RMS", picks("{x:.2f} {y:.2f} {z:.2f} UNDEF a", "Float Dip\nString Zone\n")),
    "EarthVision": ("EarthVision", picks("{x:.2f} {y:.2f} {z:.2f}", EARTHVISION + "# End:\n")),
    "EarthVision grid": ("EarthVision grid", (EARTHVISION + "# Field: 4 column\n# Field: 5 row\n# End:\n# Grid_size: 6 x 5\n" + "".join(
        "%.2f %.2f %.2f %d %d\n" % row for row in zip(X, Y, Z, I + 1, J + 1))).encode()),
    "VSet": ("points of GOCAD", picks("VRTX {i}{j} {x:.2f} {y:.2f} {z:.2f}", "GOCAD VSet 1\nHEADER {\nname:Top\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nZPOSITIVE Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n",
                                        "END\n")),
    "IRAP": ("IRAP classic ASCII", ("-996 5 50.0 25.0\n%s\n6 0.0 %.1f %.1f\n0 0 0 0 0 0 0\n" % (LIMITS, X[0], Y[0]) + values(GRID)).encode()),
    "IRAP binary": ("IRAP binary", irap_binary()),
    "STORM": ("STORM", ("STORMGRID_BINARY\n\n6 5 50.0 25.0\n%s\n" % LIMITS).encode() + GRID.astype(">f8").tobytes()),
    "ZMAP+": ("ZMAP+", ("@Top HEADER, GRID, 5\n15, 1E+30, , 7, 1\n5, 6, %s\n0.0, 0.0, 0.0\n@\n" % LIMITS.replace(" ", ", ") +
                        values(GRID.T[:, ::-1])).encode()),
    "CPS-3": ("CPS-3", ("FSASCI 0 1 \"Computed\" 0 1.0E+30 0\nFSATTR 0 0\nFSLIMI %s 1500 1523\nFSNROW 5 6\nFSXINC 50 25\n->Top\n" % LIMITS +
                        values(GRID.T[:, ::-1])).encode()),
    "GXF": ("GXF", ("#POINTS\n6\n#ROWS\n5\n#PTSEPARATION\n50\n#RWSEPARATION\n25\n#XORIGIN\n%.1f\n#YORIGIN\n%.1f\n#GRID\n" % (X[0], Y[0]) + values(GRID)).encode()),
    "Surfer": ("Surfer", ("DSAA\n6 5\n%.1f %.1f\n%.1f %.1f\n1500 1523\n" % (X[0], X[-1], Y[0], Y[-1]) + values(GRID)).encode()),
    "Esri ASCII": ("Esri ASCII", ("ncols 6\nnrows 5\nxllcenter %.1f\nyllcenter %.1f\ndx 50\ndy 25\n" % (X[0], Y[0]) + values(-GRID[::-1])).encode()),
}
# By name: the extension, and how the file begins.
HORIZONS_OUT = {"table": (".dat", b"# \"X"), "IRAP": (".irap", b"-996 5 "), "IRAP binary": (".gri", b"\0\0\0 \xff\xff\xfc\x1c"), "ZMAP+": (".zmap", b"@"),
                "CPS-3": (".cps3", b"FSASCI"), "Surfer": (".grd", b"DSAA"), "Esri ASCII": (".asc", b"ncols 6"), "GeoTIFF": (".tif", b"II*\0"),
                "TSurf": (".ts", b"GOCAD TSurf")}


def lines(line, head="", between="", foot="", first=""):
    """A line for each point of the sticks."""
    text = head
    for n, (fault, stick, points) in enumerate(STICKS):
        text += (between if n else "") + first.format(fault=fault, stick=stick)
        for node, (x, y, z) in enumerate(points):
            text += line.format(x=x, y=y, z=z, fault=fault, stick=stick, line=n, node=node) + "\n"
    return (text + foot).encode()


def plines():
    text = ""
    for fault in ("F1", "F2"):
        text += "GOCAD PLine 1\nHEADER {\nname:%s\n}\nZPOSITIVE Depth\n" % fault
        for points in (points for name, _, points in STICKS if name == fault):
            first = text.count("VRTX") + 1
            text += "ILINE\n" + "".join("VRTX %d %.2f %.2f %.2f\n" % (first + n, *point) for n, point in enumerate(points))
            text += "".join("SEG %d %d\n" % (first + n, first + n + 1) for n in range(len(points) - 1))
        text += "END\n"
    return text.encode()


def iesx():
    text = ""
    for fault in ("F1", "F2"):
        text += "PROFILE %-20sTYPE 5  1 ms\nSNAPPING PARAMETERS 5 1\n" % fault
        text += "".join("%.2f %.2f %d %.2f\n" % (x, y, stick, z) for name, stick, points in STICKS if name == fault for x, y, z in points) + "EOD\n"
    return text.encode()


PLAIN = "{x:.2f} {y:.2f} {z:.2f}"
FAULTS_IN = {
    "table": lines(PLAIN + " {line}"), "named table": lines(PLAIN + " {fault} {stick}"), "sticks of OpendTect": lines(PLAIN.replace(" ", "\t") + "\t{line}\t{node}"),
    "CSV": lines("{fault},{stick},{x:.2f},{y:.2f},{z:.2f}", "Fault,Stick,X,Y,Z\n"), "segments of GeoFrame": lines("{x:.2f} {y:.2f} {line} {z:.2f}"),
    "IRAP polygons": lines(PLAIN, between="999.0 999.0 999.0\n", foot="999.0 999.0 999.0\n"), "PLine": plines(), "IESX lines": iesx(),
    "Charisma sticks": lines("INLINE-   10   20 " + PLAIN + " {fault} {stick}"), "CPS-3 lines": lines(PLAIN, "FFASCI 0 C\nFFATTR 1 2\n", first="->{fault} {stick}\n"),
    "ZMAP+ lines": lines("{x:15.2f}{y:15.2f}{z:10.2f}{line:6d}", "@FREE POINT        , DATA, 80, 1\nX (EASTING)        , 1, 1,  1,      1, 15,,    1.0E+30,,,   4, 0\n"
                         "Y (NORTHING)       , 2, 2,  1,     16, 30,,    1.0E+30,,,   4, 0\nZ VALUE            , 3, 3,  1,     31, 40,,    1.0E+30,,,   4, 0\n"
                         "SEG I.D.           , 4, 35, 1,     41, 46,,    1.0E+30,,,   0, 0\n@\n")}
FAULTS_OUT = {"table": (".dat", b"# \"Fault"), "CSV": (".csv", b"\"Fault\","), "PLine": (".pl", b"GOCAD PLine"), "IRAP polygons": (".pol", b"4561"),
              "GeoPackage": (".gpkg", b"SQLite format 3")}


def programs():
    """The cells of the table: column, and name of the format."""
    text = PAGE.read_text(encoding="utf-8").split("## Formats by program", 1)[1].split("\n\n", 2)[1]
    head, _, *rows = ([cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines())
    return [(column, name) for row in rows for column, cell in zip(head[1:], row[1:]) for name in cell.split(", ") if name != "-"]


class Formats(unittest.TestCase):
    def names(self, column, known):
        """The names of a column are those that are tested here, all of them."""
        found = {name for own, name in programs() if own == column}
        self.assertEqual(found, set(known), column)
        return sorted(found - ({"GeoTIFF", "GeoPackage"} if not HAS_GDAL else set()))

    def check_heights(self, horizon, sign=1.0):
        found = {(round(x), round(y)): z for x, y, z in zip(horizon.x, horizon.y, horizon.z)}
        self.assertEqual(len(found), len(Z))
        for x, y, z in zip(X, Y, Z):
            self.assertAlmostEqual(found[round(x), round(y)], sign * z, delta=0.006)

    def test_horizons_in(self):
        for name in self.names("Horizons in", {*HORIZONS_IN, "TSurf", "GeoTIFF"}):
            with self.subTest(name):
                if name in ("TSurf", "GeoTIFF"):
                    continue  # files of their writers
                told, content = HORIZONS_IN[name]
                path = FOLDER / ("in_" + re.sub(r"\W", "_", name))
                path.write_bytes(content)
                (horizon,) = sh.read(path).values()
                self.assertTrue(horizon.taken[0].startswith(told), horizon.taken)
                self.check_heights(horizon, -1.0 if name in ("Petrel points", "Esri ASCII") else 1.0)

    def test_horizons_out(self):
        horizon = sh.horizon(X, Y, Z, name="Top", vertical_unit="m", coordinate_system="EPSG:23031")
        for name in self.names("Horizons out", HORIZONS_OUT):
            with self.subTest(name):
                ending, beginning = HORIZONS_OUT[name]
                path = FOLDER / ("out" + ending)
                data = sh.surface(horizon, 0.1) if name == "TSurf" else horizon
                sh.write(data, path)
                self.assertTrue(path.read_bytes().startswith(beginning))
                if name == "TSurf":
                    self.assertLess(np.abs(sh.read_mesh(path)["Top"].points[:, 2].max() + Z.min()), 0.2)
                else:
                    self.check_heights(*sh.read(path).values(), -1.0 if name == "Esri ASCII" else 1.0)

    def check_lines(self, found):
        self.assertEqual(len(found), len(STICKS))
        for line, (_, _, points) in zip(found, STICKS):
            np.testing.assert_allclose(line, np.array(points) * (1.0, 1.0, -1.0), rtol=0.0, atol=0.006)

    def test_faults_in(self):
        for name in self.names("Faults in", {*FAULTS_IN, "GeoPackage"}):
            with self.subTest(name):
                if name == "GeoPackage":
                    continue  # a file of its writer
                path = FOLDER / ("faults_" + re.sub(r"\W", "_", name))
                path.write_bytes(FAULTS_IN[name])
                self.check_lines(sh.read_faults(path))

    def test_faults_out(self):
        given = sh.Lines([fault for fault, _, _ in STICKS], [np.array(points) * (1.0, 1.0, -1.0) for _, _, points in STICKS], [str(stick) for _, stick, _ in STICKS])
        for name in self.names("Faults out", FAULTS_OUT):
            with self.subTest(name):
                ending, beginning = FAULTS_OUT[name]
                sh.write(given, FOLDER / ("faults" + ending))
                paths = [FOLDER / ("faults_%s.pol" % fault) for fault in ("F1", "F2")] if ending == ".pol" else [FOLDER / ("faults" + ending)]
                self.assertTrue(paths[0].read_bytes().startswith(beginning))
                self.check_lines(sh.read_faults(paths))


FOLDER.mkdir(parents=True, exist_ok=True)
warnings.simplefilter("ignore", UserWarning)
unittest.main(argv=sys.argv[:1], verbosity=0)
