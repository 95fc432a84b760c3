// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonName.h"

#include "Common/Horizon/DataModel.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataAssembly.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cassert>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
std::string NodeName(const std::string& name)
{
  const bool isTaken = name.empty() || vtkDataAssembly::IsNodeNameReserved(name.c_str());
  return vtkDataAssembly::MakeValidNodeName((isTaken ? '_' + name : name).c_str());
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string NameBySurfaceId(vtkPolyData* horizon)
{
  vtkDataArray* const ids = horizon->GetPointData()->GetArray(PointArray::SurfaceId);
  const double id = ids && ids->GetNumberOfTuples() > 0 ? ids->GetComponent(0, 0) : std::nan("");
  constexpr double Greatest = 1LL << 53; // Larger doubles are not exact integers.
  return std::abs(id) <= Greatest ? HorizonName(static_cast<std::int64_t>(id)) : std::string();
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPartitionedDataSetCollection> MakeCollection(const char* rootName)
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  vtkNew<vtkDataAssembly> assembly;
  assembly->SetRootNodeName(rootName);
  collection->SetDataAssembly(assembly);
  return collection;
}

//----------------------------------------------------------------------------------------------------------------------
void AddName(vtkPartitionedDataSetCollection* collection, const std::string& name)
{
  const unsigned int position = collection->GetNumberOfPartitionedDataSets();
  vtkNew<vtkPartitionedDataSet> partitions;
  collection->SetPartitionedDataSet(position, partitions);
  collection->GetMetaData(position)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  vtkDataAssembly* const assembly = collection->GetDataAssembly();
  const int node = assembly->AddNode(NodeName(name).c_str());
  assembly->AddDataSetIndex(node, position);
  assembly->SetAttribute(node, "label", name.c_str());
}

//----------------------------------------------------------------------------------------------------------------------
void MakeBlocks(const std::vector<std::string>& names, const char* rootName, vtkDataObject* output)
{
  const vtkSmartPointer<vtkPartitionedDataSetCollection> blocks = MakeCollection(rootName);
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    AddName(blocks, names[n]);
    vtkNew<vtkPolyData> mesh;
    blocks->SetPartition(unsigned(n), 0, mesh);
  }
  output->ShallowCopy(blocks);
}

//----------------------------------------------------------------------------------------------------------------------
vtkPolyData* BlockOf(vtkDataObject* collection, std::size_t number)
{
  auto* const blocks = vtkPartitionedDataSetCollection::SafeDownCast(collection);
  assert(blocks && number < blocks->GetNumberOfPartitionedDataSets());
  return vtkPolyData::SafeDownCast(blocks->GetPartitionAsDataObject(unsigned(number), 0));
}
}
