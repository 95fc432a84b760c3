# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""For ParaView scripts in pvpython and pvbatch, run locally or as the client of a server.

    from seismichorizons import client

    client.load_plugin(globals())                # after Connect, if there is a server
    meshes = client.fetch(HorizonSurface(Input=OpenDataFile("survey.vsm")))
    meshes["Horizon 1"].GetNumberOfPoints()      # a vtkPolyData in this process, wherever it was made
"""

import pathlib
import re

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet, vtkMultiPieceDataSet

COLLECTION = "vtkPartitionedDataSetCollection"


def find_plugin():
    """Returns the path of the plugin that was built or installed with this package. Raises RuntimeError."""
    for folder in pathlib.Path(__file__).resolve().parents:
        found = sorted(folder.glob("lib*/**/paraview-*/plugins/SeismicHorizons/SeismicHorizons.so"))
        if found:
            return str(found[0])
    raise RuntimeError("%s: no plugin of ParaView beside this package, expected its path" % __file__)


def load_plugin(names=None, path=None, server_path=None):
    """Loads the plugin into this process and into its server, unless it is already loaded. ParaView has a separate call for
    each, and the call for the server fails if the server has the plugin.

    `names` is globals() of a script that imports everything from paraview.simple; `path` is the plugin, by default the
    one of this package; `server_path` is its path on the server, if different.
    """
    path = path or find_plugin()
    names = vars(simple) if names is None else names
    connection = servermanager.ActiveConnection
    if (connection is not None and connection.IsRemote()
            and not connection.Session.GetProxyDefinitionManager().HasDefinition("filters", "HorizonSurface")):
        simple.LoadPlugin(server_path or path, remote=True, ns=names)
    simple.LoadPlugin(path, remote=False, ns=names)


def fetch(proxy, port=0):
    """Returns the output of a source or filter, which runs if necessary: a dictionary of horizons by name for a collection,
    otherwise the result of servermanager.Fetch, which is empty for collections in ParaView 5.11."""
    proxy.UpdatePipeline()
    if proxy.GetDataInformation(port).DataInformation.GetCompositeDataClassName() != COLLECTION:
        return servermanager.Fetch(proxy, idx=port)
    blocks = servermanager.filters.ConvertToMultiBlock(Input=servermanager.OutputPort(proxy, port))
    blocks.UpdatePipeline()  # otherwise Fetch does not recognize a collection
    horizons = {}
    _collect(servermanager.Fetch(blocks), None, horizons)
    names = _names(blocks)
    # Fetch of ParaView 6 prefixes the block names of a rank with numbers.
    horizons = {name if name in names else re.sub(r"^Block \d+_", "", name): data for name, data in horizons.items()}
    return {name: horizons[name] for name in sorted(horizons, key=names.index)}


def _names(blocks):
    """Returns the block names of a source in order; a server of several ranks groups the blocks by rank."""
    information = blocks.GetDataInformation().DataInformation
    hierarchy = information.GetHierarchy()
    return [hierarchy.GetAttributeOrDefault(child, "label", hierarchy.GetNodeName(child))
            for child in hierarchy.GetChildNodes(hierarchy.GetRootNode(), False)]


def _collect(data, name, horizons):
    """Adds the datasets of blocks to `horizons`. Each rank of a server has a block for each horizon, and one rank has its
    points."""
    if isinstance(data, (vtkMultiBlockDataSet, vtkMultiPieceDataSet)):
        is_block = isinstance(data, vtkMultiBlockDataSet)
        for number in range(data.GetNumberOfBlocks() if is_block else data.GetNumberOfPieces()):
            own = data.GetMetaData(number).Get(vtkCompositeDataSet.NAME()) if data.HasMetaData(number) else None
            _collect(data.GetBlock(number) if is_block else data.GetPieceAsDataObject(number),
                     own if is_block and own else name, horizons)
    elif data is not None and data.GetNumberOfPoints():
        horizons[name] = data
