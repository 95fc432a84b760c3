// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLayerStage_h
#define SeismicHorizonsLayerStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/VolumeGrid.h"
#include "Filters/Algorithms/Decimation/Decimation.h"
#include "Filters/Algorithms/Layers/LayerPlan.h"
#include "StackCrossings.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct LayerStageOptions
  : StackStageOptions
  , LayerQuality
{
  std::optional<double> MaximumError; // Without a value six times the largest noise.
  bool BoundThickness = false;
  bool PinchOutLines = true;
  int SmallestPinch = 25;
  LayerDomain Domain = LayerDomain::EachLayer;
  bool KeepOutlines = false;
  bool TearAtFaults = true;
  MissingPolicy Missing = MissingPolicy::Follow;
  int LargestHoleSize = 2500;
  int LargestGap = 10;
  std::string Sublayers; // a number, or one for each layer; empty for 1
  double LargestSublayerThickness = 0.0; // 0 for any
  bool Tetrahedra = false;
  std::optional<double> Contact; // world z
};

struct LayerStageResult
{
  VolumeGrid Layers;
  std::vector<Horizon> Bodies; // by layer
  std::vector<Horizon> Horizons;
  ArrayTable Figures; // a row for each layer
  ArrayTable Volumes; // above contacts
  std::string Report;
  std::vector<std::string> Warnings;
};

/// Empty unless volumes have another meaning: the first warning, which errors follow.
std::string WarnOfTime(const HorizonStack& stack);

/// The stack is in order.
LayerStageResult RunLayers(const HorizonStack& stack, const LayerStageOptions& options, const Monitor& monitor);
}

#endif
