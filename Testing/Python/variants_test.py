# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Text files of picks in all the ways that programs and people write them: each is read right, or refused with what to do
about it. Never is a coordinate a z, a horizon two, or a no value a height without a word.

Argument: a folder for the files.
"""

import pathlib
import shutil
import sys
import unittest

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

from seismichorizons_command.reading import find_format
from seismichorizons.vtk import make

FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()
INLINE, CROSSLINE = np.mgrid[1000:1040, 2000:2050]
RANDOM = np.random.default_rng(0)
LINES = "Inline, Crossline, X, Y, Z"
PLACES = "X, Y, Z"


def place(column_step, row_step, degrees=33.0):
    """World x and y of all picks on a turned survey."""
    turn, i, j = np.radians(degrees), CROSSLINE - 2000, INLINE - 1000
    return (604000.0 + i * column_step * np.cos(turn) - j * row_step * np.sin(turn),
            6079000.0 + i * column_step * np.sin(turn) + j * row_step * np.cos(turn))


X, Y = place(12.5, 25.0)
Z = 1500.0 + 20.0 * np.sin(INLINE / 9.0) + 0.5 * (CROSSLINE - 2000)


def rows(form, *columns):
    return "".join(form % values + "\n" for values in zip(*[np.ravel(column) for column in columns]))


def with_null(value):
    heights = Z.copy()
    heights[5:9, 5:9] = value
    return rows("%.2f %.2f %.2f", X, Y, heights)


def two(form):
    """Two horizons, whose name is the last field."""
    return rows(form + "Top", X, Y, Z) + rows(form + "Base", X, Y, Z + 100.0)


XYZ = rows("%.2f %.2f %.2f", X, Y, Z)
FIVE = rows("%d %d %.2f %.2f %.2f", INLINE, CROSSLINE, X, Y, Z)
PETREL = ("# Petrel Points with attributes\n# Unit in X and Y direction: m\n# Unit in depth: m\nVERSION 1\nBEGIN HEADER\n"
          "X\nY\nZ\nSTRING,Surface\nEND HEADER\n")

# Name, text, and the columns that are found in it.
READ = [
    ("plain", XYZ, PLACES), ("lines", FIVE, LINES),
    ("places_first", rows("%.2f %.2f %d %d %.2f", X, Y, INLINE, CROSSLINE, Z), "X, Y, Inline, Crossline, Z"),
    ("lines_alone", rows("%d %d %.2f", INLINE, CROSSLINE, Z), "Inline, Crossline, Z"),
    ("terminator", XYZ + "999.0 999.0 999.0\n", PLACES), ("control_z", XYZ + "\x1a", PLACES),
    ("dos", XYZ.replace("\n", "\r\n"), PLACES),
    ("numbers_above_99999", rows("%d %d %.2f %.2f %.2f", INLINE + 150000, CROSSLINE, X, Y, Z), LINES),
    ("fractions", rows("%.1f %.1f %.2f %.2f %.2f", INLINE + 0.5, CROSSLINE + 0.5, X, Y, Z), LINES),
    ("negative", rows("%d %d %.2f %.2f %.2f", INLINE - 1020, CROSSLINE - 2020, X, Y, Z), LINES),
    ("rounded_3", rows("%d %d %.0f %.0f %.2f", INLINE, CROSSLINE, *place(3.125, 3.125), Z), LINES),
    ("rounded_6", rows("%d %d %.0f %.0f %.2f", INLINE, CROSSLINE, *place(6.25, 6.25), Z), LINES),
    ("rounded_places_6", rows("%.0f %.0f %.2f", *place(6.25, 6.25), Z), PLACES),
    ("rounded_places_12", rows("%.0f %.0f %.2f", *place(12.5, 18.75, -71.0), Z), PLACES),
    ("whole_metres", rows("%d %d %d", 600000 + 25 * CROSSLINE, 6000000 + 25 * INLINE, np.round(Z)), PLACES),
    ("whole_lines", rows("%d %d %d", INLINE, CROSSLINE, np.round(Z)), "Inline, Crossline, Z"),
    ("names_of_lines", "INLINE_NO XLINE_NO POINT_X POINT_Y HORIZON_TWT\n" + FIVE, LINES),
    ("headers_of_traces", "FFID CDP CDP_X CDP_Y TWT\n" + FIVE, LINES),
    ("object_ids", "OBJECTID,xcoord,ycoord,TIME_MS\n" + rows("%d,%.2f,%.2f,%.2f", np.arange(X.size), X, Y, Z),
     "OBJECTID, X, Y, Z"),
    ("german", "Rechtswert;Hochwert;DEPTH_MSL\n" + rows("%.2f;%.2f;%.2f", X, Y, Z), PLACES),
    ("thickness", "X Y THICKNESS DEPTH_TVDSS\n" + rows("%.2f %.2f 12 %.2f", X, Y, Z), "X, Y, THICKNESS, Z"),
    ("z_and_depth", "X Y Z DEPTH\n" + rows("%.2f %.2f %.2f 7", X, Y, Z), "X, Y, Z, DEPTH"),
    ("units", "X Y Z\nm m ms\n" + XYZ, PLACES), ("dashes", "X Y Z\n---------\n" + XYZ, PLACES),
    ("title", "Top Jurassic, export of project 12\nby me 2020\n\nX Y Z\n" + XYZ, PLACES),
    ("percent", "% a comment\n* another one\n" + XYZ, PLACES), ("repeated", "X Y Z\n" + XYZ + "X Y Z\n", PLACES),
    ("commas", XYZ.replace(" ", ","), PLACES),
    ("decimal_commas", XYZ.replace(".", ","), PLACES),
    ("decimal_commas_semicolons", XYZ.replace(".", ",").replace(" ", ";"), PLACES), ("tabs", XYZ.replace(" ", "\t"), PLACES),
    ("known_null", with_null(-999.25), PLACES),
    *[("name_" + word, "X,Y,Z,%s\n" % word + two("%.2f,%.2f,%.2f,"), "X, Y, Z, Name") for word in (
        "formation", "surface", "horizon_id", "marker", "unit", "strat", "event", "interp")],
    ("name_last", two("%.2f %.2f %.2f "), "X, Y, Z, Name"),
    ("petrel", PETREL + rows('%.2f %.2f %.2f "Top"', X, Y, Z) + rows('%.2f %.2f %.2f "Base"', X, Y, Z + 100.0),
     "X, Y, Z, Name")]

# Small coordinates, below line numbers.
LOCAL = (X - 584000.0, Y - 6049000.0)


def local(x, y):
    return rows("%d %d %.2f %.2f %.2f", INLINE, CROSSLINE, x, y, Z)


READ += [
    ("local", local(*LOCAL), LINES), ("heights_of_an_event", "X Y Z EVENT\n" + rows("%.2f %.2f %.2f %.3f", X, Y, Z, Z / 3.0),
                                      "X, Y, Z, EVENT"),
    ("surface_of_heights", "X Y SURFACE\n" + XYZ, PLACES),
    ("ids", rows("P%d %.2f %.2f %.2f", np.arange(X.size), X, Y, Z), "-, X, Y, Z"),
    ("ids_last", rows("%.2f %.2f %.2f P%d", X, Y, Z, np.arange(X.size)), "X, Y, Z, -"),
    ("unit_of_each", "X,Y,Z,Unit\n" + rows("%.2f,%.2f,%.2f,m", X, Y, Z), "X, Y, Z, -")]

# Name, text, and what the error says.
REFUSED = [
    ("stray", XYZ + "1.0 1.0 5.0\n", "columns a pick; line 2001"),
    ("stray_line", rows("%d %d %.2f", INLINE, CROSSLINE, Z) + "99999 1 1500\n", "columns a pick; line 2001"),
    ("between_columns", XYZ + "604123.3 6079555.1 1500\n", "1 of 2001 picks off the lattice"),
    ("noise", rows("%d %d %.2f %.2f %.2f", INLINE, CROSSLINE, X + RANDOM.normal(0, 2, X.shape), Y, Z),
     "expected at most LatticeTolerance"),
    ("two_surveys", FIVE + rows("%d %d %.2f %.2f %.2f", INLINE, CROSSLINE, X + 50000.0, Y + 3000.0, Z),
     "may be their coordinates but do not follow them"),
    ("place_as_z", rows("%.2f %.2f %.2f", X - 600000.0, Y - 6070000.0, X),
     "expected Z of at most 99999: name the columns in Columns"),
    ("rounded_places_3", rows("%.0f %.0f %.2f", *place(3.125, 3.125), Z), "points without a lattice"),
    ("local_noise", local(LOCAL[0] + RANDOM.normal(0, 40, X.shape), LOCAL[1] + RANDOM.normal(0, 40, X.shape)),
     "may be their coordinates but do not follow them"),
    ("local_bent", local(LOCAL[0] + (LOCAL[1] - 30000.0) ** 2 / 250.0, LOCAL[1]), "may be their coordinates but do not follow them"),
    ("local_wrong_place", "".join([*local(*LOCAL).splitlines(True)[:420], "1014 2000 99.5 7.5 1500\n",
                                   *local(*LOCAL).splitlines(True)[420:]]), "the farthest, line 421, by"),
    ("two_z", "X Y TWT DEPTH\n" + rows("%.2f %.2f %.2f 7", X, Y, Z), "TWT and DEPTH could both be Z"),
    ("no_z", "X Y THICKNESS\n" + XYZ, "expected Z, and X and Y"),
    ("carriage_returns", XYZ.replace("\n", "\r"), "carriage returns only, expected line feeds")]

# Name, text, and what the warning says.
DOUBTED = [
    *[("null_%d" % value, with_null(value), "16 of 2000 points with z %d, far from all others" % value)
      for value in (-999, -9999, -32768, 0, 9999)],
    ("null_flat", rows("%.2f %.2f %d", X, Y, np.where(CROSSLINE < 2005, 0, 1500)), "200 of 2000 points with z 0, far from"),
    ("twice", XYZ + rows("%.2f %.2f %.2f", X, Y, Z + 100.0),
     "twice.dat: 2000 of 2000 columns have several z, up to 100 apart: DuplicatePolicy chooses which is kept, such as Mean for "
     "overlapping surveys, or Sheets for a horizon that overlies itself; for several horizons in one file, name the column that distinguishes "
     "them\n")]


class VariantsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)

    def read(self, name, content, **properties):
        """The horizons by their names, the reader, and its errors and warnings."""
        path = FOLDER / (name + ".dat")
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        reader = make("vtkHorizonTextReader", FileName=str(path), **properties)
        told = {"ErrorEvent": [], "WarningEvent": []}
        for event, messages in told.items():
            @calldata_type(VTK_STRING)
            def tell(_caller, _event, message, messages=messages):
                messages.append(message)
            reader.AddObserver(event, tell)
        reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        output = reader.GetOutputDataObject(0)
        horizons = {output.GetMetaData(n).Get(output.NAME()): output.GetPartition(n, 0)
                    for n in range(output.GetNumberOfPartitionedDataSets())}
        return horizons, reader, told["ErrorEvent"], told["WarningEvent"]

    def test_read(self):
        for name, text, columns in READ:
            with self.subTest(name):
                horizons, reader, errors, warnings = self.read(name, text)
                self.assertEqual((errors, warnings), ([], []))
                self.assertEqual(reader.GetDescription().splitlines()[0].split(": ")[-1], columns)
                names = ["Top", "Base"] if columns.endswith("Name") else [name]
                self.assertEqual(list(horizons), names)
                for number, horizon in enumerate(horizons.values()):
                    size = [horizon.GetFieldData().GetArray("LatticeDimensions").GetComponent(0, n) for n in (0, 1)]
                    self.assertEqual(sorted(size), [40, 50])
                    self.assertEqual(horizon.GetNumberOfPoints(), 1984 if name == "known_null" else 2000)
                    bounds = horizon.GetBounds()
                    self.assertAlmostEqual(-bounds[5], Z.min() + 100.0 * number, delta=0.51)
                    self.assertAlmostEqual(-bounds[4], Z.max() + 100.0 * number, delta=0.51)

    def test_recognised(self):
        """Whole numbers in the first line are also the header of sparse voxel files."""
        for name, text, _ in READ:
            path = FOLDER / (name + ".txt")
            path.write_text(text)
            self.assertEqual(find_format(path), "text", name)

    def test_refused(self):
        for name, text, message in REFUSED:
            with self.subTest(name):
                horizons, _, errors, _ = self.read(name, text)
                self.assertEqual((len(errors), sum(h is not None and h.GetNumberOfPoints() for h in horizons.values())), (1, 0))
                self.assertIn(message, errors[0])
        _, _, errors, _ = self.read("utf_16", XYZ.encode("utf-16"))
        self.assertIn("text in UTF-16, expected UTF-8", errors[0])

    def test_strays(self):
        """Left out on request; more than a tenth is too much."""
        for name, text, _ in REFUSED[:3]:
            with self.subTest(name):
                horizons, _, errors, warnings = self.read(name, text, StrayPicks="LeaveOut")
                self.assertEqual((errors, [h.GetNumberOfPoints() for h in horizons.values()]), ([], [2000]))
                self.assertIn("1 pick left out as strays: line 2001", warnings[0])
        five = FIVE.splitlines(True)
        five[700] = "1014 2000 99.5 7.5 1500\n"  # one wrong place moves the map of all
        horizons, _, errors, warnings = self.read("wrong_place", "".join(five), StrayPicks="LeaveOut")
        self.assertEqual((errors, horizons["wrong_place"].GetNumberOfPoints()), ([], 1999))
        self.assertIn("1 pick left out as strays: line 701", warnings[0])
        _, _, errors, _ = self.read("noise", dict((n, t) for n, t, _ in REFUSED)["noise"], StrayPicks="LeaveOut")
        self.assertIn("expected at most LatticeTolerance", errors[0])

    def test_doubted(self):
        for name, text, message in DOUBTED:
            with self.subTest(name):
                _, _, errors, warnings = self.read(name, text)
                self.assertEqual((errors, len(warnings)), ([], 1))
                self.assertIn(message, warnings[0])

    def test_duplicates(self):
        """Counted with those of the same z apart, which are no doubt."""
        moved = np.where((INLINE < 1002) & (CROSSLINE < 2010), 30.0, 0.0)
        for name, shift, repeats, doubts in (("twice", 100.0 + 0.0 * Z, 0, ["2000 of 2000 columns have several z, up to 100 apart"]),
                                             ("repeated", 0.0 * Z, 2000, []),
                                             ("some_moved", moved, 1980, ["20 of 2000 columns have several z, up to 30 apart"])):
            with self.subTest(name):
                horizons, _, errors, warnings = self.read(name, XYZ + rows("%.2f %.2f %.2f", X, Y, Z + shift))
                self.assertEqual((errors, len(warnings)), ([], len(doubts)))
                for doubt, warning in zip(doubts, warnings):
                    self.assertIn(": " + doubt, warning)
                fields = horizons[name].GetFieldData()
                self.assertEqual([fields.GetArray("Dropped" + what).GetValue(0) for what in ("Duplicates", "Repeats")],
                                 [2000, repeats])
                self.assertEqual(horizons[name].GetNumberOfPoints(), 2000)

    def test_names_of_other_encodings(self):
        for encoding, word, expected in (("latin-1", "H\u00f6he", "H\u00f6he"), ("utf-8", "H\u00f6he", "H\u00f6he"),
                                         ("cp1251", "\u041a\u0440", "\u00ca\u00f0")):
            horizons, _, errors, _ = self.read("name", rows(word + " %.2f %.2f %.2f", X, Y, Z).encode(encoding))
            self.assertEqual((list(horizons), errors), ([expected], []))


if __name__ == "__main__":
    unittest.main(verbosity=2)
