# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What TetGen, Gmsh and OpenGeode have against models of sealed_checker.py."""

import collections
import importlib

import numpy as np


def volumes_of(vertices, tetrahedra):
    a, b, c, d = np.moveaxis(vertices[tetrahedra], 1, 0)
    return np.abs(((b - a) * np.cross(c - a, d - a)).sum(1)) / 6


def compare(m, volumes):
    """What is wrong with volumes of the bodies from another program."""
    right = len(volumes) == len(m.volume) and np.allclose(volumes, m.volume, rtol=1e-6, atol=1e-12 * np.prod(m.box[1] - m.box[0]))
    return "" if right else "%d volumes %s, expected %d %s" % (len(volumes), volumes, len(m.volume), m.volume)


def run_tetgen(m):
    """Compares the volumes of TetGen's regions by size. It may fail in one order of the vertices and not in another."""
    import tetgen
    for switches, order in (("pYQA", np.arange(len(m.V))), ("pYQAT1e-12", np.random.default_rng(1).permutation(len(m.V)))):
        try:
            nodes, tetrahedra, regions, _ = tetgen.TetGen(m.V[order], np.argsort(order)[m.T].astype(np.int32)).tetrahedralize(switches=switches)
            sizes = np.bincount(np.unique(regions, return_inverse=True)[1].ravel(), volumes_of(nodes, tetrahedra))
            wrong = compare(m, np.sort(sizes)[np.argsort(np.argsort(m.volume))] if len(sizes) == len(m.volume) else sizes)
        except RuntimeError as error:
            wrong = str(error)
        if not wrong:
            break
    return wrong


def run_gmsh(m):
    """Compares the volumes that Gmsh fills with tetrahedra, once it has found the lines and corners of the surfaces."""
    import gmsh
    gmsh.initialize(interruptible=False)
    mesh = gmsh.model.mesh
    for name, value in {"General.Terminal": 0, "Mesh.MeshSizeMin": 1e9, "Mesh.Optimize": 0, "Mesh.SaveAll": 1, "Mesh.MshFileVersion": 2.2}.items():
        gmsh.option.setNumber(name, value)
    sheets, of = np.unique(np.column_stack([m.S, m.sides]), axis=0, return_inverse=True)
    for sheet in range(len(sheets)):
        gmsh.model.addDiscreteEntity(2, sheet + 1)
    mesh.addNodes(2, 1, np.arange(1, len(m.V) + 1), m.V.ravel())
    for sheet in range(len(sheets)):
        mesh.addElementsByType(sheet + 1, 2, [], (m.T[of.ravel() == sheet] + 1).ravel())
    mesh.createTopology()
    sides, around = {frozenset(t): set(s) for t, s in zip((m.T + 1).tolist(), m.sides.tolist())}, collections.defaultdict(list)
    for _, face in gmsh.model.getEntities(2):
        for body in sides[frozenset(mesh.getElementsByType(2, face)[1][:3].tolist())]:
            around[body].append(face)
    for body in range(len(m.layer)):
        gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop(around[body])], body + 1)
    gmsh.model.geo.synchronize()
    mesh.generate(3)
    gmsh.write("model.msh")
    numbers, places, _ = mesh.getNodes()
    vertices = np.zeros((int(numbers.max()) + 1, 3))
    vertices[numbers.astype(int)] = places.reshape(-1, 3)
    bodies = [mesh.getElementsByType(4, body + 1)[1].astype(int).reshape(-1, 4) for body in range(len(m.layer))]
    return compare(m, [float(volumes_of(vertices, tetrahedra).sum()) for tetrahedra in bodies])


def run_opengeode(m):
    """What OpenGeode's inspector says to the model with Gmsh's tetrahedra, but that some of these are flat."""
    core, files, inspector = map(importlib.import_module, TOOLS["OpenGeode"][1][1:])
    run_gmsh(m)
    for library in (core.OpenGeodeModelLibrary, files.OpenGeodeIOModelLibrary, inspector.OpenGeodeInspectorInspectionLibrary):
        library.initialize()
    model = core.load_brep("model.msh")
    found = inspector.inspect_brep(model)
    issues = found.nb_issues() - found.meshes.meshes_degenerations.degenerated_polyhedra.nb_issues()
    words = " ".join(line for line in found.string().splitlines() if not line.strip().startswith("no "))
    right = model.nb_blocks() == len(m.layer) and issues == 0
    return "" if right else "%d blocks, expected %d, %d issues: %s" % (model.nb_blocks(), len(m.layer), issues, words)


def inspect_structure(path):
    """The number of blocks that OpenGeode reads from a GOCAD Model3d, and of what its inspector finds."""
    modules = list(map(importlib.import_module, ("opengeode", "opengeode_io", "opengeode_inspector", "opengeode_geosciences", "opengeode_geosciencesio")))
    for module in modules:
        for name in dir(module):
            if name.endswith("Library"):
                getattr(module, name).initialize()
    model = modules[3].load_structural_model(str(path))
    return model.nb_blocks(), modules[2].inspect_brep(model).nb_issues()


TOOLS = {"TetGen": (run_tetgen, ["tetgen"]), "Gmsh": (run_gmsh, ["gmsh"]),
         "OpenGeode": (run_opengeode, ["gmsh", "opengeode", "opengeode_io", "opengeode_inspector"])}
