# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The batch program as a user runs it. Arguments: program, folder of the data, work folder, then the interpreter."""

import csv
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest


import image_compare
import ledger_check
import mesh_checks
import wrong_files

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
INTERPRETER = sys.argv[4:]
SAMPLE = DATA / "blobs.vsm"


def run(*arguments, prepare=None, stdout=subprocess.PIPE, **environment):
    command = [*INTERPRETER, str(PROGRAM), *(str(a) for a in arguments)]
    done = subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=100,
                          env={**os.environ, **environment}, preexec_fn=prepare)
    errors = [line for line in done.stderr.splitlines() if line.startswith("horizon_mesh: ")]
    return done, [line for line in errors if not ledger_check.is_warning(line)]


def files(folder):
    return sorted(p.name for p in folder.iterdir()) if folder.exists() else []


def printed_row(done, horizon):
    """The words of the row of a horizon in the table."""
    return next(line.split() for line in done.stdout.splitlines() if line.split()[:1] == [horizon])


class BatchTest(unittest.TestCase):
    def setUp(self):
        self.output = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.output, ignore_errors=True)

    def succeed(self, *arguments):
        done, errors = run("--output-folder", self.output, *arguments)
        self.assertEqual((done.returncode, errors), (0, []), done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def refused(self, *arguments, output=None, code=1, **others):
        """Runs the program with a wrong input, or with the code 2 a wrong command line, and returns its one message."""
        done, errors = run("--output-folder", output or self.output, *arguments, **others)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertTrue(errors[0].startswith("horizon_mesh: error: "), done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        self.assertNotIn("ERR|", done.stderr)
        return errors[0]

    def test_sample(self):
        done = self.succeed(SAMPLE, "--stages")
        meshes = sorted(self.output.glob("*.vtp"))
        self.assertGreaterEqual(len(meshes), 2)
        self.assertEqual(files(self.output), sorted([m.name for m in meshes] + ["blobs.png"]))
        for path in meshes:
            self.assertRegex(path.name, r"^blobs_horizon_\d+\.vtp$")
            mesh = mesh_checks.read(path)
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            row = printed_row(done, path.stem.split("_")[-1])
            self.assertEqual(int(row[1]), mesh_checks.counts(mesh).sum())
            self.assertEqual([int(row[5]), int(row[6])], [mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()])
        picture = image_compare.load(self.output / "blobs.png")
        self.assertEqual(picture.shape[1], 5 * 480)
        self.assertGreater(len(set(map(tuple, picture[::7, ::7].reshape(-1, 3)))), 100)

    def test_options(self):
        self.succeed(SAMPLE, "--no-pictures", "--stages", "--threads", "1", "--horizons", "1", "--z-from", "RealZ",
                     "--duplicate-policy", "Lowest", "--origin", "10", "20", "30", "--column-step", "2", "1",
                     "--row-step", "-1", "2", "--vertical-step", "-4", "--distance-threshold", "0", "--skip-rough")
        self.assertEqual(files(self.output), ["blobs_horizon_1.vtp"])
        mesh = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
        self.assertEqual(mesh_checks.counts(mesh).sum(), mesh.GetNumberOfPoints())
        self.assertGreater(mesh_checks.check_mesh(mesh), 0)
        self.assertTrue((mesh_checks.coordinates(mesh)[:, 2] == -mesh_checks.array(mesh, "RealZ")).all())

    def test_vertical_direction(self):
        """Down by default, and both ways every face looks up."""
        middles = []
        for arguments in ([], ["--vertical-direction", "Up"]):
            self.succeed(SAMPLE, "--no-pictures", "--horizons", "1", *arguments)
            mesh = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            middles.append(mesh.GetCenter()[2])
        self.assertLess(middles[0], 0.0)
        self.assertEqual(middles[0], -middles[1])

    def test_written_direction(self):
        """Grids and picks have z as it is said, and GOCAD files say it."""
        for direction, sign in (("Down", 1.0), ("Up", -1.0)):
            self.succeed(SAMPLE, "--horizons", "1", "--formats", "irap,dat,ts", "--written-direction", direction, "--no-pictures")
            heights = {"irap": [float(word) for word in (self.output / "blobs_horizon_1.irap").read_text().split()[19:]],
                       "dat": [float(line.split()[2]) for line in (self.output / "blobs_horizon_1.dat").read_text().splitlines() if line[0] != "#"],
                       "ts": [float(line.split()[4]) for line in (self.output / "blobs_horizon_1.ts").read_text().splitlines() if "VRTX" in line]}
            for name, values in heights.items():
                self.assertTrue(all(sign * value > 0.0 for value in values if value < 9999900.0), (name, direction, values[:3]))
            self.assertIn("ZPOSITIVE " + ("Depth" if sign > 0.0 else "Elevation"), (self.output / "blobs_horizon_1.ts").read_text())

    def test_elaborate(self):
        """After the rough simplification, and alone; with points of the input only, counts are all of them."""
        points = []
        for arguments in ([], ["--elaborate"], ["--elaborate", "--skip-rough", "--representative", "NearestPoint"],
                          ["--elaborate", "--elaborate-cell-size", "2", "--flatness-threshold", "0", "--skip-rough"]):
            done = self.succeed(SAMPLE, "--no-pictures", "--stages", "--horizons", "1", *arguments)
            mesh = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            points.append(mesh.GetNumberOfPoints())
            self.assertEqual(int(printed_row(done, "1")[1]), mesh_checks.counts(mesh).sum())
        self.assertLess(points[1], points[0])
        self.assertLess(points[2], points[3])

    def test_largest_error(self):
        """A smaller error takes more triangles, and is kept as the measure of the error sees it."""
        triangles = []
        for error in ("0.75", "2"):
            done = self.succeed(SAMPLE, "--no-pictures", "--horizons", "1", "--largest-error", error, "--measure-error")
            mesh = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            self.assertLessEqual(mesh.GetFieldData().GetArray("LargestError").GetValue(0), float(error) + 1e-9)
            row = printed_row(done, "1")
            self.assertEqual(int(row[1]), mesh_checks.counts(mesh).sum())
            self.assertLessEqual(max(float(row[7]), float(row[8])), float(error))
            self.assertLess(float(row[10]), 1.5 * float(error))  # outlines move sideways, too
            triangles.append(mesh.GetNumberOfPolys())
        self.assertGreater(triangles[0], 2 * triangles[1])
        done = self.succeed(SAMPLE, "--no-pictures", "--horizons", "1")
        data = mesh_checks.read(self.output / "blobs_horizon_1.vtp").GetFieldData()
        error = data.GetArray("ChosenMaximumError").GetValue(0)
        self.assertGreaterEqual(error, 6.0 / 12.0 ** 0.5)  # whole heights
        self.assertLessEqual(data.GetArray("LargestError").GetValue(0), error + 1e-9)
        self.assertIn("error %.2g vertical indices, six times the noise of %.2g" % (error, error / 6.0), done.stdout)
        self.assertIn("--elaborate is an option of --stages", self.refused(SAMPLE, "--largest-error", "1", "--elaborate", code=2))
        self.assertIn("--edge-length is not an option of --stages", self.refused(SAMPLE, "--stages", "--edge-length", "9", code=2))

    def test_triangles(self):
        """At most so many in each mesh; what is given is not chosen. The picture has the panels of what was made."""
        done = self.succeed(SAMPLE, "--triangles", "400", "--radius", "2")
        for path in self.output.glob("*.vtp"):
            mesh = mesh_checks.read(path)
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            row = printed_row(done, path.stem.split("_")[-1])
            self.assertEqual(int(row[4]), mesh.GetNumberOfPolys())
            self.assertIn(mesh.GetNumberOfPolys(), (399, 400))
            self.assertEqual(mesh.GetFieldData().GetArray("ChosenRadius").GetValue(0), 2)
        self.assertEqual(image_compare.load(self.output / "blobs.png").shape[1], 3 * 480)
        self.assertIn("that the outlines require", self.refused(SAMPLE, "--no-pictures", "--triangles", "5"))
        self.assertIn("not allowed with", self.refused(SAMPLE, "--triangles", "5", "--largest-error", "1", code=2))

    def test_outlines(self):
        """A larger radius takes fewer outline points, and a tolerance leaves fewer still."""
        after = []
        for arguments in ([], ["--radius", "3"], ["--radius", "3", "--outline-tolerance", "1", "--bound-deviation"]):
            done = self.succeed(SAMPLE, "--no-pictures", "--stages", "--horizons", "1", *arguments)
            after.append(int(printed_row(done, "1")[4]))
        self.assertGreater(after[0], after[1])
        self.assertGreater(after[1], after[2])
        self.succeed(SAMPLE, "--no-pictures", "--stages", "--horizons", "1", "--minimum-patch-size", "1000")
        closed = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
        self.succeed(SAMPLE, "--no-pictures", "--stages", "--horizons", "1", "--minimum-patch-size", "1000", "--keep-holes")
        holed = mesh_checks.read(self.output / "blobs_horizon_1.vtp")
        self.assertEqual(closed.GetNumberOfLines(), 1)
        self.assertGreater(holed.GetNumberOfLines(), 1)

    def test_error(self):
        """The columns of the table, the file of figures and the arrays of the mesh say the same."""
        done = self.succeed(SAMPLE, "--no-pictures", "--stages", "--horizons", "1", "2", "--measure-error", "--distance-unit",
                            "World", "--vertical-step", "4", "--samples-per-point", "3")
        self.assertEqual(files(self.output), ["blobs_error.csv", "blobs_horizon_1.vtp", "blobs_horizon_2.vtp"])
        with open(self.output / "blobs_error.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 2 * 9)
        both = next(row for row in rows if row["Direction"] == "Two-sided" and row["Unit"] == "Steps")
        printed = printed_row(done, "1")
        self.assertEqual(printed[9:11], ["%.3f" % float(both[n]) for n in ("LargestDistance", "MeanDistance")])
        self.assertGreater(float(both["LargestDistance"]), float(both["MeanDistance"]))
        world = next(row for row in rows if row["Direction"] == "Mesh to reference" and row["Unit"] == "World")
        distances = mesh_checks.array(mesh_checks.read(self.output / "blobs_horizon_1.vtp"), "Distance")
        self.assertLessEqual(distances.max(), float(world["LargestDistance"]))

    def test_report(self):
        """The parts of the page are where the package is; what is printed is JSON alone."""
        page = self.output.with_name("page.html")
        done = self.succeed("--report", page, "--json", "--horizons", "1", "--", SAMPLE)
        run = json.loads(done.stdout)
        self.assertEqual([h["name"] for h in run["files"][0]["horizons"]], ["Horizon 1"])
        text = page.read_text(encoding="utf-8")
        self.assertIn(">Horizon 1<", text)
        self.assertTrue(text.endswith("</html>\n"))
        self.assertEqual(run["command"]["words"][0], INTERPRETER[0])

    def test_any_number_of_threads(self):
        bytes_of = []
        for threads in ("1", "2"):
            self.succeed(SAMPLE, "--no-pictures", "--stages", "--threads", threads, "--horizons", "1", "--elaborate")
            bytes_of.append((self.output / "blobs_horizon_1.vtp").read_bytes())
        self.assertEqual(*bytes_of)

    def test_folder_with_a_wrong_file(self):
        """The good file of a folder is done although another one is wrong."""
        folder = self.output.with_name("mixed")
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copy(SAMPLE, folder / "good.vsm")
        (folder / "bad.vsm").write_bytes(b"1 1\n")
        message = self.refused(folder, "--no-pictures", "--horizons", "1")
        self.assertIn("bad.vsm", message)
        self.assertEqual(files(self.output), ["good_horizon_1.vtp"])

    def test_wrong_files(self):
        for path, parts in wrong_files.write(FOLDER / "wrong"):
            if path.is_dir():
                parts = [path.name]
            with self.subTest(path.name):
                message = self.refused(path)
                for part in parts:
                    self.assertIn(part, message)
                self.assertEqual(files(self.output), [])

    def test_no_such_horizon(self):
        message = self.refused(SAMPLE, "--horizons", "4711")
        self.assertIn("4711", message)
        self.assertEqual(files(self.output), [])

    def test_no_display(self):
        """All else is there; newer versions of VTK draw pictures all the same."""
        done, errors = run("--output-folder", self.output, SAMPLE, "--horizons", "1", DISPLAY=":4711")
        self.assertEqual(done.returncode, 0, done.stderr)
        if "blobs.png" not in files(self.output):
            self.assertEqual(len(errors), 1, done.stderr)
            self.assertIn("warning: no pictures, as there is no X server", errors[0])
        self.assertEqual(set(files(self.output)) - {"blobs.png"}, {"blobs_horizon_1.vtp"})

    def test_no_such_output_folder(self):
        """Noticed before the work starts, which would find that the file is wrong."""
        wrong = self.output.with_name("wrong.vsm")
        wrong.parent.mkdir(parents=True, exist_ok=True)
        wrong.write_text("wrong")
        self.output.write_text("in the way")
        # Nobody can write into the last one.
        for folder in (self.output, self.output / "below", "/proc/self"):
            with self.subTest(folder):
                self.assertIn("results cannot be written into %s: " % folder,
                              self.refused(wrong, "--no-pictures", output=folder))
        self.assertEqual(self.output.read_text(), "in the way")
        self.output.unlink()

    def test_folder_in_the_way(self):
        """Of one of the results: then there are no others, either."""
        (self.output / "blobs_horizon_2.vtp").mkdir(parents=True)
        self.assertIn("blobs_horizon_2.vtp", self.refused(SAMPLE, "--no-pictures"))
        self.assertEqual(files(self.output), ["blobs_horizon_2.vtp"])

    def test_full_disk(self):
        """A limit on the size of files does what a full disk does: of a mesh, and of the picture, which is larger."""
        self.succeed(SAMPLE)
        mesh, picture = ((self.output / name).stat().st_size for name in ("blobs_horizon_1.vtp", "blobs.png"))
        self.assertGreater(picture, 2 * mesh)
        for size, name, arguments in ((8192, "blobs_horizon_1.vtp", ["--no-pictures"]),
                                      (mesh // 2, "blobs_horizon_1.vtp", ["--no-pictures"]),
                                      ((mesh + picture) // 2, "blobs.png", [])):
            with self.subTest(size):
                shutil.rmtree(self.output, ignore_errors=True)
                message = self.refused(SAMPLE, *arguments, output=self.output / "below",
                                    prepare=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
                self.assertIn(name + " cannot be written: ", message)
                self.assertFalse(self.output.exists())

    def test_full_output(self):
        """All files are done all the same, and the table that could not be printed is told of once."""
        other = self.output.with_name("other.vsm")
        other.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(SAMPLE, other)
        with open("/dev/full", "w", encoding="utf-8") as full:
            message = self.refused(SAMPLE, other, "--no-pictures", "--horizons", "1", stdout=full)
        self.assertIn("the table cannot be printed: No space left on device", message)
        self.assertEqual(files(self.output), ["blobs_horizon_1.vtp", "other_horizon_1.vtp"])

    def test_signals(self):
        """At different moments of the work: an end without a word, and nothing is left."""
        large = self.output.with_name("large.vsm")
        large.parent.mkdir(parents=True, exist_ok=True)
        large.write_bytes(b"1000 1000 9\n" + b"3 1 1 0.5 4.0\n" * 1000000)
        command = [*INTERPRETER, str(PROGRAM), "--no-pictures", "--stages", "--skip-rough", "--output-folder",
                   str(self.output / "below"), str(large)]
        for number, delay in ((signal.SIGINT, 0.0), (signal.SIGTERM, 0.2), (signal.SIGINT, 0.6)):
            with self.subTest(number=number, delay=delay), subprocess.Popen(
                    command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                while not files(self.output / "below") and process.poll() is None:
                    time.sleep(0.01)
                time.sleep(delay)
                process.send_signal(number)
                output, errors = process.communicate(timeout=100)
                self.assertEqual((process.returncode, output), (128 + number, ""), errors)
                for word in ("Traceback", "ERR|", "Interrupt", "Loguru", "horizon_mesh: "):
                    self.assertNotIn(word, errors)
                self.assertFalse(self.output.exists())

    def test_wrong_options(self):
        for arguments in (["--cell-size", "0"], ["--stages", "--cell-size", "two"], ["--largest-error", "2 parsec"], ["--distance-threshold", "-1"],
                          ["--distance-threshold", "nan"], ["--vertical-step", "0"], ["--z-from", "Depth"],
                          ["--flatness-threshold", "-1"], ["--representative", "Any"], ["--no-such-option"],
                          ["--column-step", "1"]):
            with self.subTest(arguments):
                self.refused(SAMPLE, *arguments, code=2)
                self.assertEqual(files(self.output), [])
        self.assertIn("expected finite vectors", self.refused(SAMPLE, "--column-step", "0", "1"))

    def test_files_among_horizons(self):
        """A list ends before a file, and after a word with commas."""
        for words in (["1", "2", "--", SAMPLE], ["1", "2", SAMPLE], ["1,2", SAMPLE], ["1", "--horizons", "2", SAMPLE]):
            shutil.rmtree(self.output, ignore_errors=True)
            self.succeed("--no-pictures", "--horizons", *words)
            self.assertEqual(files(self.output), ["blobs_horizon_1.vtp", "blobs_horizon_2.vtp"])

    def write_picks(self, name, text):
        path = self.output.with_name(self.output.name + "-input") / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="ascii")
        return path

    def test_formats(self):
        """Picks of two horizons and a grid, each mesh in all formats under the name of its horizon."""
        picks = self.write_picks("picks.dat", "".join(
            '"%s"\t%d\t%d\t%.1f\t%.1f\t%.2f\n' % (name, j, i, 459600 + 25 * i, 5934800 + 25 * j, z + i % 3)
            for name, z in (("Top Reek", 1500), ("Base", 1600)) for j in range(12) for i in range(15)))
        grid = self.write_picks("reek.grd", "DSAA\n3 2\n100 120\n200 210\n5 7\n5 6 7\n5 6 7\n")
        done = self.succeed("--no-pictures", "--largest-error", "0.5", "--formats", "vtp", "ts", "stl", "ply", "obj", "--",
                            picks, grid)
        stems = ["picks_Base", "picks_Top_Reek", "reek"]
        self.assertEqual(files(self.output), sorted(
            "%s.%s" % (stem, form) for stem in stems for form in ("vtp", "ts", "stl", "ply", "obj")))
        for stem in stems:
            mesh = mesh_checks.read(self.output / (stem + ".vtp"))
            self.assertGreater(mesh_checks.check_mesh(mesh), 0)
            surface = (self.output / (stem + ".ts")).read_text(encoding="ascii")
            self.assertEqual(surface.count("\nTRGL "), mesh.GetNumberOfPolys())
            self.assertEqual((self.output / (stem + ".stl")).read_text().count("facet normal"), mesh.GetNumberOfPolys())
        self.assertIn("name:Top Reek", (self.output / "picks_Top_Reek.ts").read_text(encoding="ascii"))
        self.assertIn("Top Reek", done.stdout)
        self.succeed("--no-pictures", "--horizons", "Base", "--", picks)

    def test_format_options(self):
        """What a format leaves no choice of is refused, and so is what no format has."""
        picks = self.write_picks("odd.txt", "".join(
            "%d %d 7 %d\n" % (i, j, i + j) for j in range(5) for i in range(5)))
        self.succeed("--no-pictures", "--stages", "--skip-rough", "--columns", "X Y - Z", picks)
        self.assertEqual(files(self.output), ["odd.vtp"])
        kinds = self.write_picks("kinds.txt", "".join(
            "%d.5 %d.5 %d top\n0 bad\n- - - fault\n" % (i, j, i + j) for j in range(5) for i in range(5)))
        done = self.succeed("--no-pictures", "--columns", "X,Y,Z,kind", "--where", "kind=top", kinds)
        self.assertIn("; 50 lines of other kinds left out", done.stdout)
        self.assertIn("--where \"top\", expected COLUMN=VALUE", self.refused(kinds, "--columns", "X Y Z kind", "--where", "top"))
        self.assertIn("its format does not support --z-from", self.refused(picks, "--z-from", "RealZ"))
        self.assertIn("its format does not support --columns", self.refused(SAMPLE, "--columns", "X,Y,Z"))
        self.assertIn("--origin with a z of 3", self.refused(picks, "--origin", "0", "0", "3"))
        noise = self.write_picks("noise.txt", "a b\n")
        self.assertIn("noise.txt: ", self.refused(noise))

    def test_files_of_one_name(self):
        folders = [self.output.with_name("one-name") / name for name in "ab"]
        shutil.rmtree(folders[0].parent, ignore_errors=True)
        for folder in folders:
            folder.mkdir(parents=True, exist_ok=True)
            shutil.copy(SAMPLE, folder)
        done = self.succeed("--no-pictures", *folders, "--horizons", "1")
        self.assertEqual(files(self.output), ["a_blobs_horizon_1.vtp", "b_blobs_horizon_1.vtp"])
        for label in ("a/blobs.vsm", "b/blobs.vsm"):
            self.assertIn("\n%s: read in " % label, "\n" + done.stdout)
        self.addCleanup((folders[0] / "blobs.dat").unlink)
        shutil.copy(SAMPLE, folders[0] / "blobs.dat")
        shutil.rmtree(self.output)
        self.succeed("--no-pictures", folders[0] / "blobs.dat", folders[0] / SAMPLE.name, "--horizons", "1")
        self.assertEqual(files(self.output), ["blobs_dat_horizon_1.vtp", "blobs_vsm_horizon_1.vtp"])


if __name__ == "__main__":
    unittest.main(argv=["batch_test"], verbosity=2)
