# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""For scripts of ParaView, in pvpython and pvbatch, alone or as the client of a server.

    from seismichorizons import client

    client.load_plugin(globals())                # after Connect, if there is a server
    meshes = client.fetch(HorizonSurface(Input=OpenDataFile("survey.vsm")))
    meshes["Horizon 1"].GetNumberOfPoints()      # a vtkPolyData here, wherever it was made
"""

import pathlib
import re

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet, vtkMultiPieceDataSet

COLLECTION = "vtkPartitionedDataSetCollection"


def find_plugin():
    """The plugin that was built or installed with this package. Raises RuntimeError."""
    for folder in pathlib.Path(__file__).resolve().parents:
        found = sorted(folder.glob("lib*/**/paraview-*/plugins/SeismicHorizons/SeismicHorizons.so"))
        if found:
            return str(found[0])
    raise RuntimeError("%s: no plugin of ParaView beside this package, expected its path" % __file__)


def load_plugin(names=None, path=None, server_path=None):
    """Loads the plugin into this process, and into the server that it is connected to, where it is not loaded yet: ParaView
    has a call for each, and that for a server which has the plugin fails.

    `names` is globals() of a script that has all of paraview.simple; `path` the plugin, that of this package by default;
    `server_path` the same on the server, where it is another one."""
    path = path or find_plugin()
    names = vars(simple) if names is None else names
    connection = servermanager.ActiveConnection
    if (connection is not None and connection.IsRemote()
            and not connection.Session.GetProxyDefinitionManager().HasDefinition("filters", "HorizonSurface")):
        simple.LoadPlugin(server_path or path, remote=True, ns=names)
    simple.LoadPlugin(path, remote=False, ns=names)


def fetch(proxy, port=0):
    """The output of a source or filter, run before if need be: a dictionary of the horizons by their names for a
    collection, else what servermanager.Fetch gives, which is empty for collections in ParaView 5.11."""
    proxy.UpdatePipeline()
    if proxy.GetDataInformation(port).DataInformation.GetCompositeDataClassName() != COLLECTION:
        return servermanager.Fetch(proxy, idx=port)
    blocks = servermanager.filters.ConvertToMultiBlock(Input=servermanager.OutputPort(proxy, port))
    blocks.UpdatePipeline()  # or Fetch does not know that they are some
    horizons = {}
    _collect(servermanager.Fetch(blocks), None, horizons)
    names = _names(blocks)
    # Fetch of ParaView 6 puts the number of a rank's blocks before their names.
    horizons = {name if name in names else re.sub(r"^Block \d+_", "", name): data for name, data in horizons.items()}
    return {name: horizons[name] for name in sorted(horizons, key=names.index)}


def _names(blocks):
    """Those of the blocks of a source in their order, of which a server of several ranks sends those of each rank together."""
    information = blocks.GetDataInformation().DataInformation
    hierarchy = information.GetHierarchy()
    return [hierarchy.GetAttributeOrDefault(child, "label", hierarchy.GetNodeName(child))
            for child in hierarchy.GetChildNodes(hierarchy.GetRootNode(), False)]


def _collect(data, name, horizons):
    """Adds the datasets of blocks to horizons: each rank of a server has a block for each, and one of them its points."""
    if isinstance(data, (vtkMultiBlockDataSet, vtkMultiPieceDataSet)):
        is_block = isinstance(data, vtkMultiBlockDataSet)
        for number in range(data.GetNumberOfBlocks() if is_block else data.GetNumberOfPieces()):
            own = data.GetMetaData(number).Get(vtkCompositeDataSet.NAME()) if data.HasMetaData(number) else None
            _collect(data.GetBlock(number) if is_block else data.GetPieceAsDataObject(number),
                     own if is_block and own else name, horizons)
    elif data is not None and data.GetNumberOfPoints():
        horizons[name] = data
