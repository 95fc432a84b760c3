// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The horizons of a dataset, one or many, and places for what a stage makes of them.

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
/// The error of a stage whose memory runs out.
constexpr const char* NotEnoughMemory = "not enough memory, expected a horizon whose bounding box has fewer columns";

/// Lets an input port take a vtkPolyData, a vtkUnstructuredGrid of such cells, or a composite dataset.
void AcceptHorizons(vtkInformation* port);

/// Throws InputError when an array does not have a tuple for each point or cell, or ghosts not one number. Whatever
/// reads horizons asks this first: nothing behind it looks at the sizes of arrays.
void CheckArraySizes(vtkPolyData* horizon);

/// Gives an output port a composite dataset of the class of `input`, or a dataset of the class Single for any other
/// input, unless it has one. Does nothing without an input.
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

/// The data objects of all output ports.
std::vector<vtkDataObject*> ListOutputs(vtkInformationVector* outputPorts);

/// A horizon of a dataset.
struct HorizonLeaf
{
  /// That of the block or of the dataset above it; else by the surface ID of its points; empty when there is none.
  std::string Name;
  /// Its number among the blocks of the dataset, those included that are empty here: the same on all ranks of a
  /// program.
  int Position;
  vtkSmartPointer<vtkPolyData> Input;
  std::vector<vtkPolyData*> Outputs; // by port; empty but for the field data of the input
};

/// The horizons of `input`, a vtkPolyData or vtkUnstructuredGrid or a composite dataset of them. Gives each of
/// `outputs`, which are of the same class, the structure of the input with an empty vtkPolyData for each horizon, and
/// the field data of the whole input.
///
/// Several partitions of one vtkPartitionedDataSet are one horizon: their points are put together, and the output takes
/// the place of the first of them. Throws InputError when such partitions have lines or polygons, and when a dataset is
/// no vtkPolyData.
std::vector<HorizonLeaf> ListHorizons(vtkDataObject* input, const std::vector<vtkDataObject*>& outputs);
}

#endif
