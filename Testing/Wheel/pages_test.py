# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the pages say in Python runs as it stands there; that for ParaView and the classes of VTK is tested elsewhere.

Arguments: the folder of the project, one for files.
"""

import contextlib
import importlib.util
import io
import os
import pathlib
import re
import sys
import unittest
import warnings

import numpy as np
import seismichorizons as sh

MISSING = "|".join(["pipeline"] + [name for name in ("resqpy", "pyzgy", "mdio") if not importlib.util.find_spec(name)])
PROJECT, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])


def horizon(depth, name, unit="ms"):
    j, i = np.mgrid[0:60, 0:80]
    z = depth + 20.0 * np.sin(i / 11.0) * np.cos(j / 9.0) + np.random.default_rng(1).normal(0.0, 0.2, i.shape)
    z[20:23, 30:40] = np.nan
    return sh.horizon(z, spacing=(25.0, 25.0), vertical_unit=unit, name=name)


def sticks():
    """Two faults that dip towards each other; the second one meets the first one below the horizons' middle."""
    lines, names = [], []
    for name, x, heave in (("F1", 800.0, 300.0), ("F2", 1300.0, -400.0)):
        for y in np.arange(-100.0, 1601.0, 170.0):
            z = np.linspace(-1350.0, -850.0, 11)
            lines.append(np.column_stack((x - heave * (z + 1020.0) / 250.0, np.full(len(z), y), z)))
            names.append(name)
    return sh.Lines(names, lines, vertical_unit="m")


def make_cube(path):
    """A SEG-Y file of 20 x 30 traces with one reflection, of IEEE floats."""
    samples = 100
    header = np.zeros(3600, np.uint8)
    header[3216:3218], header[3220:3222] = np.frombuffer(np.array([4000, samples], ">i2").tobytes(), np.uint8).reshape(2, 2)
    header[3224:3226] = 0, 5
    trace = np.dtype([("before", "V70"), ("scalar", ">i2"), ("then", "V42"), ("count", ">i2"), ("step", ">i2"), ("between", "V62"), ("x", ">i4"),
                      ("y", ">i4"), ("line", ">i4"), ("crossline", ">i4"), ("after", "V44"), ("values", ">f4", samples)])
    traces = np.zeros((20, 30), trace)
    line, crossline = np.mgrid[0:20, 0:30]
    traces["count"], traces["step"], traces["scalar"] = samples, 4000, 1
    traces["x"], traces["y"], traces["line"], traces["crossline"] = 1000 + 25 * crossline, 5000 + 25 * line, 1 + line, 1 + crossline
    away = np.arange(samples) - (50.0 + 3.0 * np.sin(crossline / 6.0))[..., None]
    traces["values"] = np.exp(-(away / 3.0) ** 2) * np.cos(away)
    path.write_bytes(header.tobytes() + traces.tobytes())


def make_others():
    """The same file in the formats of others, where their packages are."""
    if "pyzgy" not in MISSING:
        from pyzgy.write import SeismicWriter

        corners = [(1000.0, 5000.0), (1000.0, 5475.0), (1725.0, 5000.0), (1725.0, 5475.0)]
        with SeismicWriter("survey.zgy", (20, 30, 100), 0.0, 4.0, (1, 1), (1, 1), corners) as file:
            file.write_volume(np.ascontiguousarray(sh.read_cube("survey.sgy").values, np.float32))
    if "mdio" not in MISSING:
        import mdio
        from mdio.builder.template_registry import get_template
        from segy.schema import HeaderField
        from segy.standards import get_segy_standard

        fields = [HeaderField(name=name, byte=byte, format="int32") for name, byte in (
            ("inline", 189), ("crossline", 193), ("cdp_x", 181), ("cdp_y", 185))]
        mdio.segy_to_mdio(get_segy_standard(1.0).customize(trace_header_fields=fields), get_template("PostStack3DTime"), "survey.sgy",
                          "survey.mdio", overwrite=True)


class PagesTest(unittest.TestCase):
    def test_all(self):
        (FOLDER / "Data").unlink(missing_ok=True)
        (FOLDER / "Data").symlink_to(PROJECT / "Data")
        os.chdir(FOLDER)
        top, base = horizon(1000.0, "Top"), horizon(1040.0, "Base")
        sh.write({"Top": top, "Base": base}, "picks.dat")
        sh.write({"Top": horizon(1000.0, "Top", "m"), "Base": horizon(1040.0, "Base", "m")}, "depths.dat")
        sh.write(horizon(1000.0, "Horizon 1"), "survey.vsm")
        sh.write(sticks(), "sticks.dat")
        make_cube(FOLDER / "survey.sgy")
        make_others()
        picks = np.array([[1250.0, 5250.0, 200.0]])
        pages = 0
        for page in [PROJECT / "README.md", *sorted((PROJECT / "Documentation").glob("*.md"))]:
            blocks = re.findall(r"^```python\n(.*?)^```$", page.read_text(encoding="utf-8"), re.M | re.S)
            known = {"horizon": top, "top": top, "base": base, "picks": picks, "boundary": sh.exterior_boundary(top)}
            for block in blocks:
                if re.search(r"\bsh\.|solid", block) and not re.search("paraview|vtk|" + MISSING, block):
                    with self.subTest(page=page.name), contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
                        warnings.simplefilter("ignore", UserWarning)  # of areas that are not known
                        exec(block, known)
                    pages += 1
                    if "resqpy" in block:
                        self.check_resqml(known["top"], known["mesh"])
        self.assertGreater(pages, 14)

    def check_resqml(self, top, mesh):
        """resqpy opens what the recipe wrote: the triangles, and the nodes as they were."""
        import resqpy.model
        import resqpy.surface

        model = resqpy.model.Model("horizon.epc")
        (surface,) = (resqpy.surface.Surface(model, uuid=one) for one in model.uuids(obj_type="TriangulatedSetRepresentation"))
        triangles, points = surface.triangles_and_points()
        np.testing.assert_array_equal(triangles, mesh.triangles)
        np.testing.assert_array_equal(points, mesh.points * (1.0, 1.0, -1.0))
        (grid,) = (resqpy.surface.Mesh(model, uuid=one) for one in model.uuids(obj_type="Grid2dRepresentation"))
        nodes = grid.full_array_ref()
        self.assertEqual(np.isfinite(nodes[..., 2]).sum(), len(top))
        column, row = top.columns.T
        np.testing.assert_allclose(nodes[row, column], np.column_stack((top.x, top.y, top.z)), rtol=0.0, atol=1e-6)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1])
