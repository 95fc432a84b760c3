# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""From a seismic cube to meshes: the batch program and the package. Arguments: the generator of cubes, the batch program,
and a folder for files."""

import pathlib
import shutil
import subprocess
import sys
import unittest
from itertools import filterfalse

import numpy as np

import ledger_check
import mesh_checks
from seismichorizons_command import cubes, pipeline, reading
from seismichorizons_command.core import HorizonError
from seismichorizons_command.data import count_points, values

GENERATOR, PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
CUBE = FOLDER / "survey.sgy"
# The fault cuts each of the reflectors in two.
REFLECTORS = 6
SURFACES = 2 * REFLECTORS


def run(*arguments):
    return subprocess.run([sys.executable, str(PROGRAM), "--no-pictures", *map(str, arguments)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100)


class CubeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        subprocess.run([GENERATOR, CUBE], check=True, stdout=subprocess.PIPE)

    def refused(self, *arguments):
        done = run("--output-folder", FOLDER / "refused", *arguments)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertFalse((FOLDER / "refused").exists())
        return done.stderr

    def test_meshes_are_those_of_reader_extraction_and_surface(self):
        folder = FOLDER / "meshes"
        done = run("--largest-error", "1", "--surfaces", "4", "--output-folder", folder, CUBE)
        self.assertEqual((done.returncode, list(filterfalse(ledger_check.is_warning, done.stderr.splitlines()))), (0, []))
        self.assertEqual(sorted(p.name for p in folder.iterdir()), ["survey_horizon_%d.vtp" % n for n in (1, 2, 3, 4)])
        horizons, _ = pipeline.read(CUBE)
        self.assertGreaterEqual(len(horizons), SURFACES)
        self.assertLessEqual(len(horizons), cubes.LARGEST_NUMBER)
        energies = [(points["point_data"]["Amplitude"] ** 2).sum() for _, points in horizons]
        self.assertEqual(max(energies), energies[0])
        self.assertGreater(energies[0], 2.0 * energies[-1])
        for number, (name, points) in enumerate(horizons[:4]):
            self.assertEqual(name, "Horizon %d" % (number + 1))
            settings = pipeline.Settings(surface=pipeline.surface_properties(largest_error=1.0))
            mesh = pipeline.run(CUBE.name, name, points, settings).data["mesh"]
            written = mesh_checks.read(folder / ("survey_horizon_%d.vtp" % (number + 1)))
            self.assertTrue(np.array_equal(mesh_checks.coordinates(written), mesh["places"]))
            self.assertEqual(mesh_checks.array(written, "PointCount").sum(), count_points(points))

    def test_choices(self):
        everything, _ = reading.read(CUBE)
        two, _ = reading.read(CUBE, horizons=["3", "1"])
        self.assertEqual([name for name, _ in two], ["Horizon 1", "Horizon 3"])
        self.assertEqual(count_points(two[1][1]), count_points(everything[2][1]))
        # With the polarity, there are fewer picks; with the reader's window, fewer traces.
        positive, _ = reading.read(CUBE, Polarity="Positive", SmallestSize=500)
        self.assertTrue(all(count_points(points) >= 500 for _, points in positive))
        self.assertTrue(all((points["point_data"]["Amplitude"] > 0.0).all() for _, points in positive))
        first = int(values(everything[0][1], "LineNumbers")[0])
        lines = int(values(everything[0][1], "LatticeDimensions")[1])
        part, _ = reading.read(CUBE, InlineRange=(first, first + lines // 4))
        self.assertLess(count_points(part[0][1]), count_points(everything[0][1]))

    def test_errors_are_those_of_the_reader(self):
        for name, content in (("cut.sgy", CUBE.read_bytes()[:5000]), ("text.segy", b"no cube\n"), ("empty.sgy", b"")):
            (FOLDER / name).write_bytes(content)
            message = self.refused(FOLDER / name)
            self.assertIn(name, message)
            self.assertRegex(message, r"a file (of|that ends) \d+ bytes")

    def test_errors_of_choices(self):
        self.assertRegex(self.refused("--origin", "0", "0", "0", CUBE), "a seismic cube does not support --origin")
        self.assertRegex(self.refused("--horizons", "1", "70", "--", CUBE), "there is no horizon 70; the file has 1, 2, ")
        self.assertRegex(self.refused("--memory", "1M", CUBE), r"a cube that takes [\d.]+M with its picks, expected at most")
        self.assertRegex(self.refused("--inlines", "-9", "-8", CUBE), "--inlines -9 to -8, expected some of the lines")
        self.assertRegex(self.refused("--smallest-surface", "1000000", CUBE), "no points")
        with self.assertRaisesRegex(HorizonError, "a seismic cube does not support Wrong"):
            reading.open_file(CUBE, Wrong=1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
