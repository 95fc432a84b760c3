// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LoadingVisitor.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
void Reserve(HorizonVoxels& horizon, std::int64_t numberOfVoxels)
{
  const auto capacity = static_cast<std::size_t>(std::max<std::int64_t>(numberOfVoxels, 0));
  horizon.I.reserve(capacity);
  horizon.J.reserve(capacity);
  horizon.K.reserve(capacity);
  horizon.Thickness.reserve(capacity);
  horizon.Amplitude.reserve(capacity);
  horizon.RealZ.reserve(capacity);
}

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
LoadingVisitor::LoadingVisitor(const SparseMatrixCounts& horizons, DuplicatePolicy policy)
  : Policy(policy)
  , Horizons(horizons.size())
{
  int position = 0;
  for (const auto& [surfaceId, numberOfVoxels] : horizons)
  {
    this->Positions.Insert(surfaceId, position);
    HorizonVoxels& horizon = this->Horizons[static_cast<std::size_t>(position++)];
    horizon.SurfaceId = surfaceId;
    Reserve(horizon, numberOfVoxels);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LoadingVisitor::VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels)
{
  for (const SparseMatrixVoxel& voxel : voxels)
  {
    const int position = this->Positions.Find(voxel.SurfaceId);
    if (position != SurfacePositions::None)
    {
      this->Add(this->Horizons[static_cast<std::size_t>(position)], i, j, voxel);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LoadingVisitor::Add(HorizonVoxels& horizon, int i, int j, const SparseMatrixVoxel& voxel) const
{
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
bool LoadingVisitor::Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const
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
