# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The error codes of VTK, of every reader and writer. Argument: a folder for files."""

import pathlib
import shutil
import struct
import sys
import unittest

from seismichorizons import vtk as sh
from seismichorizons.vtk import apply
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonMisc import vtkErrorCode

FOLDER = pathlib.Path(sys.argv[1]).resolve()

PLANE = b"5 4 9\n" + b"3 1 1 0.5 4.0\n" * 20
PICKS = b"".join(b'"Top"\t%d\t%d\t%d\t%d\t%d\n' % (j, i, 25 * i, 25 * j, 9 + i) for j in range(4) for i in range(5))
IESX = (b"PROFILE Top Chalk        TYPE 1  4                                              3d_ci7m.ifdf     m ms\n"
        b"SNAPPING PARAMETERS 5     0 1\n"
        b"  6.20986880E+05  6.08088236E+06  0 14   648.62    914.00    914.00  914 5.3956040E+03 I    376 XX      \n")
GRID = b"DSAA\n3 2\n100 120\n200 210\n5 7\n5 6 7\n5 6 7\n"
SURFACE = b"GOCAD TSurf 1\nHEADER {\nname:a\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"
FAULT = b"GOCAD PLine 1\nHEADER {\nname:a\n}\nILINE\nVRTX 1 0 0 0\nVRTX 2 1 1 1\nSEG 1 2\nEND\n"


def cube(sample_format=5):
    """Two inlines and two crosslines of four samples, as SEG-Y of revision 1."""
    header = bytearray(b" " * 3200 + bytes(400))
    struct.pack_into(">h", header, 3216, 4000)
    struct.pack_into(">h", header, 3220, 4)
    struct.pack_into(">h", header, 3224, sample_format)
    struct.pack_into(">hh", header, 3500, 0x100, 1)
    traces = b""
    for inline in (1, 2):
        for crossline in (1, 2):
            trace = bytearray(240 + 4 * 4)
            struct.pack_into(">h", trace, 28, 1)
            struct.pack_into(">h", trace, 114, 4)
            struct.pack_into(">iiii", trace, 180, 25 * crossline, 25 * inline, inline, crossline)
            struct.pack_into(">4f", trace, 240, 1.0, 2.0, 3.0, 4.0)
            traces += trace
    return bytes(header) + traces


# class: (extension, a good file, a wrong one, and one that ends too early)
READERS = {
    "vtkVerneySparseMatrixReader": (".vsm", PLANE, PLANE.replace(b"0.5", b"strong", 1), PLANE[:90]),
    "vtkHorizonTextReader": (".dat", PICKS, b"a b\n", IESX),
    "vtkHorizonGridReader": (".grd", GRID, GRID.replace(b"6", b"six", 1), GRID[:-6]),
    "vtkGOCADTSurfReader": (".ts", SURFACE, SURFACE.replace(b"TRGL 1", b"TRGL 7"), SURFACE[:-4]),
    "vtkSEGYCubeReader": (".sgy", cube(), cube(99), cube()[:-3]),
    "vtkFaultLinesReader": (".pl", FAULT, FAULT.replace(b"VRTX 1 0", b"VRTX 1 x"), FAULT[:-4]),
}
WRITERS = ("vtkVerneySparseMatrixWriter", "vtkHorizonTextWriter", "vtkHorizonGridWriter", "vtkGOCADTSurfWriter",
           "vtkHorizonDXFWriter", "vtkFaultLinesWriter")


def quiet(algorithm):
    """Errors are not printed; their number is len() of what is returned."""
    errors = []
    algorithm.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    return errors


