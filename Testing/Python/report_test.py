# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the batch program tells of a run: its report, its JSON and its exit code. Needs an X server.

Arguments: the program, the generator of horizons, the folder of the data, the page of the documentation, a work folder.
"""

import html.parser
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import unittest
from unittest import mock

import ledger_check
import numpy as np
import seismichorizons as sh
from seismichorizons_command import album, batch, charts, data, figures, markup, memory, pipeline, record, report, volumes

PROGRAM, GENERATOR, DATA, PAGE, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:6])
SAMPLE = DATA / "blobs.vsm"
BAD_NAME = "<script>window.broken=1</script>'&amp;<img src=x onerror=window.broken=1>"
# Their keys are names of classes, stages and the like.
OPEN = ("versions", "parameters", "seconds", "chosen", "prepared")
MEGABYTE = 1 << 20


class Page(html.parser.HTMLParser):
    """What is in a page: all elements as (name, attributes), and the texts outside of scripts."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.texts, self._inside = [], [], None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        self._inside = tag

    def handle_data(self, data):
        if self._inside not in ("script", "style") and data.strip():
            self.texts.append(data.strip())

    def all(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]

    def text(self):
        return " ".join(" ".join(self.texts).split())


def keys_of(value, path=""):
    """The paths to all values: `files[].label`."""
    if isinstance(value, dict) and path.rpartition(".")[2] not in OPEN:
        return {found for key, item in value.items() for found in keys_of(item, (path + "." if path else "") + key)}
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return {found for item in value for found in keys_of(item, path + "[]")}
    return {path}


def documented_keys(page):
    """Those in the first cells of the table; of several in a row the others begin with a dot, below the same parent."""
    table = re.search(r"^\| Key \| Meaning \|\n((?:\|.*\n)+)", page, re.MULTILINE).group(1)
    found = set()
    for cell in re.findall(r"^\| (`[^|]*`) \|", table, re.MULTILINE):
        first, *others = re.findall(r"`([\w.\[\]]+)`", cell)
        parent = first.rpartition(".")[0]
        found.update([first, *((parent + key).lstrip(".") for key in others)])
    return found


