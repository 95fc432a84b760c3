# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What is no regular file, or of another program, is named by each option that takes a file; warnings and errors have the
form and the words of their door.

Arguments: the program, the generator of cubes, and a folder for files.
"""

import json
import os
import pathlib
import socket
import struct
import subprocess
import sys
import time
import unittest

import seismichorizons as sh
from doors import CommandTest, picks
from seismichorizons import vtk
from seismichorizons_command import core, reading

PROGRAM, GENERATOR, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])


class VoiceTest(CommandTest):
    program, top_folder = PROGRAM, FOLDER

    def special_files(self):
        """What is no regular file, or an empty one, with the words of its error."""
        folder, pipe, empty = self.folder / "folder.dat", self.folder / "pipe.dat", self.folder / "empty.dat"
        folder.mkdir()
        os.mkfifo(pipe)
        empty.write_bytes(b"")
        link, device = self.folder / "link.dat", self.folder / "device.dat"
        link.symlink_to(self.folder / "nothing")
        device.symlink_to("/dev/zero")
        with socket.socket(socket.AF_UNIX) as server:
            os.chdir(self.folder)
            server.bind("socket.dat")
        return {folder: "a directory, expected a file|no file of horizons in this folder",
                pipe: "a special file, expected a regular one", self.folder / "socket.dat": "a special file, expected a regular",
                device: "a special file, expected a regular one", link: "a link to a file that does not exist",
                empty: "expected (lines of numbers|fault lines|at least|SEG-Y, which begins|\"GOCAD TSurf)",
                self.folder / "missing.dat": "no such file"}

    def test_special_files(self):
        """One error at once from each option that takes a file."""
        subprocess.run([GENERATOR, self.folder / "cube.sgy"], check=True, stdout=subprocess.PIPE)
        top = self.write("top.txt", picks())
        for path, words in self.special_files().items():
            for arguments in ([path], ["--fault-lines", path, top], ["--fault-sticks", path, top],
                              ["--picks", path, self.folder / "cube.sgy"], ["--limits", path, "--", self.folder / "cube.sgy"]):
                with self.subTest(path=path.name, option=arguments[0]):
                    start = time.monotonic()
                    code, messages, _ = self.run_command(*arguments)
                    seconds = time.monotonic() - start
                    self.assertEqual((code, len(messages)), (1, 1), messages)
                    self.assertRegex(messages[0], words)
                    self.assertLess(seconds, 30.0)  # opening a pipe would wait for ever
            kind = FileNotFoundError if path.name in ("link.dat", "missing.dat") else (OSError, ValueError)
            for read in (sh.read, sh.read_cube, sh.read_mesh, sh.read_faults):
                with self.subTest(path=path.name, read=read.__name__), self.assertRaisesRegex(kind, words):
                    read(path)

    def test_special_results(self):
        """What opening could wait for, and what a file cannot replace."""
        special = self.special_files()
        top = self.write("top.txt", picks())
        points = sh.read(top)["Top"]
        for path in special:
            if path.name in ("pipe.dat", "socket.dat", "folder.dat"):
                code, messages, _ = self.run_command("--report", path, top)
                self.assertEqual((code, len(messages)), (1, 1), messages)
                self.assertIn("cannot be written: ", messages[0])
                with self.assertRaisesRegex(OSError, "a directory|a pipe or socket"):
                    sh.write(points, path)
        self.output.mkdir(exist_ok=True)
        os.mkfifo(self.output / "top_Top.vtp")
        code, messages, _ = self.run_command(top)
        self.assertEqual((code, len(messages)), (1, 1), messages)
        self.assertIn("top_Top.vtp cannot be written: a pipe or socket", messages[0])

    OTHERS = {
        "a.dxf": ("  0\nSECTION\n  2\nENTITIES\n  0\nPOINT\n 10\n1.0\n 20\n2.0\n 30\n3.0\n", "a drawing (DXF)"),
        "comment.dxf": ("999\nmade by hand\n0\nSECTION\n", "a drawing (DXF)"),
        "binary.dxf": (b"AutoCAD Binary DXF\r\n\x1a\0", "a drawing (DXF)"),
        "a.obj": ("# a mesh\no top\n" + "".join("v %d %d 7\n" % (25 * i, 25 * j) for j in range(9) for i in range(9)) +
                  "f 1 2 3\n", "a triangle mesh (OBJ)"),
        "a.stl": ("solid top\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n", "a triangle mesh (STL)"),
        "binary.stl": (b"made by a program".ljust(80) + struct.pack("<I", 2) + 2 * (
            struct.pack("<12f", 0, 0, 1, 1, 2, 3, 4, 5, 3, 1, 5, 3) + b"\0\0"), "a triangle mesh (STL)"),
        "a.ply": ("ply\nformat ascii 1.0\nelement vertex 3\nend_header\n1 2 3\n2 3 4\n3 4 5\n", "a triangle mesh (PLY)"),
        "a.las": (b"LASF\0\0\0\0" + bytes(200), "a point cloud (LAS)"),
        "well.las": ("~Version Information\n VERS. 2.0 :\n~A DEPT GR\n1 2 3\n2 3 4\n3 4 5\n4 5 6\n", "a well log (LAS)"),
        "a.geojson": ('{\n "type": "FeatureCollection", "features": [\n  [1, 2, 3]\n ]\n}\n', "GeoJSON"),
        "a.zgy": (b"VBS\0\3\0\0\0" + bytes(300), "a seismic cube (ZGY), expected points of horizons, a grid, a surface or a "
                  "cube: convert it to SEG-Y"),
        "a.shp": (struct.pack(">7i", 9994, 0, 0, 0, 0, 0, 50) + struct.pack("<2i", 1000, 13) + bytes(64), "a shapefile"),
        "a.vo": ("GOCAD Voxet 1\nHEADER {\nname:Top\n}\n", "an object of GOCAD"),
        "a.xlsx": (b"PK\x03\x04" + bytes(100), "a ZIP archive, as of Excel or RESQML"),
        "a.nc": (b"\x89HDF\r\n\x1a\n" + bytes(100), "an HDF5 file, as of netCDF"),
        "a.gpkg": (b"SQLite format 3\0" + bytes(100), "a database (SQLite), as of GeoPackage"),
        "a.vtk": ("# vtk DataFile Version 3.0\ntop\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n1 2 3\n", "a VTK file"),
        "a.msh": ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "a mesh of Gmsh"),
        "a.png": (b"\x89PNG\r\n\x1a\n" + bytes(100), "a picture (PNG)")}

    def test_files_of_other_programs(self):
        """Named by their first bytes, whatever they are called, with what to do."""
        for name, (content, words) in self.OTHERS.items():
            for named in (name, name + ".dat"):
                path = self.write(named, content)
                with self.subTest(named):
                    code, messages, _ = self.run_command(path)
                    self.assertEqual((code, len(messages)), (1, 1), messages)
                    self.assertIn("error: %s: %s" % (path, words), messages[0])
                    self.assertRegex(messages[0], r"expected (points of horizons, a grid, a surface or a cube|a surface of GOCAD .TSurf.): .")
                    with self.assertRaises(ValueError) as raised:
                        sh.read(path)
                    self.assertIn(words, str(raised.exception))
            if not name.endswith("vo"):
                code, messages, _ = self.run_command("--fault-lines", path, self.write("top.txt", picks()))
                self.assertEqual((code, len(messages)), (1, 1), messages)
                self.assertIn(words.partition(", expected")[0] + ", expected fault lines as text: ", messages[0])

    def test_warnings_of_readers(self):
        """One line in the form of all, the same in JSON and in the report, and warnings of Python in the package."""
        negative = self.write("up.dat", picks(z=-1500.0))
        null = self.write("null.dat", picks().replace("1500.00", "-9999.00", 2))
        report = self.folder / "report.html"
        code, messages, printed = self.run_command(negative, null, "--json", "--report", report)
        self.assertEqual(code, 0)
        told = {file["label"]: file["warnings"] for file in json.loads(printed)["files"]}
        for label, words in (("null.dat", "add -9999 to --null-values if it means"),):
            self.assertEqual(len(told[label]), 1)
            self.assertIn("horizon-mesh: warning: %s" % told[label][0], messages)
            self.assertTrue(told[label][0].startswith(label + ": "), told[label])
            self.assertIn(words, told[label][0])
            self.assertIn("null.dat", report.read_text(encoding="utf-8"))
        for message in messages:
            self.assertRegex(message, r"^horizon-mesh: warning: (up|null)\.dat: ")
            self.assertNotRegex(message, r"0x|\x1b|\.cxx|WARN")
        with self.assertWarnsRegex(UserWarning, "add -9999 to nodata if it means") as warned:
            sh.read(null)
        self.assertEqual(warned.filename, __file__)
        heard = []
        with core.heard_by(heard.append):
            reading.read(null)
        self.assertEqual(len(heard), 1)
        self.assertRegex(heard[0], "add -9999 to --null-values|NullValues")
        with self.assertWarnsRegex(UserWarning, "add -9999 to NullValues"):
            vtk.update(vtk.make("vtkHorizonTextReader", FileName=str(null)))

    def test_nothing_is_raw(self):
        """No line of the logger, in a process of its own: its outputs are no terminal."""
        null = self.write("null.dat", picks().replace("1500.00", "-9999.00", 2))
        sticks = self.write("sticks.dat", "0 0 0 F 1\n0 0 9 F 1\n1 0 0 F 2\n1 0 9 F 2\n")
        done = subprocess.run([sys.executable, str(PROGRAM), "--no-pictures", "--output-folder", str(self.output),
                               "--fault-sticks", str(sticks), str(null)], capture_output=True, text=True, timeout=100)
        lines = done.stderr.splitlines()
        self.assertTrue(lines)
        for line in lines:
            self.assertRegex(line, r"^horizon_mesh: (warning|error): ")

    def test_options_in_the_words_of_the_door(self):
        noise = self.write("noise.xyz", "".join("%.2f %.2f %.2f\n" % (431000 + 37.7 * n % 2000, 6348000 + 91.3 * n % 1900,
                                                                       1500 + 0.01 * n) for n in range(800)))
        two = self.write("two.txt", "X Y TWT DEPTH\n" + "".join("%d %d 5 7\n" % (i, j) for j in range(5) for i in range(5)))
        for path, option, keyword, name in ((two, "set --columns", "set columns$", "set Columns"),
                                            (noise, "or --gridding", "or gridding=", "or Gridding")):
            code, messages, _ = self.run_command(path)
            self.assertEqual((code, len(messages)), (1, 1), messages)
            self.assertRegex(messages[0], option)
            with self.assertRaisesRegex(ValueError, keyword):
                sh.read(path)
            with self.assertRaisesRegex(ValueError, name):
                vtk.update(vtk.make("vtkHorizonTextReader", FileName=str(path)))
        columns = self.write("Columns.txt", "Columns 1\n")
        code, messages, _ = self.run_command(columns)
        self.assertIn("Columns.txt: ", messages[0])  # a name of a file stays

    def test_no_false_alarms(self):
        """A level platform is no number for no value, and headers between named horizons are no names."""
        platform = "X\tY\tZ\n" + "".join("%d\t%d\t%d\n" % (25 * i, 25 * j, 1600 if i < 4 else 1500) for j in range(12) for i in range(15))
        header = "# OpendTect Horizon\n# written again\n"
        for name, content in (("platform.dat", platform), ("headers.dat", header + picks("Top") + header + picks("Base", z=1700.0)),
                              ("names.dat", "Name\tI\tJ\tX\tY\tZ\n" + picks("Top") + "Name\tI\tJ\tX\tY\tZ\n" + picks("Base", z=1700.0))):
            code, messages, _ = self.run_command(self.write(name, content))
            self.assertEqual((code, messages), (0, []), name)


if __name__ == "__main__":
    unittest.main(argv=["voice_test"], verbosity=2)
