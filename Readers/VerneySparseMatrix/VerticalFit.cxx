// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "VerticalFit.h"

#include "Common/FixedChunks.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t ChunkSize = 1 << 16;

/// Sums over voxels, relative to one of them: the differences between sums of large, nearly equal numbers would be
/// mostly rounding.
struct VerticalSums
{
  double Count = 0.0;
  double K = 0.0;
  double Z = 0.0;
  double KK = 0.0;
  double KZ = 0.0;

  void Add(double k, double z)
  {
    this->Count += 1.0;
    this->K += k;
    this->Z += z;
    this->KK += k * k;
    this->KZ += k * z;
  }

  void Add(const VerticalSums& other)
  {
    this->Count += other.Count;
    this->K += other.K;
    this->Z += other.Z;
    this->KK += other.KK;
    this->KZ += other.KZ;
  }
};

/// The voxel that the sums are relative to.
struct Reference
{
  double K = 0.0;
  double Z = 0.0;
};

VerticalSums SumUp(const HorizonVoxels& horizon, const Reference& reference)
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
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixVerticalFit FitVertically(const std::vector<HorizonVoxels>& horizons)
{
  if (horizons.empty())
  {
    return {};
  }
  const Reference reference = { double(horizons.front().K.front()), horizons.front().RealZ.front() };
  VerticalSums sums;
  for (const HorizonVoxels& horizon : horizons)
  {
    sums.Add(SumUp(horizon, reference));
  }
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
