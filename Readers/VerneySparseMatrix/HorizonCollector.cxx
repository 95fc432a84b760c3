// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCollector.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Calls visit(a, b) for each pair of arrays of two horizons.
template <typename Visit>
void ForEachArray(HorizonVoxels& a, HorizonVoxels& b, Visit&& visit)
{
  visit(a.I, b.I);
  visit(a.J, b.J);
  visit(a.K, b.K);
  visit(a.Thickness, b.Thickness);
  visit(a.Amplitude, b.Amplitude);
  visit(a.RealZ, b.RealZ);
}
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Add(std::vector<HorizonVoxels> horizons)
{
  for (HorizonVoxels& part : horizons)
  {
    const auto [place, isNew] = this->Positions.emplace(part.SurfaceId, this->Horizons.size());
    if (isNew)
    {
      this->Horizons.push_back(std::move(part));
      continue;
    }
    HorizonVoxels& whole = this->Horizons[place->second];
    whole.DroppedDuplicates += part.DroppedDuplicates;
    ForEachArray(whole, part, [](auto& all, const auto& next) { all.insert(all.end(), next.begin(), next.end()); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Reserve(double times)
{
  for (HorizonVoxels& horizon : this->Horizons)
  {
    const auto size = std::size_t(times * double(horizon.I.size()));
    ForEachArray(horizon, horizon, [size](auto& all, const auto&) { all.reserve(size); });
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonVoxels> HorizonCollector::Take()
{
  std::sort(this->Horizons.begin(), this->Horizons.end(),
    [](const HorizonVoxels& a, const HorizonVoxels& b) { return a.SurfaceId < b.SurfaceId; });
  return std::move(this->Horizons);
}
}
