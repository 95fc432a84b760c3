// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTree.h"

#include "Common/Base/Errors.h"
#include "HorizonConversion.h"
#include "HorizonName.h"
#include "VersionDifferences.h"

#include "vtkAlgorithm.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace SeismicHorizons
{
namespace
{
// Threshold, Clip and Merge Blocks turn a vtkPolyData into an unstructured grid.

/// Drops cell data. Throws InputError on cells other than vertices, lines and polygons.
vtkSmartPointer<vtkPolyData> ToPolyData(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons; // Filters make no strips of horizons.
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, points);
    switch (grid->GetCellType(cell))
    {
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        vertices->InsertNextCell(points);
        break;
      case VTK_LINE:
      case VTK_POLY_LINE:
        lines->InsertNextCell(points);
        break;
      case VTK_TRIANGLE:
      case VTK_QUAD:
      case VTK_POLYGON:
        polygons->InsertNextCell(points);
        break;
      default:
        throw InputError("cell " + std::to_string(cell) + " of an unstructured grid is a " +
          CellTypeName(grid->GetCellType(cell)) +
          ", expected vertices, lines and polygons, as Extract Surface makes them");
    }
  }
  auto horizon = vtkSmartPointer<vtkPolyData>::New();
  horizon->SetPoints(grid->GetPoints());
  horizon->SetVerts(vertices);
  horizon->SetLines(lines);
  horizon->SetPolys(polygons);
  horizon->GetPointData()->ShallowCopy(grid->GetPointData());
  horizon->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return horizon;
}

std::string NameOfBlock(vtkInformation* block, const std::string& above)
{
  const char* const name = block ? block->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : above;
}

vtkSmartPointer<vtkPolyData> ToHorizon(vtkDataObject* data)
{
  if (auto* const horizon = vtkPolyData::SafeDownCast(data))
  {
    return horizon;
  }
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return ToPolyData(grid);
  }
  throw InputError(std::string("a ") + data->GetClassName() +
    " in the composite dataset, expected only vtkPolyData, as Extract Surface makes them");
}

