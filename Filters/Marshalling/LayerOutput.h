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

class vtkPolyData;
class vtkUnstructuredGrid;

namespace SeismicHorizons
{
/// The cells of all layers, with Layer, Triangle, Thickness and Volume as cell data.
void WriteLayerCells(
  const LayerCells& cells, const LayerPlan& plan, const HorizonStack& stack, vtkUnstructuredGrid* output);

/// A closed surface that faces outwards, with Face and Layer as cell data.
void WriteLayerBody(
  LayerBody body, const LayerPlan& plan, std::size_t layer, const HorizonStack& stack, vtkPolyData* output);

/// A horizon as a mesh on the plan, with the arrays that its points had.
void WriteLayerHorizon(
  const Layers& layers, const LayerCells& cells, std::size_t horizon, const HorizonStack& stack, vtkPolyData* output);
}

#endif
