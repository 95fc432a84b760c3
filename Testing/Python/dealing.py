# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons on the ranks of a program."""

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def deal(horizons, rank_of):
    """A collection with all names, and those horizons that this rank is to have."""
    own = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
    collection = vtkPartitionedDataSetCollection()
    collection.SetNumberOfPartitionedDataSets(len(horizons))
    for n, (name, horizon) in enumerate(horizons.items()):
        collection.GetMetaData(n).Set(vtkCompositeDataSet.NAME(), name)
        if rank_of(n) == own:
            collection.SetPartition(n, 0, horizon)
    return collection
