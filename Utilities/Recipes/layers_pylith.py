# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers that settle under their weight in PyLith 4: an elastic rock for each layer, and a fixed base.

    python3 layers_pylith.py survey.vsm results --densities 2300 2500

Needs the Python package seismichorizons and gmsh (pip install gmsh). The folder gets layers.msh and pylithapp.cfg, which PyLith
solves if it is there; otherwise run pylith in the folder. Groups of faces in the mesh are boundaries for other conditions.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

import gmsh
import seismichorizons as sh

SETTINGS = """[pylithapp.metadata]
description = Layers that settle under their weight
keywords = [layers]
arguments = []
version = 1.0.0
pylith_version = [>=4.0, <5.0]

[pylithapp.mesh_generator]
reader = pylith.meshio.MeshIOPetsc
reader.filename = layers.msh
reader.coordsys.space_dim = 3

[pylithapp.problem]
defaults.name = settling
gravity_field = spatialdata.spatialdb.GravityField
materials = [%(names)s]
bc = [base]
bc.base = pylith.bc.DirichletTimeDependent

[pylithapp.problem.bc.base]
label = Base
label_value = %(base)d
constrained_dof = [0, 1, 2]
db_auxiliary_field = pylith.bc.ZeroDB
db_auxiliary_field.description = Fixed base
"""
MATERIAL = """
[pylithapp.problem.materials.%(name)s]
description = %(name)s
label_value = %(number)d
db_auxiliary_field = spatialdata.spatialdb.UniformDB
db_auxiliary_field.description = Rock
db_auxiliary_field.values = [density, vs, vp]
db_auxiliary_field.data = [%(density)g*kg/m**3, 1.7*km/s, 3.0*km/s]
auxiliary_subfields.density.basis_order = 0
bulk_rheology.auxiliary_subfields.bulk_modulus.basis_order = 0
bulk_rheology.auxiliary_subfields.shear_modulus.basis_order = 0
"""


def mark_edges(path):
    """Adds the curves and points of surfaces to their groups, which PyLith wants. Returns the numbers of groups by name."""
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        gmsh.model.mesh.createTopology()
        tags = {}
        for dimension, tag in gmsh.model.getPhysicalGroups(2):
            name = gmsh.model.getPhysicalName(dimension, tag)
            surfaces = [(dimension, entity) for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)]
            curves = {(1, abs(curve)) for curve in (one for _, one in gmsh.model.getBoundary(surfaces, combined=False))}
            points = {point for point in gmsh.model.getBoundary(list(curves), combined=False) if point[0] == 0}
            for own, entities in ((1, curves), (0, points)):
                gmsh.model.addPhysicalGroup(own, sorted({abs(entity) for _, entity in entities}), tag, name)
            tags[name] = tag
        gmsh.write(str(path))
        return tags
    finally:
        gmsh.finalize()


def main():
    parser = argparse.ArgumentParser(prog="layers_pylith", description=__doc__.splitlines()[0])
    parser.add_argument("horizons", metavar="FILE", help="a file of two or more horizons, in depth and metres")
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path, help="for results")
    parser.add_argument("--densities", type=float, nargs="+", default=[2500.0], metavar="D", help="one for all layers, or one each")
    parser.add_argument("--sublayers", type=int, default=2, metavar="N", help="of each layer (default: 2)")
    arguments = parser.parse_args()
    layers = sh.layers(sh.read(arguments.horizons), effort="fast", smallest_angle=20.0, sublayers=arguments.sublayers, tetrahedra=True)
    densities = arguments.densities * (len(layers) if len(arguments.densities) == 1 else 1)
    if len(densities) != len(layers):
        sys.exit("layers_pylith: %d densities, expected one, or one for each of %d layers" % (len(densities), len(layers)))
    arguments.folder.mkdir(parents=True, exist_ok=True)
    layers.write(arguments.folder / "layers.msh")
    tags = mark_edges(arguments.folder / "layers.msh")
    used = [number for number in range(len(layers)) if layers.figures["volume"][number] > 0.0]
    settings = SETTINGS % {"names": ", ".join("layer_%d" % (number + 1) for number in used), "base": tags["Base"]}
    settings += "".join(MATERIAL % {"name": "layer_%d" % (number + 1), "number": number + 1, "density": densities[number]} for number in used)
    (arguments.folder / "pylithapp.cfg").write_text(settings)
    program = shutil.which("pylith")
    if program is None:
        print("no program pylith: run it in %s" % arguments.folder)
        return
    subprocess.run([program], cwd=arguments.folder, check=True)


if __name__ == "__main__":
    main()
