# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Groups of faces in files of layers, sublayers and tetrahedra, by own readers of the files; Gmsh reads along where it is.

Argument: a folder for files.
"""

import collections
import importlib.util
import itertools
import pathlib
import sys
import unittest
import warnings

import mesh_checks
import numpy as np
import seismichorizons as package
import vtk_inputs
from layer_files import GMSH, areas_of, read_inp, read_msh, volume_of
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

FOLDER = pathlib.Path(sys.argv[1])
ROWS, COLUMNS = 20, 30
X, Y = np.meshgrid(np.arange(float(COLUMNS)), np.arange(float(ROWS)))
VARIANTS = ({}, {"Tetrahedra": True}, {"Sublayers": "3"}, {"Sublayers": "2 1 4", "Tetrahedra": True},
            {"LargestSublayerThickness": 6.0, "HeightUnit": "World"})


def stack_with(depths, links=None, **survey):
    survey = {"origin": (5e5, 6e6), "spacing": (25.0, 12.5), "azimuth": 40.0, "VerticalStep": 1.0, **survey}
    horizons = {name: vtk_inputs.horizon(z, **survey) for name, z in depths.items()}
    if links is not None:
        array = numpy_to_vtk(np.array(links, np.int32), deep=True)
        array.SetName("FaultedLinks")
        horizons["Base"].GetFieldData().AddArray(array)
    return horizons


def pinched():
    """The second layer pinches out between the others, and the first at the top; a fault ends inside. A horizon has a name
    that is a group, too."""
    depths = {"Roof": 100.0 + np.maximum(0.0, Y - 12.0), "Sand": 110.0 + 0.2 * Y, "Base": 110.0 + 0.2 * Y + np.maximum(0.0, X - 9.0),
              "Floor": 150.0 + np.sin(0.3 * X)}
    depths["Roof"][:6] = depths["Sand"][:6]
    return stack_with(depths, [(19, j, 0) for j in range(12)]), {"MaximumError": 0.2}


def with_hole():
    """Two of four layers are absent amid the stack: the first one has a free base there, and the last one a free top. The
    lattice is left-handed."""
    depths = {name: np.full(X.shape, 100.0 + 10.0 * n) + 0.1 * X for n, name in enumerate(("Top", "Sand", "Shale", "Coal", "Base"))}
    depths["Shale"][5:15, 8:20] = np.nan
    depths["Coal"][:, 22:] = depths["Shale"][:, 22:]
    return stack_with(depths, [(j, 16, 1) for j in range(10)], spacing=(25.0, -12.5)), {"MaximumError": 0.2, "Missing": "Void"}


def two_parts():
    """Layers that pinch out along a strip are in two parts, and so are their groups."""
    gap = np.maximum(0.0, np.abs(X - 14.0) - 3.0)
    depths = {"Top": np.full(X.shape, 90.0), "Sand": np.full(X.shape, 100.0), "Shale": 100.0 + gap, "Base": 100.0 + 2.0 * gap}
    return stack_with(depths), {"MaximumError": 0.1}


class BoundaryTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(parents=True, exist_ok=True)
        cls.made = {}
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for make, number in itertools.product((pinched, with_hole, two_parts), range(len(VARIANTS))):
                horizons, properties = make()
                variant = dict(VARIANTS[number])
                if make is with_hole and " " in variant.get("Sublayers", ""):
                    variant["Sublayers"] += " 2"
                layers = vtk_inputs.layers(horizons, **properties, **variant)
                path = FOLDER / ("%s_%d.msh" % (make.__name__, number))
                for form in (".msh", ".inp"):
                    writer = sh.make("vtkHorizonLayersWriter", FileName=str(path.with_suffix(form)))
                    writer.SetInputDataObject(layers.cells)
                    sh.update(writer)
                cls.made[make.__name__, number] = layers, path, variant

    def files(self):
        for name, (layers, path, variant) in self.made.items():
            yield name, layers, path, variant

    def test_faces(self):
        """Each face at the border of a layer is in one group, looks out of its layer, and surfaces are around volumes."""
        for _, layers, path, _ in self.files():
            points, entities, elements = read_msh(path)
            owners = collections.defaultdict(list)
            volumes = collections.defaultdict(float)
            for (dimension, tag), cells in elements.items():
                for cell in cells if dimension == 3 else ():
                    for face in GMSH[len(cell)]:
                        owners[frozenset(cell[n] for n in face)].append((tag, [cell[n] for n in face]))
                    own = volume_of(points, cell)
                    self.assertGreater(own, 0.0)
                    volumes[tag] += own
            by_name = collections.Counter()
            for tag, volume in volumes.items():
                by_name[entities[3, tag][0]] += volume
            for name, figures in layers.figures.items():
                self.assertAlmostEqual(by_name[name] / max(figures.volume, 1e-9), 1.0 if figures.volume else 0.0, delta=1e-8)
            self.assertLessEqual(max(map(len, owners.values())), 2)
            border = {face for face, own in owners.items() if len({entities[3, tag][0] for tag, _ in own}) == 2 or len(own) == 1}
            found = collections.Counter(frozenset(face) for (dimension, _), faces in elements.items() if dimension == 2 for face in faces)
            self.assertEqual(set(found), border)
            self.assertEqual(max(found.values()), 1)
            for tag, volume in volumes.items():
                around = 0.0
                for surface in entities[3, tag][1]:
                    for face in elements[2, abs(surface)]:
                        self.assertIn(tag, [own for own, _ in owners[frozenset(face)]])
                        corners = points[np.array(face) - 1] - points.mean(axis=0)
                        around += np.sign(surface) * sum(np.linalg.det(corners[[0, n, n + 1]]) for n in range(1, len(face) - 1)) / 6.0
                self.assertAlmostEqual(around / volume, 1.0, delta=1e-8)
                self.check_closed(points, [(np.sign(surface), elements[2, abs(surface)]) for surface in entities[3, tag][1]])

    def check_closed(self, points, surfaces):
        """Outward areas add up to none, and each edge has faces on both sides."""
        total = sum(sign * areas_of(points, faces).sum(axis=0) for sign, faces in surfaces)
        size = sum(np.abs(areas_of(points, faces)).sum() for _, faces in surfaces)
        self.assertLess(np.abs(total).max(), 1e-9 * size)
        edges = collections.Counter()
        for sign, faces in surfaces:
            for face in faces:
                for a, b in zip(face, face[1:] + face[:1]):
                    edges[(a, b) if sign > 0 else (b, a)] += 1
        self.assertTrue(all(edges[b, a] == count for (a, b), count in edges.items()))

    def test_names(self):
        """Of each group: the uppermost and the lowest faces of columns, walls, and horizons by the layers on both sides."""
        for (kind, _), layers, path, _ in self.files():
            points, entities, elements = read_msh(path)
            sides = collections.defaultdict(list)
            for (dimension, tag), cells in elements.items():
                for cell in cells if dimension == 3 else ():
                    for face in GMSH[len(cell)]:
                        corners = [cell[n] for n in face]
                        sides[frozenset(corners)].append((entities[3, tag][0], areas_of(points, [corners])[0, 2]))
            horizons = list(layers.horizons)
            places = {name: {tuple(np.round(place, 6)) for place in mesh_checks.coordinates(mesh)} for name, mesh in layers.horizons.items()}
            columns = collections.defaultdict(list)
            groups = set()
            for (dimension, tag), faces in elements.items():
                group = entities[dimension, tag][0]
                groups |= {group} if dimension == 2 else set()
                for face in faces if dimension == 2 else ():
                    where = frozenset(tuple(np.round(points[n - 1, :2], 6)) for n in face)
                    self.assertEqual(len(where) == 2, group in ("Sides", "Faults"), group)
                    if len(where) == 3:
                        columns[where].append((points[np.array(face) - 1, 2].mean(), group, face))
            for stacked in columns.values():
                stacked.sort(key=lambda one: -one[0])
                self.assertEqual((stacked[0][1], stacked[-1][1]), ("Top", "Base"))
                for _, group, face in stacked[1:-1]:
                    between = self.horizons_at(sides[frozenset(face)], horizons)
                    self.assertEqual(group, "Horizon 3" if between == ["Base"] and kind == "pinched" else ", ".join(between))
                    for name in between:
                        self.assertLessEqual({tuple(np.round(points[n - 1], 6)) for n in face}, places[name], name)
            inner = {"pinched": {"Sand", "Horizon 3", "Sand, Base"}, "with_hole": {"Sand", "Shale", "Coal", "Shale, Coal"},
                     "two_parts": {"Sand", "Shale"}}[kind]
            walls = {"Sides"} if kind == "two_parts" else {"Sides", "Faults"}
            self.assertEqual(groups, {"Top", "Base", *walls, *inner})

    def horizons_at(self, sides, horizons):
        """The horizons between two layers, or that of one."""
        names = sorted((list(self.layer_ends(name, horizons)), up) for name, up in sides)
        if len(names) == 2:
            return horizons[names[0][0][1]:names[1][0][0] + 1]
        ends, up = names[0]
        return [horizons[ends[0] if up > 0 else ends[1]]]

    def layer_ends(self, name, horizons):
        return next((n, n + 1) for n in range(len(horizons) - 1) if name == "%s to %s" % (horizons[n], horizons[n + 1]))

    def test_walls(self):
        """Sides and faults are those of the bodies, which are made otherwise, and faults are at the line that was given."""
        for (kind, _), layers, path, _ in self.files():
            points, entities, elements = read_msh(path)
            area = collections.Counter()
            for (dimension, tag), faces in elements.items():
                if dimension == 2:
                    area[entities[2, tag][0]] += np.linalg.norm(areas_of(points, faces), axis=1).sum()
            expected = collections.Counter()
            for body in layers.bodies.values():
                corners = mesh_checks.coordinates(body)[mesh_checks.triangles(body)]
                own = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2.0
                for face, name in ((2, "Sides"), (3, "Faults")):
                    expected[name] += own[vtk_to_numpy(body.GetCellData().GetArray("Face")) == face].sum()
            for name in ("Sides", "Faults"):
                self.assertAlmostEqual(area[name], expected[name], delta=1e-6 * expected["Sides"], msg=name)
            self.assertEqual(area["Faults"] > 0.0, kind != "two_parts")
            to_world = vtk_inputs.details(next(iter(layers.horizons.values()))).lattice_to_world
            for (dimension, tag), faces in elements.items():
                if dimension == 2 and entities[2, tag][0] == "Faults":
                    at = points[np.unique(faces if len({len(face) for face in faces}) == 1 else list(itertools.chain(*faces))) - 1]
                    columns = (np.linalg.inv(to_world) @ np.column_stack((at, np.ones(len(at)))).T).T
                    across, along = (columns[:, 0], columns[:, 1]) if kind == "pinched" else (columns[:, 1], columns[:, 0])
                    first, last = (19, 12) if kind == "pinched" else (16, 10)
                    self.assertTrue(np.all((across > first - 0.01) & (across < first + 1.01) & (along < last + 0.51)), (across, along))

    def test_abaqus(self):
        """The same faces in the same groups as in the file of Gmsh."""
        for _, _, path, _ in self.files():
            points, entities, elements = read_msh(path)
            expected = collections.defaultdict(set)
            for (dimension, tag), faces in elements.items():
                if dimension == 2:
                    expected[entities[2, tag][0]] |= set(map(frozenset, faces))
            found = read_inp(path.with_suffix(".inp"))
            for name, faces in found.items():
                self.assertEqual(len(faces), len(set(faces)), name)
                self.assertRegex(name, r"^(Top|Base|Sides|Faults|H\d+(_\d+)?_\w+)$")
            self.assertEqual(set(map(frozenset, found.values())), set(map(frozenset, expected.values())), path)

    def test_division(self):
        """Volumes, bodies and horizons do not change; sublayers share the volume of their layer equally."""
        for (kind, number), layers, path, variant in self.files():
            whole = self.made[kind, 0][0]
            for one, other in ((layers.bodies, whole.bodies), (layers.horizons, whole.horizons)):
                for name, mesh in one.items():
                    np.testing.assert_array_equal(mesh_checks.coordinates(mesh), mesh_checks.coordinates(other[name]))
            data = layers.cells.GetCellData()
            layer, sublayer, volume, thickness = (vtk_to_numpy(data.GetArray(name)) for name in ("Layer", "Sublayer", "Volume", "Thickness"))
            types = np.array([layers.cells.GetCellType(n) for n in range(layers.cells.GetNumberOfCells())])
            self.assertEqual(set(types) == {10}, "Tetrahedra" in variant)
            for own, figures in enumerate(layers.figures.values()):
                self.assertEqual((figures.wedges, figures.pyramids, figures.tetrahedra),
                                 tuple(np.count_nonzero(types[layer == own] == kind) for kind in (13, 14, 10)))
                if not figures.volume:
                    continue
                given = variant.get("Sublayers", "1").split()
                limit = variant.get("LargestSublayerThickness")
                count = int(given[min(own, len(given) - 1)]) if limit is None else int(np.ceil(figures.thickness_largest / limit - 1e-9))
                self.assertEqual(set(sublayer[layer == own]), set(range(count)))
                for n in range(count):
                    self.assertAlmostEqual(volume[(layer == own) & (sublayer == n)].sum() * count / figures.volume, 1.0, delta=1e-9)
                if limit is not None:
                    self.assertLessEqual(thickness[layer == own].max(), limit * (1 + 1e-9))
            if number == 1 and kind == "pinched":
                self.assertGreater(len(types), 2 * whole.cells.GetNumberOfCells())

    def test_modflow(self):
        """Sublayers are layers of the model; tetrahedra cannot be."""
        layers = self.made["pinched", 2][0]
        writer = sh.make("vtkHorizonLayersWriter", FileName=str(FOLDER / "sublayers.disv"))
        writer.SetInputDataObject(layers.cells)
        sh.update(writer)
        text = (FOLDER / "sublayers.disv").read_text(encoding="utf-8")
        self.assertIn("# layer 2: Roof to Sand, sublayer 2\n", text)
        self.assertIn("  NLAY 9\n", text)
        writer.SetInputDataObject(self.made["pinched", 1][0].cells)
        with self.assertRaisesRegex(ValueError, "that are not above each other, expected layers as Horizon Layers makes them without Tetrahedra"):
            sh.update(writer)

    def test_errors(self):
        horizons, properties = two_parts()
        for given, message in (
                ({"Sublayers": "1 2"}, "sublayers of 2 layers, expected one number, or 3 from the uppermost on"),
                ({"Sublayers": "0"}, "sublayers of Top to Sand: 0, expected 1 to 1000"),
                ({"Sublayers": "1 1 1.5"}, "sublayers of Shale to Base: 1.5, expected 1 to 1000"),
                ({"Sublayers": "many"}, "sublayers of Top to Sand: many, expected 1 to 1000"),
                ({"LargestSublayerThickness": -1}, "largest sublayer thickness -1, expected at least 0, with 0 for any"),
                ({"LargestSublayerThickness": 1e-3}, "sublayers of Top to Sand: more by LargestSublayerThickness, expected 1 to 1000")):
            with self.subTest(given), self.assertRaisesRegex(ValueError, message):
                vtk_inputs.layers(horizons, **properties, **given)
        few = self.made["two_parts", 0][0].cells
        twice = few.NewInstance()
        twice.ShallowCopy(few)
        for _ in range(2):
            twice.InsertNextCell(few.GetCellType(0), few.GetCell(0).GetPointIds())
        for name in ("Layer", "Sublayer", "Triangle", "FaultFaces"):
            values = vtk_to_numpy(few.GetCellData().GetArray(name))
            array = numpy_to_vtk(np.append(values, values[[0, 0]]), deep=True)
            array.SetName(name)
            twice.GetCellData().AddArray(array)
        for name in ("Thickness", "Volume"):
            twice.GetCellData().RemoveArray(name)
        writer = sh.make("vtkHorizonLayersWriter", FileName=str(FOLDER / "twice.msh"))
        writer.SetInputDataObject(twice)
        with self.assertRaisesRegex(ValueError, "a face of [34] cells, such as 0, expected layers as Horizon Layers makes them"):
            sh.update(writer)

    def test_package(self):
        """Keywords of the package, and files for OpenGeoSys: faces by the numbers of points and cells in the file of cells."""
        x = np.tile(np.arange(12.0), (8, 1))
        stack = {name: package.horizon(z, spacing=(25, 25), vertical_unit="m") for name, z in (
            ("Top", 100.0 + 0 * x), ("Sand", 110.0 + 0 * x), ("Base", 110.0 + np.maximum(0.0, x - 4.0)))}
        layers = package.layers(stack, "0.1 m", sublayers=[1, 2], largest_sublayer_thickness="5 m", tetrahedra=False)
        own = {(int(a), int(b)) for size in layers.cells for a, b in zip(layers.layer[size], layers.sublayer[size])}
        self.assertEqual(own, {(0, 0), (0, 1), (1, 0), (1, 1)})
        self.assertEqual(set(package.layers(stack, 0.1, sublayers=2, tetrahedra=True).cells), {4})
        layers.write(FOLDER / "ogs.vtu", boundaries=True)
        cells, corners = self.read_vtu(FOLDER / "ogs.vtu")
        self.assertEqual(set(vtk_to_numpy(cells.GetCellData().GetArray("MaterialIDs"))), {0, 1})
        self.assertEqual(set(np.concatenate(corners)), set(range(cells.GetNumberOfPoints())))
        self.assertEqual(set(layers.boundary), {"Top", "Base", "Sides", "Sand"})
        for name, plain in (("Top", "Top"), ("Base", "Base"), ("Sides", "Sides"), ("Sand", "H2_Sand")):
            faces, own = self.read_vtu(FOLDER / ("ogs_%s.vtu" % plain))
            nodes, elements = (vtk_to_numpy(array) for array in (
                faces.GetPointData().GetArray("bulk_node_ids"), faces.GetCellData().GetArray("bulk_element_ids")))
            self.assertEqual((nodes.dtype, elements.dtype), (np.uint64, np.uint64))
            np.testing.assert_array_equal(mesh_checks.coordinates(faces), mesh_checks.coordinates(cells)[nodes])
            for face, element in zip(own, elements):
                self.assertLessEqual(set(nodes[face]), set(corners[element]))
            expected = {size: len(rows) for size, rows in layers.boundary[name].items()}
            self.assertEqual(dict(collections.Counter(map(len, own))), expected)
        with self.assertRaisesRegex(ValueError, "boundaries of a file with another extension, expected .vtu"):
            layers.write(FOLDER / "ogs.msh", boundaries=True)

    def read_vtu(self, path):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        grid = reader.GetOutput()
        return grid, np.split(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), vtk_to_numpy(grid.GetCells().GetOffsetsArray())[1:-1])

    def test_gmsh(self):
        """The topology and, of triangles, the geometry can be made, and groups keep their faces and areas."""
        if importlib.util.find_spec("gmsh") is None:
            raise unittest.SkipTest("no gmsh")
        import gmsh

        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            for _, _, path, variant in self.files():
                points, entities, elements = read_msh(path)
                expected = collections.Counter()
                for (dimension, tag), faces in elements.items():
                    if dimension == 2:
                        expected[entities[2, tag][0]] += np.linalg.norm(areas_of(points, faces), axis=1).sum()
                gmsh.open(str(path))
                gmsh.model.mesh.createTopology()
                found = collections.Counter()
                for group in gmsh.model.getPhysicalGroups(2):
                    for entity in gmsh.model.getEntitiesForPhysicalGroup(*group):
                        for numbers in gmsh.model.mesh.getElements(2, entity)[1]:
                            found[gmsh.model.getPhysicalName(*group)] += gmsh.model.mesh.getElementQualities(numbers, "volume").sum()
                self.assertEqual(set(found), set(expected))
                for name, area in expected.items():
                    self.assertAlmostEqual(found[name] / area, 1.0, delta=1e-9, msg=name)
                self.assertGreater(len(gmsh.model.getEntities(1)), 0)
                if variant.get("Tetrahedra"):
                    gmsh.model.mesh.createGeometry()
        finally:
            gmsh.finalize()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
