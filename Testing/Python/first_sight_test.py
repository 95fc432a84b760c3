# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: what each stage looks like when it is shown first, which is the same in the window.

Argument: a folder for files.
"""

import pathlib
import sys
import unittest

from paraview import servermanager, simple

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


def colored_by(display):
    return tuple(display.ColorArrayName)


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
        self.assertEqual(display.Representation, "Surface")
        return display

    def test_points(self):
        display = self.show(self.horizons)
        self.assertEqual((display.PointSize, colored_by(display)), (3, ("POINTS", "VerticalIndex")))

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

    def test_outlines_are_thick_and_in_the_colours_of_their_patches(self):
        outlines = simple.HorizonExteriorBoundary(Input=self.horizons)
        for source in (outlines, simple.HorizonBoundarySimplification(Input=outlines)):
            display = self.show(source)
            self.assertEqual((display.LineWidth, display.PointSize), (3, 1))
            self.assertEqual(colored_by(display), ("POINTS", "PatchId"))
            self.assertEqual(labels(display), {"0": "0", "1": "1"})

    def test_one_patch_is_coloured_by_height(self):
        display = self.show(simple.HorizonExteriorBoundary(Input=self.horizons, Radius=2))
        self.assertEqual(colored_by(display), ("POINTS", "VerticalIndex"))
        self.assertEqual(display.LineWidth, 3)

    def test_the_legend_grows_with_the_number_of_patches(self):
        self.show(simple.HorizonExteriorBoundary(Input=self.horizons))
        cut = simple.HorizonFaults(Input=self.horizons)
        display = self.show(simple.HorizonExteriorBoundary(Input=cut))
        self.assertEqual(list(labels(display)), ["0", "1", "2"])

    def test_many_patches_keep_colours_without_a_legend(self):
        columns = "".join("%s\n" % ("3 1 1 0 0" if n % 2 == 0 and n // SIDE % 2 == 0 else "") for n in range(SIDE * SIDE))
        path = FOLDER / "specks.vsm"
        path.write_text("%d %d 9\n%s" % (SIDE, SIDE, columns))
        specks = simple.VerneySparseMatrixReader(FileName=str(path))
        display = self.show(simple.HorizonExteriorBoundary(Input=specks))
        self.assertEqual(colored_by(display), ("POINTS", "PatchId"))
        self.assertIsNone(labels(display))

    def test_simplified_points_are_large(self):
        outlines = simple.HorizonExteriorBoundary(Input=self.horizons)
        for stage in (simple.HorizonRoughSimplification, simple.HorizonElaborateSimplification):
            display = self.show(stage(Input=outlines))
            self.assertEqual((display.LineWidth, display.PointSize), (3, 3))
            self.assertEqual(colored_by(display), ("POINTS", "PatchId"))

    def test_filled_points(self):
        display = self.show(simple.HorizonHoleFilling(Input=self.horizons))
        self.assertEqual(colored_by(display), ("POINTS", "Filled"))
        self.assertEqual(labels(display), {"0": "known", "1": "filled"})

    def test_nothing_filled_is_coloured_by_height(self):
        display = self.show(simple.HorizonHoleFilling(Input=self.horizons, LargestHoleSize=1))
        self.assertEqual(colored_by(display), ("POINTS", "VerticalIndex"))

    def test_spikes(self):
        display = self.show(simple.HorizonDespiking(Input=self.horizons, Action="Flag", Threshold=0.5))
        self.assertEqual(colored_by(display), ("POINTS", "Spike"))
        self.assertEqual(labels(display), {"0": "kept", "1": "spike", "2": "thread"})

    def test_faults_have_colours_around_zero(self):
        display = self.show(simple.HorizonFaults(Input=self.horizons), 1)
        self.assertEqual((display.LineWidth, colored_by(display)), (4, ("POINTS", "Throw")))
        values = list(display.LookupTable.RGBPoints)[0::4]
        self.assertEqual(values[0], -values[-1])

    def test_closed_faults(self):
        cut = simple.HorizonFaults(Input=self.horizons)
        display = self.show(simple.HorizonSurface(Input=cut, CloseFaults=1))
        self.assertEqual(colored_by(display), ("CELLS", "Fault"))
        self.assertEqual(labels(display), {"0": "horizon", "1": "fault"})
        self.assertEqual(colored_by(self.show(simple.HorizonSurface(Input=cut))), ("POINTS", "VerticalIndex"))

    def test_meshes_are_coloured_by_height(self):
        surface = simple.HorizonSurface(Input=self.horizons)
        self.assertEqual(colored_by(self.show(surface)), ("POINTS", "VerticalIndex"))
        self.assertEqual(self.show(surface, 1).LineWidth, 3)

    def test_distances(self):
        mesh = simple.HorizonSurface(Input=self.horizons)
        display = self.show(simple.HorizonSurfaceDistance(Reference=self.horizons, Mesh=mesh), 1)
        self.assertEqual(colored_by(display), ("POINTS", "Distance"))
        points = list(display.LookupTable.RGBPoints)
        self.assertEqual((points[0], len(points), points[1:4]), (0.0, 24, [0.957, 0.949, 0.918]))

    def test_chosen_colours_are_left_alone(self):
        table = simple.GetColorTransferFunction("Filled")
        table.RGBPoints = [0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0]
        display = self.show(simple.HorizonHoleFilling(Input=self.horizons))
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
