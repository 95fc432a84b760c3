# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Other programs read what the writers write, to the digit: xtgeo surfaces and grids, ezdxf drawings. Argument: a folder.
Exits with 77 where neither is installed, for this Python or the one that PEER_PYTHON names (both are on PyPI)."""

import os
import pathlib
import subprocess
import sys
import textwrap

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection

from seismichorizons import vtk as sh

import vtk_inputs

FOLDER = pathlib.Path(sys.argv[1])
PYTHON = os.environ.get("PEER_PYTHON", sys.executable)  # one that has them, if this one does not


def run(code, *arguments):
    """What a program prints, as lines of numbers and words."""
    done = subprocess.run([PYTHON, "-c", textwrap.dedent(code), *map(str, arguments)], capture_output=True, text=True,
                          timeout=100, check=False)
    assert done.returncode == 0, done.stderr
    return [line.split() for line in done.stdout.splitlines() if line.strip()]


def has(package):
    return subprocess.run([PYTHON, "-c", "import " + package], capture_output=True, check=False).returncode == 0


def read_horizon(steps):
    """A folded surface with a hole, off the origin; `steps` is (x, y) of a column step."""
    x, y = steps
    lines = ["%.3f %.3f %.6f" % (459600.0 + x * i - y * j, 5934800.0 + y * i + x * j, 1500.0 + 30.0 * np.sin(i / 5.0) + 1.5 * j)
             for j in range(20) for i in range(30) if not (8 < i < 12 and 5 < j < 9)]
    path = FOLDER / "picks.xyz"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    (points,) = vtk_inputs.read(path, "vtkHorizonTextReader").values()
    return points


def write(writer, data, name, **choices):
    for choice, value in choices.items():
        getattr(writer, "Set" + choice)(value)
    path = FOLDER / name
    writer.SetInputDataObject(data)
    writer.SetFileName(str(path))
    assert writer.Write() == 1
    return path


def mesh_of(horizon):
    surface = sh.vtkHorizonSurface()
    surface.SetInputDataObject(horizon)
    surface.Update()
    return surface.GetOutputDataObject(0)


def arrays_of(mesh):
    """Its points, and its triangles."""
    triangles = numpy_support.vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return numpy_support.vtk_to_numpy(mesh.GetPoints().GetData()), triangles


def check_tsurf(mesh):
    path = write(sh.vtkGOCADTSurfWriter(), mesh, "mesh.ts")
    found = run("""
        import sys, xtgeo
        surface = xtgeo.triangulated_surface_from_file(sys.argv[1], fformat="tsurf")
        for row in surface.vertices: print(*map(repr, map(float, row)))
        print("triangles")
        for row in surface.triangles: print(*row)
        """, path)
    end = found.index(["triangles"])
    points, triangles = arrays_of(mesh)
    places = np.array(found[:end], float)
    corners = np.array(found[end + 1:], int)
    assert len(corners) == len(triangles)
    assert (places[corners] == points[triangles] * [1.0, 1.0, -1.0]).all()  # it counts z downwards
    print("xtgeo: %d triangles of a TSurf" % len(corners))


def check_grid(horizon, name, **choices):
    """Nodes with values are the points, as single precision has them in binary files."""
    path = write(sh.vtkHorizonGridWriter(), horizon, name, **choices)
    found = run("""
        import sys, xtgeo
        form = {".gri": "irap_binary", ".irap": "irap_ascii", ".zmap": "zmap"}["." + sys.argv[1].split(".")[-1]]
        grid = xtgeo.surface_from_file(sys.argv[1], fformat=form)
        x, y = grid.get_xy_values()
        for row in zip(x[~grid.values.mask], y[~grid.values.mask], grid.values.compressed()): print(*map(repr, map(float, row)))
        """, path)
    nodes = np.array(found, float)
    points, _ = arrays_of(horizon)
    heights = -points[:, 2] if choices["VerticalPositive"] == 2 else points[:, 2]
    order, other = np.lexsort((nodes[:, 0].round(), nodes[:, 1].round())), np.lexsort((points[:, 0].round(), points[:, 1].round()))
    assert len(nodes) == len(points), (name, len(nodes), len(points))
    off = abs(nodes[order, :2] - points[other, :2]).max()
    is_single = name.endswith(".gri")
    assert off < (0.26 if is_single else 1e-6), (name, off)
    expected = heights[other].astype("float32").astype(float) if is_single else heights[other]
    # xtgeo itself keeps less than ASCII files have.
    assert abs(nodes[order, 2] - expected).max() <= (0.0 if is_single else 1e-3), (name, abs(nodes[order, 2] - expected).max())
    print("xtgeo: %d nodes of %s, places within %.2g" % (len(nodes), name, off))


def check_dxf(mesh):
    collection = vtkPartitionedDataSetCollection()
    for number, name in enumerate(("Top Reek", "Base/Reek")):
        collection.SetPartition(number, 0, mesh)
        collection.GetMetaData(number).Set(collection.NAME(), name)
    path = write(sh.vtkHorizonDXFWriter(), collection, "mesh.dxf")
    found = run("""
        import sys, ezdxf
        drawing = ezdxf.readfile(sys.argv[1])
        audit = drawing.audit()
        assert drawing.dxfversion == "AC1009" and not audit.errors, (drawing.dxfversion, audit.errors)
        for face in drawing.modelspace().query("3DFACE"):
            corners = (face.dxf.vtx0, face.dxf.vtx1, face.dxf.vtx2, face.dxf.vtx3)
            print(face.dxf.layer, *(repr(float(c)) for corner in corners for c in corner))
        """, path)
    points, triangles = arrays_of(mesh)
    for layer in ("Top_Reek", "Base_Reek"):
        faces = np.array([line[1:] for line in found if line[0] == layer], float).reshape(-1, 4, 3)
        assert len(faces) == len(triangles)
        assert (faces[:, :3] == points[triangles]).all() and (faces[:, 3] == faces[:, 2]).all()
    assert len(found) == 2 * len(triangles)
    print("ezdxf: %d faces on two layers" % len(found))


def main():
    if not has("xtgeo") and not has("ezdxf"):
        print("neither xtgeo nor ezdxf is installed")
        sys.exit(77)
    FOLDER.mkdir(parents=True, exist_ok=True)
    straight, turned = read_horizon((25.0, 0.0)), read_horizon((20.0, 15.0))
    if has("xtgeo"):
        check_tsurf(mesh_of(turned))
        for name, horizon in (("turned.gri", turned), ("turned.irap", turned), ("straight.gri", straight),
                              ("straight.zmap", straight)):
            check_grid(horizon, name, VerticalPositive=2)
    if has("ezdxf"):
        check_dxf(mesh_of(turned))


main()
