# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The same fault sticks, written as programs write them, are read as the same lines, and cut a horizon at the same links. What has
no effect is named with its cause.

Arguments: the program horizon-mesh, and a folder for files.
"""

import csv
import dataclasses
import gzip
import importlib.util
import io
import json
import pathlib
import shutil
import subprocess
import sys
import unittest
import warnings

import numpy as np
import seismichorizons as sh

PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
MAPS = (".gpkg",) if importlib.util.find_spec("osgeo") else ()
ORIGIN, STEP, ANGLE = np.array([620073.56, 6070345.86]), 12.5, np.radians(23.0)
ROWS, COLUMNS = 60, 80
NAMES = ("North fault", "F-2", "Splay")


def on_map(i, j):
    return ORIGIN + STEP * np.array([i * np.cos(ANGLE) - j * np.sin(ANGLE), i * np.sin(ANGLE) + j * np.cos(ANGLE)])


def make_sticks():
    """(fault, number, points of x, y, z downwards) of three dipping faults across the horizon, of sticks of unequal length."""
    random = np.random.default_rng(53)
    sticks = []
    for fault, at in zip(NAMES, (17.0, 38.0, 59.0)):
        for number, j in enumerate(np.linspace(3.0, ROWS - 4.0, 7)):
            z = np.round(np.sort(random.uniform(1400.0, 1600.0, 3 + number % 3)), 2)
            z[0], z[-1] = 1390.25 + number, 1612.5 + number
            points = [np.append(np.round(on_map(at + (depth - 1500.0) / 40.0, j + 0.3 * np.sin(depth)), 2), depth) for depth in z]
            sticks.append((fault, number, points))
    return sticks


STICKS = make_sticks()
FAULT_NUMBERS = {name: number + 1 for number, name in enumerate(NAMES)}
LINE_NUMBERS = {(fault, number): n for n, (fault, number, _) in enumerate(STICKS)}


def table(row, header="", between=""):
    """A line for each point, of x, y, z, and what else is known of it."""
    text, count = io.StringIO(), 0
    text.write(header)
    for n, (fault, stick, points) in enumerate(STICKS):
        text.write(between if n else "")
        for node, (x, y, z) in enumerate(points):
            text.write(row.format(x=x, y=y, z=z, fault=fault, number=FAULT_NUMBERS[fault], stick=stick, line=LINE_NUMBERS[fault, stick],
                                  node=node, count=count) + "\n")
            count += 1
    return text.getvalue()


def plines():
    text = ""
    for name in NAMES:
        text += "GOCAD PLine 1\nHEADER {\nname: %s\n}\nZPOSITIVE Depth\n" % name
        count = 0
        for points in (points for fault, _, points in STICKS if fault == name):
            text += "ILINE\n" + "".join("VRTX %d %.2f %.2f %.2f\n" % (count + n + 1, *point) for n, point in enumerate(points))
            text += "".join("SEG %d %d\n" % (count + n + 1, count + n + 2) for n in range(len(points) - 1))
            count += len(points)
        text += "END\n"
    return text


def iesx():
    text = "#GeoFrame fault sticks\n"
    for name in NAMES:
        text += "PROFILE %-20sTYPE 5  1 ms\nSNAPPING PARAMETERS 5 1\n" % name
        for stick, points in ((stick, points) for fault, stick, points in STICKS if fault == name):
            text += "".join("%.2f %.2f %d %.2f\n" % (x, y, stick, z) for x, y, z in points)
        text += "EOD\n"
    return text


def cps():
    return "FFASCI 0 C\nFFATTR 1 2\n" + "".join("->%s %d\n" % (fault, stick) + "".join("%.2f %.2f %.2f\n" % tuple(p) for p in points)
                                              for fault, stick, points in STICKS)


PLAIN = "{x:.2f} {y:.2f} {z:.2f}"
TABS = PLAIN.replace(" ", "\t")
COMMAS = PLAIN.replace(" ", ",")
NAMED, NUMBERED, UNNAMED = "named", "numbered", "unnamed"  # what a file says of faults
# A file, its content, what it says of faults, and options.
FILES = (
    ("header.csv", table("{fault},{stick},%s" % COMMAS, "Fault name,Stick,X,Y,Z\n"), NAMED, {}),
    ("behind.csv", table(COMMAS + ",{fault},{stick}", "X,Y,Z,Fault,Stick\n"), NAMED, {}),
    ("northing.csv", table("{y:.2f},{x:.2f},{z:.2f},{fault},{stick}", "Northing,Easting,TWT,Fault,Stick\n"), NAMED, {}),
    ("pandas.csv", table("{count},%s,{fault},{stick}" % COMMAS, ",X,Y,Z,fault,stick\n"), NAMED, {}),
    ("index.csv", table("{count},%s,{fault},{stick}" % COMMAS), NAMED, {}),
    ("loop.csv", table(COMMAS + ",{fault},{stick}", "X,Y,Z,feature_name,polyline_id\n"), NAMED, {}),
    ("commas.csv", table("{fault};{stick};{x:.2f};{y:.2f};{z:.2f}", "Fault;Stick;X;Y;Z\n").replace(".", ","), NAMED, {}),
    ("quoted.csv", table('"{fault}",{stick},%s' % COMMAS, '"Fault","Stick","X","Y","Z"\n'), NAMED, {}),
    ("windows.csv", "\ufeff" + table("{fault},{stick},%s" % COMMAS, "Fault,Stick,X,Y,Z\n").replace("\n", "\r\n"), NAMED, {}),
    ("packed.csv.gz", table("{fault},{stick},%s" % COMMAS, "Fault,Stick,X,Y,Z\n"), NAMED, {}),
    ("kingdom.txt", table(PLAIN + " {fault} {stick}"), NAMED, {}),
    ("columns.txt", table("{stick} {z:.2f} {fault} 7 {y:.2f} {x:.2f}").replace("North fault", "North_fault"), NAMED,
     {"columns": "Stick Z Fault - Y X"}),
    ("charisma.txt", table("INLINE-   10   20 " + PLAIN + " {fault} {stick}"), NAMED, {}),
    ("iesx.dat", iesx(), NAMED, {}),
    ("cps.flt", cps(), NAMED, {}),
    ("gocad.pl", plines(), NAMED, {}),
    ("faults.txt", table(PLAIN + " {number} {line} {node}", "# X Y Z Fault Stick Node\n"), NUMBERED, {}),
    ("opendtect.txt", table(TABS + "\t{line}\t{node}"), UNNAMED, {}),
    ("opendtect_stick.txt", table(TABS + "\t{line}"), UNNAMED, {}),
    ("opendtect_node.txt", table(TABS + "\t{node}"), UNNAMED, {}),
    ("geoframe.txt", table("{x:.2f} {y:.2f} {line} {z:.2f}"), UNNAMED, {}),
    ("before.txt", table("{line} " + PLAIN), UNNAMED, {}),
    ("rms.pol", table(PLAIN, between="999.0 999.0 999.0\n") + "999.0 999.0 999.0\n", UNNAMED, {}),
    ("gmt.txt", table(PLAIN, "> first\n", "> next\n"), UNNAMED, {}),
    ("dug.dufault", table(PLAIN, between="\n"), UNNAMED, {}),
    ("upward.csv", table("{fault},{stick},{x:.2f},{y:.2f},-{z:.2f}", "Fault,Stick,X,Y,Z\n"), NAMED, {}),
    ("nodata.csv", table("{fault},{stick},%s" % COMMAS, "Fault,Stick,X,Y,Z\nF-2,0,1,2,-999.25\n"), NAMED, {"nodata": -999.25}),
)


def write(name, content):
    path = FOLDER / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(gzip.compress(content.encode()) if path.suffix == ".gz" else content.encode())
    return path


def horizon():
    """Heights near 1500, with a throw of 40 at each fault."""
    j, i = np.mgrid[0:ROWS, 0:COLUMNS]
    throws = sum(40.0 * (i > at) for at in (17, 38, 59))
    x = ORIGIN[0] + STEP * (i * np.cos(ANGLE) - j * np.sin(ANGLE))
    y = ORIGIN[1] + STEP * (i * np.sin(ANGLE) + j * np.cos(ANGLE))
    return sh.horizon(points=np.column_stack((x.ravel(), y.ravel(), (1440.0 + throws).ravel())), direction="down")


def cut(lines, **options):
    """The faulted links, and the warnings."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        links = sh.faults(HORIZON, lines=lines, are_sticks=True, **options).links
    return sorted(map(tuple, np.sort(np.reshape(links, (-1, 2)), axis=1).tolist())), [str(one.message) for one in told]


