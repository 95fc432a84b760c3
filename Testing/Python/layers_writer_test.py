# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of layers, read back here, and by Gmsh, meshio, flopy and CalculiX where these are.

Argument: a folder for files.
"""

import collections
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import mesh_checks
import numpy as np
import vtk_inputs
from layer_files import areas_of, read_msh
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

FOLDER = pathlib.Path(sys.argv[1])
WEDGE, PYRAMID, TETRA = 13, 14, 10


def module(name):
    """A reader that need not be there; one that is there but broken fails."""
    if importlib.util.find_spec(name) is None:
        raise unittest.SkipTest("no %s" % name)
    return importlib.import_module(name)


def volume_of(points):
    """Of tetrahedra, pyramids and wedges whose corners are in the order of Gmsh and Abaqus, by pieces."""
    cuts = {4: [(0, 1, 2, 3)], 5: [(0, 1, 2, 4), (0, 2, 3, 4)],
            6: [(0, 1, 2, 3), (1, 2, 3, 4), (2, 3, 4, 5)]}[len(points)]
    return [np.linalg.det(points[list(cut[1:])] - points[cut[0]]) / 6.0 for cut in cuts]


def few_layers():
    pair = {"A": vtk_inputs.horizon(np.zeros((3, 3))), "B": vtk_inputs.horizon(np.ones((3, 3)))}
    return vtk_inputs.layers(pair, MaximumError=0.75).cells


def write(data, path):
    """Writes cells in the format of the extension. Raises ValueError with the error of the writer."""
    writer = sh.make("vtkHorizonLayersWriter", FileName=str(path))
    writer.SetInputDataObject(data)
    sh.update(writer)


class LayersWriterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Three layers: the second one pinches out between the others, the first one at the top."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        x, y = np.meshgrid(np.arange(30.0), np.arange(20.0))
        depths = {"Top": 100.0 + np.maximum(0.0, y - 12.0), "Sand": 110.0 + 0.2 * y,
                  "Shale": 110.0 + 0.2 * y + np.maximum(0.0, x - 9.0), "Base": 150.0 + np.sin(0.3 * x)}
        depths["Top"][:6] = depths["Sand"][:6]
        survey = {"origin": (5e5, 6e6), "spacing": (25.0, 12.5), "azimuth": 40.0, "VerticalStep": 1.0}
        cls.layers = vtk_inputs.layers({name: vtk_inputs.horizon(z, **survey) for name, z in depths.items()}, MaximumError=0.2)
        cls.grid = cls.layers.cells
        sizes = vtkCellSizeFilter()
        sizes.SetInputData(cls.grid)
        sizes.Update()
        cls.volumes = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))
        cls.layer = vtk_to_numpy(cls.grid.GetCellData().GetArray("Layer"))
        types = [cls.grid.GetCellType(n) for n in range(cls.grid.GetNumberOfCells())]
        cls.counts = {kind: types.count(kind) for kind in (WEDGE, PYRAMID, TETRA)}
        assert min(cls.counts.values()) > 0, cls.counts
        for form in ("msh", "inp", "disv", "vtu"):
            write(cls.grid, FOLDER / ("layers." + form))

    def volume(self, layer):
        return float(self.volumes[self.layer == layer].sum())

    def test_gmsh(self):
        gmsh = module("gmsh")
        if not hasattr(gmsh.model.mesh, "getElementQualities"):
            raise unittest.SkipTest("gmsh before 4.9, which does not measure elements")
        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.open(str(FOLDER / "layers.msh"))
            groups = {gmsh.model.getPhysicalName(*group): group for group in gmsh.model.getPhysicalGroups(3)}
            self.assertEqual(sorted(groups), sorted(self.layers.figures))
            found = {WEDGE: 0, PYRAMID: 0, TETRA: 0}
            for name, (dimension, tag) in groups.items():
                volume = 0.0
                for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag):
                    kinds, numbers, _ = gmsh.model.mesh.getElements(dimension, entity)
                    for kind, tags in zip(kinds, numbers):
                        found[{6: WEDGE, 7: PYRAMID, 4: TETRA}[kind]] += len(tags)
                        own = np.asarray(gmsh.model.mesh.getElementQualities(tags, "volume"))
                        self.assertGreater(own.min(), 0.0)
                        self.assertGreater(np.min(gmsh.model.mesh.getElementQualities(tags, "minDetJac")), 0.0)
                        volume += own.sum()
                self.assertAlmostEqual(volume / self.volume(tag - 1), 1.0, delta=1e-9, msg=name)
            self.assertEqual(found, self.counts)
        finally:
            gmsh.finalize()

    def test_meshio(self):
        meshio = module("meshio")
        for form in ("msh", "inp"):
            mesh = meshio.read(FOLDER / ("layers." + form))
            counts = {WEDGE: 0, PYRAMID: 0, TETRA: 0}
            total = 0.0
            for block in mesh.cells:
                if block.type in ("triangle", "quad"):
                    continue  # faces
                counts[{"wedge": WEDGE, "pyramid": PYRAMID, "tetra": TETRA}[block.type]] += len(block.data)
                for cell in block.data:
                    parts = volume_of(mesh.points[cell])
                    self.assertGreaterEqual(min(parts), -1e-9 * sum(parts), (form, block.type))
                    self.assertGreater(sum(parts), 0.0)
                    total += sum(parts)
            collapsed = self.counts[PYRAMID] if form == "inp" else 0
            self.assertEqual(counts, {WEDGE: self.counts[WEDGE] + collapsed, PYRAMID: self.counts[PYRAMID] - collapsed,
                                      TETRA: self.counts[TETRA]})
            self.assertAlmostEqual(total / self.volumes.sum(), 1.0, delta=1e-9)
            if form == "inp":
                self.assertEqual(list(mesh.cell_sets), ["L1_Top_to_Sand", "L2_Sand_to_Shale", "L3_Shale_to_Base"])

    def test_calculix(self):
        """A solver takes all elements, and has the same volumes; surfaces have the areas of those in the file of Gmsh."""
        program = shutil.which("ccx")
        if program is None:
            raise unittest.SkipTest("no ccx")
        sets = ["L%d_%s" % (layer + 1, name.replace(" ", "_")) for layer, name in enumerate(self.layers.figures)]
        surfaces = re.findall(r"SURFACE, NAME=(\w+)", (FOLDER / "layers.inp").read_text())
        (FOLDER / "weight.inp").write_text(
            "*INCLUDE, INPUT=layers.inp\n*NSET, NSET=ALL, GENERATE\n1, %d\n*MATERIAL, NAME=ROCK\n*ELASTIC\n1e10, 0.25\n"
            % self.grid.GetNumberOfPoints()
            + "".join("*SOLID SECTION, ELSET=%s, MATERIAL=ROCK\n" % name for name in sets)
            + "*BOUNDARY\nALL, 1, 2\n1, 3, 3\n*STEP\n*STATIC\n"
            + "".join("*SECTION PRINT, SURFACE=%s, NAME=P_%s\nSOAREA\n" % (name, name) for name in surfaces)
            + "".join("*EL PRINT, ELSET=%s, TOTALS=ONLY\nEVOL\n" % name for name in sets) + "*END STEP\n")
        run = subprocess.run([program, "weight"], cwd=FOLDER, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             text=True, check=False)
        self.assertEqual((run.returncode, "ERROR" in run.stdout), (0, False), run.stdout)
        found = re.findall(r"total volume for set (\S+) and time.*\s+(\S+)", (FOLDER / "weight.dat").read_text())
        self.assertEqual([name for name, _ in found], [name.upper() for name in sets])
        for layer, (_, volume) in enumerate(found):
            self.assertAlmostEqual(float(volume) / self.volume(layer), 1.0, delta=1e-6)  # it prints 7 digits
        points, entities, elements = read_msh(FOLDER / "layers.msh")
        areas = collections.Counter()
        for (dimension, tag), faces in elements.items():
            if dimension == 2:
                areas[entities[2, tag][0]] += np.linalg.norm(areas_of(points, faces), axis=1).sum()
        found = re.findall(r"statistics for surface set (\S+).*?area, normal force.*?\s(\d\S+)", (FOLDER / "weight.dat").read_text(), re.DOTALL)
        self.assertEqual([name for name, _ in found], [name.upper() for name in surfaces])
        np.testing.assert_allclose(sorted(float(area) for _, area in found), sorted(areas.values()), rtol=1e-6)

    def test_flopy(self):
        flopy = module("flopy")
        files = {"mfsim.nam": "BEGIN OPTIONS\nEND OPTIONS\nBEGIN TIMING\n  TDIS6 flow.tdis\nEND TIMING\nBEGIN MODELS\n"
                              "  gwf6 flow.nam flow\nEND MODELS\nBEGIN EXCHANGES\nEND EXCHANGES\n"
                              "BEGIN SOLUTIONGROUP 1\n"
                              "  ims6 flow.ims flow\nEND SOLUTIONGROUP 1\n",
                 "flow.ims": "BEGIN OPTIONS\nEND OPTIONS\n",
                 "flow.tdis": "BEGIN DIMENSIONS\n  NPER 1\nEND DIMENSIONS\n"
                              "BEGIN PERIODDATA\n  1.0 1 1.0\nEND PERIODDATA\n",
                 "flow.nam": "BEGIN OPTIONS\nEND OPTIONS\nBEGIN PACKAGES\n  DISV6 layers.disv disv\nEND PACKAGES\n"}
        for name, text in files.items():
            (FOLDER / name).write_text(text)
        simulation = flopy.mf6.MFSimulation.load(sim_ws=str(FOLDER), verbosity_level=0)
        package = simulation.get_model("flow").disv
        layers, columns = package.nlay.get_data(), package.ncpl.get_data()
        triangles = np.unique(vtk_to_numpy(self.grid.GetCellData().GetArray("Triangle")))
        self.assertEqual((layers, columns), (3, len(triangles)))
        places = {int(row[0]): (row[1], row[2]) for row in package.vertices.get_data()}
        corners = np.array([[places[int(row[4 + n])] for n in range(3)] for row in package.cell2d.get_data()])
        a, b, c = corners.transpose(1, 0, 2)
        areas = -0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
        self.assertGreater(areas.min(), 0.0)  # clockwise
        levels = np.concatenate((package.top.get_data()[None], package.botm.get_data()))
        domain = package.idomain.get_data()
        self.check_model(areas, levels, domain)

    def test_own_reader(self):
        """The same by an own reader of what was written."""
        text = (FOLDER / "layers.disv").read_text()
        size = {name: int(value) for name, value in re.findall(r"(NLAY|NCPL|NVERT) (\d+)", text)}

        def block(name):
            return re.search("BEGIN %s\n(.*?)END %s" % (name, name), text, re.DOTALL)[1]

        numbers = [np.array(part.split(), dtype=float) for part in re.findall(
            r"INTERNAL FACTOR 1\n((?:      .*\n)+)", block("GRIDDATA"))]
        self.assertEqual([len(part) for part in numbers], [size["NCPL"]] * 7)
        places = np.array([line.split()[1:] for line in block("VERTICES").splitlines()], dtype=float)
        cells = np.array([line.split() for line in block("CELL2D").splitlines()], dtype=float)
        self.assertEqual(len(places), size["NVERT"])
        a, b, c = places[cells[:, 4:].astype(int) - 1].transpose(1, 0, 2)
        areas = -0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
        self.check_model(areas, np.array(numbers[:4]), np.array(numbers[4:]).astype(int))

    def check_model(self, areas, levels, domain):
        thickness = levels[:-1] - levels[1:]
        self.assertGreaterEqual(thickness.min(), 0.0)
        for layer in range(3):
            volume = (areas * thickness[layer])[domain[layer] == 1].sum()
            self.assertAlmostEqual(volume / self.volume(layer), 1.0, delta=1e-9)
        self.assertTrue(np.all(thickness[domain == 1] > 0.0))
        self.assertTrue(np.all(thickness[domain == -1] == 0.0))
        self.assertEqual(set(domain[0]), {0, 1})  # on top nothing can be passed through
        self.assertEqual(set(domain[1]) & {-1, 1}, {-1, 1})
        self.assertEqual(set(domain[2]), {1})

    def test_errors(self):
        """One message, and no file."""
        few = few_layers()
        without = vtkUnstructuredGrid()
        without.ShallowCopy(few)
        without.GetCellData().RemoveArray("Triangle")
        points = vtkUnstructuredGrid()
        points.DeepCopy(few)
        vtk_to_numpy(points.GetPoints().GetData())[2, 1] = np.nan
        apart = vtkUnstructuredGrid()
        apart.DeepCopy(few)
        vtk_to_numpy(apart.GetCellData().GetArray("Triangle"))[:] = 0
        tilted = vtkUnstructuredGrid()
        tilted.DeepCopy(few)
        vtk_to_numpy(tilted.GetPoints().GetData())[:, 0] += 0.1 * np.arange(few.GetNumberOfPoints())
        below = vtkUnstructuredGrid()
        below.DeepCopy(few)
        vtk_to_numpy(below.GetCellData().GetArray("Layer"))[0] = 4
        feet = mesh_checks.with_text(mesh_checks.with_text(few, "VerticalUnit", "ft"), "HorizontalUnit", "m")
        for data, form, message in (
                (vtkUnstructuredGrid(), "msh", "no cells, expected layers as Horizon Layers makes them"),
                (without, "inp", "no cell data array Triangle of one number, expected layers"),
                (points, "msh", "coordinate nan of point 2, expected a finite number"),
                (below, "msh", "layer 4 of cell 0, expected 0 to 0"),
                (apart, "disv", "cells of triangle 0 that are not above each other, expected layers"),
                (tilted, "disv", "whose sides are not vertical, expected layers"),
                (mesh_checks.with_text(few, "VerticalDomain", "time"), "disv",
                 "layers in time, expected depths: convert the horizons before"),
                (feet, "disv", "z in ft and x and y in m, expected one unit")):
            path = FOLDER / ("wrong." + form)
            with self.assertRaisesRegex(ValueError, message):
                write(data, path)
            self.assertFalse(path.exists())
        with self.assertRaisesRegex(ValueError, "extension \"stl\", expected vtu, msh, inp or disv"):
            write(few, FOLDER / "wrong.stl")
        write(mesh_checks.with_text(feet, "HorizontalUnit", "ft"), FOLDER / "feet.disv")
        self.assertIn("  LENGTH_UNITS FEET\n", (FOLDER / "feet.disv").read_text())
        write(mesh_checks.with_text(few, "VerticalDomain", "time"), FOLDER / "time.msh")

    def test_other_grids(self):
        """What Horizon Layers does not make."""
        few = few_layers()
        count = few.GetNumberOfPoints()
        for kind, corners, layer, message in (
                (12, range(8), 0, "cell 0 of VTK type 12, expected wedges, pyramids and tetrahedra"),
                (WEDGE, range(5), 0, "cell 0 of VTK type 13 with 5 corners, expected 6"),
                (PYRAMID, range(6), 0, "cell 0 of VTK type 14 with 6 corners, expected 5"),
                (TETRA, (0, 1, 2, count), 0, "point id %d in cell 0, expected 0 to %d" % (count, count - 1)),
                (TETRA, (0, 1, 2, -1), 0, "point id -1 in cell 0, expected 0 to"),
                (TETRA, range(4), np.nan, "layer nan0* of cell 0, expected 0 to"),
                (TETRA, range(4), -1, "layer -1.0* of cell 0, expected 0 to")):
            grid = vtkUnstructuredGrid()
            grid.SetPoints(few.GetPoints())
            grid.InsertNextCell(kind, len(corners), list(corners))
            for name, value in (("Layer", layer), ("Triangle", 0)):
                array = numpy_to_vtk(np.array([value], dtype=float), deep=True)
                array.SetName(name)
                grid.GetCellData().AddArray(array)
            for form in ("msh", "inp", "disv"):
                with self.assertRaisesRegex(ValueError, message):
                    write(grid, FOLDER / ("other." + form))

    def test_names(self):
        """Layers have names, too, where nobody gave them any."""
        few = few_layers()
        few.GetFieldData().RemoveArray("LayerNames")
        write(few, FOLDER / "nameless.msh")
        self.assertIn('\n3 1 "Layer 1"\n', (FOLDER / "nameless.msh").read_text())

    def test_complete_or_not_at_all(self):
        writer = sh.vtkHorizonLayersWriter()
        writer.SetInputData(self.grid)
        messages = []
        writer.AddObserver("ErrorEvent", lambda *_: messages.append(1))
        for name in ("layers.txt", "layers"):
            writer.SetFileName(str(FOLDER / name))
            self.assertEqual((writer.Write(), len(messages)), (0, 1))
            self.assertFalse((FOLDER / name).exists())
            messages.clear()
        for form in ("msh", "inp", "disv"):
            path = FOLDER / ("old." + form)
            path.write_text("old")
            stopped = sh.vtkHorizonLayersWriter()
            stopped.SetInputData(self.grid)
            stopped.SetFileName(str(path))
            parts = []
            stopped.AddObserver("ProgressEvent", lambda caller, _: (
                parts.append(caller.GetProgress()), caller.SetAbortExecute(caller.GetProgress() > 0.25)))
            stopped.Write()
            self.assertEqual(sum(0.25 < part < 1.0 for part in parts), 1, parts)  # the end is told, too
            self.assertEqual(path.read_text(), "old")
        left = [path.name for path in FOLDER.iterdir() if "old" in path.name]
        self.assertEqual(sorted(left), ["old.disv", "old.inp", "old.msh"])

    def test_bodies(self):
        """Closed in other formats, too."""
        for name, body in self.layers.bodies.items():
            writer = sh.make("vtkGOCADTSurfWriter", FileName=str(FOLDER / "body.ts"))
            writer.SetInputDataObject(vtk_inputs.collect({name: body}))
            sh.update(writer)
            ((found, surface),) = vtk_inputs.read(FOLDER / "body.ts", "vtkGOCADTSurfReader").items()
            self.assertEqual(found, name)
            self.assertEqual(surface.GetNumberOfPolys(), body.GetNumberOfPolys())
            triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            edges = np.concatenate((triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]))
            self.assertEqual(len(np.unique(edges, axis=0)), len(edges))
            self.assertEqual({tuple(edge) for edge in edges}, {tuple(edge) for edge in edges[:, ::-1]})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
