# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython, by client_server_test.py: what comes from a server is what the client finds alone, and what goes
wrong on the server is told to the client.

Arguments: the folder of the data, a folder for results, and the port of the server.
"""

import os
import pathlib
import sys

from paraview import servermanager, simple
from seismichorizons import client
from vtkmodules.vtkIOXML import vtkXMLPartitionedDataSetCollectionReader

import errors_test
import mesh_checks
import pipelines


def results(path, folder):
    """The meshes by their names with their distances, the rows of the table, and what the panel says."""
    horizons = simple.OpenDataFile(str(path))
    surface = simple.HorizonSurface(Input=horizons, MaximumError=1)
    distance = simple.HorizonSurfaceDistance(Reference=horizons, Mesh=surface)
    distance.UpdatePipeline()
    file = folder / "mesh.vtpc"
    # Appended data, the default, cannot be read by VTK up to 9.2 with a recent Expat library.
    simple.SaveData(str(file), simple.OutputPort(distance, 1), DataMode="Binary")
    reader = vtkXMLPartitionedDataSetCollectionReader()
    reader.SetFileName(str(file))
    reader.Update()
    table = servermanager.Fetch(distance, idx=2)
    rows = [[str(table.GetValue(row, column)) for column in range(table.GetNumberOfColumns())]
            for row in range(table.GetNumberOfRows())]
    told = [list(horizons.GetProperty("HorizonStatus").Available), surface.GetDataInformation().GetNumberOfPoints()]
    meshes = mesh_checks.blocks(reader.GetOutputDataObject(0))
    fetched = client.fetch(distance, 1)
    assert list(fetched) == list(meshes), (list(fetched), list(meshes))
    for name, mesh in meshes.items():
        pipelines.assert_same(fetched[name], mesh)
    assert client.fetch(distance, 2).GetNumberOfRows() == table.GetNumberOfRows()
    return meshes, rows, told


def check_errors(folder):
    """A wrong file: no data, and the client hears why."""
    path = folder / "wrong.vsm"
    path.write_text("2 1 9\n1 1 1 1 1\nx\n", encoding="ascii")
    with errors_test.captured() as log:
        surface = simple.HorizonSurface(Input=simple.OpenDataFile(str(path)))
        surface.UpdatePipeline()
        text = log()
    assert surface.GetDataInformation().GetNumberOfPoints() == 0
    assert 'wrong.vsm: line 3: vertical index "x", expected a number' in text, text


def check_heights(path):
    """What is shown has heights, which the server makes; all of its ranks have a part of the range."""
    horizons = simple.OpenDataFile(str(path))
    display = simple.Show(horizons)
    simple.Render()
    low, high = horizons.GetDataInformation().GetBounds()[4:]
    shown = display.SMProxy.GetRepresentedDataInformation().GetArrayInformation("Depth", 0)
    assert list(shown.GetComponentRange(0)) == [-high, -low], (shown.GetComponentRange(0), low, high)


def main():
    sample, folder = pathlib.Path(sys.argv[1]) / "blobs.vsm", pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for _ in range(2):
        client.load_plugin()
    expected, expected_rows, expected_told = results(sample, folder)
    assert len(expected) == 3 and len(expected_rows) == 27 and len(expected_told[0]) == 3
    simple.Connect("127.0.0.1", int(sys.argv[3]))
    assert servermanager.ActiveConnection.IsRemote()
    client.load_plugin()  # on both sides: neither has it by itself
    client.load_plugin()
    found, rows, told = results(sample, folder)
    assert told == expected_told, (told, expected_told)
    assert rows == expected_rows, (rows, expected_rows)
    assert sorted(found) == sorted(expected), (found.keys(), expected.keys())
    for name, mesh in expected.items():
        pipelines.assert_same(found[name], mesh)
        pipelines.assert_same_fields(found[name], mesh)
    check_errors(folder)
    check_heights(sample)
    print("client: done", flush=True)
    simple.Disconnect()
    os._exit(0)  # what the interpreter would still tidy up has gone with the server


main()
