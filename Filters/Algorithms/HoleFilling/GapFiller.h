// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface over one gap, or over a part of it that cuts divide from the rest.

#ifndef SeismicHorizonsGapFiller_h
#define SeismicHorizonsGapFiller_h

#include "Common/Monitor.h"
#include "GapRegion.h"
#include "HoleFilling.h"
#include "SiteSolver.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
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

/// The equations of the plate over a gap and its ring, which hold for any heights.
struct GapPlate
{
  GapPlate(const GapRegion& region, double ringWeight);

  const SiteSystem<2> System;
  const SiteSolver<2> Solver;
};

/// Plates of small gaps are kept, as many have the same shape: holes of one column in most cases. Several threads may
/// ask for them, all with the same weight of the ring.
class GapPlates
{
public:
  std::shared_ptr<const GapPlate> Get(const GapRegion& region, double ringWeight);

private:
  static constexpr std::int64_t LargestKept = 256; // places
  static constexpr std::size_t MostKept = 256; // plates, of some 20 megabytes in all

  std::mutex Mutex;
  std::unordered_map<std::string, std::shared_ptr<const GapPlate>> Kept;
};

GapFill FillGap(const GapRegion& region, const std::vector<double>& heights, const std::vector<PointValue>& attributes,
  const HoleFillingOptions& options, GapPlates& plates, const Monitor& monitor);
}

#endif
