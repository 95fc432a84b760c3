// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCollector.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
namespace
{
template <typename Value>
void Append(std::vector<Value>& all, const std::vector<Value>& next)
{
  all.insert(all.end(), next.begin(), next.end());
}
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Add(const std::vector<HorizonVoxels>& horizons)
{
  for (const HorizonVoxels& part : horizons)
  {
    if (part.I.empty())
    {
      continue;
    }
    const auto [place, isNew] = this->Positions.emplace(part.SurfaceId, this->Horizons.size());
    if (isNew)
    {
      this->Horizons.emplace_back().SurfaceId = part.SurfaceId;
    }
    HorizonVoxels& whole = this->Horizons[place->second];
    whole.DroppedDuplicates += part.DroppedDuplicates;
    Append(whole.I, part.I);
    Append(whole.J, part.J);
    Append(whole.K, part.K);
    Append(whole.Thickness, part.Thickness);
    Append(whole.Amplitude, part.Amplitude);
    Append(whole.RealZ, part.RealZ);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Reserve(double times)
{
  for (HorizonVoxels& horizon : this->Horizons)
  {
    const auto size = std::size_t(times * double(horizon.I.size()));
    ForEachVoxelArray(horizon, [size](auto& values) { values.reserve(size); });
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
