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
import seismichorizons as sh
from seismichorizons_command import cubes, options, pipeline, reading
from seismichorizons_command.core import HorizonError
from seismichorizons_command.data import count_points, values

GENERATOR, PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
CUBE = FOLDER / "survey.sgy"
# The fault cuts each of the reflectors in two.
REFLECTORS = 6
SURFACES = 2 * REFLECTORS


# Properties of the classes that only the window needs: its image is drawn, and world z is real.
OF_WINDOW = {"FileName", "ImageTolerance", "ThresholdType", "ZFrom"}


def write_line(path, count=120, samples=200):
    """A line with a bend and two reflectors, with trace numbers and positions, by revision 1 of SEG-Y. Returns positions."""
    header = np.zeros(3600, np.uint8)
    for byte, value in ((3217, 4000), (3221, samples), (3225, 5)):
        header[byte - 1:byte + 1] = value >> 8, value & 255
    header[3500] = 1
    trace = np.zeros(count, np.dtype({"names": ["number", "kind", "scalar", "x", "y", "samples", "values"], "formats": [
        ">i4", ">i2", ">i2", ">i4", ">i4", ">i2", (">f4", samples)], "offsets": [20, 28, 70, 180, 184, 114, 240]}))
    n, k = np.arange(count), np.arange(samples)
    places = np.column_stack((1000 + 10 * n, 9000 + 10 * np.maximum(0, n - 60)))
    trace["number"], trace["kind"], trace["scalar"], trace["samples"] = 500 + n, 1, -10, samples
    trace["x"], trace["y"] = 10 * places.T
    away = k - (80 + 10 * np.sin(n / 20.0))[:, None]
    trace["values"] = sum(size * np.exp(-((away - shift) / 4) ** 2) * np.cos((away - shift) / 2) for size, shift in ((1, 0), (0.3, 60)))
    path.write_bytes(header.tobytes() + trace.tobytes())
    return places


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

    def test_every_property_of_the_window_is_an_option(self):
        from seismichorizons import vtk

        own = {name for group in (cubes.READER, cubes.FRAME, cubes.EXTRACTION) for name in group}
        for make in (vtk.vtkSEGYCubeReader, vtk.vtkSeismicReflectionExtraction):
            of_class = {name[3:] for name in dir(make) if name.startswith("Set") and hasattr(make, "Get" + name[3:])} - {
                name[3:] for name in dir(make.__mro__[1]) if name.startswith("Set")}
            self.assertEqual({name for name in of_class if not name.startswith("Input")} - own - OF_WINDOW, set())
        self.assertLessEqual(set(options.CUBE_PROPERTIES), own)

    def test_properties_without_an_option_of_their_own(self):
        folder = FOLDER / "properties"
        done = run("--formats", "dat", "--surfaces", "1", "-o", folder, "--cube", "SampleRange=0:60", "InlineByte=189", "CrosslineByte=193",
                   "Position=ZeroCrossing", "Connectivity=Eight", "DelayPolicy=Nearest", "KeepOthers=off", CUBE)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = sh.extract(sh.read_cube(CUBE, sample_range=(0, 60), inline_byte=189, crossline_byte=193, delays="nearest"), largest_number=1,
                           position="zero_crossing", eight_neighbours=True)
        written = sh.read(folder / "survey_horizon_1.dat")
        self.assertTrue(np.allclose(next(iter(written.values())).z, next(iter(found.values())).z))
        for given, message in (("InlineByte=300,CrosslineByte=9", "--cube InlineByte 300, expected 1 to 237"),
                               ("InlineByte=x,CrosslineByte=9", "inline_byte 'x', expected another kind of value"),
                               ("SampleRange=5", "sample_range '5', expected another kind of value"),
                               ("InlineByte=1.5", "inline_byte '1.5', expected another kind of value"),
                               ("Position=Top", r"survey.sgy: position 'top', expected middle, peak or zero_crossing"),
                               ("AmplitudeThreshold=-1", "AmplitudeThreshold -1, expected")):
            self.assertRegex(self.refused("--cube", given, CUBE), message)
        self.assertRegex(run("--cube", "Wrong=1", CUBE).stderr, "invalid choice: 'Wrong=1'")
        self.assertRegex(run("--cube", "XByte", CUBE).stderr, "invalid choice: 'XByte'")

    def test_units(self):
        """Guides, limits and horizons with z in another unit than the cube are refused, and lines of the lattice are ranges."""
        cube = sh.read_cube(CUBE)
        first, step = cube.lattice.lines[:2]
        self.assertEqual(sh.read_cube(CUBE, inlines=(first, first + 2.0 * step)).lattice.shape[0], 3)
        seconds = sh.horizon(np.full(cube.lattice.shape, 0.2), vertical_unit="s")
        for call in (lambda: sh.extract(cube, seconds), lambda: sh.extract(cube, limits=[seconds]), lambda: sh.amplitudes(cube, seconds)):
            with self.assertRaisesRegex(ValueError, "z in s, and a cube in ms"):
                call()

    def test_a_line_is_written_as_picks_where_its_traces_are(self):
        path, folder = FOLDER / "line.sgy", FOLDER / "line"
        places = write_line(path)
        for formats, is_refused in (("dat", False), ("dat,ts", False), ("ts", True)):
            done = run("--surfaces", "2", "--formats", formats, "-o", folder, "--report", FOLDER / "line.html", path)
            self.assertEqual(done.returncode, int(is_refused), done.stderr)
            self.assertEqual("is left out" in done.stderr, formats != "dat")
            self.assertEqual("; --formats dat writes the points" in done.stderr, is_refused)
            self.assertFalse(list(folder.glob("*.ts")))
        picks = np.loadtxt(folder / "line_horizon_1.dat", comments="#")
        self.assertEqual(len(picks), len(places))
        self.assertTrue(np.array_equal(picks[:, 1], 500 + np.arange(len(places))))
        self.assertTrue(np.array_equal(picks[:, 2:4], places))
        self.assertLess(np.abs(picks[:, 4] - 4.0 * (80 + 10 * np.sin(np.arange(len(places)) / 20.0))).max(), 1.0)
        sh.write(sh.extract(sh.read_cube(path), largest_number=1)["Horizon 1"], FOLDER / "line.dat")
        self.assertTrue(np.array_equal(np.loadtxt(FOLDER / "line.dat", comments="#")[:, :5], picks[:, :5]))

    def test_what_a_cube_was_taken_for_is_said(self):
        self.assertIn("ms, taken as time; set --vertical-unit for depth", run("-o", FOLDER / "said", CUBE).stdout)
        self.assertNotIn("taken as time", run("-o", FOLDER / "said", "--vertical-unit", "m", CUBE).stdout)
        self.assertIn("set vertical_unit for depth", sh.read_cube(CUBE).taken[-1])

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
