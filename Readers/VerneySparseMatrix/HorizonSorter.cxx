// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSorter.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
void RemoveLast(HorizonVoxels& horizon)
{
  horizon.I.pop_back();
  horizon.J.pop_back();
  horizon.K.pop_back();
  horizon.Thickness.pop_back();
  horizon.Amplitude.pop_back();
  horizon.RealZ.pop_back();
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonVoxels& HorizonSorter::HorizonOf(int surfaceId)
{
  int position = this->Positions.Find(surfaceId);
  if (position == SurfacePositions::None)
  {
    position = static_cast<int>(this->Horizons.size());
    this->Positions.Insert(surfaceId, position);
    this->Horizons.emplace_back().SurfaceId = surfaceId;
  }
  return this->Horizons[static_cast<std::size_t>(position)];
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonSorter::Add(int i, int j, const SparseMatrixVoxel& voxel)
{
  HorizonVoxels& horizon = this->HorizonOf(voxel.SurfaceId);
  // All voxels of a column come at once, so a duplicate can only be one of the voxel added last.
  if (!horizon.I.empty() && horizon.I.back() == i && horizon.J.back() == j)
  {
    ++horizon.DroppedDuplicates;
    if (!this->Prefers(voxel, horizon))
    {
      return;
    }
    RemoveLast(horizon);
  }
  horizon.I.push_back(i);
  horizon.J.push_back(j);
  horizon.K.push_back(voxel.VerticalIndex);
  horizon.Thickness.push_back(voxel.Thickness);
  horizon.Amplitude.push_back(voxel.Amplitude);
  horizon.RealZ.push_back(voxel.RealZ);
}

//----------------------------------------------------------------------------------------------------------------------
/// Whether a voxel replaces the last one of the horizon.
bool HorizonSorter::Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const
{
  const bool isAbove = voxel.VerticalIndex < horizon.K.back();
  if (this->Policy == DuplicatePolicy::StrongestAmplitude)
  {
    const double strength = std::abs(voxel.Amplitude);
    const double lastStrength = std::abs(horizon.Amplitude.back());
    return strength > lastStrength || (strength == lastStrength && isAbove);
  }
  return isAbove == (this->Policy == DuplicatePolicy::Topmost);
}
}
