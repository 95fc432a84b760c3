// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSealedStage_h
#define SeismicHorizonsSealedStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Filters/Cutoffs/FaultInput.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct SealedStageOptions
{
  CutoffStageOptions Cutoffs;
  std::string Endings; // "minor > main", with semicolons or lines between them
  double EndDistance = 5.0; // columns
  std::string Unconformities; // names of horizons, with semicolons or lines between them
  bool GoesThrough = false; // Faults do not die out where their sticks end.
  bool FollowsOutline = false; // Walls are along the outline of picks, not of a box.
};

struct SealedStageResult
{
  Horizon Surfaces;
  Horizon Lines;
  std::vector<std::string> BodyNames;
  std::vector<Horizon> Bodies; // closed surfaces
  ArrayTable Figures; // a row per body
  ArrayTable Areas; // a row per fault and pair of layers
  ArrayTable Picks; // a row per horizon
  std::string Report;
  std::vector<std::string> Warnings;
};

/// Throws InputError as RunCutoffs, for horizons in time, lattices without
/// right angles, and models that cannot be sealed.
SealedStageResult RunSealed(const CutInputs& inputs, const SealedStageOptions& options, const Monitor& monitor);
}

#endif
