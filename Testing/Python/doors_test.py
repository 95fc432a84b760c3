# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files are written by the functions, the command and the classes, which are those of the window: each format beside all
others and on a full disk, and under names that are the same, or too long, on some systems.

Arguments: the program, and a folder for files.
"""

import contextlib
import csv
import hashlib
import importlib.util
import io
import os
import pathlib
import resource
import shutil
import sys
import types
import unittest
import warnings
from unittest import mock

import numpy as np
import seismichorizons as sh
from doors import CommandTest, picks
from seismichorizons import vtk
from seismichorizons_command import batch, pipeline, record, writing
from seismichorizons_command.core import HorizonError
from seismichorizons_command.options import FORMATS
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
GRIDS_OF_CELLS = ("vtu", *writing.LAYER_FORMATS)
FILES_OF_VTK = {"vtp": vtkXMLPolyDataReader, "vtu": vtkXMLUnstructuredGridReader}
MESH_WRITER, GRID_WRITER = "vtkHorizonMeshWriter", "vtkHorizonGridWriter"
WRITERS = {"vtp": MESH_WRITER, "stl": MESH_WRITER, "ply": MESH_WRITER, "obj": MESH_WRITER, "ts": "vtkGOCADTSurfWriter",
           "dxf": "vtkHorizonDXFWriter", "irap": GRID_WRITER, "gri": GRID_WRITER, "zmap": GRID_WRITER,
           **dict.fromkeys(("cps3", "grd", "asc"), GRID_WRITER),
           "dat": "vtkHorizonTextWriter", "vsm": "vtkVerneySparseMatrixWriter",
           **dict.fromkeys(GRIDS_OF_CELLS, "vtkHorizonLayersWriter")}
NOT_BY_CLASSES = ("tif",)  # GDAL is Python's
NEIGHBOURS = (*FORMATS, "vtu", "aux.xml", "tif.aux.xml", "part", "tmp", "csv", "png")
SMALL = 200  # bytes of a file for which a full disk has room
PRECIOUS = b"precious"


class FakeGdal(types.ModuleType):
    """As much of GDAL as GeoTIFF is written with, for machines without it: files in memory alone."""

    GDT_Float64 = 7

    def __init__(self):
        super().__init__("gdal")
        self.files = {}

    def __getattr__(self, name):
        return mock.MagicMock()

    def GetDriverByName(self, _name):
        def create(place, columns, rows, *_):
            assert place.startswith("/vsimem/"), place
            self.files[place] = b"II*\0" + columns * rows * 8 * b"x"
            return mock.MagicMock()
        return types.SimpleNamespace(Create=create)

    def VSIFOpenL(self, place, _mode):
        return place

    def VSIStatL(self, place):
        return types.SimpleNamespace(size=len(self.files[place]))

    def VSIFReadL(self, _unit, size, stream):
        return bytearray(self.files[stream][:size])

    def Unlink(self, place):
        self.files.pop(place)


def with_gdal():
    if importlib.util.find_spec("osgeo"):
        return contextlib.nullcontext()
    gdal, osr = FakeGdal(), mock.MagicMock()
    return mock.patch.dict(sys.modules, {"osgeo": types.SimpleNamespace(gdal=gdal, ogr=osr, osr=osr), "osgeo.gdal": gdal, "osgeo.ogr": osr, "osgeo.osr": osr})


@contextlib.contextmanager
def full_disk(size):
    """Files larger than that cannot be written."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


