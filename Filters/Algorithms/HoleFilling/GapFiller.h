// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface over one gap, or over a part of it that cuts divide from the rest.

#ifndef SeismicHorizonsGapFiller_h
#define SeismicHorizonsGapFiller_h

#include "Common/Monitor.h"
#include "GapRegion.h"
#include "HoleFilling.h"

#include <vector>

namespace SeismicHorizons
{
/// What a part of a gap is filled with, by its columns in the order of GapRegion::GapPlaces. Empty when no known column
/// is linked to it.
struct GapFill
{
  std::vector<double> Height;
  std::vector<PointId> Nearest;
  std::vector<std::vector<double>> Attribute;
};

GapFill FillGap(const GapRegion& region, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
  const HoleFillingOptions& options, const Monitor& monitor);
}

#endif