class FaultFiles(unittest.TestCase):
    def test_formats(self):
        expected, told = cut(sh.read_faults(write("reference.csv", FILES[0][1])))
        self.assertGreater(len(expected), 3 * (ROWS - 12))
        self.assertEqual(told, [])
        for name, content, kind, options in FILES:
            with self.subTest(name):
                lines = sh.read_faults(write(name, content), **options)
                self.assertEqual(len(lines), len(STICKS))
                for line, (_, _, points) in zip(lines, STICKS):
                    np.testing.assert_array_equal(line, np.array(points) * (1.0, 1.0, -1.0))
                names = [fault for fault, _, _ in STICKS]
                if name == "columns.txt":
                    names = [fault.replace(" ", "_") for fault in names]
                numbers = [str(FAULT_NUMBERS[fault]) for fault, _, _ in STICKS]
                self.assertEqual(lines.names, {NAMED: names, NUMBERED: numbers, UNNAMED: [""] * len(STICKS)}[kind])
                if kind == NAMED and name != "gocad.pl":
                    self.assertEqual(lines.sticks, [str(stick) for _, stick, _ in STICKS])
                self.assertIn("%d lines, z 1390.25 to 1618.5 " % len(STICKS) if name != "upward.csv" else "z -1618.5 to -1390.25 up", lines.taken[0])
                self.assertEqual("1 point without z left out" in lines.taken[0], name == "nodata.csv")
                self.assertEqual(cut(lines), (expected, []))

    def test_several_files(self):
        """Each is a fault of the name of its file; lines of the command, of Python and of both in one list are the same."""
        expected, _ = cut(sh.read_faults(write("reference.csv", FILES[0][1])))
        paths = []
        for name in NAMES:
            own = "\n".join("".join("%.2f %.2f %.2f\n" % tuple(point) for point in points) for fault, _, points in STICKS if fault == name)
            paths.append(write("several/%s.dat" % name, own))
        lines = sh.read_faults(paths)
        self.assertEqual(lines.names, [fault for fault, _, _ in STICKS])
        self.assertEqual([text.split(":")[0] for text in lines.taken], list(NAMES))
        for given in (lines, paths, [sh.read_faults(paths[:1]), sh.read_faults(paths[1:])]):
            with self.subTest(type(given).__name__):
                self.assertEqual(cut(given)[0], expected)

    def test_no_effect(self):
        """Sticks alone, faults that cut nothing and lines beside the horizon are named with the likely cause."""
        alone = "Lonely,0,%.2f,%.2f,1400\nLonely,0,%.2f,%.2f,1600\n" % (*on_map(30, 30), *on_map(31, 30))
        shallow = "".join("Shallow,%d,%.2f,%.2f,%d\n" % (n, *on_map(50, 20 + 9 * n), z) for n in range(3) for z in (100, 200))
        far = "".join("Far,%d,%.2f,%.2f,%d\n" % (n, *on_map(5000, 20 + 9 * n), z) for n in range(3) for z in (1400, 1600))
        for added, words in ((alone, ("1 of 22 fault sticks (Lonely) form no surface",)),
                             (shallow, ("1 of 4 faults (Shallow) cut nothing", "of another unit or direction")),
                             (far, ("1 of 4 faults (Far) cut nothing", "of another coordinate system"))):
            with self.subTest(words[0]):
                _, told = cut(sh.read_faults(write("added.csv", FILES[0][1] + added)))
                self.assertEqual(len(told), 1)
                for word in words:
                    self.assertIn(word, told[0])
        exchanged = table("{fault},{stick},{y:.2f},{x:.2f},{z:.2f}", "Fault,Stick,X,Y,Z\n")
        links, told = cut(sh.read_faults(write("exchanged.csv", exchanged)))
        self.assertEqual(links, [])
        self.assertRegex(told[0], "none of 21 fault polylines .*: x and y beside the horizon: are they exchanged")

    def test_contours(self):
        """Open at faults, written by their levels, and read again."""
        z = np.where(np.arange(80) < 40, 1000.0, 1030.0) + 0.5 * np.arange(60)[:, None]
        plain = sh.horizon(z, spacing=(25, 25), vertical_unit="ms", name="Top")
        faults = sh.faults(plain, 10.0)
        whole, cut = sh.contours(plain, "5 ms"), sh.contours(plain, "5 ms", faults=faults)
        lengths = [sum(np.linalg.norm(np.diff(line[:, :2], axis=0), axis=1).sum() for line in lines) for lines in (whole, cut)]
        self.assertGreater(lengths[0], lengths[1] + 1000.0)
        self.assertFalse(any(((line[:, 0] > 39 * 25) & (line[:, 0] < 40 * 25)).any() for line in cut))
        for ending in (".dat", ".csv", ".pl"):
            sh.write(cut, FOLDER / ("contours" + ending))
            again = sh.read_faults(FOLDER / ("contours" + ending))
            self.assertEqual(sorted(again.names), sorted(cut.names))
            self.assertTrue(all(np.allclose(line[:, 2], -float(name)) for name, line in zip(again.names, again.lines)))
        with self.assertRaisesRegex(TypeError, "expected them where the mesh is made"):
            sh.contours(sh.surface(plain, 1.0), 5.0, faults=faults)

    def test_contours_of_several_horizons(self):
        from seismichorizons import vtk

        reader, contours, writer = vtk.vtkHorizonTextReader(), vtk.vtkHorizonContours(), vtk.vtkFaultLinesWriter()
        reader.AddFileName(str(write("several.txt", "Name X Y Z\n" + "".join(
            "%s %d %d %g\n" % (name, 25 * i, 25 * j, top + i) for name, top in (("Top", 1000), ("Base", 1005)) for j in range(9)
            for i in range(15)))))
        contours.SetInputConnection(reader.GetOutputPort())
        contours.SetInterval(5.0)
        writer.SetInputConnection(contours.GetOutputPort())
        writer.SetFileName(str(FOLDER / "several.dat"))
        writer.Write()
        names = sh.read_faults(FOLDER / "several.dat").names
        self.assertEqual(sorted(names), ["Base 1005", "Base 1010", "Base 1015", "Top 1000", "Top 1005", "Top 1010"])

    def test_refused(self):
        """What is missing is an error that says where, and which columns were expected."""
        whole = table("{fault},{stick},%s" % COMMAS, "Fault,Stick,X,Y,Z\n")
        for content, options, words in ((whole + "Cut off,1,620", {}, "line %d: 3 fields, expected the columns Fault, Stick, X, Y, Z" % (whole.count("\n") + 1)),
                                        (whole + "A,1,x,2,3\n", {}, 'line %d: "x", expected a finite number, x' % (whole.count("\n") + 1)),
                                        (whole, {"columns": "X Y"}, "expected X, Y and Z"),
                                        (whole, {"columns": "X X Y Z Stick"}, "each once"),
                                        (iesx()[:-4], {}, "expected EOD"),
                                        ("Fault,Northing,Easting,Depth\nA,6,5,1,7\nA,6,6,2,7\n", {}, "5 fields below 4 column names, expected one field for each"),
                                        ("Fault Northing Easting Depth\nMain A 6 5 1\nMain A 6 6 2\n", {}, "5 fields below 4 column names"),
                                        ("Northing,Easting,Depth,Fault\n6,5,1\n6,6,2\n", {}, "3 fields below 4 column names"),
                                        ("", {}, "expected fault lines")):
            with self.subTest(words):
                with self.assertRaises(ValueError) as caught:
                    sh.read_faults(write("refused.csv", content), **options)
                self.assertIn(words, str(caught.exception))