class ErrorCodeTest(unittest.TestCase):
    def expect(self, algorithm, code):
        name = vtkErrorCode.GetStringFromErrorCode(algorithm.GetErrorCode())
        self.assertEqual(algorithm.GetErrorCode(), getattr(vtkErrorCode, code), "%s: %s" % (algorithm.GetClassName(), name))

    def read(self, reader, errors, path, code):
        if path:
            reader.SetFileName(str(path))
        del errors[:]
        reader.Update()
        self.expect(reader, code)
        self.assertEqual(len(errors), 0 if code == "NoError" else 1)

    def test_readers(self):
        for name, (extension, good, wrong, cut_off) in READERS.items():
            with self.subTest(name):
                reader = getattr(sh, name)()
                errors = quiet(reader)
                self.expect(reader, "NoError")
                self.read(reader, errors, None, "NoFileNameError")
                self.read(reader, errors, FOLDER / ("missing" + extension), "FileNotFoundError")
                self.read(reader, errors, FOLDER, "CannotOpenFileError")
                for stem, content, code in (("good", good, "NoError"), ("wrong", wrong, "FileFormatError"),
                                            ("cut off", cut_off, "PrematureEndOfFileError"), ("again", good, "NoError")):
                    path = FOLDER / (stem + extension)
                    path.write_bytes(content)
                    self.read(reader, errors, path, code)

    def test_stopped(self):
        """Being asked to stop, however early, is no fault: the output is empty, and whole when a reader runs again."""
        for name, (extension, good, _, _) in READERS.items():
            for options in ({}, {"OutputType": 1}) if name == "vtkVerneySparseMatrixReader" else ({},):
                for event in (1, 2):
                    with self.subTest("%s %s: event %d" % (name, options, event)):
                        self.stop_at(event, getattr(sh, name)(), good, extension, options)

    def stop_at(self, event, reader, content, extension, options):
        path = FOLDER / ("stopped" + extension)
        path.write_bytes(content)
        reader.SetFileName(str(path))
        for option, value in options.items():
            getattr(reader, "Set" + option)(value)
        errors, events = quiet(reader), []

        def stop(*_):
            events.append(1)
            if len(events) == event:
                reader.SetAbortExecuteAndUpdateTime()

        def points():
            output = reader.GetOutputDataObject(0)
            return 0 if output is None else output.GetNumberOfElements(output.POINT)

        tag = reader.AddObserver("ProgressEvent", stop)
        reader.Update()
        self.assertGreaterEqual(len(events), event)
        self.assertEqual((points(), errors), (0, []))
        reader.RemoveObserver(tag)
        reader.SetAbortExecute(0)
        reader.Update()
        self.assertGreater(points(), 0)
        self.assertEqual(errors, [])
        self.expect(reader, "NoError")

    def test_unreadable(self):
        """A file whose bytes cannot be read, as on a broken disk."""
        for name in READERS:
            with self.subTest(name):
                reader = getattr(sh, name)()
                is_empty = name == "vtkSEGYCubeReader"  # by its size, at which this one looks first
                self.read(reader, quiet(reader), "/proc/self/mem", "PrematureEndOfFileError" if is_empty else "FileFormatError")

    def test_parameters(self):
        """What is no fault of the file has no name among the codes."""
        reader = sh.vtkVerneySparseMatrixReader()
        errors = quiet(reader)
        path = FOLDER / "plane.vsm"
        path.write_bytes(PLANE)
        reader.SetVerticalStep(0.0)
        self.read(reader, errors, path, "UnknownError")
        for name, parameters in (("vtkVerneySparseMatrixReader", {"DuplicatePolicy": 3, "LeastMemory": True}),
                                 ("vtkHorizonTextReader", {"DuplicatePolicy": 3, "LatticeTolerance": 7.0}),
                                 ("vtkHorizonTextReader", {"Columns": "X,Y,Z,X"}),
                                 ("vtkSEGYCubeReader", {"SampleFormat": 77}), ("vtkSEGYCubeReader", {"SampleFormat": -1})):
            with self.subTest(name, **parameters):
                extension, good, _, _ = READERS[name]
                path = FOLDER / ("parameters" + extension)
                path.write_bytes(good)
                reader = getattr(sh, name)()
                for parameter, value in parameters.items():
                    getattr(reader, "Set" + parameter)(value)
                self.read(reader, quiet(reader), path, "UnknownError")

    def test_unchanged(self):
        """Telling of an error does not make a reader read again."""
        reader = sh.vtkVerneySparseMatrixReader()
        errors = quiet(reader)
        self.read(reader, errors, FOLDER / "missing.vsm", "FileNotFoundError")
        path = FOLDER / "unchanged.vsm"
        path.write_bytes(PLANE)
        reader.SetFileName(str(path))
        changes = []
        reader.AddObserver("ModifiedEvent", lambda *_: changes.append(reader.GetMTime()))
        self.read(reader, errors, None, "NoError")
        self.assertEqual(changes, [])

    def test_writers(self):
        path = FOLDER / "written.vsm"
        path.write_bytes(PLANE)
        reader = sh.vtkVerneySparseMatrixReader()
        reader.SetFileName(str(path))
        reader.Update()
        mesh = reader.GetOutputDataObject(0)
        for stage in (sh.vtkHorizonExteriorBoundary(), sh.vtkHorizonTriangulation()):
            mesh = apply(stage, mesh)
        for name in WRITERS:
            with self.subTest(name):
                writer = getattr(sh, name)()
                errors = quiet(writer)
                writer.SetInputDataObject(0, mesh)
                if hasattr(writer, "SetFormatToZmap"):
                    writer.SetFormatToZmap()
                for target, code in ((None, "NoFileNameError"), (FOLDER / "none" / "x", "CannotOpenFileError"),
                                     (FOLDER, "CannotOpenFileError"), ("/dev/full", "OutOfDiskSpaceError"),
                                     (FOLDER / name, "NoError")):
                    writer.SetFileName(target and str(target))
                    del errors[:]
                    self.assertEqual(writer.Write(), int(code == "NoError"), target)
                    self.expect(writer, code)
                    self.assertEqual(len(errors), int(code != "NoError"), target)
                writer.SetInputDataObject(0, vtkPolyData())
                self.assertEqual(writer.Write(), 0)
                self.expect(writer, "UnknownError")


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=["error_codes_test"], verbosity=2)