def write_picks(path, names):
    """Small horizons, one above the other, in the form of OpendTect."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("".join('"%s"\t%d\t%d\t%.1f\t%.1f\t%.2f\n' % (
        name, j, i, 459600 + 25 * i, 5934800 + 25 * j, 1500 + 100 * n + (3 * i * j) % 5)
        for n, name in enumerate(names) for j in range(10) for i in range(12)), encoding="utf-8")
    return path


def write_voxels(path, height):
    """A horizon of 40 times 40 columns, without gaps."""
    path.write_text("40 40 80\n" + "".join("%d 1 1 1 1\n" % height(i, j) for j in range(40) for i in range(40)),
                    encoding="utf-8")
    return path


def write_fault(path):
    """A fault inside, whose throw fades out at both ends."""
    return write_voxels(path, lambda i, j: 20 + i * j // 60 + (max(0, 12 - abs(j - 20)) if i + 0.3 * j > 26 else 0))


class ReportTest(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.page = self.folder / "page.html"

    def run_program(self, *arguments, code=0, **environment):
        command = [sys.executable, str(PROGRAM), "--output-folder", str(self.folder / "results"), *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=200,
                              env={**os.environ, **environment})
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done

    def run_report(self, *arguments, **others):
        self.run_program("--report", self.page, *arguments, **others)
        return Page(self.page.read_text(encoding="utf-8"))

    def test_page(self):
        """All in one file, for everybody: nothing from elsewhere, words for all pictures, heads for all columns."""
        page = self.run_report(SAMPLE, "--largest-error", "0.75")
        links = [attributes.get(name) for tag, attributes in page.elements for name in ("src", "href", "data", "poster")
                 if tag != "use" and name in attributes]
        self.assertEqual([link for link in links if not link.startswith(("data:", "#"))], [])
        self.assertNotRegex(markup.read("page.css"), "url|@import")
        self.assertIn("default-src 'none'", page.all("meta")[1]["content"])
        images = page.all("img")
        self.assertEqual(len(images), 3 + 3 * 4)  # a thumbnail, points, outline, mesh and error
        self.assertEqual(len([image for image in images if image["alt"]]), 3 * 4)
        self.assertTrue(all("scope" in head for head in page.all("th")))
        self.assertTrue(all("aria-label" in drawing for drawing in page.all("svg")))
        self.assertEqual((len(page.all("h1")), page.all("html")[0]["lang"]), (1, "en"))
        ids = [attributes["id"] for _, attributes in page.elements if "id" in attributes]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual([link["href"] for link in page.all("a") if link["href"][1:] not in ids], [])
        for text in ("120 \u00d7 100 columns", "18,258", "Horizon 2", "VTK 9", "--largest-error 0.75", "MaximumError",
                     "Smallest angle", "increasing downwards"):
            self.assertIn(text, page.text())
        size = self.page.stat().st_size / 1e6
        self.assertIn("a single file of %.1f MB" % size, page.text())
        self.assertFalse((self.folder / "results" / "blobs_error.csv").exists())

    def test_names_are_text(self):
        """Those of horizons and of files, and what errors say; nothing of them is taken for a part of the page."""
        picks = write_picks(self.folder / "<b onclick=window.broken=1>\".dat", [BAD_NAME, "Top & Base"])
        wrong = self.folder / "<i>wrong.vsm"
        wrong.write_text("1 1\n")
        page = self.run_report(picks, wrong, "--largest-error", "0.5", code=1)
        self.assertIn(BAD_NAME, page.texts)
        self.assertIn(BAD_NAME, [row["data-value"] for row in page.all("th") if "data-value" in row])
        self.assertIn("<b onclick=window.broken=1>\".dat", page.texts)
        self.assertIn("<i>wrong.vsm", page.text())
        self.assertEqual((page.all("b")[0], page.all("i")), ({}, []))
        self.assertFalse(any(name.startswith("on") for _, attributes in page.elements for name in attributes))
        # Only what the page names by its hash may run.
        codes = [attributes for attributes in page.all("script") if "type" not in attributes]
        hashes = re.findall("'sha256-", page.all("meta")[1]["content"])
        self.assertEqual(len(codes), len(hashes))

    def test_escaping(self):
        self.assertEqual(markup.fill("tile", name="<a>", value="\"'&\0\udcff"),
                         "<div><dt>&lt;a&gt;</dt><dd>&quot;&#x27;&amp;\ufffd\ufffd</dd></div>\n")
        self.assertEqual(markup.fill("tile", name=markup.fill("tick", x=1, text="<", anchor="a"), value=None).count("&lt;"), 1)
        self.assertNotRegex(markup.script_safe("'</SCRIPT><!--<script'"), r"(?i)</script|<!--|<script")
        self.assertEqual(json.loads(markup.as_json(["</script>"])), ["</script>"])
        self.assertNotIn("<", markup.as_json(["</script>"]))
        with self.assertRaises(KeyError):
            markup.fill("tile", name="x")

    def test_units(self):
        """Distances have the units of the file where it says them, errors that of the user."""
        indices = r"vertical indices \([\d.e-]+ ms\)"
        for head, arguments, world, vertical in (
                ("X (m),Y (m),Z (ms)", [], "m, z in ms", "ms"), ("X (m),Y (m),Depth (m)", [], "m", "m"),
                ("X (m),Y (m),Z (ms)", ["--largest-error", "0.002s"], "m, z in ms", "s"),
                ("X (m),Y (m),Z (ms)", ["--largest-error", "0.75"], "m, z in ms", indices),
                ("X,Y,Z", ["--vertical-unit", "s"], "unit of x and y, z in s", "s"), ("X,Y,Z", [], "world units", "z")):
            path = self.folder / "units.csv"
            path.write_text("\n".join([head, *("%d,%d,%g" % (25 * i, 25 * j, 1000 + 0.2 * (i * j % 7))
                                               for j in range(12) for i in range(12)), ""]), encoding="utf-8")
            page = self.run_report(path, "--no-pictures", *arguments)
            self.assertIn("lattice units %s" % world, " ".join(page.text().split()))
            self.assertRegex(page.text(), r"at most [\d.e-]+ %s, [\d.e-]+ on average" % vertical)

    def test_without_pictures(self):
        """No X server is needed then."""
        page = self.run_report(SAMPLE, "--no-pictures", DISPLAY=":4711")
        self.assertEqual(page.all("img"), [])
        self.assertIn("No pictures were requested.", page.text())
        self.assertEqual(len(page.all("svg")), 2 * 3)

    def test_many_horizons(self):
        """Pictures of the largest ones only; size and time are bounded."""
        path = self.folder / "many.vsm"
        subprocess.run([GENERATOR, "--size", "24", "20", "1000", "--horizons", "200", "--holes", "0", "--islands", "0", path],
                       check=True, stdout=subprocess.DEVNULL)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        page = self.run_report(path, "--largest-error", "2")
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 60.0)
        self.assertLess(self.page.stat().st_size, 12 * MEGABYTE)
        self.assertEqual(len([d for d in page.all("details") if d["class"] == "horizon"]), 200)
        self.assertEqual(len([image for image in page.all("img") if image["alt"]]), 4 * album.MOST_PICTURED)
        self.assertIn("for the 12 horizons with the most points, of 200.", page.text())
        self.assertEqual(len([row for row in page.all("th") if "data-value" in row]), 200)
        self.assertIn("filter", [attributes.get("id") for attributes in page.all("input")])

    def test_album(self):
        """What does not fit goes: the largest meshes, and pictures of the smallest horizons."""
        points = pipeline.read(SAMPLE)[0]
        results = [pipeline.run("sample", name, own, pipeline.Settings(error={})) for name, own in points]
        with mock.patch.multiple(album, MOST_PICTURED=1, MOST_THUMBNAILS=2):
            few = album.Album(True)
            for result in results:
                few.add(result, 0)
        self.assertEqual([bool(entry.pictures) for entry in few.entries], [True, False, False])
        self.assertEqual([bool(entry.thumbnail) for entry in few.entries], [True, True, False])
        self.assertTrue(all(entry.mesh for entry in few.entries))
        sizes = [len(entry.mesh.content) for entry in few.entries]
        with mock.patch.object(album, "MESH_BYTES", sum(sizes) - 1):
            small = album.Album(False)
            for result in results:
                small.add(result, 0)
        self.assertEqual([entry.mesh is None for entry in small.entries], [size == max(sizes) for size in sizes])
        small.cut(1)
        self.assertEqual(len(small.entries), 1)

    def test_mesh_of_a_page(self):
        """The bytes are those of the mesh: places to single precision, and all corners."""
        (name, points), = pipeline.read(SAMPLE, horizons=[2])[0]
        mesh = pipeline.run("sample", name, points, pipeline.Settings(surface={"MaximumError": 1.0})).data["mesh"]
        coded = album.encode(mesh)
        places = np.frombuffer(coded.content, "<f4", 3 * coded.points).reshape(-1, 3) + coded.center
        np.testing.assert_allclose(places, mesh["places"], atol=1e-5)
        self.assertEqual((coded.error_on, coded.triangles), ("triangles", data.count_polygons(mesh)))
        errors = np.frombuffer(coded.content, "<f4", coded.triangles, 12 * coded.points)
        self.assertAlmostEqual(errors.max(), data.value(mesh, "LargestError"), 5)
        corners = np.frombuffer(coded.content, "<u2", -1, 12 * coded.points + 4 * coded.triangles)
        offsets, expected = mesh["polygons"]
        np.testing.assert_array_equal(np.diff(offsets), 3)
        np.testing.assert_array_equal(corners, expected)

    def test_maps_of_layers(self):
        """The volume below a map is that of the layer, of wedges, pyramids and tetrahedra; its picture names both ends."""
        rows, columns = np.mgrid[:30, :40].astype(float)
        path = self.folder / "horizons.dat"
        sh.write({"Top": sh.horizon(100.0 + 0 * rows), "Base": sh.horizon(95.0 + np.hypot(rows - 12.3, columns - 21.7) * 0.8)}, path)
        made, _ = volumes.of_points(dict(pipeline.read(path, VerticalStep=1.0)[0]), pipeline.Settings(
            layers={"MaximumError": 0.5, "Order": "AsGiven", "Crossings": "UpperWins"}), path.name)
        self.assertGreater(made.figures["Top to Base"].tetrahedra, 0)
        self.assertGreater(made.figures["Top to Base"].pyramids, 0)
        plan = album.plan_of(made.cells, 0)
        thickness = plan["point_data"]["Thickness"].reshape(-1, 3)
        np.testing.assert_array_equal(plan["polygons"][1], np.arange(len(plan["places"])))
        sides = np.diff(plan["places"].reshape(-1, 3, 3)[:, :, :2], axis=1)
        areas = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]) / 2.0
        self.assertEqual(len(areas), len(made.cells["types"]))
        self.assertAlmostEqual(np.sum(areas * thickness.mean(axis=1)), made.figures["Top to Base"].volume, 6)
        self.assertEqual(data.count_points(album.plan_of(made.cells, 1)), 0)
        pictured = album.Album(True)
        pictured.add_layers(made)
        (bodies, map_of_layer), = (entry.pictures for entry in pictured.layers)
        self.assertIsNone(bodies.scale_ends)
        np.testing.assert_allclose(map_of_layer.scale_ends, (0.0, made.figures["Top to Base"].thickness_largest))

    def test_angles(self):
        """Their smallest is what the mesh itself tells, and each triangle is counted."""
        self.assertIsNone(figures.angles(pipeline.read_first(SAMPLE)))
        for name, points in pipeline.read(SAMPLE, ColumnStep=[3.0, 1.0], RowStep=[-2.0, 9.0], Origin=[1e6, 2e6, 0.0])[0]:
            mesh = pipeline.run("sample", name, points, pipeline.Settings()).data["mesh"]
            angles = figures.angles(mesh)
            self.assertAlmostEqual(angles["smallest"], data.value(mesh, "SmallestAngle"), 6)
            self.assertEqual(sum(angles["counts"]), data.count_polygons(mesh))

    def test_histogram(self):
        drawing = charts.histogram("T", "c", [3, 0, 1], 6.0, "m")
        self.assertEqual(drawing.count("M"), 2 + 2)  # rules, and bars of what there is
        self.assertIn("75 %", drawing)
        self.assertEqual(charts.round_steps(6.0), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
        self.assertEqual(charts.round_steps(0.0), [0.0])
        for high in (0.013, 0.7, 1.0, 2.3, 99.0, 1234.5):
            self.assertTrue(3 <= len(charts.round_steps(high)) <= 7, high)

    def test_larger_than_memory(self):
        """A horizon whose rows are read is not measured, and the page says so; nothing else is missing."""
        settings = pipeline.Settings(surface=pipeline.surface_properties(largest_error=1.0), error={}, error_if_whole=True,
                                     memory=memory.WORKED * 4000)
        run = record.Record(lambda *told: ledger_check.is_warning(told[1]) or self.fail(told), True, report.make_album(True))
        with mock.patch.multiple(memory, SPARE=0, _resident=lambda: 0):
            batch.run([SAMPLE], self.folder, settings, False, run, prints=False)
        page = Page(report.make(run.as_values(), run.album))
        self.assertIn("not measured: the horizons are larger than memory.", page.text())
        self.assertIn("on average; at outlines at most", page.text())
        self.assertEqual([image["alt"].split(";")[0] for image in page.all("img") if image["alt"].startswith("Mesh")][:1],
                         ["Mesh of Horizon 1: 6,282 points, %d triangles" % run.files[0]["horizons"][0]["triangles"]])
        self.assertFalse(pipeline.Settings(surface={}, error={}).can_go_by_rows())

    def write_fault(self):
        path = self.folder / "fault.pol"
        path.write_text("20.5 -9 0\n20.5 900 0\n", encoding="ascii")
        return path

    def test_json(self):
        """One object with the documented keys, and the figures of the meshes; nothing else is printed."""
        picks = write_picks(self.folder / "picks.dat", ["A", "B"])
        done = self.run_program("--json", "--no-pictures", "--measure-error", "--layers", "--largest-error", "0.75", "--fault-lines", self.write_fault(), "--", picks, SAMPLE)
        run = json.loads(done.stdout)
        self.assertEqual(done.stderr.splitlines(), ["horizon_mesh: warning: " + text for file in run["files"] for text in file["warnings"]])
        keys = keys_of(run)
        empty = {key for key in keys if any(other.startswith(key + "[].") for other in keys)}  # lists of nothing beside full ones
        self.assertEqual(keys - empty, documented_keys(PAGE.read_text(encoding="utf-8")))
        self.assertEqual([len(file["horizons"]) for file in run["files"]], [2, 3])
        first = run["files"][1]["horizons"][0]
        self.assertEqual((first["name"], first["points_in"], first["patches"]), ("Horizon 1", 6282, 5))  # one is cut in two
        self.assertEqual(sum(first["angles"]["counts"]), first["triangles"])
        self.assertEqual(sum(first["distances"]["counts"]), 6282)
        self.assertLess(first["error"]["lattice"]["mean"], first["error"]["lattice"]["largest"])
        self.assertEqual([name for name in run["files"][1]["results"][1:] if "layer" not in name],
                         ["blobs_horizon_%d.vtp" % n for n in (1, 2, 3)])
        self.assertEqual([own["name"] for own in run["files"][1]["layers"]], ["Horizon 1 to Horizon 2", "Horizon 2 to Horizon 3"])
        self.assertEqual(run["files"][0]["survey"]["lattice"]["columns"][:2], [12, 10])
        self.assertEqual(run["command"]["words"][1:], done.args[1:])

    def test_closed_faults(self):
        """Triangles that close faults are no part of any figure but their own number."""
        inside = write_fault(self.folder / "inside.vsm")
        across = write_voxels(self.folder / "across.vsm", lambda i, j: 30 if i < 20 else 50)
        for path, target in ((inside, ["--stages", "--skip-rough"]), (across, ["--largest-error", "0.5"])):
            figures_of = []
            for closing in ([], ["--close-faults"]):
                done = self.run_program("--json", "--no-pictures", "--cut-faults", "3", "--measure-error", *target, *closing,
                                        path)
                horizon = json.loads(done.stdout)["files"][0]["horizons"][0]
                figures_of.append({key: value for key, value in horizon.items() if key != "seconds"})
            counts = [values.pop("fault_triangles") for values in figures_of]
            self.assertEqual(counts[0], 0)
            self.assertGreaterEqual(counts[1], 2)
            self.assertEqual(*figures_of)
            self.assertEqual(sum(figures_of[1]["angles"]["counts"]), figures_of[1]["triangles"])
        # Two halves of 19 times 39 columns; what is between them would have 1.5 degrees.
        self.assertAlmostEqual(figures_of[1]["angles"]["smallest"], math.degrees(math.atan2(19, 39)), 6)

    def test_page_of_closed_faults(self):
        """Their number stands alone in a tile, a column, with the facts and below the picture; other pages are silent."""
        path = write_fault(self.folder / "fault.vsm")
        arguments = ("--cut-faults", "3", "--largest-error", "0.5", path)
        open_page, closed_page = self.run_report(*arguments), self.run_report("--close-faults", *arguments)
        (horizon,) = json.loads(self.run_program("--json", "--no-pictures", "--close-faults", *arguments).stdout)[
            "files"][0]["horizons"]
        self.assertEqual(closed_page.texts.count("Fault triangles"), 3)
        self.assertIn("Fault triangles %d" % horizon["fault_triangles"], closed_page.text())
        self.assertIn("%d triangles, %d fault triangles" % (horizon["triangles"], horizon["fault_triangles"]),
                      closed_page.text())
        self.assertIn("triangles that close faults", closed_page.text())
        self.assertNotIn("ault triangle", open_page.text())
        self.assertNotIn("close faults", open_page.text())

    def test_exit_codes(self):
        """0 when all is done; 1 when something is not, which JSON tells of as well; 2 for a wrong command line."""
        wrong = self.folder / "wrong.vsm"
        wrong.write_text("1 1\n")
        run = json.loads(self.run_program("--json", "--no-pictures", "--horizons", "1", "--", SAMPLE).stdout)
        self.assertEqual((run["done"], run["error"], run["files"][0]["status"]), (True, None, "done"))
        run = json.loads(self.run_program("--json", "--no-pictures", wrong, SAMPLE, code=1).stdout)
        self.assertEqual([file["status"] for file in run["files"]], ["failed", "done"])
        self.assertIn("wrong.vsm", run["files"][0]["error"])
        run = json.loads(self.run_program("--json", self.folder / "no", SAMPLE, code=1, DISPLAY=":4711").stdout)
        self.assertEqual([file["status"] for file in run["files"]], ["failed", "done"])
        self.assertEqual(self.run_program("--json", "--no-such-option", SAMPLE, code=2).stdout, "")

    def test_report_that_can_not_be_written(self):
        """Noticed before any work."""
        for place, words in ((self.folder, "it is a folder"), (self.folder / "no" / "page.html", "is not a writable folder")):
            done = self.run_program("--report", place, SAMPLE, code=1)
            self.assertRegex(done.stderr, "^horizon_mesh: error: .*%s" % words)
            self.assertFalse((self.folder / "results").exists())
        self.assertEqual(len(list(self.folder.iterdir())), 0)


if __name__ == "__main__":
    unittest.main(argv=["report_test"], verbosity=2)
