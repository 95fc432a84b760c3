// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonPairs.h"

#include "Common/Errors.h"
#include "Common/VTK/HorizonName.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
struct Leaf
{
  std::string Name;
  vtkPolyData* Input;
  vtkPolyData* Output;
};

std::string NameOf(vtkInformation* block, const std::string& above)
{
  const char* const name = block ? block->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : above;
}

/// Appends all horizons of a dataset, in the order of vtkDataObjectTreeIterator.
void Collect(vtkDataObject* data, const std::string& name, std::vector<Leaf>& leaves)
{
  if (auto* const horizon = vtkPolyData::SafeDownCast(data))
  {
    leaves.push_back({ name.empty() ? NameBySurfaceId(horizon) : name, horizon, nullptr });
  }
  else if (auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int n = 0; n < collection->GetNumberOfPartitionedDataSets(); ++n)
    {
      Collect(collection->GetPartitionedDataSet(n),
        NameOf(collection->HasMetaData(n) ? collection->GetMetaData(n) : nullptr, name), leaves);
    }
  }
  else if (auto* const parts = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int n = 0; n < parts->GetNumberOfPartitions(); ++n)
    {
      Collect(parts->GetPartitionAsDataObject(n), name, leaves);
    }
  }
  else if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int n = 0; n < blocks->GetNumberOfBlocks(); ++n)
    {
      Collect(blocks->GetBlock(n), NameOf(blocks->HasMetaData(n) ? blocks->GetMetaData(n) : nullptr, name), leaves);
    }
  }
  else if (data)
  {
    throw InputError(std::string("a ") + data->GetClassName() + " in the composite dataset, expected only vtkPolyData");
  }
}

void MakeOutputs(vtkDataObject* input, vtkDataObject* output, std::vector<Leaf>& leaves)
{
  auto* const tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    leaves.front().Output = vtkPolyData::SafeDownCast(output);
    return;
  }
  auto* const outputTree = vtkDataObjectTree::SafeDownCast(output);
  outputTree->CopyStructure(tree);
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  iterator->SkipEmptyNodesOn();
  auto leaf = leaves.begin();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem(), ++leaf)
  {
    vtkNew<vtkPolyData> empty;
    outputTree->SetDataSet(iterator, empty);
    leaf->Output = empty;
  }
}

std::vector<Leaf> CollectWithOutputs(vtkDataObject* input, vtkDataObject* output)
{
  std::vector<Leaf> leaves;
  Collect(input, std::string(), leaves);
  MakeOutputs(input, output, leaves);
  return leaves;
}

std::string List(const std::vector<Leaf>& leaves)
{
  std::string text;
  for (const Leaf& leaf : leaves)
  {
    text += (text.empty() ? "" : ", ") + (leaf.Name.empty() ? "one without a name" : leaf.Name);
  }
  return text.empty() ? "no horizon" : text;
}

[[noreturn]] void RefuseMissing(
  const char* missing, const Leaf& leaf, const char* side, const std::vector<Leaf>& others)
{
  throw InputError(std::string("no ") + missing + " for " +
    (leaf.Name.empty() ? "a horizon without a name" : leaf.Name) + " of the " + side +
    ", expected one of that name; there is " + List(others));
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonPair> MatchHorizons(
  vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput)
{
  const std::vector<Leaf> references = CollectWithOutputs(reference, referenceOutput);
  std::vector<Leaf> meshes = CollectWithOutputs(mesh, meshOutput);
  const bool single = references.size() == 1 && meshes.size() == 1;
  const std::vector<Leaf> all = meshes;
  std::vector<HorizonPair> pairs;
  for (const Leaf& leaf : references)
  {
    const auto match = std::find_if(meshes.begin(), meshes.end(),
      [&](const Leaf& other) { return single || (!leaf.Name.empty() && other.Name == leaf.Name); });
    if (match == meshes.end())
    {
      RefuseMissing("mesh", leaf, "reference", all);
    }
    pairs.push_back({ leaf.Name, leaf.Input, match->Input, leaf.Output, match->Output });
    meshes.erase(match);
  }
  if (!meshes.empty())
  {
    RefuseMissing("reference", meshes.front(), "mesh", references);
  }
  return pairs;
}
}
