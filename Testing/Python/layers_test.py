# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers between horizons, checked from their outputs alone. Argument: the folder Data."""

import itertools
import pathlib
import sys
import unittest
import warnings

import mesh_checks
import numpy as np
import vtk_inputs
from seismichorizons import vtk as sh
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

SAMPLE = str(pathlib.Path(sys.argv[1]) / "blobs.vsm")
ROWS, COLUMNS = 30, 40
X, Y = np.meshgrid(np.arange(COLUMNS, dtype=float), np.arange(ROWS, dtype=float))
TOP, BASE, OUTLINE, FAULT = range(4)


def on_grid(z, **keywords):
    return vtk_inputs.horizon(z, **{"spacing": (25.0, 12.5), "azimuth": 30.0, "origin": (5e5, 6e6), "VerticalStep": 1.0, **keywords})


def lattice_places(data, lattice=None):
    """Coordinates of points on their lattice, or on that of other data."""
    to_world = vtk_inputs.details(data if lattice is None else lattice).lattice_to_world
    world = mesh_checks.coordinates(data)
    return (np.linalg.inv(to_world) @ np.column_stack((world, np.ones(len(world)))).T).T[:, :3]


def surface_heights(mesh, places):
    """Heights of a mesh on the lattice at some columns; nan beside it."""
    corners = lattice_places(mesh)
    heights = np.full(len(places), np.nan)
    for a, b, c in corners[mesh_checks.triangles(mesh)]:
        low, high = np.minimum(np.minimum(a, b), c)[:2] - 1e-6, np.maximum(np.maximum(a, b), c)[:2] + 1e-6
        near = np.flatnonzero(np.all((places[:, :2] >= low) & (places[:, :2] <= high), axis=1))
        weights = np.linalg.solve(np.array([[a[0], b[0], c[0]], [a[1], b[1], c[1]], [1, 1, 1]]),
                                  np.column_stack((places[near, :2], np.ones(len(near)))).T)
        inside = np.all(weights >= -1e-9, axis=0)
        heights[near[inside]] = weights.T[inside] @ np.array([a[2], b[2], c[2]])
    return heights


def add_cuts(horizon, links):
    array = numpy_to_vtk(links, deep=True)
    array.SetName("FaultedLinks")
    horizon.GetFieldData().AddArray(array)