def states(folder):
    """What is in the files of a folder."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()}


def dome(rows=30, columns=40):
    j, i = np.mgrid[0:rows, 0:columns]
    return 1000.0 + 0.37 * i + 20.0 * np.sin(j / 9.0) * np.cos(i / 11.0)


def kind_of(form):
    """What a format holds."""
    return "cells" if form in GRIDS_OF_CELLS else "points" if form in writing.POINT_FORMATS else "mesh"


def read_by_vtk(path):
    reader = FILES_OF_VTK[path.suffix[1:]]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def arrays_of(data):
    """All that is in data of VTK, as types, shapes and values that can be compared."""
    def plain(array):
        if not array.IsNumeric():
            return [array.GetValue(number) for number in range(array.GetNumberOfValues())]
        return array.GetDataTypeAsString(), array.GetNumberOfComponents(), vtk_to_numpy(array).tobytes()

    found = {"points": plain(data.GetPoints().GetData())}
    for name in ("Verts", "Lines", "Polys", "Cells"):
        cells = getattr(data, "Get" + name)() if hasattr(data, "Get" + name) else None
        if cells is not None:
            found[name] = plain(cells.GetOffsetsArray()), plain(cells.GetConnectivityArray())
    if hasattr(data, "GetCellTypesArray"):
        found["types"] = plain(data.GetCellTypesArray())
    for kind in ("Point", "Cell", "Field"):
        attributes = getattr(data, "Get%sData" % kind)()
        arrays = [attributes.GetAbstractArray(number) for number in range(attributes.GetNumberOfArrays())]
        found[kind] = {array.GetName(): plain(array) for array in arrays}
    return found


def write_picks_by_class(points, path):
    """Writes the horizons of a file of picks as the window does, each into a file of its own."""
    reader = vtk.make("vtkHorizonTextReader", FileName=str(points))
    vtk.update(reader)
    writer = vtk.make(MESH_WRITER, FileName=str(path))
    writer.SetInputDataObject(reader.GetOutputDataObject(0))
    vtk.update(writer)


class DoorsTest(CommandTest):
    program, top_folder = PROGRAM, FOLDER

    @classmethod
    def setUpClass(cls):
        with contextlib.redirect_stderr(io.StringIO()):
            place = {"origin": (512345.678, 6543210.987), "spacing": (0.25, 0.25), "vertical_step": 0.1}
            cls.top = sh.horizon(dome(), name="top", **place)
            cls.mesh = sh.surface(cls.top)
            cls.layers = sh.layers({"Top": cls.top, "Base": sh.horizon(dome() + 50.0, **place)}, effort="fast")
        FOLDER.mkdir(parents=True, exist_ok=True)
        # What classes write, as VTK reads it.
        cls.given = {}
        for kind, data, form in (("points", cls.top, "vtp"), ("mesh", cls.mesh, "vtp"), ("cells", cls.layers, "vtu")):
            path = FOLDER / ("%s.%s" % (kind, form))
            data.write(path) if form == "vtu" else sh.write(data, path)
            cls.given[kind] = read_by_vtk(path)

    def setUp(self):
        super().setUp()
        patch = with_gdal()
        patch.__enter__()
        self.addCleanup(patch.__exit__, None, None, None)

    def write_by_function(self, path):
        form = path.suffix[1:]
        if form in GRIDS_OF_CELLS:
            self.layers.write(path)
        else:
            sh.write(self.top if form in writing.POINT_FORMATS else self.mesh, path)

    def doors(self, form):
        """What writes a format into a folder as top.form, by the name of the door."""
        def by_function(folder):
            self.write_by_function(folder / ("top." + form))

        def by_class(folder):
            # The functions write surfaces of GOCAD in the direction of the horizon, which a class is told.
            told = {"VerticalPositive": "Depth"} if form == "ts" else {}
            writer = vtk.make(WRITERS[form], FileName=str(folder / ("top." + form)), **told)
            writer.SetInputDataObject(self.given[kind_of(form)])
            vtk.update(writer)

        def by_command(folder):
            points = pathlib.Path(self.folder / "top.dat")
            points.write_text(picks(), encoding="ascii")
            settings = pipeline.Settings(formats=(form,), reader={"CoordinateSystem": "EPSG:23031"})
            run = record.Record(lambda kind, text: None)
            batch.run([points], folder, settings, False, run, prints=False)
            if run.files[0]["error"]:
                raise OSError(run.files[0]["error"])

        yield "function", by_function
        if form not in NOT_BY_CLASSES:
            yield "class", by_class
        if form not in GRIDS_OF_CELLS:
            yield "command", by_command

    def test_beside_each_other(self):
        """No file but the one that is written changes, appears or goes, whatever is beside it."""
        for form in (*FORMATS, "vtu"):
            for door, write in self.doors(form):
                with self.subTest(form=form, door=door):
                    folder = self.folder / ("%s-%s" % (form, door))
                    folder.mkdir()
                    name = "top_Top." + form if door == "command" else "top." + form
                    for stem in ("top", "top_Top", "sampled", "x"):
                        for other in NEIGHBOURS:
                            (folder / ("%s.%s" % (stem, other))).write_bytes(PRECIOUS)
                    before = states(folder)
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        write(folder)
                    after = states(folder)
                    self.assertEqual({key for key in {*before, *after} if before.get(key) != after.get(key)}, {name})
                    shutil.rmtree(folder)

    def test_all_at_once(self):
        """In any order."""
        forms = ["irap", "tif", *(form for form in FORMATS if form not in ("irap", "tif", *writing.LAYER_FORMATS))]
        points = self.write("top.txt", picks())
        for order in (forms, forms[::-1]):
            shutil.rmtree(self.output, ignore_errors=True)
            code, _, _ = self.run_command(points, "--formats", *order)
            self.assertEqual(code, 0)
            self.assertEqual(sorted(os.listdir(self.output)), sorted("top_Top." + form for form in forms))

    def test_full_disk(self):
        """An OSError, or an exit code; what was there is as it was, and nothing else is left."""
        for form in (*FORMATS, "vtu"):
            for door, write in self.doors(form):
                with self.subTest(form=form, door=door):
                    folder = self.folder / ("%s-%s" % (form, door))
                    folder.mkdir()
                    names = ["top." + form, "top_Top." + form]
                    for name in names:
                        (folder / name).write_bytes(PRECIOUS)
                    if door == "command":
                        (self.folder / "top.dat").write_text(picks(), encoding="ascii")
                    with full_disk(SMALL), warnings.catch_warnings(), mock.patch("pathlib.Path.write_text"):
                        warnings.simplefilter("ignore")
                        with self.assertRaises((OSError, ValueError)) as raised:
                            write(folder)
                    if door != "class":
                        self.assertIsInstance(raised.exception, OSError)
                        self.assertIn(".%s" % form, str(raised.exception))
                    self.assertEqual(states(folder), dict.fromkeys(names, hashlib.sha256(PRECIOUS).hexdigest()))
                    shutil.rmtree(folder)

    def test_full_device(self):
        """Not by a limit, but where the last bytes do not fit."""
        if not os.path.exists("/dev/full"):
            self.skipTest("no such device")
        (name, points), = pipeline.read(self.write("top.dat", picks()))[0]
        result = pipeline.run("top.dat", name, points, pipeline.Settings())
        for form in (*FORMATS, "vtu"):
            link = self.folder / ("x." + form)
            link.symlink_to("/dev/full")
            with self.subTest(form=form), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                with self.assertRaises(OSError):
                    self.write_by_function(link)

    def test_same_bytes(self):
        """Every door writes the same file; meshes have all digits. In files of VTK the same arrays are compressed otherwise."""
        for form in (*FORMATS, "vtu"):
            if form in NOT_BY_CLASSES:
                continue
            path = self.folder / ("top." + form)
            written = []
            for door, write in self.doors(form):
                if door == "command":
                    continue
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")  # of single precision
                    write(self.folder)
                self.assertGreater(path.stat().st_size, 100, form)
                written.append(arrays_of(read_by_vtk(path)) if form in FILES_OF_VTK else
                               path.read_bytes().replace(b"Horizon 1", b"top").replace(b"Horizon_1", b"top"))
            self.assertEqual(*written, form)
        np.testing.assert_array_equal(vtk_to_numpy(self.given["mesh"].GetPoints().GetData()), self.mesh.points)
        corners = vtk_to_numpy(self.given["mesh"].GetPolys().GetConnectivityArray())
        np.testing.assert_array_equal(corners.reshape(-1, 3), self.mesh.triangles)
        head = (self.folder / "top.ply").read_bytes()[:300]
        self.assertIn(b"property double x", head)
        for name in ("top.ts", "top.obj"):
            self.assertRegex((self.folder / name).read_text(), r" 51\d{4}\.\d{3}")

    def test_inputs_and_results_of_others(self):
        """No result replaces a file that is read, or a result of another file."""
        self.output.mkdir()
        points = self.output / "top.dat"
        points.write_text(picks().replace("Top\t", ""), encoding="ascii")
        before = points.read_bytes()
        code, messages, _ = self.run_command(points, "--formats", "dat")
        self.assertEqual((code, len(messages)), (1, 1), messages)
        self.assertRegex(messages[0], "error: top.dat: .*top.dat is an input and would be replaced, expected another --output")
        self.assertEqual(points.read_bytes(), before)
        points.unlink()
        one, other = self.write("a.txt", picks("B")), self.write("a_B.txt", picks("a_B"))
        code, messages, _ = self.run_command(one, other)
        self.assertEqual((code, messages), (1, ["horizon-mesh: error: a.txt and a_B.txt would write the same results, a_B.vtp"]))

    def test_names_in_other_cases(self):
        """They are the same file on some systems."""
        names = ("Top", "TOP", "top_2", "top")
        points = self.write("x.txt", "".join(picks(name, z=1500.0 + 50.0 * n) for n, name in enumerate(names)))
        self.write("X.TXT", picks("Top"))
        code, messages, _ = self.run_command(points, self.folder / "X.TXT")
        self.assertEqual((code, messages), (0, []))
        written = os.listdir(self.output)
        self.assertEqual(len(written), len(names) + 1)
        self.assertEqual(len({name.casefold() for name in written}), len(written), written)
        write_picks_by_class(points, self.folder / "y.vtp")
        sh.write(sh.read(points), self.folder / "z.vtp")
        for stem in "yz":
            written = [path.name.casefold() for path in self.folder.glob(stem + "*.vtp")]
            self.assertEqual((len(written), len(set(written))), (len(names), len(names)), written)

    def test_long_names(self):
        """Two that differ in their last letters only; the window and the functions write them, too."""
        names = ["\u00e4" * 300 + end for end in "ab"]
        points = self.write("x.txt", picks(names[0]) + picks(names[1], z=1700.0))
        code, messages, _ = self.run_command(points, "--formats", "vtp", "dat")
        self.assertEqual((code, messages, len(os.listdir(self.output))), (0, [], 4))
        write_picks_by_class(points, self.folder / "y.vtp")
        sh.write(sh.read(points), self.folder / "z.vtp")
        for stem in "yz":
            self.assertEqual(len(list(self.folder.glob(stem + "*.vtp"))), 2)
        name = "z" * 251 + ".vtp"  # as long as may be
        sh.write(self.mesh, self.folder / name)
        self.assertTrue((self.folder / name).is_file())
        with self.assertRaisesRegex(OSError, "a name of 304 bytes, expected at most 255"):
            sh.write(self.mesh, self.folder / ("z" * 300 + ".vtp"))

    def test_cells_of_tables(self):
        """Names that a spreadsheet would run."""
        points = self.write("x.txt", "".join(picks("%sA1+1" % sign, z=1500.0 + 50.0 * n) for n, sign in enumerate("=+@")))
        code, messages, _ = self.run_command(points, "--layers")
        self.assertEqual(code, 0, messages)
        with open(self.output / "x_layers.csv", encoding="utf-8", newline="") as file:
            cells = [cell for row in list(csv.reader(file))[1:] for cell in row]
        self.assertTrue(any(cell.startswith("'") for cell in cells), cells)
        for cell in cells:
            with contextlib.suppress(ValueError):
                float(cell)
                continue
            self.assertNotIn(cell[:1], tuple("=+-@"))


if __name__ == "__main__":
    unittest.main(argv=["doors_test"], verbosity=2)
