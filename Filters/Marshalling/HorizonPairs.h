// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which horizon of one dataset belongs to which of another.

#ifndef SeismicHorizonsHorizonPairs_h
#define SeismicHorizonsHorizonPairs_h

#include "HorizonTree.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace SeismicHorizons
{
/// A horizon of the reference and of the mesh, with an empty output for each.
struct HorizonPair
{
  std::string Name; // empty when there is none
  vtkSmartPointer<vtkPolyData> Reference;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkPolyData* ReferenceOutput;
  vtkPolyData* MeshOutput;
};

/// Pairs the horizons of two datasets, each a vtkPolyData or a composite of them, in the order of the reference. One
/// horizon on either side are a pair whatever they are called. Otherwise names have to agree: that of the block or of
/// the dataset above it, or "Horizon <SurfaceId>" where there is none; of equal names the first belong together, then
/// the second. Gives each output the structure of its input. Throws InputError when a horizon has no counterpart, and
/// on other data than vtkPolyData.
std::vector<HorizonPair> MatchHorizons(
  vtkDataObject* reference, vtkDataObject* mesh, vtkDataObject* referenceOutput, vtkDataObject* meshOutput);
}

#endif
