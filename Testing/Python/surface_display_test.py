# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: points of a horizon are drawn as a lit surface with contours. What is checked is the picture, seen from
above, where the place of each column is known.

Argument: a folder for files.
"""

import pathlib
import random
import sys
import unittest

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

FOLDER = pathlib.Path(sys.argv.pop())
SIDE = 40
BIN = 25.0
PIXELS = 800
HALF = BIN * SIDE / 2.0  # half of the height of the view
LARGE = (800, 900)


def plane(column, row):
    return 2.0 * column


def write_picks(name, height, columns=SIDE, rows=SIDE):
    """Picks where `height` is not None."""
    path = FOLDER / (name + ".xyz")
    with path.open("w") as file:
        file.write("Inline Crossline X Y Z\n")
        for row in range(rows):
            for column in range(columns):
                z = height(column, row)
                if z is not None:
                    file.write("%d %d %g %g %g\n" % (row, column, BIN * column, BIN * row, z))
    return str(path)


def write_large():
    """More points than are drawn: heights of whole indices, a hole in the middle."""
    path = FOLDER / "large.vsm"
    with path.open("w") as file:
        file.write("%d %d 400\n" % LARGE)
        for row in range(LARGE[1]):
            file.writelines("\n" if abs(column - 400) < 60 and abs(row - 450) < 60 else "%d 1 1 0 0\n" % (10 + column // 4)
                            for column in range(LARGE[0]))
    return str(path)


class SurfaceDisplayTest(unittest.TestCase):
    def setUp(self):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [PIXELS, PIXELS]
        self.view.OrientationAxesVisibility = 0
        self.view.UseColorPaletteForBackground = 0
        self.view.Background = [1, 0, 1]  # as nothing else

    def tearDown(self):
        simple.Delete(self.view)

    def show(self, path, **properties):
        source = simple.OpenDataFile(path)
        display = simple.Show(source, self.view)
        simple.ColorBy(display, None)
        for name, value in properties.items():
            setattr(display, name, value)
        self.look()
        return source, display

    def look(self, size=HALF, middle=(HALF, HALF)):
        self.view.CameraParallelProjection = 1
        self.view.CameraFocalPoint = [*middle, 0]
        self.view.CameraPosition = [*middle, 1e5]
        self.view.CameraViewUp = [0, 1, 0]
        self.view.CameraParallelScale = size
        simple.Render(self.view)

    def picture(self):
        """Values of pixels by row, from below, and column."""
        path = FOLDER / "seen.png"
        simple.SaveScreenshot(str(path), self.view, ImageResolution=[PIXELS, PIXELS])
        return self.read(path)

    def read(self, path):
        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(PIXELS, PIXELS, -1)[:, :, :3].astype(int)

    def at(self, picture, column, row):
        """The pixel of a column, or of a place between columns."""
        return tuple(picture[int((row * BIN) / (2 * HALF) * PIXELS), int((column * BIN) / (2 * HALF) * PIXELS)])

    def is_open(self, picture, column, row):
        red, green, blue = self.at(picture, column, row)
        return red > 200 and green < 60 and blue > 200

    def drawn(self, display):
        """Points and cells on the screen."""
        simple.Render(self.view)
        data = display.SMProxy.GetRepresentedDataInformation()
        return data.GetNumberOfPoints(), data.GetNumberOfCells()

    def test_cells_between_known_neighbours(self):
        """A hole stays open, a column that is missing alone leaves the corners of its cells, which have three known ones."""
        def holed(column, row):
            return None if (10 <= column < 20 and 5 <= row < 15) or (column, row) == (30, 30) else 3.0
        _, display = self.show(write_picks("holed", holed))
        picture = self.picture()
        for column in range(SIDE - 1):
            for row in range(SIDE - 1):
                known = sum(holed(column + i, row + j) is not None for i in (0, 1) for j in (0, 1))
                if known != 3:
                    self.assertEqual(self.is_open(picture, column + 0.5, row + 0.5), known < 3, (column, row))
        self.assertTrue(self.is_open(picture, 30, 30))
        self.assertEqual(display.ContourInterval, 0)  # nothing to draw on a level horizon

    def test_faults_are_torn(self):
        path = write_picks("faulted", lambda column, row: (100.0 if column < 20 else 130.0) + 0.1 * row)
        source, _ = self.show(path, ContourInterval=0)
        self.assertFalse(any(self.is_open(self.picture(), 19.5, row + 0.5) for row in range(1, SIDE - 2)))
        faults = simple.HorizonFaults(Input=source)
        simple.Hide(source, self.view)
        display = simple.Show(faults, self.view)
        self.look()
        picture = self.picture()
        cut = [self.is_open(picture, 19.5, row + 0.5) for row in range(SIDE - 1)]
        self.assertGreaterEqual(sum(cut), SIDE - 5)
        self.assertFalse(any(self.is_open(picture, column + 0.5, 20.5) for column in range(SIDE - 1) if column != 19))
        self.assertGreater(display.ContourInterval, 0)

    def test_contours_are_at_multiples_of_the_interval(self):
        """On z = -2 column, every tenth column for an interval of 20, and the fifth is bold."""
        source, _ = self.show(write_picks("plane", plane), ContourInterval=20)
        dark = [False, *self.dark(), False]
        starts = [n - 1 for n in range(1, PIXELS + 1) if dark[n] and not dark[n - 1]]
        ends = [n - 1 for n in range(1, PIXELS + 1) if dark[n] and not dark[n + 1]]
        lines = [((start + end + 1) / 2.0 / PIXELS * SIDE, end - start + 1) for start, end in zip(starts, ends)]
        self.assertEqual([round(column) for column, _ in lines if 1 < column < 38], [10, 20, 30])
        self.assertTrue(all(abs(column - round(column)) < 0.15 for column, _ in lines if 1 < column < 38), lines)
        simple.Hide(source, self.view)
        self.show(write_picks("deep", lambda column, row: 60.0 + 2.0 * column), ContourInterval=20)  # 100 at column 20
        dark = self.dark()
        widths = [sum(dark[column * PIXELS // SIDE - 8:column * PIXELS // SIDE + 9]) for column in (10, 20, 30)]
        self.assertGreater(widths[1], 1.4 * max(widths[0], widths[2]))

    def dark(self):
        """Dark pixels along the middle row of the picture."""
        row = self.picture()[PIXELS // 2].sum(axis=1)
        usual = sorted(row)[PIXELS // 2]
        return [int(value) < usual - 60 for value in row]

    def test_one_interval_for_all_of_a_unit(self):
        _, wide = self.show(write_picks("wide", lambda column, row: 10.0 * column + row))
        _, narrow = self.show(write_picks("narrow", lambda column, row: 800 + 4.0 * column))
        _, flat = self.show(write_picks("flat", lambda column, row: 900 + 0.1 * column))
        self.assertEqual((wide.ContourInterval, narrow.ContourInterval), (50, 50))  # 429 / 12 = 36, nearest by ratio
        self.assertEqual(flat.ContourInterval, 0.5)  # of which 50 would show nothing

    def test_terraces_are_no_contours(self):
        """Heights of whole units, some at multiples of the interval: contours are lines at the edges of terraces."""
        self.show(write_picks("terraces", lambda column, row: float(column // 4)), ContourInterval=2)
        dark = self.dark()
        self.assertTrue(2 <= sum(dark) < 60, sum(dark))

    def test_two_points_in_a_column(self):
        """Both surfaces are drawn, as points, also where they are more than a surface may have."""
        for side in (40, 600):
            source = simple.OpenDataFile(self.write_doubled(side))
            source.UpdatePipeline()
            display = servermanager.rendering.HorizonRepresentation(Input=source)
            self.view.Representations.append(display)
            count = source.GetDataInformation().GetNumberOfPoints()
            self.assertEqual(self.drawn(display), (count, count))
            self.view.Representations.remove(display)

    def write_doubled(self, side):
        made = simple.OpenDataFile(write_picks("single%d" % side, plane, 40, 40)) if side < 100 else \
            simple.VerneySparseMatrixReader(FileName=write_large())
        made.UpdatePipeline()
        blocks = made.GetClientSideObject().GetOutputDataObject(0)
        iterator = blocks.NewIterator()
        iterator.InitTraversal()
        points = iterator.GetCurrentDataObject()
        lower = vtkPolyData()
        lower.DeepCopy(points)
        for n in range(lower.GetNumberOfPoints()):
            x, y, z = lower.GetPoint(n)
            lower.GetPoints().SetPoint(n, x, y, z - 500)
        both = vtkAppendPolyData()
        both.AddInputData(points)
        both.AddInputData(lower)
        both.Update()
        path = FOLDER / ("doubled%d.vtp" % side)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(both.GetOutput())
        writer.Write()
        return str(path)

    def test_all_ways_to_draw(self):
        """Shaders that cannot be compiled leave nothing to see."""
        _, display = self.show(write_picks("ways", plane), ContourInterval=10)
        for way in ("Surface", "Surface With Edges", "Wireframe", "Points"):
            display.Representation = way
            simple.Render(self.view)
            picture = self.picture()
            seen = sum(not self.is_open(picture, column, row) for column in range(2, 38) for row in range(2, 38))
            self.assertGreater(seen, 1000, way)
        display.Representation = "Surface"
        display.Opacity = 0.5
        simple.Render(self.view)
        self.assertFalse(self.is_open(self.picture(), 20.5, 20.5))
        self.assertEqual(self.drawn(display), (SIDE * SIDE, (SIDE - 1) ** 2))

    def test_no_surface_where_there_is_none(self):
        """Random picks and a row of picks remain points; lines of picks are joined across."""
        chance = random.Random(3)
        kept = {(chance.randrange(200), chance.randrange(200)) for _ in range(400)}
        for name, height, count, isSurface in (
                ("random", lambda column, row: 5.0 if (column, row) in kept else None, len(kept), False),
                ("single", lambda column, row: 5.0 if row == 7 else None, 200, False),
                ("lines", lambda column, row: 5.0 + row / 10 if row % 10 == 0 else None, 4000, True)):
            source, display = self.show(write_picks(name, height, 200, 200))
            points, cells = self.drawn(display)
            self.assertEqual((points, cells), (count, 199 * 19 if isSurface else count), name)
            self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), count)

    def test_points_that_are_alone_are_seen(self):
        """A row that leaves the surface."""
        _, display = self.show(write_picks("spur", lambda column, row: 4.0 if column < 20 or row == 20 else None),
                               PointSize=5)
        picture = self.picture()
        self.assertTrue(all(not self.is_open(picture, column, 20) for column in range(21, SIDE)))
        self.assertTrue(self.is_open(picture, 30, 25))
        self.assertEqual(self.drawn(display)[0], 20 * SIDE + 20)

    def test_large_horizons_are_thinned_on_the_screen_alone(self):
        source, display = self.show(write_large())
        whole = LARGE[0] * LARGE[1] - 119 * 119
        points, _ = self.drawn(display)
        self.assertTrue(100000 < points < 500000, points)
        steps = display.SMProxy.GetRepresentedDataInformation().GetFieldDataInformation().GetArrayInformation(
            "HorizonSheetStep")
        self.assertEqual(tuple(steps.GetComponentRange(0)), (2, 2))
        self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), whole)
        bounds = source.GetDataInformation().GetBounds()
        self.look(450, ((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2))
        still = self.picture()
        self.assertEqual(list(still[PIXELS // 2, PIXELS // 2]), [255, 0, 255])  # the hole
        self.assertNotEqual(list(still[PIXELS // 2, PIXELS // 4]), [255, 0, 255])
        display.Representation = "Points"
        self.assertEqual(self.drawn(display), (whole, whole))

    def test_selection_returns_points_of_the_horizon(self):
        """Also where not all are drawn: the point is one of those under the rectangle, by its true number."""
        for path, middle, half in ((write_picks("picked", plane), (HALF, HALF), HALF), (write_large(), None, 30)):
            source, display = self.show(path)
            bounds = source.GetDataInformation().GetBounds()
            middle = middle or (bounds[0] + 120.0, bounds[2] + 90.0)
            self.look(half, middle)
            for select in (simple.SelectSurfacePoints, simple.SelectSurfaceCells):
                select(Rectangle=[410, 210, 470, 270], View=self.view)
                found = simple.ExtractSelection(Input=source)
                found.UpdatePipeline()
                size = found.GetDataInformation().GetNumberOfPoints()
                self.assertGreater(size, 2, select.__name__)
                box = found.GetDataInformation().GetBounds()
                reach = 2.0 * (BIN if half == HALF else 1.0) + 1e-6
                for n, pixel in enumerate((410, 470, 210, 270)):
                    place = middle[n // 2] + (pixel / PIXELS - 0.5) * 2.0 * half
                    self.assertAlmostEqual(box[n], place, delta=reach, msg=(path, select.__name__, n))
                simple.Delete(found)
                simple.ClearSelection(source)
            simple.Hide(source, self.view)

    def test_pictures_while_moving_are_of_the_same_horizon(self):
        source, _ = self.show(write_large())
        bounds = source.GetDataInformation().GetBounds()
        self.look(460, ((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2))
        still = self.picture()
        self.view.LODThreshold = 0
        self.view.SMProxy.InteractiveRender()
        window = self.view.SMProxy.GetRenderWindow()
        taken = vtkWindowToImageFilter()
        taken.SetInput(window)
        taken.ShouldRerenderOff()
        taken.ReadFrontBufferOff()
        writer = vtkPNGWriter()
        writer.SetInputConnection(taken.GetOutputPort())
        writer.SetFileName(str(FOLDER / "moving.png"))
        writer.Write()
        moving = self.read(FOLDER / "moving.png")
        opened = (still[:, :, 1] < 60) != (moving[:, :, 1] < 60)
        self.assertLess(opened.mean(), 0.02)
        self.assertLess(abs(still - moving).mean(), 6)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    simple._DisableFirstRenderCameraReset()
    unittest.main()
