// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Collections of horizons, or of what is made of them, by names.

#ifndef SeismicHorizonsNamedCollection_h
#define SeismicHorizonsNamedCollection_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace SeismicHorizons
{
/// An empty collection with an assembly, whose root has a name.
vtkSmartPointer<vtkPartitionedDataSetCollection> MakeCollection(const char* rootName);

/// Adds an empty partitioned dataset with a name, and a node of the assembly for it.
void AddName(vtkPartitionedDataSetCollection* collection, const std::string& name);

/// Gives a collection an empty mesh for each name.
void MakeBlocks(const std::vector<std::string>& names, const char* rootName, vtkDataObject* output);

/// One of these.
vtkPolyData* BlockOf(vtkDataObject* collection, std::size_t number);
}

#endif
