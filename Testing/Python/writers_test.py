# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: files are opened and saved as in the menus. Arguments: the folder of the data and one for files."""

import pathlib
import shutil
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401
import numpy as np
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import mesh_checks


def fetch(proxy):
    """The data of a proxy; the server is this process itself, so they are at hand."""
    proxy.UpdatePipeline()
    return mesh_checks.blocks(proxy.GetClientSideObject().GetOutputDataObject(0))


def open_file(path, name):
    """What File > Open makes of a file, which has to be a proxy of that name."""
    proxy = simple.OpenDataFile(str(path))
    assert proxy is not None and type(proxy).__name__ == name, (path, proxy)
    return proxy


def same_array(first, second):
    """Bit for bit, but that one nan is as good as another."""
    return first.shape == second.shape and ((first == second) | ((first != first) & (second != second))).all()


def names_of_arrays(mesh):
    """Of what files have: heights are made anew from z."""
    data = mesh.GetPointData()
    arrays = [data.GetAbstractArray(n) for n in range(data.GetNumberOfArrays())]
    return [array.GetName() for array in arrays if array.GetComponentName(0) != "height"]


def check_same_triangles(back, mesh):
    """Corner by corner: points of outlines that no triangle has are not saved."""
    corners = [mesh_checks.triangles(surface) for surface in (back, mesh)]
    assert (corners[0].shape == corners[1].shape) and len(corners[0]) > 0
    places = [mesh_checks.coordinates(surface)[used] for surface, used in zip((back, mesh), corners)]
    assert (places[0] == places[1]).all()
    for name in names_of_arrays(back):
        values = [mesh_checks.array(surface, name)[used] for surface, used in zip((back, mesh), corners)]
        assert same_array(*values), name


def check_tsurf(sample, folder):
    """Meshes are saved under their names, with each choice of the panel, and opened again."""
    surface = simple.HorizonSurface(Input=sample)
    expected = fetch(surface)
    assert len(expected) >= 2, expected
    simple.SaveData(str(folder / "x.ts"), proxy=surface)
    opened = fetch(open_file(folder / "x.ts", "GOCADTSurfReader"))
    assert list(opened) == list(expected), (list(opened), list(expected))
    for name, mesh in expected.items():
        check_same_triangles(opened[name], mesh)
        assert sorted(names_of_arrays(opened[name])) == ["Amplitude", "Thickness"], names_of_arrays(opened[name])
    simple.SaveData(str(folder / "all.ts"), proxy=surface, WriteAttributes="All Arrays", WriteBorders=1)
    assert "BORDER" in (folder / "all.ts").read_text()
    opened = fetch(open_file(folder / "all.ts", "GOCADTSurfReader"))
    for name, mesh in expected.items():
        assert names_of_arrays(opened[name]) == names_of_arrays(mesh), name
    simple.SaveData(str(folder / "deep.ts"), proxy=surface, VerticalPositive="Depth", VerticalUnit="ms",
                    HorizontalUnit="ft", CoordinateSystemName="local", WriteAttributes="No Arrays")
    text = (folder / "deep.ts").read_text()
    for line in ("ZPOSITIVE Depth", 'AXIS_UNIT "ft" "ft" "ms"', "NAME local"):
        assert line + "\n" in text, line
    assert "PVRTX" not in text and "BORDER" not in text
    deep = fetch(open_file(folder / "deep.ts", "GOCADTSurfReader"))
    for name, mesh in expected.items():
        check_same_triangles(deep[name], mesh)
        assert not names_of_arrays(deep[name]), name
    assert {path.name for path in folder.iterdir()} == {"x.ts", "all.ts", "deep.ts"}, list(folder.iterdir())


def check_dxf_and_gri(sample, folder):
    """Save Data knows the extensions: a face for each triangle, a layer for each mesh, and binary grids."""
    surface = simple.HorizonSurface(Input=sample)
    meshes = fetch(surface)
    simple.SaveData(str(folder / "x.dxf"), proxy=surface)
    lines = (folder / "x.dxf").read_text().split("\n")
    assert lines.count("3DFACE") == sum(mesh.GetNumberOfPolys() for mesh in meshes.values())
    assert lines.count("LAYER") == len(meshes) + 1  # with the table itself
    simple.SaveData(str(folder / "x.gri"), proxy=surface)
    grids = sorted(folder.glob("*.gri"))
    assert len(grids) == len(meshes), grids
    assert all(path.read_bytes()[:8] == b"\x00\x00\x00\x20\xff\xff\xfc\x1c" for path in grids)


