// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonName_h
#define SeismicHorizonsHorizonName_h

#include "Common/Horizon/NamedHorizon.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPartitionedDataSetCollection;
class vtkPolyData;

namespace SeismicHorizons
{
/// Uses the first point; empty without points or IDs.
std::string NameBySurfaceId(vtkPolyData* horizon);

vtkSmartPointer<vtkPartitionedDataSetCollection> MakeCollection(const char* rootName);

void AddName(vtkPartitionedDataSetCollection* collection, const std::string& name);

void MakeBlocks(const std::vector<std::string>& names, const char* rootName, vtkDataObject* output);

vtkPolyData* BlockOf(vtkDataObject* collection, std::size_t number);
}

#endif
