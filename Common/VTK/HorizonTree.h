// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonTree_h
#define SeismicHorizonsHorizonTree_h

#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkInformationVector;

namespace SeismicHorizons
{
constexpr const char* NotEnoughMemory = "not enough memory, expected a horizon whose bounding box has fewer columns";

/// The port accepts vtkPolyData, vtkUnstructuredGrid and composite datasets.
void AcceptHorizons(vtkInformation* port);

/// As that of plain data; VTK does not check before it reads.
void CheckArraySizes(vtkPolyData* horizon);

/// Keeps an existing output of the right class. Inputs that are not composite give a `Single`.
template <typename Single = vtkPolyData>
void MakeOutputLike(vtkDataObject* input, vtkInformation* outputPort)
{
  vtkDataObject* const output = vtkDataObject::GetData(outputPort);
  const bool isTree = vtkDataObjectTree::SafeDownCast(input) != nullptr;
  if (input && (isTree ? !output || !output->IsA(input->GetClassName()) : !Single::SafeDownCast(output)))
  {
    auto made = vtkSmartPointer<vtkDataObject>::Take(isTree ? input->NewInstance() : Single::New());
    outputPort->Set(vtkDataObject::DATA_OBJECT(), made);
  }
}

std::vector<vtkDataObject*> ListOutputs(vtkInformationVector* outputPorts);

struct HorizonLeaf
{
  /// The name of the block or the dataset above it, or "Horizon <SurfaceId>", or empty.
  std::string Name;
  /// The index among all blocks, with those that are empty on this rank, so that it is the same on all ranks.
  int Position;
  vtkSmartPointer<vtkPolyData> Input;
  std::vector<vtkPolyData*> Outputs; // by port, with only the field data of the input
};

/// Outputs get the structure and field data of `input`. Partitions of a vtkPartitionedDataSet are one horizon, in place
/// of the first. Throws InputError on partitions with lines or polygons, and on other datasets.
std::vector<HorizonLeaf> ListHorizons(vtkDataObject* input, const std::vector<vtkDataObject*>& outputs);

/// Those with points of all connections of a port, with distinct names, "Surface 1" and so on where they have none.
std::vector<HorizonLeaf> ListNamedHorizons(vtkInformationVector* port);
}

#endif