def read_obj(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    places = np.array([[float(word) for word in line[1:]] for line in lines if line[0] == "v"])
    return places, np.array([[int(word) - 1 for word in line[1:]] for line in lines if line[0] == "f"])


def read_ply(path):
    head, _, body = path.read_bytes().partition(b"end_header\n")
    points, faces = (int(line.split()[2]) for line in head.decode().splitlines() if line.startswith("element"))
    found = np.frombuffer(body[24 * points:], dtype=[("size", "u1"), ("corners", "=i4", 3)])
    assert len(found) == faces and (found["size"] == 3).all()
    return np.frombuffer(body[:24 * points], dtype="=f8").reshape(-1, 3), found["corners"]


def read_stl(path):
    places = np.array([[float(word) for word in line.split()[1:]] for line in path.read_text().splitlines()
                       if line.split()[0] == "vertex"])
    return places, np.arange(len(places)).reshape(-1, 3)


def read_vtp(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return mesh_checks.coordinates(reader.GetOutput()), mesh_checks.triangles(reader.GetOutput())


def check_meshes(sample, folder):
    """A file for each mesh, with its name, and all digits."""
    surface = simple.HorizonSurface(Input=sample)
    meshes = fetch(surface)
    for extension, read in (("vtp", read_vtp), ("stl", read_stl), ("ply", read_ply), ("obj", read_obj)):
        simple.SaveData(str(folder / ("mesh." + extension)), proxy=surface)
        expected = {"mesh_%s.%s" % (name.replace(" ", "_"), extension): mesh for name, mesh in meshes.items()}
        assert {path.name for path in folder.glob("mesh*." + extension)} == set(expected)
        for name, mesh in expected.items():
            places, corners = read(folder / name)
            assert (places[corners] == mesh_checks.coordinates(mesh)[mesh_checks.triangles(mesh)]).all(), name
        opened = simple.OpenDataFile(str(folder / next(iter(expected))))  # ParaView's own readers take them
        opened.UpdatePipeline()
        assert opened.GetDataInformation().DataInformation.GetNumberOfCells() > 0
    assert read_vtp(folder / "mesh_Horizon_1.vtp")[0].dtype == np.float64
    one = simple.Plane()  # for ParaView's own writers
    simple.SaveData(str(folder / "plane.stl"), proxy=one)
    assert (folder / "plane.stl").is_file()


def check_selection(path):
    """Only the surfaces that are switched on are loaded."""
    reader = open_file(path, "GOCADTSurfReader")
    names = list(fetch(reader))
    reader.HorizonStatus = [names[1]]
    assert list(fetch(reader)) == [names[1]]


def check_vsm(sample, folder):
    """Points are saved and opened again; a file that was saved comes out the same, byte by byte."""
    simple.SaveData(str(folder / "x.vsm"), proxy=sample)
    opened = open_file(folder / "x.vsm", "VerneySparseMatrixReader")
    expected, found = fetch(sample), fetch(opened)
    assert list(found) == list(expected)
    for name, horizon in expected.items():
        for array in names_of_arrays(horizon):
            assert same_array(mesh_checks.array(found[name], array), mesh_checks.array(horizon, array)), array
        assert (mesh_checks.coordinates(found[name]) == mesh_checks.coordinates(horizon)).all(), name
    simple.SaveData(str(folder / "y.vsm"), proxy=opened)
    assert (folder / "x.vsm").read_bytes() == (folder / "y.vsm").read_bytes()


def check_others(folder):
    """A file of another kind with the extension is left to others."""
    (folder / "program.ts").write_text("import { x } from './y';\n")
    try:
        proxy = simple.OpenDataFile(str(folder / "program.ts"))
    except RuntimeError:
        proxy = None
    assert proxy is None, proxy


def main():
    sample_path, folder = pathlib.Path(sys.argv[1]) / "blobs.vsm", pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    sample = open_file(sample_path, "VerneySparseMatrixReader")
    check_tsurf(sample, folder)
    check_selection(folder / "x.ts")
    check_dxf_and_gri(sample, folder)
    check_meshes(sample, folder)
    check_vsm(sample, folder)
    check_others(folder)


main()