class FaultsOut(unittest.TestCase):
    """What is written cuts the same links when it is read again, and faults keep their names."""

    def again(self, lines, ending):
        folder = FOLDER / ("out" + ending)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        sh.write(lines, folder / ("lines" + ending))
        return sh.read_faults(sorted(folder.iterdir()))

    def test_round_trips(self):
        for source, content, _, options in (FILES[0], FILES[17]):
            given = sh.read_faults(write(source, content), **options)
            found = sh.faults(HORIZON, lines=given, are_sticks=True)
            for ending in (".dat", ".txt", ".csv", ".pl", ".pol", *MAPS):
                with self.subTest(source=source, ending=ending):
                    sticks, traces = self.again(given, ending), self.again(found.traces, ending)
                    self.assertEqual((sticks.direction, traces.direction), ("down", "down"))
                    self.assertEqual(cut(sticks)[0], cut(given)[0])
                    np.testing.assert_array_equal(sh.faults(HORIZON, lines=traces).links, found.links)
                    if ending != ".pol":
                        self.assertEqual(sorted(sticks.names), sorted(given.names))
                        self.assertEqual(sorted(traces.names), sorted(found.traces.names))

    def test_units(self):
        """Headers have the unit of z. Sticks in another one than the horizon are refused, and so are files of two units."""
        horizon = dataclasses.replace(HORIZON, vertical_unit="ms")
        given = sh.read_faults(write("units.csv", FILES[0][1]))
        for ending in (".dat", ".csv", ".pl"):
            with self.subTest(ending):
                sticks = self.again(dataclasses.replace(given, vertical_unit="m"), ending)
                self.assertEqual((sticks.vertical_unit, sticks.vertical_domain), ("m", "depth"))
                for use in (lambda lines: sh.faults(horizon, lines=lines, are_sticks=True), lambda lines: sh.cutoffs({"Top": horizon}, lines)):
                    with self.assertRaisesRegex(ValueError, 'with z in "depth", expected "time"'):
                        use(sticks)
                sh.faults(horizon, lines=sticks, are_sticks=False)  # traces on the map need no z
                sh.write(dataclasses.replace(given, vertical_unit="ms"), FOLDER / ("ms" + ending))
                with self.assertRaisesRegex(ValueError, "ms%s: z in ms, expected m as in " % ending):
                    sh.read_faults([FOLDER / ("out" + ending) / ("lines" + ending), FOLDER / ("ms" + ending)])

    def test_sticks_are_no_traces(self):
        """Python refuses to take sticks for traces on the map unless it is said."""
        given = sh.read_faults(write("sticks.csv", FILES[0][1]))
        with self.assertRaisesRegex(ValueError, "look like fault sticks, expected are_sticks=True"):
            sh.faults(HORIZON, lines=given)
        traces = sh.faults(HORIZON, lines=given, are_sticks=True).traces
        self.assertGreater(len(sh.faults(HORIZON, lines=traces).links), 0)
        sh.faults(HORIZON, lines=given, are_sticks=False)
        for bad in (np.nan, np.inf):
            broken = [np.where(np.arange(len(line))[:, None] == 1, bad, line) for line in given.lines]
            with self.assertRaisesRegex(ValueError, "expected finite numbers"):
                sh.faults(HORIZON, lines=dataclasses.replace(given, lines=broken))
        with self.assertRaisesRegex(TypeError, "faults\\(horizon, lines="):
            sh.faults(HORIZON, given)

    def test_names(self):
        """In links, lines and surfaces, and in files of the command."""
        path = write("names.csv", FILES[0][1])
        found = sh.faults(HORIZON, lines=path, are_sticks=True)
        self.assertEqual(set(found.traces.names), set(NAMES))
        self.assertEqual(list(found.surfaces), list(NAMES))
        self.assertEqual([found.names[n] for n in np.unique(found.lines)], found.traces.names)
        sh.write(found.surfaces, FOLDER / "surfaces.ts")
        self.assertEqual(list(sh.read_mesh(FOLDER / "surfaces.ts")), list(NAMES))
        self.assertEqual(sh.faults(HORIZON, 10.0).traces.names[0], "fault 1")
        sh.write(HORIZON, FOLDER / "horizon.dat")
        out = FOLDER / "command"
        done = subprocess.run([sys.executable, PROGRAM, FOLDER / "horizon.dat", "--fault-sticks", path, "--fault-formats", "csv,pl", "--formats", "ts", "--json",
                               "-o", out, "--no-pictures"], stdout=subprocess.PIPE, check=True)
        (horizon,) = json.loads(done.stdout)["files"][0]["horizons"]
        self.assertEqual([fault["name"] for fault in horizon["faults"]], list(NAMES))
        self.assertEqual(sum(fault["links"] for fault in horizon["faults"]), len(found.links))
        for ending in ("csv", "pl"):
            lines = sh.read_faults(out / ("horizon_fault_lines.%s" % ending))
            np.testing.assert_array_equal(sh.faults(HORIZON, lines=lines).links, found.links)
        self.assertEqual(list(sh.read_mesh(out / "horizon_faults.ts")), list(NAMES))

    def test_warnings_of_a_file(self):
        """A fault that cuts one of two horizons is none without an effect; one that cuts neither is told once."""
        shallow = "".join("Shallow,%d,%.2f,%.2f,%d\n" % (n, *on_map(50, 20 + 9 * n), z) for n in range(3) for z in (100, 200))
        path = write("several.csv", FILES[0][1] + shallow)
        low = dataclasses.replace(HORIZON, z=HORIZON.z + 5000.0, name="Low")
        sh.write({"Top": HORIZON, "Low": low}, FOLDER / "two.dat")
        done = subprocess.run([sys.executable, PROGRAM, FOLDER / "two.dat", "--fault-sticks", path, "-o", FOLDER / "two", "--no-pictures"],
                              capture_output=True, check=True, text=True)
        told = [line for line in done.stderr.splitlines() if "fault" in line]
        self.assertEqual(len(told), 1, told)
        self.assertIn("two.dat: 1 of 4 faults (Shallow) cut nothing: z ", told[0])

    def test_ugly_lines(self):
        """Come back from each format: two of a stick, with a name of quotes and commas, closed, above the datum, to and fro."""
        square = np.array([[0.5, 0.5, -5.0], [3.5, 0.5, -6.0], [3.5, 4.5, -7.0], [0.5, 4.5, -8.0], [0.5, 0.5, -5.0]])
        above, to_and_fro = square * (1.0, 1.0, -1.0), np.array([[4.15, 3.65, -9.0], [4.65, 1.65, -9.0], [4.15, 5.15, -9.0]])
        flat = sh.horizon(np.full((8, 8), 1000.0))
        for name, lines, sticks in (("P", [square, square + 7.0], ["1", "1"]), ("a, b; c", [square], [""]), ("7", [to_and_fro], ["x"]),
                                    ("Above", [above], ["1"]), ("\u00c6r\u00f8", [square, to_and_fro], ["", ""])):
            given = sh.Lines([name] * len(lines), lines, sticks)
            for ending in (".dat", ".csv", ".pl", *MAPS):
                with self.subTest(name=name, ending=ending):
                    back = self.again(given, ending)
                    self.assertEqual(back.names, given.names)
                    self.assertEqual(len(back), len(lines))
                    for one, other in zip(back, lines):
                        np.testing.assert_array_equal(one, other)
        found = sh.faults(flat, lines=sh.Lines(["7"], [to_and_fro], ["x"]))
        np.testing.assert_array_equal(sh.faults(flat, lines=self.again(found.traces, ".dat")).links, found.links)

    def test_empty_last_field(self):
        """Names hold where lines end with a separator."""
        lines = sh.read_faults(write("trailing.csv", "Fault,Northing,Easting,Elevation\nA,6,5,1,\nA,7,5,2,\n"))
        self.assertEqual((lines.names, lines.lines[0].tolist(), lines.direction), (["A"], [[5, 6, 1], [5, 7, 2]], "up"))

    def test_doubled_quotes(self):
        """Of spreadsheets, in fields with quotes."""
        for name in ('say "hi"', '"q"', 'a, "b"', '5" liner, east', ""):
            text = io.StringIO()
            csv.writer(text).writerows([("Fault", "X", "Y", "Z"), (name, 1, 2, 3), (name, 4, 5, 6)])
            lines = sh.read_faults(write("quotes.csv", text.getvalue()))
            self.assertEqual((lines.names, lines.lines[0].tolist()), ([name], [[1, 2, -3], [4, 5, -6]]))

    def test_refused(self):
        lines = sh.read_faults(write("reference.csv", FILES[0][1]))
        for ending, words in ((".ts", "expected one of the extensions .dat"), (".irap", "expected one of the extensions .dat")):
            with self.assertRaisesRegex(ValueError, words):
                sh.write(lines, FOLDER / ("refused" + ending))
        with self.assertRaisesRegex(ValueError, "no lines, expected polylines or polygons"):
            sh.write(sh.Lines([], []), FOLDER / "none.csv")


FOLDER.mkdir(parents=True, exist_ok=True)
HORIZON = horizon()
unittest.main(argv=sys.argv[:1], verbosity=0)
