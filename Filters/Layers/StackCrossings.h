// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStackCrossings_h
#define SeismicHorizonsStackCrossings_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Algorithms/Layers/Crossings.h"
#include "Filters/Common/HeightUnit.h"
#include "HorizonStack.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct StackStageOptions
{
  bool ByHeight = true; // Otherwise horizons keep their order, from the uppermost on.
  CrossingPolicy Crossings = CrossingPolicy::Mean;
  std::string CrossingsByLayer; // words for each layer, or empty
  double MinimumThickness = 0.0;
  HeightUnit Unit = HeightUnit::Steps; // of heights in the options
};

struct CrossingStageResult
{
  std::vector<Horizon> Horizons;
  std::string Report;
};

/// Puts the horizons of a stack that is placed in order. Throws InputError for wrong options, and without a clear order.
void OrderStack(const StackStageOptions& options, HorizonStack& stack);

/// Converts a height in the unit of the options to vertical indices.
double IndicesOf(const StackStageOptions& options, double height, const HorizonStack& stack);

/// Throws InputError for crossings that are not known, or not one for each layer.
CrossingOptions MakeCrossings(const StackStageOptions& options, const HorizonStack& stack);

/// Repairs the given z, so that merged horizons get equal values and unmoved points keep their z exactly.
CrossingStageResult RunCrossings(const HorizonStack& stack, const StackStageOptions& options, const Monitor& monitor);
}

#endif
