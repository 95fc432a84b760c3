// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Datasets have world coordinates, with heights upwards.

#ifndef SeismicHorizonsLayerOutput_h
#define SeismicHorizonsLayerOutput_h

#include "Common/Horizon/VolumeGrid.h"
#include "Filters/Algorithms/Layers/LayerBody.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "Filters/Algorithms/Layers/LayerPlan.h"
#include "HorizonStack.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Cell data are Layer, Sublayer, Triangle, Thickness, Volume and FaultFaces.
void WriteLayerCells(const LayerCells& cells, const LayerPlan& plan, const HorizonStack& stack, VolumeGrid& output);

/// The surface is closed and faces outwards; cell data are Face and Layer.
void WriteLayerBody(
  LayerBody body, const LayerPlan& plan, std::size_t layer, const HorizonStack& stack, Horizon& output);

/// Arrays of the points are copied.
void WriteLayerHorizon(
  const Layers& layers, const LayerCells& cells, std::size_t horizon, const HorizonStack& stack, Horizon& output);
}

#endif
