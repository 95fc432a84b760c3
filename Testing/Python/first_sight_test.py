# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: what each stage looks like when it is shown first, which is the same in the window.

Argument: a folder for files.
"""

import pathlib
import struct
import sys
import unittest

from paraview import servermanager, simple
from seismichorizons import client

FOLDER = pathlib.Path(sys.argv.pop())
SIDE = 40


def surface(column, row):
    """Two patches, the larger one with a hole and a fault."""
    if column == 30 or (18 <= column < 21 and 5 <= row < 8):
        return ""
    return "%d 1 1 0.5 4.0" % ((10 if column < 12 else 22) + (column + row) // 8)


def write_file():
    path = FOLDER / "sight.vsm"
    lines = [surface(column, row) for row in range(SIDE) for column in range(SIDE)]
    path.write_text("%d %d 60\n%s\n" % (SIDE, SIDE, "\n".join(lines)))
    return str(path)


def write_cube(path, columns, rows):
    """SEG-Y of IEEE floats: 100 samples a trace, from -2 to 2, and one sample of 1,000."""
    text = b" " * 3200
    header = bytearray(400)
    struct.pack_into(">hxxhxxh", header, 16, 4000, 100, 5)
    traces = []
    for row in range(rows):
        for column in range(columns):
            place = bytearray(240)
            struct.pack_into(">hh", place, 114, 100, 4000)
            struct.pack_into(">iiii", place, 180, 25 * column, 25 * row, 100 + row, 300 + column)
            samples = [(n - 50) / 25 for n in range(100)]
            samples[7] = 1000 if row == column == 3 else samples[7]
            traces.append(bytes(place) + struct.pack(">100f", *samples))
    path.write_bytes(text + bytes(header) + b"".join(traces))


def colored_by(display):
    return tuple(display.ColorArrayName)


def shown_arrays(display):
    points = display.SMProxy.GetRepresentedDataInformation().GetPointDataInformation()
    return [points.GetArrayInformation(n).GetName() for n in range(points.GetNumberOfArrays())]


def range_of(display):
    values = list(display.LookupTable.RGBPoints)[0::4]
    return [round(min(values), 3), round(max(values), 3)]


def labels(display):
    """The legend by value; None where colours are not those of categories."""
    table = display.LookupTable
    entries = list(table.Annotations)
    return dict(zip(entries[0::2], entries[1::2])) if table.InterpretValuesAsCategories else None


class FirstSightTest(unittest.TestCase):
    def setUp(self):
        self.horizons = simple.VerneySparseMatrixReader(FileName=write_file())
        self.view = simple.CreateView("RenderView")

    def tearDown(self):
        simple.Delete(self.view)
        # Colours of an array stay for the whole session otherwise.
        for table in servermanager.ProxyManager().GetProxiesInGroup("lookup_tables").values():
            simple.Delete(table)

    def show(self, source, port=0):
        display = simple.Show(simple.OutputPort(source, port), self.view)
        meshes = ("HorizonSurface", "HorizonTriangulation", "HorizonDecimation")
        has_edges = source.__class__.__name__ in (meshes if port == 0 else ("HorizonLayers", "HorizonSealedModel"))
        self.assertEqual(display.Representation, "Surface With Edges" if has_edges else "Surface")
        return display

    def test_points(self):
        display = self.show(self.horizons)
        self.assertEqual((display.PointSize, colored_by(display)), (3, ("POINTS", "Depth")))

    def test_volumes_are_seen_through(self):
        volume = simple.VerneySparseMatrixReader(FileName=self.horizons.FileName, OutputType="Volume")
        display = simple.Show(volume, self.view)
        self.assertEqual((display.Representation, colored_by(display)), ("Volume", ("POINTS", "SurfaceId")))
        # Value, opacity, midpoint and sharpness of each point: clear where there is no horizon.
        points = list(display.ScalarOpacityFunction.Points)
        self.assertEqual([(value, opacity) for value, opacity in zip(points[0::4], points[1::4])][:3],
                         [(0, 0), (0.5, 0), (1, 0.9)])

    def test_large_volumes_are_a_slice(self):
        path = FOLDER / "wide.vsm"
        path.write_text("4 2 4000000\n3 1 1 0 0\n" + "\n" * 7)
        volume = simple.VerneySparseMatrixReader(FileName=str(path), OutputType="Volume")
        self.assertEqual(simple.Show(volume, self.view).Representation, "Slice")

    def test_maps_are_surfaces(self):
        self.show(simple.VerneySparseMatrixReader(FileName=self.horizons.FileName, OutputType="Images"))

    def test_volumes_of_attributes_show_them(self):
        path = FOLDER / "attributes.vsm"
        path.write_text("2 1 9\n3 1 1 5.5 0\n4 1 2 -6 0\n")
        for array in ("Amplitude", "Thickness"):
            volume = simple.VerneySparseMatrixReader(FileName=str(path), OutputType="Volume", VolumeArray=array)
            self.assertEqual(colored_by(simple.Show(volume, self.view)), ("POINTS", array))

    def test_sizes_of_horizons(self):
        self.horizons.UpdatePipelineInformation()
        self.assertEqual(list(self.horizons.GetProperty("HorizonSizes")), [SIDE * (SIDE - 1) - 9])

    def test_outlines_stand_out_from_the_points(self):
        display = self.show(simple.HorizonExteriorBoundary(Input=self.horizons))
        tubes = simple.GetParaViewVersion().major < 6
        self.assertEqual((display.LineWidth, display.RenderLinesAsTubes, display.PointSize), (3, tubes, 2))
        self.assertEqual(colored_by(display), ("POINTS", "Boundary"))
        self.assertEqual(labels(display), {"0": "inside", "1": "outline", "2": "hole"})

    def test_simplified_outlines_differ_from_outlines(self):
        outlines = simple.HorizonExteriorBoundary(Input=self.horizons)
        first = self.show(outlines)
        display = self.show(simple.HorizonBoundarySimplification(Input=outlines))
        self.assertEqual(colored_by(display), ("POINTS", "Simplified Boundary"))
        self.assertEqual(labels(display), {"0": "inside", "1": "simplified outline", "2": "hole"})
        self.assertNotEqual(list(first.LookupTable.IndexedColors), list(display.LookupTable.IndexedColors))
        simple.Render(self.view)
        self.assertIn("Simplified Boundary", shown_arrays(display))
        self.assertNotIn("Simplified Boundary", shown_arrays(first))

    def test_simplified_points_are_large(self):
        outlines = simple.HorizonExteriorBoundary(Input=self.horizons)
        for stage in (simple.HorizonRoughSimplification, simple.HorizonElaborateSimplification):
            display = self.show(stage(Input=outlines))
            self.assertEqual((display.LineWidth, display.PointSize, display.RenderPointsAsSpheres), (3, 8, 1))
            self.assertEqual(colored_by(display), ("POINTS", "Depth"))

    def test_many_points_are_small_enough_to_be_told_apart(self):
        path = FOLDER / "many.vsm"
        path.write_text("200 200 60\n" + "".join("%d 1 1 0 0\n" % (10 + n * 7919 % 40) for n in range(40000)))
        many = simple.HorizonExteriorBoundary(Input=simple.VerneySparseMatrixReader(FileName=str(path)))
        for size, points in ((1, 3), (3, 7)):
            rough = simple.HorizonRoughSimplification(Input=many, CellSize=size)
            self.assertEqual(self.show(rough).PointSize, points, rough.GetDataInformation().GetNumberOfPoints())

    def test_heights_of_all_files_are_on_one_scale_in_their_unit(self):
        """The vertical index of each file counts from its own top."""
        display = self.show(self.picks("ms", 1000))
        self.assertEqual(colored_by(display), ("POINTS", "Time (ms)"))
        self.assertEqual(range_of(display), [1000, 1022])
        second = self.show(self.picks("ms", 1100))
        self.assertEqual(colored_by(second), ("POINTS", "Time (ms)"))
        self.assertEqual(range_of(display), [1000, 1122])
        self.assertEqual(colored_by(self.show(self.picks("m", 1000))), ("POINTS", "Depth (m)"))
        upwards = self.show(self.picks("m", 1000, "Up"))
        self.assertEqual(colored_by(upwards), ("POINTS", "Elevation (m)"))
        self.assertEqual(range_of(upwards), [1000, 1022])
        self.assertEqual(colored_by(self.show(self.picks("", 1000, "Up"))), ("POINTS", "Height"))
        # The top is bright on both.
        for table, top in ((display.LookupTable, 1), (upwards.LookupTable, -3)):
            self.assertGreater(list(table.RGBPoints)[top], 0.9)

    def test_ranges_that_somebody_has_set_stay(self):
        display = self.show(self.picks("ms", 1000))
        display.LookupTable.RescaleTransferFunction(900, 1500)
        self.show(self.picks("ms", 2000))
        self.assertEqual(range_of(display), [900, 1500])

    def picks(self, unit, top, direction="Down"):
        path = FOLDER / ("picks%d.xyz" % top)
        path.write_text("Inline Crossline X Y Z\n" + "".join(
            "%d %d %d %d %d\n" % (row, column, 25 * column, 25 * row, top + row + column)
            for row in range(12) for column in range(12)))
        return simple.HorizonTextReader(FileName=[str(path)], VerticalUnit=unit, VerticalDirection=direction)

    def test_heights_are_in_the_data(self):
        """Filters of ParaView take them; where these move points, stages make them anew."""
        picks = self.picks("ms", 1000)
        contours = simple.Contour(Input=simple.HorizonSurface(Input=picks, MaximumError=0.1), ContourBy=["POINTS", "Time (ms)"],
                                  Isosurfaces=[1006.0, 1010.0])
        contours.UpdatePipeline()
        bounds = contours.GetDataInformation().GetBounds()
        self.assertAlmostEqual(bounds[4], -1010.0, places=3)
        self.assertAlmostEqual(bounds[5], -1006.0, places=3)
        self.show(picks)
        part = simple.Threshold(Input=picks, LowerThreshold=1005.0, UpperThreshold=1010.0)  # of what has these colours
        display = simple.Show(part, self.view)
        self.assertEqual(colored_by(display), ("POINTS", "Time (ms)"))
        self.assertGreater(display.LookupTable.RGBPoints[1], 0.9)  # bright on top
        moved = simple.Transform(Input=picks)
        moved.Transform.Translate = [0, 0, -500]
        despiked = simple.HorizonDespiking(Input=moved)
        despiked.UpdatePipeline()
        self.assertEqual(tuple(despiked.PointData["Time (ms)"].GetRange()), (1500, 1522))

    def test_other_ways_to_draw_have_heights_too(self):
        display = self.show(self.horizons)
        for way in ("Points", "Point Gaussian", "Surface With Edges", "Surface"):
            display.SetRepresentationType(way)
            simple.Render(self.view)
            self.assertIn("Depth", shown_arrays(display), way)

    def test_cubes_are_a_section_whose_colours_show_more_than_the_strongest_sample(self):
        for columns, rows, mode, index in ((40, 9, "XZ Plane", 4), (9, 41, "YZ Plane", 4)):
            cube = FOLDER / ("cube%d.sgy" % columns)
            write_cube(cube, columns, rows)
            display = simple.Show(simple.SEGYCubeReader(FileName=str(cube)), self.view)
            self.assertEqual((display.Representation, display.SliceMode, display.Slice), ("Slice", mode, index))
            self.assertEqual(range_of(display), [-1.96, 1.96])  # of sizes up to 2, and one of 1,000

    def test_lines_have_the_colours_of_the_legend(self):
        path = FOLDER / "line.sgy"
        write_cube(path, 40, 1)
        display = self.show(simple.SEGYCubeReader(FileName=str(path)), 1)
        self.assertEqual((display.Ambient, display.Diffuse), (1, 0))
        self.assertEqual(range_of(display), [-1.96, 1.96])

    def test_filled_points(self):
        display = simple.Show(simple.HorizonHoleFilling(Input=self.horizons), self.view)
        self.assertEqual((display.Representation, colored_by(display)), ("Points", ("POINTS", "Filled")))
        self.assertEqual(labels(display), {"0": "known", "1": "filled"})

    def test_nothing_filled_is_coloured_by_height(self):
        display = self.show(simple.HorizonHoleFilling(Input=self.horizons, LargestHoleSize=1))
        self.assertEqual(colored_by(display), ("POINTS", "Depth"))

    def test_spikes(self):
        display = simple.Show(simple.HorizonDespiking(Input=self.horizons, Action="Flag", Threshold=0.5), self.view)
        self.assertEqual((display.Representation, colored_by(display)), ("Points", ("POINTS", "Spike")))
        self.assertEqual(labels(display), {"0": "kept", "1": "spike", "2": "spur"})

    def test_removed_spikes(self):
        despiking = simple.HorizonDespiking(Input=self.horizons, Threshold=0.5)
        self.assertEqual(colored_by(self.show(despiking)), ("POINTS", "Depth"))
        display = simple.Show(simple.OutputPort(despiking, 1), self.view)
        self.assertEqual((display.Representation, colored_by(display)), ("Points", ("POINTS", "Spike")))
        self.assertEqual(labels(display), {"0": "kept", "1": "spike", "2": "spur"})

    def test_cutoffs_have_colours_of_their_walls(self):
        cutoffs = simple.HorizonCutoffs(Input=simple.OutputPort(simple.HorizonFaults(Input=self.horizons), 0))
        display = self.show(cutoffs, 0)
        self.assertEqual(colored_by(display), ("CELLS", "Wall"))
        self.assertEqual(labels(display), {"footwall": "footwall", "hanging wall": "hanging wall"})
        simple.Render(self.view)
        cells = display.SMProxy.GetRepresentedDataInformation().GetCellDataInformation()
        self.assertIsNotNone(cells.GetArrayInformation("Wall"))
        for port in (3, 4):
            display = self.show(cutoffs, port)
            self.assertEqual(colored_by(display), ("CELLS", "Juxtaposition"))
            self.assertIn("below Horizon 1 against above Horizon 1", labels(display))

    def test_bodies_have_colours_of_their_layers(self):
        faults = simple.OutputPort(simple.HorizonCutoffs(Input=simple.OutputPort(simple.HorizonFaults(Input=self.horizons), 0), Dip=60.0), 2)
        self.assertEqual(colored_by(self.show(simple.HorizonSealedModel(Input=self.horizons, Faults=faults, MaximumError=4.0), 2)), ("CELLS", "Layer"))

    def test_numbers_of_lines_are_in_the_data(self):
        path = FOLDER / "lines.xyz"
        path.write_text("Inline Crossline X Y Z\n" + "".join(
            "%d %d %d %d %d\n" % (1206 - 2 * row, 500 + 3 * column, 25 * column, 40 * row, 9 + row * column % 7)
            for row in range(10) for column in range(12)))
        picks = simple.HorizonTextReader(FileName=[str(path)], VerticalUnit="ms")
        part = simple.Threshold(Input=simple.HorizonDespiking(Input=picks), Scalars=["POINTS", "Inline"],
                                LowerThreshold=1192, UpperThreshold=1200)
        surface = simple.HorizonSurface(Input=part, MaximumError=0.1)
        surface.UpdatePipeline()
        arrays = surface.PointData
        self.assertEqual(tuple(arrays["Inline"].GetRange()), (1192, 1200))
        self.assertEqual(tuple(arrays["Crossline"].GetRange()), (500, 533))
        (places,) = client.fetch(surface).values()
        for point in range(places.GetNumberOfPoints()):
            x, y, _ = places.GetPoint(point)
            self.assertEqual(places.GetPointData().GetArray("Inline").GetValue(point), 1206 - 2 * y / 40)
            self.assertEqual(places.GetPointData().GetArray("Crossline").GetValue(point), 500 + 3 * x / 25)

    def test_faults_have_colours_around_zero(self):
        display = self.show(simple.HorizonFaults(Input=self.horizons), 1)
        self.assertEqual((display.LineWidth, colored_by(display)), (5, ("POINTS", "Throw")))
        values = list(display.LookupTable.RGBPoints)[0::4]
        self.assertEqual(values[0], -values[-1])

    def test_fault_lines_are_at_the_upper_edge_of_the_step(self):
        faults = simple.HorizonFaults(Input=self.horizons)
        display = self.show(faults, 1)
        simple.Render(self.view)
        lines = faults.GetDataInformation(1)
        own, seen = lines.GetBounds(), display.SMProxy.GetRepresentedDataInformation().GetBounds()
        throws = lines.GetPointDataInformation().GetArrayInformation("Throw").GetComponentRange(0)
        self.assertEqual(own[:4], seen[:4])
        self.assertGreaterEqual(throws[0], 12)
        for low, high in zip(own[4:], seen[4:]):
            self.assertTrue(throws[0] / 2 <= high - low <= throws[1] / 2, (throws, own, seen))

    def test_colours_around_zero_stay_so_with_a_second_file(self):
        first = self.show(simple.HorizonFaults(Input=self.horizons), 1)
        path = FOLDER / "deeper.vsm"
        path.write_text("%d %d 90\n%s" % (SIDE, SIDE, "".join(
            "%d 1 1 0 0\n" % (10 if n % SIDE < 12 else 60) for n in range(SIDE * SIDE))))
        reach = range_of(first)[1]
        self.show(simple.HorizonFaults(Input=simple.VerneySparseMatrixReader(FileName=str(path))), 1)
        low, high = range_of(first)
        self.assertEqual(low, -high)
        self.assertGreater(high, 2 * reach)

    def test_closed_faults(self):
        cut = simple.HorizonFaults(Input=self.horizons)
        display = self.show(simple.HorizonSurface(Input=cut, CloseFaults=1))
        self.assertEqual(colored_by(display), ("CELLS", "Fault"))
        self.assertEqual(labels(display), {"0": "horizon", "1": "fault"})
        self.assertEqual(colored_by(self.show(simple.HorizonSurface(Input=cut))), ("POINTS", "Depth"))

    def test_meshes_are_coloured_by_height(self):
        surface = simple.HorizonSurface(Input=self.horizons)
        self.assertEqual(colored_by(self.show(surface)), ("POINTS", "Depth"))
        self.assertEqual(self.show(surface, 1).LineWidth, 3)

    def test_layers_have_their_colours(self):
        """Several by their numbers, one by height; the repaired horizons by how far points were moved."""
        horizons = [self.picks("m", top) for top in (100, 140, 180)]
        display = self.show(simple.HorizonLayers(Input=horizons), 1)
        self.assertEqual((colored_by(display), range_of(display)), (("CELLS", "Layer"), [0, 1]))
        self.assertEqual(colored_by(self.show(simple.HorizonLayers(Input=horizons[:2]), 1)), ("POINTS", "Depth (m)"))
        crossings = simple.HorizonCrossings(Input=horizons[:2], MinimumThickness=1000)
        self.assertEqual(colored_by(self.show(crossings)), ("POINTS", "Moved (m)"))

    def test_thickness_at_points_and_as_a_map(self):
        base = FOLDER / "base.xyz"
        base.write_text("Inline Crossline X Y Z\n" + "".join(
            "%d %d %d %d %d\n" % (row, column, 25 * column, 25 * row, 140 + 2 * row)
            for row in range(12) for column in range(12)))
        other = simple.HorizonTextReader(FileName=[str(base)], VerticalUnit="m")
        thickness = simple.HorizonThickness(Input=self.picks("m", 100), OtherHorizon=other)
        for port in (0, 1):
            self.assertEqual(colored_by(self.show(thickness, port)), ("POINTS", "Isochore (m)"))

    def test_distances(self):
        mesh = simple.HorizonSurface(Input=self.horizons, MaximumError=0.75)
        display = self.show(simple.HorizonSurfaceDistance(Reference=self.horizons, Mesh=mesh), 1)
        self.assertEqual(colored_by(display), ("POINTS", "Distance"))
        points = list(display.LookupTable.RGBPoints)
        self.assertEqual((points[0], len(points), points[1:4]), (0.0, 24, [0.957, 0.949, 0.918]))

    def test_distances_end_where_one_percent_is_farther(self):
        """One place is far off: without it nothing else would be told apart."""
        points = "".join("%d 1 1 0 0\n" % (39 if n == 820 else 10) for n in range(SIDE * SIDE))
        path = FOLDER / "spike.vsm"
        path.write_text("%d %d 60\n%s" % (SIDE, SIDE, points))
        spiked = simple.VerneySparseMatrixReader(FileName=str(path))
        flat = simple.HorizonDespiking(Input=spiked, Threshold=5)
        for unit, component in (("Steps", 0), ("World", 1)):
            distance = simple.HorizonSurfaceDistance(Reference=spiked, Mesh=simple.HorizonSurface(Input=flat),
                                                     DistanceUnit=unit)
            display = self.show(distance, 0)
            figures = distance.FieldData["DistancePercentile99"].GetRange(component)
            self.assertEqual(range_of(display), [0, round(figures[1], 3)])
            self.assertEqual(display.LookupTable.UseAboveRangeColor, 1)
            simple.Delete(display.LookupTable)

    def test_chosen_colours_are_left_alone(self):
        table = simple.GetColorTransferFunction("Filled")
        table.RGBPoints = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0]
        display = simple.Show(simple.HorizonHoleFilling(Input=self.horizons), self.view)
        self.assertEqual(colored_by(display), ("POINTS", "Filled"))
        self.assertIsNone(labels(display))
        self.assertEqual(list(table.RGBPoints), [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0])

    def test_state_files_keep_what_was_changed(self):
        display = self.show(simple.HorizonExteriorBoundary(Input=self.horizons))
        display.LineWidth = 7
        display.LookupTable.Annotations = ["0", "large", "1", "small"]
        file = str(FOLDER / "sight.pvsm")
        simple.SaveState(file)
        simple.ResetSession()
        simple.LoadState(file)
        self.view = simple.GetActiveView()
        display, = self.view.Representations
        self.assertEqual((display.LineWidth, labels(display)), (7, {"0": "large", "1": "small"}))

    def test_nothing_to_show(self):
        display = self.show(simple.HorizonHoleFilling(Input=simple.VerneySparseMatrixReader(FileName=self.empty())))
        self.assertEqual(display.LineWidth, 1)

    def empty(self):
        path = FOLDER / "empty.vsm"
        path.write_text("3 3 3\n" + "\n" * 9)
        return str(path)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main()
