// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The surface over one hole, or over one of the sections into which cuts divide it.

#ifndef SeismicHorizonsHoleFiller_h
#define SeismicHorizonsHoleFiller_h

#include "Common/Base/Monitor.h"
#include "HoleFilling.h"
#include "HoleRegion.h"
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
/// Entries are in the order of HoleRegion::HolePlaces, and empty if no known column is linked to them.
struct HoleFill
{
  std::vector<double> Height;
  std::vector<PointId> Nearest;
  std::vector<std::vector<double>> Attribute;
};

struct HolePlate
{
  HolePlate(const HoleRegion& region, double ringWeight);

  const SiteSystem<2> System;
  const SiteSolver<2> Solver;
};

/// Plates of small holes are cached, since many have the same shape, mostly a single column. Threads share the cache
/// and must use one ring weight.
class HolePlates
{
public:
  std::shared_ptr<const HolePlate> Get(const HoleRegion& region, double ringWeight);

private:
  static constexpr std::int64_t LargestKept = 256; // places of a plate
  static constexpr std::size_t MostKept = 256; // plates, about 20 MB in all

  std::mutex Mutex;
  std::unordered_map<std::string, std::shared_ptr<const HolePlate>> Kept;
};

HoleFill FillHole(const HoleRegion& region, const std::vector<double>& heights,
  const std::vector<PointValue>& attributes, const HoleFillingOptions& options, HolePlates& plates,
  const Monitor& monitor);
}

#endif
