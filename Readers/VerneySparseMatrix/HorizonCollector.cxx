// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonCollector.h"

#include <algorithm>
#include <utility>

namespace SeismicHorizons
{
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
    whole.I.append(part.I.begin(), part.I.end());
    whole.J.append(part.J.begin(), part.J.end());
    whole.K.append(part.K.begin(), part.K.end());
    whole.Thickness.append(part.Thickness.begin(), part.Thickness.end());
    whole.Amplitude.append(part.Amplitude.begin(), part.Amplitude.end());
    whole.RealZ.append(part.RealZ.begin(), part.RealZ.end());
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