class LayersTest(unittest.TestCase):
    def check(self, made, horizons, error, moved=()):
        """What holds for all layers, given the points that were read. Gives the share of these that are beside them."""
        cells = vtkCellSizeFilter()
        cells.SetInputData(made.cells)
        cells.Update()
        volumes = vtk_to_numpy(cells.GetOutput().GetCellData().GetArray("Volume"))
        data = made.cells.GetCellData()
        own = vtk_to_numpy(data.GetArray("Volume"))
        layer = vtk_to_numpy(data.GetArray("Layer"))
        self.assertGreater(own.min(), 0.0)
        np.testing.assert_allclose(own, volumes, rtol=1e-6)  # large coordinates
        self.assertEqual(len(np.unique(mesh_checks.coordinates(made.cells), axis=0)), made.cells.GetNumberOfPoints())
        names = vtk_inputs.details(made.cells).layer_names
        names = [names] if isinstance(names, str) else names
        self.assertEqual(names, list(made.figures))
        for number, name in enumerate(names):
            figures = made.figures[name]
            self.assertAlmostEqual(figures.volume, own[layer == number].sum(), delta=1e-9 * figures.volume)
            if name in made.bodies:
                self.check_body(made.bodies[name], figures)
            self.assertAlmostEqual(made.curve[name][-1], figures.volume, delta=1e-9 * figures.volume)
            self.assertEqual(made.curve[name][0], 0.0)
            self.assertTrue(np.all(np.diff(made.curve[name]) >= -1e-9 * figures.volume))
        self.assertTrue(np.all(np.diff(made.curve["contact"]) < 0.0))
        beside = 0
        for name, points in horizons.items():
            places = lattice_places(points, made.horizons[name])
            off = surface_heights(made.horizons[name], places) - places[:, 2]
            outside = np.count_nonzero(np.isnan(off))
            self.assertEqual(vtk_inputs.details(made.horizons[name]).number_of_outside_points, outside)
            beside += outside / len(off) / len(horizons)
            if name not in moved:
                self.assertLessEqual(np.nanmax(np.abs(off)), error + 1e-6, name)
            self.assertLessEqual(vtk_inputs.details(made.horizons[name]).largest_error, error + 1e-9)
        return beside

    def check_body(self, body, figures):
        """Closed, facing outwards, with upright walls."""
        points = mesh_checks.coordinates(body)
        points = points - points.mean(axis=0)
        triangles = mesh_checks.triangles(body)
        edges = np.concatenate((triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]))
        self.assertEqual(len(np.unique(edges, axis=0)), len(edges))
        self.assertEqual({tuple(edge) for edge in edges}, {tuple(edge) for edge in edges[:, ::-1]})
        a, b, c = points[triangles].transpose(1, 0, 2)
        self.assertAlmostEqual(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0 / figures.volume, 1.0, delta=1e-9)
        upwards = np.cross(b - a, c - a)[:, 2] / 2.0
        face = vtk_to_numpy(body.GetCellData().GetArray("Face"))
        self.assertAlmostEqual(upwards[face == TOP].sum() / figures.area, 1.0, delta=1e-9)
        self.assertAlmostEqual(upwards[face == BASE].sum() / figures.area, -1.0, delta=1e-9)
        self.assertLess(np.abs(upwards[face >= OUTLINE]).max(), 1e-6 * figures.area)

    def test_sample(self):
        """Horizons with holes, on a turned lattice; both domains."""
        horizons = vtk_inputs.read(SAMPLE, ColumnStep=(3.0, 4.0), RowStep=(-8.0, 6.0))
        each = vtk_inputs.layers(horizons, MaximumError=0.75)
        self.check(each, horizons, 0.75)
        common = vtk_inputs.layers(horizons, MaximumError=1.5, Domain="Common")
        self.assertLess(self.check(common, horizons, 1.5), 0.5)
        self.assertLess(common.cells.GetNumberOfCells(), each.cells.GetNumberOfCells())
        kept = vtk_inputs.layers(horizons, MaximumError=0.75, Domain="Common", KeepOutlines=True, FitHeights=False, Effort="Fast")
        self.check(kept, horizons, 0.75)
        for mesh in kept.horizons.values():
            self.assertIsNotNone(mesh.GetPointData().GetArray("Amplitude"))

    def test_planes(self):
        """Exact volumes, whichever way rows turn and z counts; from the uppermost on in any order."""
        depths = {"Base": 150.0 + 0.25 * X, "Top": 100.0 + 0.5 * Y, "Middle": 120.0 + 0.25 * X}
        area = 25.0 * 12.5 * (ROWS - 1) * (COLUMNS - 1)
        expected = [area * (20.0 + 0.25 * (COLUMNS - 1) / 2 - 0.5 * (ROWS - 1) / 2), area * 30.0]
        for spacing in ((25.0, 12.5), (25.0, -12.5)):
            for sign, direction in ((1.0, "Down"), (-1.0, "Up")):
                horizons = {name: on_grid(sign * z, spacing=spacing, VerticalDirection=direction)
                            for name, z in depths.items()}
                made = vtk_inputs.layers(horizons, MaximumError=0.1)
                self.check(made, horizons, 0.1)
                self.assertEqual(list(made.figures), ["Top to Middle", "Middle to Base"])
                np.testing.assert_allclose([own.volume for own in made.figures.values()], expected, rtol=1e-9)
        with self.assertWarnsRegex(UserWarning, "contact -1e\\+06 below all layers, expected a z from "):
            contact = vtk_inputs.layers(horizons, MeasureAboveContact=True, Contact=-1e6).figures["Middle to Base"]
        self.assertAlmostEqual(contact.volume_above_contact, contact.volume, delta=1e-9 * contact.volume)

    def test_pinch_out(self):
        """A layer that ends on a line through columns."""
        top = {"Top": on_grid(np.full(X.shape, 100.0)), "Base": on_grid(100.0 + np.maximum(0.0, X - 15.0))}
        made = vtk_inputs.layers(top, MaximumError=0.2)
        self.check(made, top, 0.2)
        figures = made.figures["Top to Base"]
        self.assertAlmostEqual(figures.area, 25.0 * 12.5 * (ROWS - 1) * (COLUMNS - 1 - 15), delta=1e-6)
        self.assertAlmostEqual(figures.volume, 25.0 * 12.5 * (ROWS - 1) * (COLUMNS - 1 - 15) ** 2 / 2, delta=0.5)
        self.assertGreater(figures.tetrahedra + figures.pyramids, 0)

    def test_crossings(self):
        """A basement through two horizons: each policy moves the horizons that it should."""
        horizons = {"Top": on_grid(np.full(X.shape, 100.0)), "Fill": on_grid(np.full(X.shape, 110.0)),
                    "Basement": on_grid(80.0 + 2.0 * X)}
        moves = {}
        for policy, moved in (("UpperWins", ("Basement",)), ("LowerWins", ("Top", "Fill")), ("Mean UpperWins", ("Basement",))):
            chosen = {"CrossingsByLayer": policy} if " " in policy else {"Crossings": policy}
            made = vtk_inputs.layers(horizons, MaximumError=0.75, Order="AsGiven", **chosen)
            self.check(made, horizons, 0.75, moved)
            moves[policy] = {name: vtk_inputs.details(mesh).moved_columns for name, mesh in made.horizons.items()}
        self.assertEqual(moves["UpperWins"], {"Top": 0, "Fill": 0, "Basement": 15 * ROWS})
        self.assertEqual(moves["LowerWins"], {"Top": 10 * ROWS, "Fill": 15 * ROWS, "Basement": 0})
        self.assertEqual(moves["Mean UpperWins"], moves["UpperWins"])
        with self.assertRaisesRegex(ValueError, "Fill and Basement cross in 450 columns, by up to 30 lattice units, expected none: choose Mean"):
            vtk_inputs.layers(horizons, Order="AsGiven", CrossingsByLayer="Mean Stop")
        with self.assertWarnsRegex(UserWarning, "Fill and Basement cross by up to 30, expected no more than their noise makes"):
            vtk_inputs.layers(horizons, Order="AsGiven")
        with self.assertRaisesRegex(ValueError, "Fill is above Basement in 6. % of their columns and below in 3. %, expected an order"):
            vtk_inputs.layers(horizons)

    def test_repaired(self):
        """All points of horizons, in order, by the crossings alone."""
        spacing = {"spacing": (25.0, -12.5)}
        horizons = {"Basement": on_grid((80.0 + 2.0 * X)[:, 3:], origin=(5e5 + 75.0 * np.cos(np.pi / 3), 6e6 + 75.0 * np.sin(np.pi / 3)), **spacing),
                    "Top": on_grid(np.full(X.shape, 100.0), **spacing), "Fill": on_grid(np.full(X.shape, 110.0), **spacing)}
        given = {name: mesh_checks.coordinates(points) for name, points in horizons.items()}
        order = ["Top", "Fill", "Basement"]
        stack = {name: horizons[name] for name in order}
        for policy in ("UpperWins", "LowerWins", "Mean"):
            made = vtk_inputs.crossings(stack, Order="AsGiven", Crossings=policy)
            self.assertEqual(list(made), order)
            heights = np.full((3, *X.shape), np.nan)
            for n, name in enumerate(order):
                points = mesh_checks.coordinates(made[name])
                np.testing.assert_array_equal(points[:, :2], given[name][:, :2])
                moved = mesh_checks.array(made[name], "Moved")
                np.testing.assert_allclose(points[:, 2] - given[name][:, 2], moved, atol=1e-9)
                self.assertEqual(np.count_nonzero(moved), vtk_inputs.details(made[name]).moved_columns)
                self.assertAlmostEqual(np.abs(moved).max(), vtk_inputs.details(made[name]).farthest_move, delta=1e-9)
                columns = np.rint(lattice_places(made[name], horizons["Top"])[:, :2]).astype(int)
                heights[n, columns[:, 1], columns[:, 0]] = points[:, 2]
                np.testing.assert_allclose(mesh_checks.array(made[name], "VerticalIndex"), lattice_places(made[name])[:, 2],
                                           atol=1e-9)
            self.assertEqual(np.count_nonzero(np.isnan(heights[2])), 3 * ROWS)
            before = np.array((np.full(X.shape, -100.0), np.full(X.shape, -110.0), -80.0 - 2.0 * (X - 0.0)))
            before[2, :, :3] = np.nan
            expected = {"UpperWins": np.minimum.accumulate(np.nan_to_num(before, nan=-1e9)),
                        "LowerWins": np.maximum.accumulate(np.nan_to_num(before, nan=-1e9)[::-1])[::-1]}.get(policy)
            known = ~np.isnan(heights)
            if expected is not None:
                np.testing.assert_allclose(heights[known], expected[known], atol=1e-9)
            self.assertTrue(np.all(np.diff(np.nan_to_num(heights, nan=-1e9), axis=0) <= 1e-9))

    def test_one_number(self):
        """Horizons that become one have one z to the bit, whatever the step; in order, nothing moves any more."""
        for step, policy in ((0.1, "UpperWins"), (0.01, "LowerWins"), (0.3, "LowerWins"), (1.0, "Mean"), (0.1, "Mean")):
            noise = np.random.default_rng(1).normal(0.0, 1.0, (3, *X.shape))
            stack = {name: vtk_inputs.horizon((1500.0 + 10.0 * np.sin(0.1 * X) + 0.8 * n + noise[n]).round(1), spacing=(25, 25),
                                              VerticalUnit="m", VerticalStep=step) for n, name in enumerate("ABC")}
            with self.subTest(step=step, policy=policy):
                made = vtk_inputs.crossings(stack, Order="AsGiven", Crossings=policy)
                self.assertGreater(sum(vtk_inputs.details(points).moved_columns for points in made.values()), 100)
                heights = np.array([mesh_checks.coordinates(points)[:, 2] for points in made.values()])
                self.assertTrue(np.all(np.diff(heights, axis=0) <= 0.0))
                for name, points in made.items():
                    still = mesh_checks.array(points, "Moved") == 0.0
                    np.testing.assert_array_equal(mesh_checks.coordinates(points)[still], mesh_checks.coordinates(stack[name])[still])
                for pair in ("AB", "BC", "AC"):
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        self.assertEqual(vtk_inputs.details(vtk_inputs.thickness(*(made[name] for name in pair))).isochore_crossings, 0)
                for points in vtk_inputs.crossings(made, Order="AsGiven", Crossings=policy).values():
                    self.assertEqual((vtk_inputs.details(points).moved_columns, vtk_inputs.details(points).farthest_move), (0, 0.0))
        with self.assertRaisesRegex(ValueError, r"A and B cross in \d+ columns, by up to [0-9.]+ m, expected none"):
            vtk_inputs.crossings(stack, Order="AsGiven", Crossings="Stop")

    def test_faults(self):
        """Thrown down along a line that ends inside, in the lower horizon alone: a wall on both sides, in all layers."""
        lower = 150.0 + np.where((X > 19.5) & (Y < 20.5), 12.0, 0.0)
        faulted = sh.apply(sh.make("vtkHorizonFaults", SmallestThrow=5.0), on_grid(lower))
        horizons = {"Top": on_grid(np.full(X.shape, 100.0)), "Base": faulted}
        made = vtk_inputs.layers(horizons, MaximumError=0.75)
        self.check(made, horizons, 0.75)
        figures = made.figures["Top to Base"]
        cut = 25.0 * 12.5 * (ROWS - 1) * (COLUMNS - 1) - figures.area
        self.assertGreaterEqual(figures.area_at_faults, 25.0 * 12.5 * 20)
        self.assertAlmostEqual(figures.area_at_faults, cut, delta=1e-6)
        self.assertGreater(figures.volume_at_faults / figures.area_at_faults, 50.0)
        self.assertLess(figures.volume_at_faults / figures.area_at_faults, 62.0)
        body = made.bodies["Top to Base"]
        face = vtk_to_numpy(body.GetCellData().GetArray("Face"))
        columns = lattice_places(body)[mesh_checks.triangles(body)][face == FAULT][:, :, 0]
        self.assertGreaterEqual(np.count_nonzero(face == FAULT), 4)
        self.assertTrue(np.all((columns >= 19.0) & (columns <= 20.0)) or figures.area_at_faults > 25.0 * 12.5 * 21)
        whole = vtk_inputs.layers(horizons, MaximumError=0.75, TearAtFaults=False)
        self.assertEqual(whole.figures["Top to Base"].area_at_faults, 0.0)
        self.check(whole, horizons, 0.75)

    def test_two_lattices(self):
        """Every second line of one horizon, and another window of the survey."""
        fine = on_grid(100.0 + 0.5 * Y)
        coarse = on_grid((120.0 + 0.5 * Y)[::2, ::2], spacing=(50.0, 25.0))
        made = vtk_inputs.layers({"Coarse": coarse, "Fine": fine}, MaximumError=0.1)
        self.check(made, {"Coarse": coarse, "Fine": fine}, 0.1)
        figures = made.figures["Fine to Coarse"]
        self.assertAlmostEqual(figures.volume / figures.area, 20.0, delta=1e-9)
        step = fine.GetPoint(3 * COLUMNS + 5)
        window = on_grid((120.0 + 0.5 * (Y + 3))[:, :30], origin=step[:2])
        made = vtk_inputs.layers({"Window": window, "All": fine}, MaximumError=0.1)
        self.check(made, {"Window": window, "All": fine}, 0.1)
        self.assertAlmostEqual(made.figures["All to Window"].area, 25.0 * 12.5 * 26 * 29, delta=1e-6)
        deep = on_grid(200.0 + X)
        with self.assertRaisesRegex(ValueError, "Coarse with steps of 2 columns from point to point, expected 1 for the domain"):
            vtk_inputs.layers({"Coarse": coarse, "Fine": fine, "Deep": deep}, Missing="Void")
        rough = on_grid(100.0 + 3.0 * np.sin(X) * np.cos(2.0 * Y))
        for domain, third in (("EachLayer", {}), ("Common", {"Deep": deep})):
            stack = {"Rough": rough, "Coarse": on_grid(np.full((15, 20), 140.0), spacing=(50.0, 25.0)), **third}
            self.check(vtk_inputs.layers(stack, MaximumError=0.75, Domain=domain), stack, 0.75)
        with self.assertRaisesRegex(ValueError, "a point of Between at .*, which is not on a column of Fine, expected points on "
                                                "one lattice"):
            vtk_inputs.layers({"Fine": fine, "Between": on_grid(150.0 + Y, origin=(5e5 + 3.0, 6e6))})

    def test_straight_line(self):
        """A layer ends along the line through the outermost columns that have none of it, whatever the error."""
        x, y = np.meshgrid(np.arange(61.0), np.arange(61.0))
        top = 100.0 + 3.0 * np.sin(x / 9.0) + 2.0 * np.cos(y / 7.0)
        wedge = {name: vtk_inputs.horizon(top + own, VerticalStep=1.0)
                 for name, own in (("A", 0.0), ("B", np.maximum(0.0, 0.1 * (x - 20.0))))}
        for error in (0.3, 1.5, 3.0):
            made = vtk_inputs.layers(wedge, MaximumError=error, MinimumThickness=1.0, KeepOutlines=True)
            self.assertAlmostEqual(made.figures["A to B"].area, 31.0 * 60.0, 6)

    def test_strips_at_faults(self):
        """What layers leave out at faults is what they fill without them; beside gaps, too."""
        x, y = np.meshgrid(np.arange(41.0), np.arange(41.0))
        some = np.random.default_rng(1).random(x.shape)
        full, sparse, half = np.ones(x.shape, bool), some < 0.3, some < 0.6
        for known, columns, number, domain in ((full, (20,), 2, "Common"), (half, (20,), 2, "Common"), (sparse, (20,), 2, "Common"),
                                               (full, (0,), 3, "EachLayer"), (full, (5, 6), 3, "EachLayer")):
            links = np.array([(i, j, 0) for j in range(41) for i in columns], np.int32)
            horizons = {}
            for n in range(number):
                horizons["ABC"[n]] = vtk_inputs.horizon(np.where(known, 100.0 + 20.0 * n + 0.1 * x + 0.05 * y, np.nan), VerticalStep=1.0)
                add_cuts(horizons["ABC"[n]], links)
            cut, whole = (vtk_inputs.layers(horizons, MaximumError=0.0, KeepOutlines=domain == "Common", TearAtFaults=use,
                                            Domain=domain).figures["A to B"] for use in (True, False))
            self.assertAlmostEqual(cut.area_at_faults, whole.area - cut.area, 6)
            self.assertAlmostEqual(cut.volume_at_faults, whole.volume - cut.volume, 5)
            self.assertGreater(cut.area_at_faults, 10.0)

    def test_cutoffs(self):
        """Heights at faults are nearer to the truth than the points are, as they are fitted, and so are throws."""
        offs = {True: [], False: []}
        for seed, fit in itertools.product(range(5), (True, False)):
            noise = np.random.default_rng(seed).normal(0.0, 0.2, (2, *X.shape))
            horizons = {name: vtk_inputs.horizon(z + 2.0 * np.sin(Y / 6.0) + np.where(X > 19.5, 12.0, 0.0) + own, VerticalStep=1.0)
                        for name, z, own in zip(("Top", "Base"), (100.0, 130.0), noise)}
            for horizon in horizons.values():
                add_cuts(horizon, np.array([(19, j, 0) for j in range(ROWS)], np.int32))
            made = vtk_inputs.layers(horizons, MaximumError=0.6, FitHeights=fit)
            self.check(made, horizons, 0.6)
            for z, mesh in zip((100.0, 130.0), made.horizons.values()):
                x, y, height = mesh_checks.coordinates(mesh).T
                at_fault = (x == 19.0) | (x == 20.0)
                offs[fit].extend((np.abs(height) - z - 2.0 * np.sin(y / 6.0) - np.where(x > 19.5, 12.0, 0.0))[at_fault])
        self.assertGreater(len(offs[True]), 80)
        self.assertLess(np.std(offs[True]), 0.8 * np.std(offs[False]))

    def test_units(self):
        """Heights in the unit of z are those in vertical indices; what any horizon says of units counts; of vertical
        indices the smallest."""
        kind = {"VerticalStep": 4.0, "VerticalUnit": "m"}
        pair = {"A": on_grid(400.0 + 24.0 * np.sin(X / 6.0), **kind), "B": on_grid(420.0 + 24.0 * np.sin(X / 6.0) + 4.0 * np.cos(X / 3.0), **kind)}
        for thin in (0.0, 0.25):
            plain = vtk_inputs.layers(pair, MaximumError=0.75, MinimumThickness=thin)
            world = vtk_inputs.layers(pair, MaximumError=3.0, MinimumThickness=4.0 * thin, HeightUnit="World")
            self.assertEqual(world.figures, plain.figures)
        bare = on_grid(430.0 + 0 * X)
        for one, two in ((pair["A"], bare), (bare, pair["A"])):
            made = vtk_inputs.layers({"One": one, "Two": two})
            self.assertEqual(vtk_inputs.details(made.cells).vertical_unit, "m")
            self.assertEqual(abs(vtk_inputs.details(made.cells).lattice_to_world[2, 2]), 1.0)
        for name, units in (("HorizontalUnit", ("ft", "m")), ("VerticalUnit", ("ms", "m")), ("CoordinateSystem", ("EPSG:23031", "EPSG:32631"))):
            with self.assertRaisesRegex(ValueError, 'Two with z in "depth"|Two with z in|Two with x and y in "m", expected "ft" as in One: convert'
                                        '|Two with the coordinate system "EPSG:32631", expected "EPSG:23031" as in One'):
                vtk_inputs.layers({number: mesh_checks.with_text(bare, name, unit) for number, unit in zip(("One", "Two"), units)})
        for name, same in (("HorizontalUnit", ("m", "metre", "Metres")), ("VerticalUnit", ("metres", "m")), ("CoordinateSystem", ("EPSG:23031", "epsg:23031"))):
            vtk_inputs.layers({str(n): mesh_checks.with_text(on_grid(430.0 + 10.0 * n + 0 * X), name, unit) for n, unit in enumerate(same)})
        with self.assertWarnsRegex(UserWarning, "z is time"):
            vtk_inputs.layers({"One": bare, "Two": mesh_checks.with_text(on_grid(440.0 + 0 * X), "VerticalUnit", "ms")})

    def test_errors(self):
        top, base = on_grid(np.full(X.shape, 100.0)), on_grid(np.full(X.shape, 120.0))
        for wrong, message in (({"Top": top}, "one horizon with points, expected at least 2"),
                               ({"Top": top, "Far": on_grid(np.full(X.shape, 120.0), origin=(5e5 - 2500.0 * np.sqrt(3) / 2, 6e6 + 1250.0))},
                                "Top and Far have no column in common|which is not on a column")):
            with self.assertRaisesRegex(ValueError, message):
                vtk_inputs.layers(wrong)
        pair = {"Top": top, "Base": base}
        for keywords, message in (({"CrossingsByLayer": "Middle"}, 'crossings "Middle", expected Mean, UpperWins, LowerWins or Stop'),
                                  ({"CrossingsByLayer": "Mean Stop"}, "crossings of 2 layers, expected 1, from the uppermost on"),
                                  ({"MaximumError": -2.0}, "maximum error -2, expected at least 0, or -1 for automatic"),
                                  ({"MinimumThickness": float("nan")}, "minimum thickness nan, expected a finite number, at least 0"),
                                  ({"SmallestPinch": 0}, "smallest pinch 0, expected at least 1"),
                                  ({"SmallestAngle": 70.0}, "smallest angle 70, expected .*60")):
            with self.assertRaisesRegex(ValueError, message):
                vtk_inputs.layers(pair, **keywords)
        with self.assertRaisesRegex(ValueError, 'Base with z in "time", expected "depth" as in Top'):
            vtk_inputs.layers({name: mesh_checks.with_text(points, "VerticalDomain", domain)
                               for (name, points), domain in zip(pair.items(), ("depth", "time"))})
        with self.assertWarnsRegex(UserWarning, "z is time, so that volumes are areas times time"):
            vtk_inputs.layers({name: mesh_checks.with_text(points, "VerticalDomain", "time") for name, points in pair.items()})
        with self.assertWarnsRegex(UserWarning, "z is time, so that volumes are areas times time"):  # by what the user says
            vtk_inputs.layers(vtk_inputs.read(SAMPLE, VerticalUnit="ms", VerticalStep=4.0), Crossings="LowerWins")
        mesh = vtk_inputs.surface(on_grid(100.0 + np.sin(X)), MaximumError=2.0)
        with self.assertRaisesRegex(ValueError, "Top: a mesh of 2 triangles, already simplified, expected all points"):
            vtk_inputs.layers({"Top": mesh, "Base": base})
        line = np.full(X.shape, np.nan)
        line[3] = 150.0
        for thin in (top, on_grid(line)):
            with self.assertWarnsRegex(UserWarning, "Top to Thin without a cell, expected horizons that are apart by more than the error over an area"):
                empty = vtk_inputs.layers({"Top": top, "Thin": thin}, Order="AsGiven")
            self.assertEqual((empty.figures["Top to Thin"].volume, empty.bodies), (0.0, {}))
        with self.assertRaisesRegex(ValueError, "contact nan, expected a finite number"):
            vtk_inputs.layers(pair, MeasureAboveContact=True, Contact=float("nan"))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            vtk_inputs.layers(pair)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
