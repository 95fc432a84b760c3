// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalFit.h"

#include "Common/Base/FixedChunks.h"

#include <cmath>
#include <tuple>

namespace SeismicHorizons
{
namespace
{
std::optional<ReferenceVoxel> FindReference(const std::vector<LatticeHorizon>& horizons)
{
  const LatticeHorizon* first = nullptr;
  const auto place = [](const LatticeHorizon& voxels)
  { return std::make_tuple(voxels.Column.front().Y, voxels.Column.front().X, voxels.SurfaceId); };
  for (const LatticeHorizon& horizon : horizons)
  {
    if (!horizon.K.empty() && (!first || place(horizon) < place(*first)))
    {
      first = &horizon;
    }
  }
  return first ? ReferenceVoxel{ double(first->K.front()), first->RealZ.front() } : std::optional<ReferenceVoxel>();
}

VerticalSums SumUp(const LatticeHorizon& horizon, const ReferenceVoxel& reference)
{
  return AddUpChunks<VerticalSums>(std::int64_t(horizon.K.size()), ChunkSize, Monitor(),
    [&](VerticalSums& part, std::int64_t first, std::int64_t last)
    {
      for (auto voxel = std::size_t(first); voxel < std::size_t(last); ++voxel)
      {
        part.Add(horizon.K[voxel] - reference.K, horizon.RealZ[voxel] - reference.Z);
      }
    });
}

SparseMatrixVerticalFit Fit(const VerticalSums& sums, const ReferenceVoxel& reference)
{
  const double spread = sums.Count * sums.KK - sums.K * sums.K;
  const double step = spread > 0.0 ? (sums.Count * sums.KZ - sums.K * sums.Z) / spread : 0.0;
  if (step == 0.0 || !std::isfinite(step))
  {
    return {};
  }
  const double offset = (sums.Z - step * sums.K) / sums.Count;
  return { reference.Z + offset - step * reference.K, step };
}
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVerticalFit FitVertically(const std::vector<LatticeHorizon>& horizons)
{
  const std::optional<ReferenceVoxel> reference = FindReference(horizons);
  if (!reference)
  {
    return {};
  }
  VerticalSums sums;
  for (const LatticeHorizon& horizon : horizons)
  {
    sums.Add(SumUp(horizon, *reference));
  }
  return Fit(sums, *reference);
}

//----------------------------------------------------------------------------------------------------------------------
void VerticalFitter::Add(const std::vector<HorizonSorter>& blocks, std::size_t count)
{
  for (std::size_t block = 0; block < count; ++block)
  {
    this->Reference = this->Reference ? this->Reference : FindReference(blocks[block].List());
    for (const LatticeHorizon& voxels : blocks[block].List())
    {
      if (!voxels.K.empty())
      {
        this->Add(voxels, this->Horizons[voxels.SurfaceId]);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void VerticalFitter::Add(const LatticeHorizon& voxels, Sums& sums) const
{
  for (std::size_t voxel = 0; voxel < voxels.K.size(); ++voxel)
  {
    if (sums.InChunk == ChunkSize)
    {
      sums.All.Add(sums.Chunk);
      sums.Chunk = VerticalSums();
      sums.InChunk = 0;
    }
    sums.Chunk.Add(voxels.K[voxel] - this->Reference->K, voxels.RealZ[voxel] - this->Reference->Z);
    ++sums.InChunk;
  }
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVerticalFit VerticalFitter::Fit() const
{
  if (!this->Reference)
  {
    return {};
  }
  VerticalSums all;
  for (const auto& [surfaceId, sums] : this->Horizons)
  {
    VerticalSums horizon = sums.All;
    horizon.Add(sums.Chunk);
    all.Add(horizon);
  }
  return SeismicHorizons::Fit(all, *this->Reference);
}
}
