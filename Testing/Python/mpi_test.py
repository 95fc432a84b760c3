# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvbatch on two ranks: the horizons are dealt to the ranks, and the result is that of one process.

Arguments: the folder of the data and a folder for results.
"""

import pathlib
import shutil
import sys

from paraview import servermanager, simple
from seismichorizons.vtk import vtkGOCADTSurfReader
from vtkmodules.vtkIOXML import vtkXMLPartitionedDataSetCollectionReader

import mesh_checks
import pipelines
import vtk_inputs


def ranks_with_points(proxy, ranks):
    """How many points each rank has."""
    return [proxy.GetRankDataInformation(rank).GetNumberOfPoints() for rank in range(ranks)]


def gather(proxy, path):
    """The horizons of all ranks, by way of a file that all of them write."""
    # Appended data, the default, cannot be read by VTK up to 9.2 with a recent Expat library.
    simple.SaveData(str(path), proxy, DataMode="Binary")
    return read(path)


def read(path):
    reader = vtkXMLPartitionedDataSetCollectionReader()
    reader.SetFileName(str(path))
    reader.Update()
    return mesh_checks.blocks(reader.GetOutputDataObject(0))


def check_writers(meshes, folder):
    """The first rank writes the horizons of all, in their order."""
    simple.SaveData(str(folder / "all.ts"), proxy=meshes)
    reader = vtkGOCADTSurfReader()
    reader.SetFileName(str(folder / "all.ts"))
    reader.Update()
    found = mesh_checks.blocks(reader.GetOutputDataObject(0))
    expected = read(folder / (meshes.GetXMLName() + ".vtpc"))
    assert list(found) == list(expected) and len(found) == 3, list(found)
    for name, mesh in expected.items():
        assert len(mesh_checks.triangles(found[name])) == len(mesh_checks.triangles(mesh)) > 0
    for extension in ("stl", "dxf", "irap", "dat", "vsm"):
        simple.SaveData(str(folder / ("each." + extension)), proxy=meshes)
    assert len(list(folder.glob("each_*.stl"))) == len(list(folder.glob("each_*.irap"))) == 3
    assert (folder / "each.dxf").read_text().count("\nLAYER\n") == 4
    assert not list(folder.glob(".*")), list(folder.iterdir())


def check_layers(horizons, folder):
    """The first rank makes them of all horizons, and writes them; the others have the same blocks, empty."""
    layers = simple.HorizonLayers(Input=horizons)
    layers.UpdatePipeline()
    points = ranks_with_points(layers, 2)
    assert points[0] > 0 and points[1] == 0, points
    found = gather(simple.OutputPort(layers, 1), folder / "bodies.vtpc")
    assert len(found) == 2, list(found)
    alone = vtk_inputs.layers(read(folder / (horizons.GetXMLName() + ".vtpc")))
    assert points[0] == alone.cells.GetNumberOfPoints(), (points, alone.cells.GetNumberOfPoints())
    simple.SaveData(str(folder / "layers.msh"), proxy=layers)
    assert " %d 1 %d\n" % (points[0], points[0]) in (folder / "layers.msh").read_text()


def main():
    folder = pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    sample = pathlib.Path(sys.argv[1]) / "blobs.vsm"
    ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    assert ranks == 2, "%d ranks, expected 2" % ranks
    proxies = pipelines.with_proxies(sample)
    for proxy, serial in zip(proxies, pipelines.with_classes(sample)):
        expected = mesh_checks.blocks(serial)
        gathered = gather(proxy, folder / (proxy.GetXMLName() + ".vtpc"))
        assert sorted(gathered) == sorted(expected), (gathered.keys(), expected.keys())
        for name, horizon in expected.items():
            pipelines.assert_same(gathered[name], horizon)
        shares = ranks_with_points(proxy, ranks)
        print("%s: points per rank %s" % (proxy.GetXMLName(), shares))
        assert all(shares) and sum(shares) == sum(h.GetNumberOfPoints() for h in expected.values()), shares
    # ParaView has tables on the first rank alone.
    picks = folder / "picks.csv"
    picks.write_text("Name,X,Y,Z\n" + "".join("%s,%d,%d,%d\n" % (name, 25 * i, 25 * j, 10 + i)
                     for name in ("Top", "Base") for i in range(9) for j in range(9)), encoding="ascii")
    of_table = simple.HorizonFromPoints(Input=simple.CSVReader(FileName=[str(picks)]))
    of_table.UpdatePipeline()
    assert ranks_with_points(of_table, ranks) == [81, 81]
    # Each rank measures its own horizons, and the figures of all are in one table; the last `expected` are the meshes.
    distance = simple.HorizonSurfaceDistance(Reference=proxies[0], Mesh=proxies[-1])
    simple.SaveData(str(folder / "distance.vtpc"), simple.OutputPort(distance, 1), DataMode="Binary")
    table = servermanager.Fetch(distance, idx=2)
    measured = [table.GetValueByName(row, "Horizon").ToString() for row in range(0, table.GetNumberOfRows(), 9)]
    assert measured == sorted(expected), measured
    for name, mesh in read(folder / "distance.vtpc").items():
        assert len(mesh_checks.array(mesh, "Distance")) == expected.pop(name).GetNumberOfPoints()
    assert not expected, expected.keys()
    check_writers(proxies[-1], folder)
    check_layers(proxies[0], folder)


main()
