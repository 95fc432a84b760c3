# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Steady flow through layers in MODFLOW 6: rain on top, a fixed head along the west side, a conductivity for each layer.

    python3 layers_modflow.py survey.vsm results --conductivities 1 0.01 5

Needs the Python packages seismichorizons and flopy (pip install flopy). The folder gets the model, which mf6 solves if it is
there (get-modflow installs it); otherwise run mf6 in the folder. Add other packages to the model before it is written.
"""

import argparse
import pathlib
import shutil
import sys

import flopy
import numpy as np
import seismichorizons as sh


def read_model(path):
    """A simulation with a model of the package DISV of a file alone, as flopy has it."""
    folder = path.parent
    (folder / "mfsim.nam").write_text("BEGIN OPTIONS\nEND OPTIONS\nBEGIN TIMING\n  TDIS6 flow.tdis\nEND TIMING\nBEGIN MODELS\n  gwf6 flow.nam flow\n"
                                      "END MODELS\nBEGIN EXCHANGES\nEND EXCHANGES\nBEGIN SOLUTIONGROUP 1\n  ims6 flow.ims flow\nEND SOLUTIONGROUP 1\n")
    (folder / "flow.nam").write_text("BEGIN OPTIONS\nEND OPTIONS\nBEGIN PACKAGES\n  DISV6 %s disv\nEND PACKAGES\n" % path.name)
    (folder / "flow.ims").write_text("BEGIN OPTIONS\nEND OPTIONS\n")
    (folder / "flow.tdis").write_text("BEGIN DIMENSIONS\n  NPER 1\nEND DIMENSIONS\nBEGIN PERIODDATA\n  1.0 1 1.0\nEND PERIODDATA\n")
    return flopy.mf6.MFSimulation.load(sim_ws=str(folder), verbosity_level=0)


def main():
    parser = argparse.ArgumentParser(prog="layers_modflow", description=__doc__.splitlines()[0])
    parser.add_argument("horizons", metavar="FILE", help="a file of two or more horizons, in depth")
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path, help="for results")
    parser.add_argument("--conductivities", type=float, nargs="+", default=[1.0], metavar="K", help="one for all layers, or one each")
    parser.add_argument("--sublayers", type=int, default=2, metavar="N", help="of each layer (default: 2)")
    parser.add_argument("--rain", type=float, default=1e-3, metavar="R", help="length per day (default: 0.001)")
    arguments = parser.parse_args()
    layers = sh.layers(sh.read(arguments.horizons), effort="fast", smallest_angle=20.0, sublayers=arguments.sublayers)
    given = arguments.conductivities * (len(layers) if len(arguments.conductivities) == 1 else 1)
    if len(given) != len(layers):
        sys.exit("layers_modflow: %d conductivities, expected one, or one for each of %d layers" % (len(given), len(layers)))
    arguments.folder.mkdir(parents=True, exist_ok=True)
    layers.write(arguments.folder / "flow.disv")
    simulation = read_model(arguments.folder / "flow.disv")
    model = simulation.get_model("flow")
    grid, domain = model.disv, model.disv.idomain.get_data()
    shape = (grid.nlay.get_data(), grid.ncpl.get_data())
    model.newtonoptions = "NEWTON"
    simulation.ims.complexity = "COMPLEX"
    simulation.ims.linear_acceleration = "BICGSTAB"
    conductivity = np.repeat(given, shape[0] // len(layers))  # layers of the model are sublayers
    flopy.mf6.ModflowGwfnpf(model, xt3doptions=True, icelltype=1, k=np.broadcast_to(conductivity[:, None], shape).copy())
    top = float(grid.top.get_data().max())
    flopy.mf6.ModflowGwfic(model, strt=top)
    x = np.array([row[1] for row in grid.cell2d.get_data()])
    west = x < x.min() + 0.1 * (x.max() - x.min())
    heads = [((layer, cell), top) for layer, cell in zip(*np.nonzero((domain == 1) & west))]
    flopy.mf6.ModflowGwfchd(model, stress_period_data={0: heads})
    uppermost = [(int(np.argmax(domain[:, cell] == 1)), cell) for cell in np.flatnonzero((domain == 1).any(axis=0))]
    flopy.mf6.ModflowGwfrch(model, stress_period_data={0: [(cell, arguments.rain) for cell in uppermost]})
    flopy.mf6.ModflowGwfoc(model, head_filerecord="flow.hds", saverecord=[("HEAD", "ALL")])
    simulation.write_simulation(silent=True)
    program = shutil.which("mf6")
    if program is None:
        print("no program mf6: run it in %s" % arguments.folder)
        return
    simulation.exe_name = program
    success, said = simulation.run_simulation(silent=True, report=True)
    if not success:
        sys.exit("layers_modflow: mf6 failed: " + "\n".join(said[-10:]))


if __name__ == "__main__":
    main()
