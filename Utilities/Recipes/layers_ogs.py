# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heat conduction through layers in OpenGeoSys: fixed temperatures at top and base, a conductivity for each layer.

    python3 layers_ogs.py survey.vsm results --conductivities 1.5 3

Needs the Python package seismichorizons and the program ogs (pip install ogs). The folder gets the meshes, the project
heat.prj, and the temperatures. Add other processes and conditions to the project; groups of faces are meshes of their own.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

import seismichorizons as sh

PROJECT = """<?xml version="1.0" encoding="UTF-8"?>
<OpenGeoSysProject>
  <meshes><mesh>layers.vtu</mesh><mesh>layers_Top.vtu</mesh><mesh>layers_Base.vtu</mesh></meshes>
  <processes><process>
    <name>Heat</name><type>STEADY_STATE_DIFFUSION</type><integration_order>2</integration_order>
    <process_variables><process_variable>temperature</process_variable></process_variables>
    <secondary_variables><secondary_variable internal_name="darcy_velocity" output_name="flux"/></secondary_variables>
  </process></processes>
  <media>%s</media>
  <parameters>
    <parameter><name>start</name><type>Constant</type><value>%g</value></parameter>
    <parameter><name>top</name><type>Constant</type><value>%g</value></parameter>
    <parameter><name>base</name><type>Constant</type><value>%g</value></parameter>
  </parameters>
  <process_variables><process_variable>
    <name>temperature</name><components>1</components><order>1</order><initial_condition>start</initial_condition>
    <boundary_conditions>
      <boundary_condition><mesh>layers_Top</mesh><type>Dirichlet</type><parameter>top</parameter></boundary_condition>
      <boundary_condition><mesh>layers_Base</mesh><type>Dirichlet</type><parameter>base</parameter></boundary_condition>
    </boundary_conditions>
  </process_variable></process_variables>
  <time_loop>
    <processes><process ref="Heat">
      <nonlinear_solver>Picard</nonlinear_solver>
      <convergence_criterion><type>DeltaX</type><norm_type>NORM2</norm_type><abstol>1e-9</abstol></convergence_criterion>
      <time_discretization><type>BackwardEuler</type></time_discretization>
      <time_stepping><type>SingleStep</type></time_stepping>
    </process></processes>
    <output>
      <type>VTK</type><prefix>heat</prefix>
      <timesteps><pair><repeat>1</repeat><each_steps>1</each_steps></pair></timesteps>
      <variables><variable>temperature</variable><variable>flux</variable></variables>
    </output>
  </time_loop>
  <nonlinear_solvers><nonlinear_solver>
    <name>Picard</name><type>Picard</type><max_iter>10</max_iter><linear_solver>CG</linear_solver>
  </nonlinear_solver></nonlinear_solvers>
  <linear_solvers><linear_solver><name>CG</name>
    <eigen><solver_type>CG</solver_type><precon_type>DIAGONAL</precon_type><max_iteration_step>100000</max_iteration_step>
      <error_tolerance>1e-12</error_tolerance></eigen>
  </linear_solver></linear_solvers>
</OpenGeoSysProject>
"""
MEDIUM = ('<medium id="%d"><phases/><properties><property><name>diffusion</name><type>Constant</type><value>%g</value></property>'
          "<property><name>reference_temperature</name><type>Constant</type><value>293.15</value></property></properties></medium>")


def main():
    parser = argparse.ArgumentParser(prog="layers_ogs", description=__doc__.splitlines()[0])
    parser.add_argument("horizons", metavar="FILE", help="a file of two or more horizons, in depth")
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path, help="for results")
    parser.add_argument("--conductivities", type=float, nargs="+", default=[2.0], metavar="K", help="one for all layers, or one each")
    parser.add_argument("--sublayers", type=int, default=3, metavar="N", help="of each layer (default: 3)")
    parser.add_argument("--temperatures", type=float, nargs=2, default=(40.0, 60.0), metavar=("TOP", "BASE"))
    arguments = parser.parse_args()
    program = shutil.which("ogs", path=str(pathlib.Path(sys.executable).parent)) or shutil.which("ogs")
    if program is None:
        sys.exit("layers_ogs: no program ogs, expected OpenGeoSys: pip install ogs")
    layers = sh.layers(sh.read(arguments.horizons), effort="fast", smallest_angle=20.0, sublayers=arguments.sublayers)
    given = arguments.conductivities * (len(layers) if len(arguments.conductivities) == 1 else 1)
    if len(given) != len(layers):
        sys.exit("layers_ogs: %d conductivities, expected one, or one for each of %d layers" % (len(given), len(layers)))
    arguments.folder.mkdir(parents=True, exist_ok=True)
    layers.write(arguments.folder / "layers.vtu", boundaries=True)
    media = "".join(MEDIUM % (number, value) for number, value in enumerate(given))
    top, base = arguments.temperatures
    (arguments.folder / "heat.prj").write_text(PROJECT % (media, top, top, base))
    subprocess.run([program, "heat.prj"], cwd=arguments.folder, check=True)


if __name__ == "__main__":
    main()
