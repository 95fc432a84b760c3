// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The horizons of a dataset, one or many, and places for what a stage makes of them.

#ifndef SeismicHorizonsHorizonTree_h
#define SeismicHorizonsHorizonTree_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkPolyData;

namespace SeismicHorizons
{
/// The error of a stage whose memory runs out.
constexpr const char* NotEnoughMemory = "not enough memory, expected a horizon whose bounding box has fewer columns";

/// Lets an input port take a vtkPolyData or a composite dataset.
void AcceptHorizons(vtkInformation* port);

struct HorizonLeaf
{
  /// That of the block or of the dataset above it; else by the surface ID of its points; empty when there is none.
  std::string Name;
  vtkSmartPointer<vtkPolyData> Input;
  std::vector<vtkPolyData*> Outputs;
};

/// The horizons of `input`, a vtkPolyData or a composite dataset of them. Gives each of `outputs`, which are of the
/// same type, the structure of the input with an empty vtkPolyData for each horizon, and passes the field data of the
/// root.
///
/// A horizon that is dealt out to several partitions of a vtkPartitionedDataSet is put together, and its output is in
/// the place of the first of them. Throws InputError when such a horizon has more than points already, and on leaves
/// that are no vtkPolyData.
std::vector<HorizonLeaf> ListHorizons(vtkDataObject* input, const std::vector<vtkDataObject*>& outputs);
}

#endif
