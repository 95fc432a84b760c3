# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pipeline does before all stages: spikes, faults, holes. Argument: a folder for files."""

import pathlib
import sys
import unittest

import numpy as np
from seismichorizons_command import album, data, overview, pipeline, tables

FOLDER = pathlib.Path(sys.argv[1]).resolve()
ROUNDING = 1e-12  # of the meter's real numbers; distances here are 0


def write(name, content):
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / name
    path.write_bytes(content)
    return path


def largest_error(figures):
    return figures["LargestDistance"][tables.TWO_SIDED]


class PreparationsTest(unittest.TestCase):
    def test_filled(self):
        """A hole of one column is filled before all stages, and the figures of the error do not count its point."""
        voxel = b"3 1 1 0.5 4.0\n"
        points = pipeline.read_first(write("hole.vsm", b"5 4 9\n" + 6 * voxel + b"\n" + 13 * voxel))
        for settings in (pipeline.Settings(filled={}, rough=None, error={}),
                         pipeline.Settings(filled={}, surface=pipeline.surface_properties(largest_error=0.5), error={})):
            result = pipeline.run("hole.vsm", "Horizon 1", points, settings)
            self.assertEqual((data.count_points(points), result.number_of_points), (19, 19))
            self.assertEqual(data.count_points(result.data["filled"]), 20)
            self.assertEqual(data.count_points(result.data["boundary"]), 20)
            self.assertLess(largest_error(result.figures), ROUNDING)
            self.assertIn("filled", " ".join(tables.table([result])).split())
            row = tables.row(result, entries=["filled"])
            self.assertEqual((row["filled (area)"], "error" in row), ("1 (1)", settings.surface is not None))
            self.assertLess(set(tables.ERROR_COLUMNS.values()), set(row))
            panel = overview.panels(result)[1]
            self.assertEqual((panel.title, panel.caption), ("Hole filling", "1 new point"))
            self.assertFalse(settings.can_go_by_rows())
        self.assertNotIn("filled", pipeline.run("hole.vsm", "Horizon 1", points, pipeline.Settings(rough=None)).data)

    def test_torn(self):
        """A step across the whole lattice parts the mesh, and is told in the table and in the picture."""
        rows = b"".join((b"5 1 1 0.5 4.0\n" * 15 + b"25 1 1 0.5 4.0\n" * 15) for _ in range(30))
        points = pipeline.read_first(write("step.vsm", b"30 30 40\n" + rows))
        for surface in (None, pipeline.surface_properties(largest_error=0.5)):
            result = pipeline.run("step.vsm", "Horizon 1", points, pipeline.Settings(despiked={}, torn={}, surface=surface))
            self.assertEqual(data.count_polygons(result.data["mesh"]) if surface else 4, 4)
            self.assertEqual(result.loops[0], 2)
            row = tables.row(result)
            self.assertEqual((row["spikes"], row["faulted links"]), ("0", "30"))
            self.assertIn("faulted links", tables.table([result])[0])
            captions = [(panel.title, panel.caption) for panel in overview.panels(result)[1:3]]
            self.assertEqual(captions, [("Despiking", "0 points removed"), ("Faults", "1 line")])

    def test_closed_faults(self):
        """The same step as one mesh, whose triangles at the fault are told."""
        rows = b"".join((b"5 1 1 0.5 4.0\n" * 15 + b"25 1 1 0.5 4.0\n" * 15) for _ in range(30))
        points = pipeline.read_first(write("step.vsm", b"30 30 40\n" + rows))
        for name, given in (("surface", pipeline.surface_properties(largest_error=0.5)), ("mesh", {})):
            gaping, result = (pipeline.run("step.vsm", "Horizon 1", points, pipeline.Settings(
                torn={}, **{name: {**given, "CloseFaults": closes}})) for closes in (False, True))
            mesh = result.data["mesh"]
            closed = int(mesh["cell_data"]["Fault"].sum())
            self.assertEqual(closed, data.value(mesh, "FaultTriangleCount"))
            self.assertEqual(data.value(mesh, "TriangleCount") + closed, data.count_polygons(mesh))
            self.assertGreaterEqual(closed, 2)
            self.check_told(gaping, result, closed)
            self.check_encoded(mesh, closed)

    def check_told(self, gaping, result, closed):
        """The table and the picture tell of both apart; the table also where only one of two meshes is closed."""
        surface = data.count_polygons(gaping.data["mesh"])
        self.assertEqual(overview.panels(gaping)[-1].caption, "%d triangles" % surface)
        self.assertEqual(overview.panels(result)[-1].caption, "%d triangles, %d fault triangles" % (surface, closed))
        self.assertNotIn("fault triangles", tables.table([gaping])[0])
        self.assertIn("fault triangles", " ".join(tables.table([gaping, result])))
        rows = [tables.row(one, True) for one in (gaping, result)]
        self.assertEqual([row["triangles"] for row in rows], 2 * [str(surface)])
        self.assertEqual([row["fault triangles"] for row in rows], ["0", str(closed)])

    def check_encoded(self, mesh, closed):
        """In a page they come last: only they span the throw."""
        coded = album.encode(mesh)
        surface = data.count_polygons(mesh) - closed
        self.assertEqual((coded.triangles, coded.fault_triangles), (surface, closed))
        corners = np.frombuffer(coded.content, "<u2")[-3 * data.count_polygons(mesh):].reshape(-1, 3)
        heights = mesh["places"][:, 2][corners]
        np.testing.assert_array_equal(np.ptp(heights, axis=1), surface * [0.0] + closed * [20.0])


if __name__ == "__main__":
    unittest.main(argv=["preparations_test"], verbosity=2)
