# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The batch program with files and options that nobody expects, and what is left of runs that were killed.

Arguments: program, folder of the data, work folder, then the interpreter.
"""

import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import numpy as np

import ledger_check
import mesh_checks
from seismichorizons_command import reading
from seismichorizons_command.data import count_points

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
INTERPRETER = sys.argv[4:]
SAMPLE = DATA / "blobs.vsm"
LATIN = os.fsdecode("caf\u00e9".encode("latin-1"))


def files(folder):
    return sorted(p.name for p in folder.iterdir()) if folder.exists() else []


class FilesTest(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.output = self.folder / "results"

    def command(self, *arguments):
        return [*INTERPRETER, str(PROGRAM), "--no-pictures", "--output-folder", str(self.output), *map(str, arguments)]

    def run_program(self, *arguments):
        """The exit code and the messages, after "horizon_mesh: "."""
        done = subprocess.run(self.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100)
        self.assertNotIn("Traceback", done.stderr)
        messages = [line.replace("horizon_mesh: ", "", 1) for line in done.stderr.splitlines()
                    if not ledger_check.is_warning(line)]
        return done.returncode, messages, done.stdout

    def copy(self, name):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        shutil.copy(SAMPLE, path)
        return path

    def write(self, name, lines):
        path = self.folder / name
        path.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
        return path

    def test_horizon_without_triangles(self):
        """Left out with a warning in every format, the rest is done."""
        picks = self.write("two.csv", ["X,Y,Z,Name", *("%d,%d,%d,Good" % (25 * i, 25 * j, 1000 + i) for j in range(9)
                                                       for i in range(9)), *("%d,0,900,Thin" % (25 * i) for i in range(9))])
        for form in ("vtp", "ts", "ply"):
            for options in ((), ("--largest-error", "1", "--leave-out-invalid")):
                code, messages, _ = self.run_program(picks, "--formats", form, *options)
                self.assertEqual((code, len(messages)), (0, 1), messages)
                self.assertRegex(messages[0], "warning: two.csv: Thin is left out: no triangles between 9 points")
        self.assertEqual(files(self.output), ["two_Good.ply", "two_Good.ts", "two_Good.vtp"])
        line = self.write("line.txt", ("1 %d 0.5" % i for i in range(3)))
        code, messages, _ = self.run_program(line)
        self.assertEqual((code, len(messages)), (1, 1), messages)
        self.assertIn("columns 1 and 2 may be line numbers or coordinates", messages[0])
        code, messages, _ = self.run_program("--columns", "Inline,Crossline,Z", line)
        self.assertEqual((code, len(messages)), (1, 2), messages)
        self.assertRegex(messages[0], "^warning: line.txt: .* is left out: no triangles between 3 points")
        self.assertEqual(messages[1], "error: line.txt: all horizons were left out")

    def write_turned(self, *others):
        """A dome on a lattice turned by 30 degrees, in steps of 25 and 12.5, with nulls, and with other picks as (i, j, z)."""
        def line(i, j, z):
            x, y = 25.0 * i, 12.5 * j
            c, s = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
            return "%d,%d,%.4f,%.4f,%.3f" % (1000 + i, 500 + j, 460000.0 + c * x - s * y, 6000000.0 + s * x + c * y, z)

        return self.write("dome.csv", [
            "Crossline,Inline,X,Y,TWT [ms]", *(line(i, j, 1200.0 + 0.2 * (i - 10) ** 2 + 0.1 * (j - 8) ** 2)
                                               for j in range(16) for i in range(20) if (i, j) not in ((0, 0), (9, 9))),
            *(line(*other) for other in others), line(0, 0, -999.25), line(9, 9, -999.25)])

    def test_what_was_found(self):
        """A wrong guess would be seen; the error of each horizon is that of the horizon alone."""
        code, messages, told = self.run_program(self.write_turned((5, 5, 1300.0)))
        self.assertEqual((code, len(messages)), (0, 1), messages)
        self.assertRegex(messages[0], "^warning: dome.csv: 1 of 318 columns have several z, up to 94.1 apart: "
                         "--duplicate-policy chooses which is kept, ")
        for words in ("plain text, separated by commas: Crossline, Inline, X, Y, Z", "20 x 16 crosslines and inlines, 25 x 12.5 "
                      "apart, the first axis 60 degrees from north", "z 1200 to 1224.9 ms, growing down (as depth and time do; "
                      "--vertical-direction Up turns it); vertical step 1; error 0.98 ms, six times the noise of 0.16\n",
                      "\n  1 duplicate left out; 2 without z left out; others up to 94.1 apart\n",
                      "1 file in %s: dome.vtp" % self.output):
            self.assertIn(words, told)
        self.assertLess(max(map(len, told.splitlines())), 200)
        several = self.write("several.csv", [
            "X,Y,Z,Name", *("%d,%d,%.3f,Fine" % (25 * i, 25 * j, 1000 + 0.01 * i * j) for j in range(20) for i in range(20)),
            *("%d,%d,%.3f,Coarse" % (25 * i, 25 * j, 2000 + 3.0 * i * (j % 7)) for j in range(20) for i in range(20))])
        meshes = {}
        for names in (["Fine"], ["Coarse"], ["Fine", "Coarse"]):
            told = self.run_program("--json", "--horizons", *names, "--", several)[2]
            for horizon in json.loads(told)["files"][0]["horizons"]:
                meshes.setdefault(horizon["name"], []).append((horizon["triangles"], horizon["vertical_error"]))
        for name, (alone, beside) in meshes.items():
            self.assertEqual(alone, beside, name)

    def test_units(self):
        """Heights in a unit need z in one of the same kind, or of none."""
        dome = self.write_turned()
        triangles = [json.loads(self.run_program("--json", "--largest-error", error, dome)[2])["files"][0]["horizons"][0]
                     ["triangles"] for error in ("2ms", "0.002 s", "0.02ms")]
        self.assertEqual(triangles[0], triangles[1])
        self.assertGreater(triangles[2], 2 * triangles[0])
        self.assertEqual(self.run_program("--vertical-unit", "ms", dome)[1], [])
        for arguments, text in (
                (("--largest-error", "2m", dome), "2m for z in ms, expected ms or s (--vertical-unit says what z is in)"),
                (("--vertical-unit", "ms", SAMPLE), "--vertical-unit ms, and z in vertical indices, expected --vertical-step with"),
                (("--despike", "1ms", SAMPLE), "in ms, and z in vertical indices, expected --vertical-step with"),
                (("--despike", "0", "ms", "--largest-error", "0.002", "ft", dome), "0.002ft for z in ms, expected ms or s"),
                (("--largest-error", "2m", "--memory", "2G", "--vertical-unit", "s", "--vertical-step", "0.004", SAMPLE),
                 "2m for z in s, expected ms or s")):
            code, messages, _ = self.run_program(*arguments)
            self.assertEqual((code, len(messages), files(self.output)), (1, 1, ["dome.vtp"]), messages)
            self.assertIn(text, messages[0])
        code, messages, told = self.run_program("--largest-error", "2m", "--vertical-unit", "m", dome)
        self.assertEqual((code, messages), (
            0, ["warning: dome.csv: z in ms in the file, replaced by --vertical-unit m: numbers are not converted"]))
        self.assertIn("1224.9 m, growing", told)
        code, messages, _ = self.run_program("--largest-error", "2ms", "--vertical-step", "4", SAMPLE)
        self.assertEqual((code, messages), (0, []))
        code, messages, told = self.run_program("--layers", "--crossings", "LowerWins", "--vertical-step", "4",
                                                "--vertical-unit", "ms", SAMPLE)
        self.assertEqual((code, len(messages)), (0, 3))
        self.assertIn("z is time", messages[0])
        self.assertTrue(all("with interpolated heights" in message for message in messages[1:]), messages)
        self.assertIn(" ms, growing down", told)

    def test_surfaces(self):
        """Triangles of GOCAD are meshed anew, with the direction of z that the file says; of a plane comes a plane."""
        corners = [(431000 + x, 6348000 + y, 1000 + 0.5 * x - 0.25 * y) for x, y in ((0, 0), (400, 0), (400, 300), (0, 300))]
        for positive, sign in (("Depth", -1.0), ("Elevation", 1.0)):
            path = self.write("top.ts", [
                "GOCAD TSurf 1", "HEADER {", "name:Top", "}", "GOCAD_ORIGINAL_COORDINATE_SYSTEM", "NAME Default",
                'AXIS_NAME "X" "Y" "Z"', 'AXIS_UNIT "m" "m" "ms"', "ZPOSITIVE " + positive,
                "END_ORIGINAL_COORDINATE_SYSTEM", "TFACE",
                *("VRTX %d %.3f %.3f %.3f" % (n + 1, *corner) for n, corner in enumerate(corners)), "TRGL 1 2 3", "TRGL 1 3 4",
                "END"])
            for steps, columns in (((), 7), (("--column-step", "25", "0", "--row-step", "0", "25"), 17)):
                given = {"ColumnStep": (25.0, 0.0), "RowStep": (0.0, 25.0), "Origin": (431000.0, 6348000.0, 0.0)} if steps else {}
                (name, points), = reading.read(path, **given)[0]
                x, y, z = points["places"].T
                self.assertEqual((name, len(set(x.round(6))) >= columns), ("Top", True))
                self.assertLess(np.abs(z * sign - (1000 + 0.5 * (x - 431000) - 0.25 * (y - 6348000))).max(), 1e-6)
                code, messages, told = self.run_program(*steps, path)
                self.assertEqual((code, messages), (0, []))
                self.assertIn("ms, growing %s (as ZPOSITIVE of the file says); " % ("down" if sign < 0 else "up"), told)
                self.assertRegex(told, "error [0-9.]+ ms, six times the rounding of [0-9.]+\n")
        steep = self.write("steep.ts", ["GOCAD TSurf 1", "HEADER {", "name:Fault", "}", "TFACE", "VRTX 1 0.3 0.4 0",
                                        "VRTX 2 0.35 99.4 0", "VRTX 3 0.3 50.4 90", "TRGL 1 2 3", "END"])
        code, messages, _ = self.run_program("--column-step", "10", "0", "--row-step", "0", "10", steep)
        self.assertEqual((code, len(messages)), (1, 1))
        self.assertIn("steep.ts: Fault: no column under the triangles, expected at least one", messages[0])

    def test_gridding(self):
        """2D lines of IESX and scattered picks stand on no lattice: of a plane comes a plane."""
        places = [(431000 + (13.7 - 0.9 * line) * n + 211.3 * line, 6348000 + 977.1 * line + 3.1 * n * (line % 3))
                  for line in range(6) for n in range(80)]
        heights = [1500 + 0.02 * (x - 431000) - 0.03 * (y - 6348000) for x, y in places]
        lines = self.write("lines.dat", [
            "PROFILE Top              TYPE 1  4" + 46 * " " + "2d_ci7m.ifdf     m ms", "SNAPPING PARAMETERS 5     0 1",
            *("%16.8E%16.8E  0 14%9.2f%10.2f%10.2f%5d%20s NL-%02d::1" % (*place, z, n % 80, n % 80, n % 80, "", n // 80)
              for n, (place, z) in enumerate(zip(places, heights))), "EOD"])
        scattered = self.write("scattered.xyz", ("%.4f %.4f %.4f" % (*place, z) for place, z in zip(places, heights)))
        for path, off in ((lines, 0.1), (scattered, 1e-3)):
            code, messages, _ = self.run_program(path)
            self.assertEqual((code, len(messages)), (1, 1))
            self.assertIn("points without a lattice", messages[0])
            self.assertIn("or --gridding", messages[0])
            code, messages, told = self.run_program("--gridding", "Plate", "--column-step", "50", "0", "--row-step", "0", "50",
                                                    "--origin", "431000", "6348000", "0", path)
            self.assertEqual((code, messages), (0, []))
            self.assertIn("50 x 50 apart", told)
            (_, points), = reading.read(path, Gridding="Plate")[0]
            x, y, z = points["places"].T
            self.assertLess(np.abs(-z - (1500 + 0.02 * (x - 431000) - 0.03 * (y - 6348000))).max(), off)

    def test_gridding_of_strays(self):
        """One wrong place does not make steps of kilometres, and a number for no value is told of, not smeared."""
        picks = [(431000 + 37.7 * n % 2000, 6348000 + 91.3 * n % 1900, 1500 + 0.01 * n) for n in range(800)]
        stray = self.write("stray.xyz", ("%.2f %.2f %.2f" % pick for pick in [*picks, (0, 0, 1510)]))
        code, messages, _ = self.run_program("--gridding", "Plate", stray)
        self.assertEqual((code, len(messages)), (1, 1))
        self.assertIn("1 of 801 picks far from all others, line 801; expected --stray-picks", messages[0])
        code, messages, told = self.run_program("--gridding", "Plate", "--stray-picks", "LeaveOut", stray)
        self.assertEqual((code, len(messages)), (0, 1))
        self.assertIn("1 pick left out as strays: line 801", messages[0])
        self.assertIn("50 x 50 apart", told)
        null = self.write("null.xyz", ("%.2f %.2f %.2f" % pick for pick in [*picks[:-1], (431500, 6348500, -9999)]))
        code, messages, _ = self.run_program("--gridding", "Plate", null)
        self.assertEqual((code, len(messages)), (0, 2))
        self.assertIn("1 of 800 points with z -9999, far from all others", messages[0])
        self.assertIn("z are negative", messages[1])  # of the plate around it

    def test_back_to_points(self):
        """Grids and picks of a mesh have the places of the picks, to the error; sparse files have their columns."""
        dome = self.write_turned()
        self.run_program("--largest-error", "0.01ms", "--formats", "irap", "dat", "vsm", "--grids-of-meshes", "--", dome)
        (_, picks), = reading.read(dome)[0]
        expected = picks["places"]
        for name, most in (("dome.irap", 0.02), ("dome.dat", 1e-4)):
            (_, points), = reading.read(self.output / name)[0]
            found = points["places"]
            distances = np.linalg.norm(found[:, None, :] - expected[None, :, :], axis=2).min(axis=0)
            self.assertLess(distances.max(), most, name)
        (_, voxels), = reading.read(self.output / "dome.vsm")[0]
        self.assertEqual(count_points(voxels), count_points(picks))

    def test_formats_of_less(self):
        """Turned grids: what a format cannot hold is told once, under the name of the file, and the rest is as it was."""
        dome = self.write_turned()
        code, messages, _ = self.run_program("--largest-error", "0.01ms", "--formats", "dxf", "gri", "zmap", "vtp", "--grids-of-meshes", "--", dome)
        self.assertEqual((code, len(messages)), (0, 1), messages)
        self.assertRegex(messages[0], "^warning: dome.zmap: dome: the format has no rotation: resampled on a lattice along the axes")
        mesh = mesh_checks.read(self.output / "dome.vtp")
        drawing = (self.output / "dome.dxf").read_text(encoding="ascii")
        self.assertEqual(drawing.count("3DFACE\n8\ndome\n"), mesh.GetNumberOfPolys())
        (_, picks), = reading.read(dome)[0]
        for name, most in (("dome.gri", count_points(picks) + 2), ("dome.zmap", count_points(picks))):
            (_, points), = reading.read(self.output / name)[0]
            found = points["places"]
            self.assertTrue(0.75 * most < len(found) <= most, (name, len(found), most))
            c, s = math.cos(math.radians(30.0)), math.sin(math.radians(30.0))
            x, y = found[:, 0] - 460000.0, found[:, 1] - 6000000.0
            i, j = (c * x + s * y) / 25.0, (c * y - s * x) / 12.5
            expected = -(1200.0 + 0.2 * (i - 10) ** 2 + 0.1 * (j - 8) ** 2)
            self.assertLess(abs(found[:, 2] - expected).max(), 0.15, name)  # a bowl between columns: 0.2 / 4 + 0.1 / 4

    def test_other_files(self):
        """What is no file of horizons is told as what it is; a folder without any stops nothing."""
        empty = self.folder / "empty"
        empty.mkdir()
        for name, content, text in (
                ("a.pdf", b"%PDF-1.4\n1 2 3\n", "a PDF document"), ("a.bin", bytes(range(256)), "so this is no text"),
                ("a.pl", b"GOCAD PLine 1\nHEADER {\n}\n", "a.pl: lines of GOCAD, expected points")):
            (self.folder / name).write_bytes(content)
            code, messages, _ = self.run_program(self.folder / name, empty, SAMPLE, "--horizons", "1")
            self.assertEqual((code, len(messages)), (1, 2), messages)
            self.assertIn("empty: there is no file of horizons in this folder", messages[0])
            self.assertIn(text, messages[1])
            self.assertEqual(files(self.output), ["blobs_horizon_1.vtp"])

    def test_faults_from_files(self):
        """Polygons leave their inside out; sticks cut, and their surface is a result."""
        picks = self.write("top.dat", ["X Y Z", *("%d %d 1000" % (25 * i, 25 * j) for j in range(40) for i in range(40))])
        corners = ((260, 260), (410, 260), (410, 410), (260, 410), (260, 260))
        polygon = self.write("faults.pol", [*("%g %g 1000" % corner for corner in corners), "999.0 999.0 999.0"])
        sticks = self.write("sticks.dat", ("%g %g %g F %d" % (462, 25 * j, z, j)
                                           for j in (39, 0, 20, 10, 30) for z in (800, 1200)))
        areas = []
        for option, path in ((None, None), ("--fault-lines", polygon), ("--fault-sticks", sticks)):
            code, messages, printed = self.run_program(
                picks, "--largest-error", "0.5", "--json", *([] if option is None else [option, path]))
            self.assertEqual((code, messages), (0, []))
            mesh = json.loads(printed)["files"][0]["horizons"][0]
            areas.append((mesh["patches"], mesh["triangles"]))
        self.assertEqual(files(self.output), ["top.vtp", "top_faults.vtp"])
        self.assertEqual(areas[0], (1, 2))
        self.assertEqual(areas[1][0], 1)
        self.assertGreater(areas[1][1], 2)  # around the hole
        self.assertEqual(areas[2], (2, 4))
        code, messages, _ = self.run_program(picks, "--fault-lines", self.folder / "none.pol")
        self.assertEqual(code, 1)
        self.assertRegex(messages[0], "error: .*none.pol")

    def test_names_and_filled_points(self):
        """Warnings have the name of the file, and distances are those of points that were read."""
        picks = self.write("top.dat", ["X Y Z Horizon", *("%d %d %.2f Top" % (25 * i, 25 * j, 1000 + i * j % 7)
                                                          for j in range(20) for i in range(20) if (i, j) != (9, 9))])
        code, messages, printed = self.run_program(picks, "--largest-error", "0.5", "--fill-holes", "9", "--measure-error", "--json")
        horizon = json.loads(printed)["files"][0]["horizons"][0]
        self.assertEqual((code, sum(horizon["distances"]["counts"]), horizon["ledger"]["columns"]["filled"]), (0, 399, 1))
        messages = self.run_program(picks, "--largest-error", "0.5", "--minimum-patch-size", "1000")[1]
        self.assertRegex(messages[0], "^warning: top.dat: Top: none of the 399 points")

    def test_stack_of_files(self):
        """Files of one horizon each are a stack; one alone is not."""
        depths = {"top": 1000.0, "mid": 1050.0, "base": 1100.0}
        grids = [self.write(name + ".xyz", ["%.3f %.3f %.3f" % (5e5 + 25 * i, 65e5 + 25 * j, z + 0.1 * i)
                                            for j in range(12) for i in range(15)]) for name, z in depths.items()]
        code, messages, text = self.run_program("--layers", "--formats", "vtp", "msh", "--", *grids)
        self.assertEqual((code, messages), (0, []))
        self.assertRegex(text, "\nstack of 3 files\n  top to mid: volume 4.8125e\\+06.*\n  mid to base: volume 4.8125e\\+06")
        self.assertEqual([name for name in files(self.output) if "layer" in name],
                         ["stack_layer_1.vtp", "stack_layer_2.vtp", "stack_layers.csv", "stack_layers.msh", "stack_layers.vtu"])
        code, messages, text = self.run_program("--layers", "--json", "--order", "AsGiven", "--missing", "Void", "--", *grids[::2])
        self.assertEqual([own["name"] for own in json.loads(text)["files"][-1]["layers"]], ["top to base"])
        code, messages, _ = self.run_program("--layers", grids[0], SAMPLE)
        self.assertEqual((code, messages[-1]), (1, "error: top: one horizon, expected at least 2, in the file or in files of one horizon each"))
        code, messages, _ = self.run_program("--layers", grids[0])
        self.assertEqual((code, messages), (1, ["error: top.xyz: one horizon with points, expected at least 2"]))

    def test_name_in_latin_1(self):
        """An error of that file alone, also in a report and in JSON."""
        good, report = self.copy("good.vsm"), self.folder / "report.html"
        folder = self.copy(LATIN + "/a.vsm").parent
        (folder / (LATIN + ".txt")).write_text("dear all\n")  # no file of horizons, which is not looked at
        for wrong in (self.copy(LATIN + ".vsm"), folder):
            code, messages, printed = self.run_program(wrong, good, "--json", "--report", report)
            self.assertEqual((code, len(messages)), (1, 1), messages)
            self.assertRegex(messages[0], r"error: '.*caf\\udce9.*\.vsm': the name of the file is not in UTF-8")
            self.assertEqual([file["status"] for file in json.loads(printed)["files"]], ["failed", "done"])
            self.assertIn("udce9", report.read_text(encoding="utf-8"))
            self.assertEqual(files(self.output), ["good_horizon_%d.vtp" % n for n in (1, 2, 3)])

    def test_option_in_latin_1(self):
        for arguments in (["--report", LATIN], ["--columns", LATIN], ["--output-folder", LATIN], ["--horizons", LATIN, "--"]):
            code, messages, _ = self.run_program(*arguments, SAMPLE)
            self.assertEqual((code, messages), (2, [r"error: 'caf\udce9' is not in UTF-8 (see --help)"]))

    def test_long_names(self):
        """One that no file can have is an error of that file alone; others are shortened."""
        code, messages, _ = self.run_program("n" * 300 + ".vsm", self.copy("m" * 248 + ".vsm"), self.copy("good.vsm"))
        self.assertEqual((code, len(messages), len(files(self.output))), (1, 1, 6), messages)
        self.assertIn("no such file", messages[0])

    def test_twice(self):
        path = self.copy("a.vsm")
        for other in (path, self.folder, self.folder / ".." / self.folder.name / "a.vsm"):
            code, messages, _ = self.run_program(path, other)
            self.assertEqual((code, messages), (1, ["error: %s is given twice" % path]))

    def test_large_numbers(self):
        for option, *values in (("--triangles", "9" * 15), ("--cell-size", str(2**31)), ("--threads", str(2**31)),
                                ("--smallest-hole-size", str(2**31)), ("--inlines", str(2**31), "1"),
                                ("--memory", "9" * 400), ("--memory", "9" * 305 + "T"), ("--memory", "0.1")):
            code, messages, _ = self.run_program(option, *values, SAMPLE)
            self.assertEqual((code, len(messages)), (2, 1), messages)
            self.assertRegex(messages[0], "^error: argument %s: invalid .*: value: " % option)
        self.assertEqual(self.run_program("--stages", "--cell-size", str(2**31 - 1), SAMPLE)[:2], (0, []))

    def test_quiet(self):
        """Errors and warnings alone; of several files, a last line counts those that are done."""
        wrong, good = self.write("wrong.vsm", ["1 1"]), self.copy("good.vsm")
        code, messages, printed = self.run_program(wrong, good)
        self.assertEqual((code, len(messages)), (1, 1))
        self.assertRegex(printed.splitlines()[-1], r"^2 files: 1 done, 1 failed, \d warnings; 3 meshes in %s/$" % self.output)
        self.assertEqual(self.run_program("-q", wrong, good), (1, messages, ""))
        self.assertNotIn("1 file:", self.run_program(good)[2])

    def test_killed(self):
        """The next run takes away what is left, but nothing of a run that still goes on."""
        large = self.folder / "large.vsm"
        large.write_bytes(b"1000 1000 9\n" + b"3 1 1 0.5 4.0\n" * 1000000)
        with subprocess.Popen(self.command(large, "--stages", "--skip-rough")) as process:
            while not files(self.output) and process.poll() is None:
                time.sleep(0.01)
            workspace = self.output / files(self.output)[0]
            os.utime(workspace, (0, 0))  # not made this moment
            self.assertEqual(self.run_program("--horizons", "1", "--", SAMPLE)[:2], (0, []))
            self.assertTrue(workspace.exists())
            process.send_signal(signal.SIGKILL)
        os.utime(workspace, (0, 0))
        self.assertEqual(self.run_program("--horizons", "1", "--", SAMPLE)[:2], (0, []))
        self.assertEqual(files(self.output), ["blobs_horizon_1.vtp"])

    def test_first_moments(self):
        """Ctrl-C while modules are loaded; before that it is Python that answers."""
        code = ("import runpy, sys, signal\n"
                "class Finder:\n"
                "    def find_spec(self, name, *_):\n"
                "        if name == %r: signal.raise_signal(signal.SIGINT)\n"
                "sys.meta_path.insert(0, Finder())\n"
                "sys.argv = sys.argv[1:]\n"
                "runpy.run_path(sys.argv[0], run_name='__main__')\n")
        for module in ("argparse", "seismichorizons"):
            done = subprocess.run([*INTERPRETER, "-c", code % module, *self.command(SAMPLE)[len(INTERPRETER):]],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (130, "", ""), module)


if __name__ == "__main__":
    unittest.main(argv=["batch_files_test"], verbosity=2)
