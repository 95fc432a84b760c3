// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCollector.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
struct HorizonPart
{
  const LatticeHorizon* Part;
  LatticeHorizon* Whole;
  std::size_t First;
};

void Copy(const HorizonPart& part)
{
  const auto copy = [&part](const auto& from, auto& to)
  { std::copy(from.begin(), from.end(), to.begin() + part.First); };
  copy(part.Part->Column, part.Whole->Column);
  copy(part.Part->K, part.Whole->K);
  copy(part.Part->Thickness, part.Whole->Thickness);
  copy(part.Part->Amplitude, part.Whole->Amplitude);
  copy(part.Part->RealZ, part.Whole->RealZ);
}
}

//----------------------------------------------------------------------------------------------------------------------
LatticeHorizon& HorizonCollector::HorizonOf(int surfaceId)
{
  const auto [place, isNew] = this->Positions.emplace(surfaceId, this->Horizons.size());
  if (isNew)
  {
    this->Horizons.emplace_back().SurfaceId = surfaceId;
  }
  return this->Horizons[place->second];
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Add(const std::vector<HorizonSorter>& blocks, std::size_t count)
{
  std::vector<HorizonPart> parts;
  for (std::size_t block = 0; block < count; ++block)
  {
    for (const LatticeHorizon& part : blocks[block].List())
    {
      if (!part.Column.empty())
      {
        LatticeHorizon& whole = this->HorizonOf(part.SurfaceId);
        parts.push_back({ &part, &whole, whole.Column.size() });
        whole.DroppedDuplicates += part.DroppedDuplicates;
        ForEachVoxelArray(whole, [&part](auto& values) { values.Extend(part.Column.size()); });
      }
    }
  }
  ParallelFor(std::int64_t(parts.size()), 1,
    [&parts](std::int64_t first, std::int64_t last)
    { std::for_each(parts.begin() + first, parts.begin() + last, Copy); });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LatticeHorizon> HorizonCollector::Take(std::int64_t smallestSize)
{
  std::vector<LatticeHorizon> horizons;
  for (LatticeHorizon& horizon : this->Horizons)
  {
    if (std::int64_t(horizon.Column.size()) >= smallestSize)
    {
      horizons.push_back(std::move(horizon));
    }
  }
  this->Horizons.clear();
  std::sort(horizons.begin(), horizons.end(),
    [](const LatticeHorizon& a, const LatticeHorizon& b) { return a.SurfaceId < b.SurfaceId; });
  return horizons;
}
}
