# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that gzip compressed, of all formats: what is read is the same, and results have the names of the files within.

Argument: a folder for the files.
"""

import contextlib
import gzip
import io
import pathlib
import resource
import struct
import sys
import unittest

from seismichorizons import _core
from seismichorizons.vtk import make, update
from seismichorizons_command import batch, core, pipeline, reading, record
from seismichorizons_command.core import HorizonError
from vtkmodules.vtkCommonMisc import vtkErrorCode

MATRIX = b"3 2 9\n1 1 1 1 1\n2 1 1 2 2\n3 1 1 3 3\n4 1 1 4 4\n5 1 1 5 5\n6 1 1 6 6\n"
PICKS = b"".join(b"%.1f %.1f %d\n" % (100.5 + 25 * i, 200.5 + 25 * j, 1000 + i * j) for j in range(6) for i in range(5))
GRID = b"-996 2 25.0 25.0\n0 50 0 25\n3 0.0 0.0 0.0\n0 0 0 0 0 0 0\n1 2 3 4 5 6\n"
SURFACE = b"GOCAD TSurf 1\nHEADER {\nname:Top\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"
FAULTS = b"100 200 10\n110 210 11\n999 999 999\n120 220 12\n130 200 13\n"


def records(*contents):
    """Those of Fortran."""
    return b"".join(struct.pack(">i", len(content)) + content + struct.pack(">i", len(content)) for content in contents)


# Of these, readers need no byte behind the last value: others may follow. Larger than what is looked at to recognise them.
SIDE = 300
VALUES = [k % 97 for k in range(SIDE * SIDE)]
IRAP = records(struct.pack(">ii6f", -996, SIDE, 0, SIDE - 1, 0, SIDE - 1, 1, 1), struct.pack(">i3f", SIDE, 0, 0, 0), bytes(28),
               *(struct.pack(">%df" % SIDE, *VALUES[k:k + SIDE]) for k in range(0, SIDE * SIDE, SIDE)))
SURFER7 = (b"DSRB" + struct.pack("<ii", 4, 2) + b"GRID" + struct.pack("<iii8d", 72, SIDE, SIDE, 0, 0, 1, 1, 0, 96, 0, 1e30)
           + b"DATA" + struct.pack("<i%dd" % (SIDE * SIDE), 8 * SIDE * SIDE, *VALUES))
SURFER6 = b"DSBB" + struct.pack("<hh6d6f", 3, 2, 0, 50, 0, 25, 1, 6, 1, 2, 3, 4, 5, 6)
STORM = b"STORMGRID_BINARY\n\n3 2 25 25\n0 50 0 25\n" + struct.pack(">6d", 1, 2, 3, 4, 5, 6)
# The class of VTK that reads each of them.
FILES = (("map.gri", IRAP, "vtkHorizonGridReader"), ("map7.grd", SURFER7, "vtkHorizonGridReader"),
         ("map6.grd", SURFER6, "vtkHorizonGridReader"), ("map.storm", STORM, "vtkHorizonGridReader"),
         ("faults.dat", FAULTS, "vtkFaultLinesReader"), ("a.vsm", MATRIX, "vtkVerneySparseMatrixReader"),
         ("picks.xyz", PICKS, "vtkHorizonTextReader"),
         ("map.irap", GRID, "vtkHorizonGridReader"), ("top.ts", SURFACE, "vtkGOCADTSurfReader"))

FOLDER = pathlib.Path(sys.argv[1]).resolve()


def write(name, content):
    path = FOLDER / name
    path.write_bytes(content)
    return path


def load(path, class_name):
    """The names and points of the horizons of a file."""
    reader = make(class_name, FileName=str(path))
    update(reader)
    output = reader.GetOutput()
    if class_name == "vtkFaultLinesReader":
        return ["faults"], [[output.GetPoint(n) for n in range(output.GetNumberOfPoints())]]
    blocks = [output.GetPartition(n, 0) for n in range(output.GetNumberOfPartitionedDataSets())]
    names = [reader.GetHorizonName(n) for n in range(reader.GetNumberOfHorizons())]
    return names, [[block.GetPoint(n) for n in range(block.GetNumberOfPoints())] for block in blocks]


def load_for_command(path, class_name):
    """The same as the command reads it."""
    if class_name == "vtkFaultLinesReader":
        with core.errors("%s: " % path):
            return ["faults"], [core.run(_core.read_fault_lines, [str(path)], {}, "")[0]["places"].tolist()]
    found, _ = reading.read(path)
    return [name for name, _ in found], [points["places"].tolist() for _, points in found]


class CompressedFiles(unittest.TestCase):
    def test_all_formats(self):
        for name, content, class_name in FILES:
            with self.subTest(name):
                plain = write(name, content)
                compressed = write(name + ".gz", gzip.compress(content[:40]) + gzip.compress(content[40:]))
                if class_name != "vtkFaultLinesReader":
                    self.assertEqual(make(class_name).CanReadFile(str(compressed)), 1)
                    self.assertIsNotNone(reading.find_format(compressed))
                    self.assertEqual(reading.find_format(compressed), reading.find_format(plain))
                names, points = load(plain, class_name)
                self.assertEqual(load(compressed, class_name), (names, points))
                self.assertEqual(load_for_command(compressed, class_name), load_for_command(plain, class_name))
                self.check_same_points(load_for_command(compressed, class_name), (names, points), class_name)
                self.assertEqual(names, {"a.vsm": ["Horizon 1"], "top.ts": ["Top"]}.get(name, [plain.stem]))
                self.assertGreaterEqual(len(points[0]), 3)

    def check_same_points(self, found, expected, class_name):
        """Surfaces are those of the file for VTK, and columns under them for the command."""
        self.assertEqual(found[0], expected[0])
        if class_name != "vtkGOCADTSurfReader":
            self.assertEqual(found[1], [list(map(list, points)) for points in expected[1]])

    def test_recognised_by_content(self):
        matrix = make("vtkVerneySparseMatrixReader")
        self.assertEqual(matrix.CanReadFile(str(write("some.dat", gzip.compress(MATRIX)))), 1)
        self.assertEqual(matrix.CanReadFile(str(write("text.dat", gzip.compress(b"dear all\n")))), 0)
        self.assertEqual(matrix.CanReadFile(str(write("cut.dat", gzip.compress(MATRIX)[:-1]))), 1)
        self.assertEqual(matrix.CanReadFile(str(write("cut.vsm.gz", b"\x1f\x8b"))), 1)  # so that it says what is wrong
        self.assertEqual(matrix.CanReadFile(str(write("plain.vsm.gz", MATRIX))), 1)
        self.assertEqual(load(FOLDER / "plain.vsm.gz", "vtkVerneySparseMatrixReader"),
                         load(FOLDER / "some.dat", "vtkVerneySparseMatrixReader"))
        for name, form in (("some.dat", "sparse"), ("text.dat", None), ("cut.dat", "sparse"), ("cut.vsm.gz", "sparse"),
                           ("plain.vsm.gz", "sparse")):
            self.assertEqual(reading.find_format(FOLDER / name), form, name)

    def test_errors(self):
        """One for each, with the name of the file."""
        for name, content, class_name in FILES:
            compressed = gzip.compress(content)
            cuts = [(compressed[:size], "byte %d: end of file, expected the rest" % size, "PrematureEndOfFileError")
                    for size in (len(compressed) - 1, len(compressed) - 8, len(compressed) - 20)]
            changed = bytes([compressed[-5] ^ 1])
            for wrong, text, code in (*cuts,
                                      (compressed[:-5] + changed + compressed[-4:], "damaged compressed data", "FileFormatError"),
                                      (compressed + b"x", "byte %d: more bytes after" % len(compressed), "FileFormatError")):
                with self.subTest(name + ": " + text):
                    path = write(name + ".gz", wrong)
                    reader = make(class_name, FileName=str(path))
                    with self.assertRaises(ValueError) as raised:
                        update(reader)
                    self.check_error(raised.exception, path, text)
                    self.assertEqual(reader.GetErrorCode(), getattr(vtkErrorCode, code))
                    with self.assertRaises(HorizonError) as raised:
                        load_for_command(path, class_name)
                    self.check_error(raised.exception, path, text)
        path = write("lines.vsm.gz", gzip.compress(MATRIX.replace(b"4 1 1 4", b"4 1 x 4")))
        for loads, error in ((load, ValueError), (load_for_command, HorizonError)):
            with self.assertRaisesRegex(error, 'line 5: thickness "x", expected a number'):
                loads(path, "vtkVerneySparseMatrixReader")

    def check_error(self, error, path, text):
        self.assertIn("%s: " % path, str(error))
        self.assertIn(text, str(error))

    def test_much_out_of_little(self):
        """What a small file is made from does not have to be in memory at once, and of one line it may not be."""
        blanks = gzip.compress(b" " * 2**22) * 32
        zmap = b"!\n@GRID FILE, GRID, 4\n15, 1E+30, , 7, 1\n2, 2, 0, 1, 0, 1\n0, 0, 0\n@\n1 2 3 4"
        for name, content, class_name in (("long.zmap", zmap, "vtkHorizonGridReader"),
                                          ("long.vsm", MATRIX[:20], "vtkVerneySparseMatrixReader"),
                                          ("long.xyz", PICKS, "vtkHorizonTextReader"),
                                          ("long.ts", SURFACE[:50], "vtkGOCADTSurfReader"),
                                          ("long.dat", FAULTS, "vtkFaultLinesReader")):
            with self.subTest(name):
                path = write(name + ".gz", gzip.compress(content) + blanks)
                for loads, error in ((load, ValueError), (load_for_command, HorizonError)):
                    with self.assertRaisesRegex(error, r"byte \d+: a line of more than \d+ bytes, expected a shorter one"):
                        loads(path, class_name)
        path = write("comments.dat.gz", gzip.compress(b"# nothing\n" * 400000) * 100 + gzip.compress(FAULTS))
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for loads in (load, load_for_command):
            self.assertEqual(len(loads(path, "vtkFaultLinesReader")[1][0]), 4)
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 200000)  # KiB

    def test_names_of_results(self):
        """Those of the file within."""
        folder = FOLDER / "batch"
        folder.mkdir(exist_ok=True)
        (folder / "a.vsm.gz").write_bytes(gzip.compress(MATRIX))
        (folder / "picks.xyz.GZ").write_bytes(gzip.compress(PICKS))
        messages = []
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            batch.run([folder], folder / "output", pipeline.Settings(rough=None), False,
                      record.Record(lambda kind, text: messages.append("%s: %s" % (kind, text))))
        self.assertEqual(messages, [])
        self.assertEqual(sorted(path.name for path in (folder / "output").iterdir()), ["a_horizon_1.vtp", "picks.vtp"])
        self.assertTrue(printed.getvalue().startswith("a.vsm.gz: read in "), printed.getvalue())
        labels = batch.make_labels([folder / "a.vsm", folder / "a.vsm.gz"])
        self.assertEqual(batch.make_stems(labels), ["a_vsm", "a_vsm_gz"])


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=["compressed_test"], verbosity=2)
