# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Reports in a browser: they open without a complaint, sort, find, print, and turn their meshes. Skips itself where
Chromium or its driver is not installed. Needs an X server.

Arguments: the program, the folder of the data, a work folder.
"""

import base64
import pathlib
import shutil
import subprocess
import sys
import unittest

import browser
import image_compare
import numpy as np

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SKIPPED = 77
BAD_NAME = "<img src=x onerror=window.broken=1>"
# Calls back once what was asked for is drawn.
DRAWN = """const done = arguments[0];
requestAnimationFrame(() => requestAnimationFrame(() => done(document.getElementById("viewer-canvas").dataset.triangles)));"""
CHANGE = """const element = document.getElementById(arguments[0]);
element[arguments[1]] = arguments[2];
element.dispatchEvent(new Event(arguments[3]));"""
COLUMN = "return Array.from(document.querySelectorAll('#table tbody tr:not([hidden])'), (row) => row.cells[arguments[0]].innerText)"


def write_picks(path):
    """Twenty horizons, the later ones with more points, and one with a name that is no good."""
    names = ["Top %d" % n for n in range(1, 20)] + [BAD_NAME]
    path.write_text("".join('"%s"\t%d\t%d\t%.1f\t%.1f\t%.2f\n' % (
        name, j, i, 459600 + 25 * i, 5934800 + 25 * j, 1500 + 30 * n + (i * j) % 7)
        for n, name in enumerate(names) for j in range(8) for i in range(8 + n)), encoding="utf-8")


def write_step(path):
    """A fault across a horizon."""
    path.write_text("20 20 50\n" + 20 * (10 * "10 1 1 1 1\n" + 10 * "30 1 1 1 1\n"), encoding="utf-8")


def make_report(page, *arguments):
    subprocess.run([sys.executable, str(PROGRAM), "--output-folder", str(FOLDER / "results"), "--report", str(page),
                    *map(str, arguments)], check=True, stdout=subprocess.DEVNULL, timeout=200)


class BrowserTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.sample, cls.picks = FOLDER / "sample.html", FOLDER / "picks.html"
        make_report(cls.sample, "--largest-error", "0.75", DATA / "blobs.vsm")
        write_picks(FOLDER / "picks.dat")
        make_report(cls.picks, "--no-pictures", "--largest-error", "2", FOLDER / "picks.dat")
        cls.closed = FOLDER / "closed.html"
        write_step(FOLDER / "step.vsm")
        make_report(cls.closed, "--no-pictures", "--largest-error", "0.5", "--cut-faults", "4", "--close-faults",
                    FOLDER / "step.vsm")
        cls.browser = cls.enterClassContext(browser.Browser())

    def open(self, page):
        self.browser.open(page)
        self.assertEqual(self.browser.messages(), [])

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [])

    def change(self, element, name, value, event="change"):
        self.browser.run(CHANGE, element, name, value, event)
        return int(self.browser.wait(DRAWN))

    def canvas(self):
        """What is drawn, as an array of pixels."""
        path = FOLDER / "canvas.png"
        path.write_bytes(self.browser.picture("#viewer-canvas"))
        return np.asarray(image_compare.load(path)).astype(int)

    def test_mesh_is_drawn(self):
        """All meshes of the file, which fill a good part of the picture in many colours."""
        self.open(self.sample)
        self.assertGreater(int(self.browser.wait(DRAWN)), 500)
        pixels = self.canvas()
        colorful = np.ptp(pixels[..., :3], axis=-1) > 40
        self.assertTrue(0.1 < colorful.mean() < 0.7, colorful.mean())
        self.assertGreater(len(np.unique(pixels[colorful] // 16, axis=0)), 50)
        self.assertFalse(colorful[:8].any() or colorful[:, :8].any(), "the mesh is cut off")
        self.assertTrue(self.browser.run("return document.getElementById('viewer-failure').hidden"))

    def test_mesh_follows_its_controls(self):
        """One horizon alone has fewer triangles; edges, colours, heights and turning all change the picture."""
        self.open(self.sample)
        before = int(self.browser.wait(DRAWN))
        alone = self.change("viewer-choice", "value", "1")
        self.assertLess(alone, before)
        known = [self.canvas()]
        self.assertEqual(self.change("viewer-edges", "checked", True), alone)  # edges are lines, and do not count
        known.append(self.canvas())
        self.change("viewer-edges", "checked", False)
        self.change("viewer-colors", "value", "error")
        known.append(self.canvas())
        self.assertIn("each triangle", self.browser.run("return document.getElementById('viewer-unit').innerText"))
        self.change("viewer-heights", "value", "2", "input")
        known.append(self.canvas())
        self.browser.run("document.getElementById('viewer-canvas').dispatchEvent(new KeyboardEvent('keydown',"
                         "{key: 'ArrowLeft'}))")
        self.browser.wait(DRAWN)
        known.append(self.canvas())
        for first, second in zip(known, known[1:]):
            self.assertGreater((np.abs(first - second).max(axis=-1) > 20).mean(), 0.01)
        self.browser.run("document.getElementById('viewer-reset').click()")
        self.change("viewer-colors", "value", "height")
        self.assertLess((np.abs(known[0] - self.canvas()).max(axis=-1) > 20).mean(), 0.001)

    def test_closed_faults(self):
        """What closes them has a colour of its own, which is neither that of a height nor of an error, and a legend."""
        self.open(self.closed)
        self.assertEqual(int(self.browser.wait(DRAWN)), 2 + 2 + 2)
        legend = "const legend = document.getElementById('viewer-faults'); return legend && legend.innerText.trim()"
        self.assertEqual(self.browser.run(legend), "triangles that close faults")
        red, green, blue = np.moveaxis(self.canvas()[..., :3], -1, 0)
        self.assertGreater(((red > 1.5 * green) & (red > 1.3 * blue)).mean(), 0.01)
        self.change("viewer-colors", "value", "error")
        red, _, blue = np.moveaxis(self.canvas()[..., :3], -1, 0)
        self.assertGreater((blue > 1.1 * red + 10).mean(), 0.01)
        self.open(self.sample)
        self.assertIsNone(self.browser.run(legend))

    def test_button_of_a_horizon(self):
        self.open(self.sample)
        self.browser.run("document.querySelector('[data-turn=\"2\"]').click()")
        self.browser.wait(DRAWN)
        self.assertEqual(self.browser.run("return document.getElementById('viewer-choice').value"), "2")

    def test_without_webgl(self):
        """The page says so in place of the meshes, and all else is there."""
        with browser.Browser("--disable-3d-apis") as plain:
            plain.open(self.sample)
            self.assertIn("need JavaScript and WebGL", plain.run("return document.getElementById('meshes').innerText"))
            self.assertTrue(plain.run("return document.getElementById('viewer').hidden"))
            plain.run("document.querySelectorAll('#table thead button')[1].click()")
            self.assertEqual(plain.run("return document.querySelectorAll('[aria-sort]').length"), 1)

    def test_table_sorts(self):
        """Numbers from the largest on first, then the other way; names as numbers in them count."""
        self.open(self.picks)
        points = [8 * (8 + n) for n in range(20)]
        heads = "document.querySelectorAll('#table thead button')"
        for direction, order in (("descending", points[::-1]), ("ascending", points)):
            self.browser.run(heads + "[1].click()")
            self.assertEqual([int(text) for text in self.browser.run(COLUMN, 1)], order)
            self.assertEqual(self.browser.run("return " + heads + "[1].parentElement.ariaSort"), direction)
        self.browser.run(heads + "[0].click()")
        self.assertEqual(self.browser.run(COLUMN, 0), [BAD_NAME] + ["Top %d" % n for n in range(1, 20)])
        self.assertEqual(self.browser.run("return document.querySelectorAll('[aria-sort]').length"), 1)

    def test_names_are_found(self):
        self.open(self.picks)
        self.change("filter", "value", "TOP 1", "input")
        self.assertEqual(sorted(self.browser.run(COLUMN, 0)), sorted(["Top 1"] + ["Top %d" % n for n in range(10, 20)]))
        self.assertEqual(self.browser.run("return document.getElementById('filtered').innerText"), "11 of 20")

    def test_links_open_details(self):
        self.open(self.picks)
        self.browser.run("document.querySelector('a[href=\"#horizon-7\"]').click()")
        self.assertTrue(self.browser.wait("const d = arguments[0]; setTimeout(() => d("
                                          "document.getElementById('horizon-7').open), 100)"))

    def test_names_are_text(self):
        """Nothing of them runs; and even what got into the page may not, nor ask for anything from elsewhere."""
        self.open(self.picks)
        self.assertIn(BAD_NAME, self.browser.run("return document.body.innerText"))
        self.assertIsNone(self.browser.run("return window.broken ?? null"))
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map((e) => e.name).filter("
                                          "(name) => !name.startsWith('data:'))"), [])
        self.browser.run("document.body.insertAdjacentHTML('beforeend', arguments[0])", BAD_NAME)
        refused = self.browser.wait("const done = arguments[0]; setTimeout(() => done(window.broken ?? null), 200)")
        self.assertIsNone(refused)
        self.assertTrue(all("Content Security Policy" in text for text in self.browser.messages()))

    def test_dark(self):
        self.open(self.sample)
        shades = []
        for scheme in ("light", "dark"):
            self.browser.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            color = self.browser.run("return getComputedStyle(document.body).backgroundColor")
            shades.append(sum(int(part) for part in color[4:-1].split(",")))
        self.browser.command("Emulation.setEmulatedMedia", features=[])
        self.assertGreater(shades[0], 700)
        self.assertLess(shades[1], 100)

    def test_print(self):
        """On paper details are open, nothing turns, and everything fits into a few pages."""
        self.open(self.sample)
        paper = base64.b64decode(self.browser.command("Page.printToPDF", printBackground=True)["data"])
        self.assertTrue(paper.startswith(b"%PDF"))
        self.assertIn(paper.count(b"/Type /Page\n"), range(3, 9))
        self.assertFalse(self.browser.run("return document.getElementById('horizon-0').open"))


if __name__ == "__main__":
    lacking = browser.missing()
    if lacking:
        print("SKIPPED: not installed: %s" % ", ".join(lacking))
        sys.exit(SKIPPED)
    unittest.main(argv=["browser_test"], verbosity=2)
