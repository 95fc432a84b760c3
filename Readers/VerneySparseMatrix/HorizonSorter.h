// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSorter_h
#define SeismicHorizonsHorizonSorter_h

#include "SparseMatrixParser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
/// Caches answers, because all columns have the same few IDs and the map is slower.
class SurfacePositions
{
public:
  static constexpr int None = -1;

  int Find(int surfaceId)
  {
    Answer& answer = this->LastAnswer(surfaceId);
    if (!answer.IsKnown || answer.SurfaceId != surfaceId)
    {
      const auto found = this->Positions.find(surfaceId);
      answer = { true, surfaceId, found == this->Positions.end() ? None : found->second };
    }
    return answer.Position;
  }

  void Insert(int surfaceId, int position)
  {
    this->Positions.emplace(surfaceId, position);
    this->LastAnswer(surfaceId) = { true, surfaceId, position };
  }

private:
  struct Answer
  {
    bool IsKnown = false;
    int SurfaceId = 0;
    int Position = None;
  };

  Answer& LastAnswer(int surfaceId)
  {
    return this->Answers[static_cast<unsigned int>(surfaceId) % this->Answers.size()];
  }

  std::unordered_map<int, int> Positions;
  std::array<Answer, 64> Answers;
};

/// Resolves duplicates unless they become sheets. Functions are inside the class so that compilers inline them, since
/// they affect the time of reading.
class HorizonSorter
{
public:
  explicit HorizonSorter(const SparseMatrixOptions& options)
    : Options(options)
  {
  }

  /// Memory is kept for the next voxels.
  void Clear()
  {
    if (this->Horizons.size() > MostKept)
    {
      *this = HorizonSorter(this->Options);
    }
    for (LatticeHorizon& horizon : this->Horizons)
    {
      ForEachVoxelArray(horizon, [](auto& values) { values.clear(); });
      horizon.DroppedDuplicates = 0;
    }
  }

  void Add(int i, int j, const SparseMatrixVoxel& voxel)
  {
    if (!IsWithin(i, this->Options.ColumnRange) || !IsWithin(j, this->Options.RowRange) ||
      !this->Takes(voxel.SurfaceId))
    {
      return;
    }
    LatticeHorizon& horizon = this->HorizonOf(voxel.SurfaceId);
    // A duplicate can only be the voxel added last, since the voxels of a column are consecutive.
    if (this->Options.Policy != DuplicatePolicy::Sheets && !horizon.Column.empty() && horizon.Column.back().X == i &&
      horizon.Column.back().Y == j)
    {
      ++horizon.DroppedDuplicates;
      if (this->Options.Policy == DuplicatePolicy::Mean)
      {
        this->Average(voxel, horizon);
        return;
      }
      if (!this->Prefers(voxel, horizon))
      {
        return;
      }
      ForEachVoxelArray(horizon, [](auto& values) { values.pop_back(); });
    }
    horizon.Column.push_back({ i, j });
    horizon.K.push_back(voxel.VerticalIndex);
    horizon.Thickness.push_back(voxel.Thickness);
    horizon.Amplitude.push_back(voxel.Amplitude);
    horizon.RealZ.push_back(voxel.RealZ);
  }

  const std::vector<LatticeHorizon>& List() const { return this->Horizons; }

private:
  // With more horizons their memory is released.
  static constexpr std::size_t MostKept = 256;

  static bool IsWithin(int n, const std::array<int, 2>& range) { return n >= range[0] && n <= range[1]; }

  bool Takes(int surfaceId) const
  {
    const std::vector<int>& chosen = this->Options.Surfaces;
    return chosen.empty() || std::binary_search(chosen.begin(), chosen.end(), surfaceId);
  }

  LatticeHorizon& HorizonOf(int surfaceId)
  {
    int position = this->Positions.Find(surfaceId);
    if (position == SurfacePositions::None)
    {
      position = static_cast<int>(this->Horizons.size());
      this->Positions.Insert(surfaceId, position);
      this->Horizons.emplace_back().SurfaceId = surfaceId;
    }
    return this->Horizons[position];
  }

  /// The mean index is rounded.
  void Average(const SparseMatrixVoxel& voxel, LatticeHorizon& horizon)
  {
    const PlanePoint column = horizon.Column.back();
    MeanVoxel& mean = this->Means[voxel.SurfaceId];
    if (mean.Column != column || mean.Voxels == 0.0)
    {
      mean = { column, 1.0, double(horizon.K.back()) };
    }
    mean.Voxels += 1.0;
    const auto average = [&mean](double& value, double next) { value += (next - value) / mean.Voxels; };
    average(mean.Index, voxel.VerticalIndex);
    horizon.K.back() = int(std::lround(mean.Index));
    average(horizon.Thickness.back(), voxel.Thickness);
    average(horizon.Amplitude.back(), voxel.Amplitude);
    average(horizon.RealZ.back(), voxel.RealZ);
  }

  bool Prefers(const SparseMatrixVoxel& voxel, const LatticeHorizon& horizon) const
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

  struct MeanVoxel
  {
    PlanePoint Column;
    double Voxels = 0.0;
    double Index = 0.0; // not rounded
  };

  SparseMatrixOptions Options;
  SurfacePositions Positions;
  std::unordered_map<int, MeanVoxel> Means;
  std::vector<LatticeHorizon> Horizons;
};
}

#endif
