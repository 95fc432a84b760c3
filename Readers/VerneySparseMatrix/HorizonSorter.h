// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSorter_h
#define SeismicHorizonsHorizonSorter_h

#include "SparseMatrixParser.h"
#include "SurfacePositions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace SeismicHorizons
{
/// Deals the voxels of columns out to their horizons, and leaves one in each column of a horizon unless they are to be
/// sheets, in the ranges of the options only. Functions are defined
/// inside the class, where compilers inline them: they take a part of the time of reading.
class HorizonSorter
{
public:
  explicit HorizonSorter(const SparseMatrixOptions& options)
    : Options(options)
  {
  }

  /// Takes the voxels out, but not the memory they had: the next ones have it.
  void Clear()
  {
    if (this->Horizons.size() > MostKept)
    {
      *this = HorizonSorter(this->Options);
    }
    for (HorizonVoxels& horizon : this->Horizons)
    {
      ForEachVoxelArray(horizon, [](auto& values) { values.clear(); });
      horizon.DroppedDuplicates = 0;
    }
  }

  /// Adds a voxel of column (i, j). All voxels of a column come one after the other.
  void Add(int i, int j, const SparseMatrixVoxel& voxel)
  {
    if (!IsWithin(i, this->Options.ColumnRange) || !IsWithin(j, this->Options.RowRange) ||
      !this->Takes(voxel.SurfaceId))
    {
      return;
    }
    HorizonVoxels& horizon = this->HorizonOf(voxel.SurfaceId);
    // All voxels of a column come at once, so a duplicate can only be one of the voxel added last.
    if (this->Options.Policy != DuplicatePolicy::Sheets && !horizon.I.empty() && horizon.I.back() == i &&
      horizon.J.back() == j)
    {
      ++horizon.DroppedDuplicates;
      if (!this->Prefers(voxel, horizon))
      {
        return;
      }
      ForEachVoxelArray(horizon, [](auto& values) { values.pop_back(); });
    }
    horizon.I.push_back(i);
    horizon.J.push_back(j);
    horizon.K.push_back(voxel.VerticalIndex);
    horizon.Thickness.push_back(voxel.Thickness);
    horizon.Amplitude.push_back(voxel.Amplitude);
    horizon.RealZ.push_back(voxel.RealZ);
  }

  /// The horizons, in the order in which their first voxels came; some may have none.
  const std::vector<HorizonVoxels>& List() const { return this->Horizons; }

private:
  // Of more horizons the memory is given back.
  static constexpr std::size_t MostKept = 256;

  static bool IsWithin(int n, const std::array<int, 2>& range) { return n >= range[0] && n <= range[1]; }

  bool Takes(int surfaceId) const
  {
    const std::vector<int>& chosen = this->Options.Surfaces;
    return chosen.empty() || std::binary_search(chosen.begin(), chosen.end(), surfaceId);
  }

  HorizonVoxels& HorizonOf(int surfaceId)
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

  /// Whether a voxel replaces the last one of the horizon.
  bool Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const
  {
    const bool isAbove = voxel.VerticalIndex < horizon.K.back();
    if (this->Options.Policy == DuplicatePolicy::StrongestAmplitude)
    {
      const double strength = std::abs(voxel.Amplitude);
      const double lastStrength = std::abs(horizon.Amplitude.back());
      return strength > lastStrength || (strength == lastStrength && isAbove);
    }
    return isAbove == (this->Options.Policy == DuplicatePolicy::Topmost);
  }

  SparseMatrixOptions Options;
  SurfacePositions Positions;
  std::vector<HorizonVoxels> Horizons;
};
}

#endif
