# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes for simulators, where their packages are.

Arguments: the folder of the recipes, and one for results.
"""

import importlib.util
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy as np
import seismichorizons as sh
from layer_files import read_msh
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

RECIPES, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:3])


def require(name):
    if importlib.util.find_spec(name) is None:
        raise unittest.SkipTest("no %s" % name)


def run(name, *arguments, code=0):
    """What a recipe says."""
    command = [sys.executable, "-W", "ignore", str(RECIPES / (name + ".py")), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class SimulatorsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Two layers of 10 and 30 m; the lower one pinches out in the second file."""
        FOLDER.mkdir(parents=True, exist_ok=True)
        x = np.tile(np.arange(12.0), (9, 1))
        survey = {"spacing": (25.0, 25.0), "origin": (1000.0, 2000.0), "vertical_unit": "m", "horizontal_unit": "m"}
        cls.flat, cls.pinched = FOLDER / "flat.dat", FOLDER / "pinched.dat"
        for path, base in ((cls.flat, 140.0 + 0.0 * x), (cls.pinched, 110.0 + 3.0 * np.maximum(0.0, x - 4.0))):
            depths = {"Top": 100.0 + 0.0 * x, "Middle": 110.0 + 0.0 * x, "Base": base}
            sh.write([sh.horizon(z, name=name, **survey) for name, z in depths.items()], path)

    def test_opengeosys(self):
        """Temperatures of layers in series; and between those of top and base where a layer pinches out."""
        if shutil.which("ogs") is None:
            raise unittest.SkipTest("no ogs")
        run("layers_ogs", self.flat, FOLDER / "heat", "--conductivities", 1, 3)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(FOLDER / "heat" / "heat_ts_1_t_1.000000.vtu"))
        reader.Update()
        depth = -vtk_to_numpy(reader.GetOutput().GetPoints().GetData())[:, 2]
        found = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("temperature"))
        np.testing.assert_allclose(found, np.interp(depth, (100.0, 110.0, 140.0), (40.0, 50.0, 60.0)), atol=1e-6)
        run("layers_ogs", self.pinched, FOLDER / "pinched", "--conductivities", 2)
        reader.SetFileName(str(FOLDER / "pinched" / "heat_ts_1_t_1.000000.vtu"))
        reader.Update()
        found = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("temperature"))
        self.assertTrue(found.min() > 40.0 - 1e-6 and found.max() < 60.0 + 1e-6, (found.min(), found.max()))
        self.assertIn("layers_ogs: 3 conductivities, expected one, or one for each of 2 layers",
                      run("layers_ogs", self.flat, FOLDER / "none", "--conductivities", 1, 2, 3, code=1))

    def test_pylith(self):
        """The mesh has tetrahedra, and groups of surfaces have their curves and points, which PyLith wants."""
        require("gmsh")
        run("layers_pylith", self.pinched, FOLDER / "settling", "--densities", 2300, 2600)
        text = (FOLDER / "settling" / "layers.msh").read_text(encoding="utf-8")
        for dimension in (0, 1, 2):
            self.assertIn('\n%d 2 "Base"\n' % dimension, text)
        self.assertEqual({line.split()[2] for line in text.split("$Elements\n")[1].splitlines() if line.startswith("3 ") and len(line.split()) == 4}, {"4"})
        settings = (FOLDER / "settling" / "pylithapp.cfg").read_text(encoding="utf-8")
        self.assertIn("materials = [layer_1, layer_2]", settings)
        self.assertIn("data = [2600*kg/m**3", settings)

    def test_modflow(self):
        """flopy writes a model with the conductivity of each layer, and, if mf6 is there, water flows."""
        require("flopy")
        import flopy

        run("layers_modflow", self.pinched, FOLDER / "flow", "--conductivities", 5, 0.5, "--sublayers", 3)
        simulation = flopy.mf6.MFSimulation.load(sim_ws=str(FOLDER / "flow"), verbosity_level=0)
        model = simulation.get_model("flow")
        self.assertEqual(model.disv.nlay.get_data(), 6)
        conductivity = model.npf.k.get_data()
        self.assertEqual([set(layer) for layer in conductivity], [{5.0}] * 3 + [{0.5}] * 3)
        domain = model.disv.idomain.get_data()
        self.assertEqual({tuple(column) for column in domain.T} & {(1,) * 6, (1, 1, 1, 0, 0, 0)}, {tuple(column) for column in domain.T})
        if shutil.which("mf6"):
            heads = flopy.utils.HeadFile(str(FOLDER / "flow" / "flow.hds")).get_data().reshape(domain.shape)[domain == 1]
            self.assertGreater(heads.min(), -101.0)
            self.assertGreater(heads.max(), -100.0)

    def test_groups(self):
        """The package writes what the recipes need."""
        sh.layers(sh.read(self.pinched), 0.1).write(FOLDER / "pinched.msh")
        _, entities, _ = read_msh(FOLDER / "pinched.msh")
        self.assertEqual({name for (dimension, _), (name, _) in entities.items() if dimension == 2}, {"Top", "Base", "Sides", "Middle"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
