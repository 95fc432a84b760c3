// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the plan of layers to the datasets that are made of it. All in the world, with heights upwards.

#ifndef SeismicHorizonsLayerOutput_h
#define SeismicHorizonsLayerOutput_h

#include "HorizonStack.h"
#include "Layers/LayerBody.h"
#include "Layers/LayerCells.h"
#include "Layers/LayerPlan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace SeismicHorizons
{
/// "Top to Base", for each layer.
std::vector<std::string> NamesOfLayers(const HorizonStack& stack);

/// The cells of all layers, with Layer, Triangle, Thickness and Volume as cell data.
void WriteLayerCells(
  const LayerCells& cells, const LayerPlan& plan, const HorizonStack& stack, vtkUnstructuredGrid* output);

/// A closed surface that faces outwards, with Face and Layer as cell data.
void WriteLayerBody(
  LayerBody body, const LayerPlan& plan, std::size_t layer, const HorizonStack& stack, vtkPolyData* output);

/// A horizon as a mesh on the plan, with the arrays that its points had.
void WriteLayerHorizon(
  const Layers& layers, const LayerCells& cells, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output);

/// How large layers are, a row for each. With a contact, a world z, also how much of them lies above it.
void WriteLayerTable(const Layers& layers, const HorizonStack& stack, std::optional<double> contact, vtkTable* table);

/// The volume of each layer above contacts from the top of all to the base.
void WriteVolumeCurve(const LayerPlan& plan, const HorizonStack& stack, vtkTable* table);

/// The unit of volumes, "m3" or "m2 ms"; empty where units are not known.
std::string UnitOfVolumes(const HorizonStack& stack);
}

#endif