/// Keeps the field data of the first partition.
vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkSmartPointer<vtkPolyData>>& partitions, const std::string& name)
{
  vtkNew<vtkAppendPolyData> append;
  for (const vtkSmartPointer<vtkPolyData>& partition : partitions)
  {
    if (partition->GetNumberOfLines() + partition->GetNumberOfPolys() + partition->GetNumberOfStrips() > 0)
    {
      throw InputError((name.empty() ? "a horizon" : name) + " with outlines or triangles in " +
        std::to_string(partitions.size()) +
        " partitions, expected one partition for each horizon from its boundary on");
    }
    CheckArraySizes(partition);
    append->AddInputData(partition);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> joined = append->GetOutput();
  joined->GetFieldData()->PassData(partitions.front()->GetFieldData());
  return joined;
}

class LeafCollector
{
public:
  std::vector<HorizonLeaf> Leaves;

  void Collect(vtkDataObject* data, const std::vector<vtkDataObject*>& outputs, const std::string& name)
  {
    if (auto* const collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      for (unsigned int n = 0; n < collection->GetNumberOfPartitionedDataSets(); ++n)
      {
        this->CollectPartitions(collection->GetPartitionedDataSet(n),
          At<vtkPartitionedDataSetCollection>(outputs, [n](auto* output) { return output->GetPartitionedDataSet(n); }),
          NameOfBlock(collection->HasMetaData(n) ? collection->GetMetaData(n) : nullptr, name));
      }
    }
    else if (auto* const partitions = vtkPartitionedDataSet::SafeDownCast(data))
    {
      this->CollectPartitions(partitions, outputs, name);
    }
    else if (auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int n = 0; n < blocks->GetNumberOfBlocks(); ++n)
      {
        this->CollectBlock(
          blocks, n, outputs, NameOfBlock(blocks->HasMetaData(n) ? blocks->GetMetaData(n) : nullptr, name));
      }
    }
  }

  void Add(vtkPolyData* horizon, std::vector<vtkPolyData*> outputs, const std::string& name)
  {
    this->Leaves.push_back(
      { name.empty() ? NameBySurfaceId(horizon) : name, this->Position, horizon, std::move(outputs) });
  }

private:
  int Position = -1; // position of the current block

  template <typename Type, typename Part>
  static std::vector<vtkDataObject*> At(const std::vector<vtkDataObject*>& outputs, Part&& part)
  {
    std::vector<vtkDataObject*> parts;
    for (vtkDataObject* output : outputs)
    {
      parts.push_back(part(Type::SafeDownCast(output)));
    }
    return parts;
  }

  template <typename Type, typename Set>
  static std::vector<vtkPolyData*> MakeEmpty(const std::vector<vtkDataObject*>& outputs, Set&& set)
  {
    std::vector<vtkPolyData*> made;
    for (vtkDataObject* output : outputs)
    {
      vtkNew<vtkPolyData> empty;
      set(Type::SafeDownCast(output), empty);
      made.push_back(empty);
    }
    return made;
  }

  void CollectPartitions(
    vtkPartitionedDataSet* partitions, const std::vector<vtkDataObject*>& outputs, const std::string& name)
  {
    ++this->Position;
    std::vector<vtkSmartPointer<vtkPolyData>> found;
    unsigned int first = 0;
    for (unsigned int n = 0; partitions && n < partitions->GetNumberOfPartitions(); ++n)
    {
      if (vtkDataObject* const partition = partitions->GetPartitionAsDataObject(n))
      {
        first = found.empty() ? n : first;
        found.push_back(ToHorizon(partition));
      }
    }
    if (found.empty())
    {
      return;
    }
    std::vector<vtkPolyData*> made = MakeEmpty<vtkPartitionedDataSet>(
      outputs, [first](auto* output, vtkPolyData* empty) { output->SetPartition(first, empty); });
    this->Add(found.size() > 1 ? Join(found, name) : found.front(), std::move(made), name);
  }

  void CollectBlock(
    vtkMultiBlockDataSet* blocks, unsigned int n, const std::vector<vtkDataObject*>& outputs, const std::string& name)
  {
    vtkDataObject* const block = blocks->GetBlock(n);
    if (vtkDataObjectTree::SafeDownCast(block))
    {
      this->Collect(block, At<vtkMultiBlockDataSet>(outputs, [n](auto* output) { return output->GetBlock(n); }), name);
      return;
    }
    ++this->Position;
    if (block)
    {
      std::vector<vtkPolyData*> made =
        MakeEmpty<vtkMultiBlockDataSet>(outputs, [n](auto* output, vtkPolyData* empty) { output->SetBlock(n, empty); });
      this->Add(ToHorizon(block), std::move(made), name);
    }
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
void AcceptHorizons(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
}

//----------------------------------------------------------------------------------------------------------------------
void CheckArraySizes(vtkPolyData* horizon)
{
  CheckArraySizes(FromVTK(horizon));
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkDataObject*> ListOutputs(vtkInformationVector* outputPorts)
{
  std::vector<vtkDataObject*> outputs;
  for (int port = 0; port < outputPorts->GetNumberOfInformationObjects(); ++port)
  {
    outputs.push_back(vtkDataObject::GetData(outputPorts, port));
  }
  return outputs;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonLeaf> ListHorizons(vtkDataObject* input, const std::vector<vtkDataObject*>& outputs)
{
  LeafCollector collector;
  auto* const tree = vtkDataObjectTree::SafeDownCast(input);
  std::vector<vtkPolyData*> single;
  for (vtkDataObject* output : outputs)
  {
    if (tree)
    {
      vtkDataObjectTree::SafeDownCast(output)->CopyStructure(tree);
    }
    // This must come before the work: a single horizon writes its figures to `output` itself.
    output->GetFieldData()->PassData(input->GetFieldData());
    single.push_back(vtkPolyData::SafeDownCast(output));
  }
  if (tree)
  {
    collector.Collect(tree, outputs, std::string());
  }
  else
  {
    collector.Add(ToHorizon(input), std::move(single), std::string());
  }
  for (const HorizonLeaf& leaf : collector.Leaves)
  {
    for (vtkPolyData* output : leaf.Outputs)
    {
      output->GetFieldData()->PassData(leaf.Input->GetFieldData());
    }
  }
  return std::move(collector.Leaves);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonLeaf> ListNamedHorizons(vtkInformationVector* port)
{
  std::vector<HorizonLeaf> leaves;
  std::vector<std::string> names;
  for (int n = 0; n < port->GetNumberOfInformationObjects(); ++n)
  {
    for (HorizonLeaf& leaf : ListHorizons(vtkDataObject::GetData(port, n), {}))
    {
      if (leaf.Input->GetNumberOfPoints() > 0)
      {
        names.push_back(leaf.Name.empty() ? "Surface " + std::to_string(names.size() + 1) : leaf.Name);
        leaves.push_back(std::move(leaf));
      }
    }
  }
  names = MakeDistinct(std::move(names));
  for (std::size_t n = 0; n < leaves.size(); ++n)
  {
    leaves[n].Name = std::move(names[n]);
  }
  return leaves;
}
}
