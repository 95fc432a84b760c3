// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the parser's two uses do with the columns: count the voxels of each horizon and see how real z goes with the
// vertical index, or load some horizons.

#ifndef SeismicHorizonsSparseMatrixVisitors_h
#define SeismicHorizonsSparseMatrixVisitors_h

#include "SparseMatrixParser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Finds what belongs to a surface ID. All columns have the same few IDs, so it remembers the last answers.
class SurfacePositions
{
public:
  static constexpr int None = -1;

  int Find(int surfaceId)
  {
    Answer& answer = this->Recall(surfaceId);
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
    this->Recall(surfaceId) = { true, surfaceId, position };
  }

private:
  struct Answer
  {
    bool IsKnown = false;
    int SurfaceId = 0;
    int Position = None;
  };

  Answer& Recall(int surfaceId) { return this->Recent[static_cast<unsigned int>(surfaceId) % this->Recent.size()]; }

  std::unordered_map<int, int> Positions;
  std::array<Answer, 64> Recent;
};

/// Fits a line through pairs of vertical index and real z.
class VerticalFitter
{
public:
  void Add(const SparseMatrixVoxel& voxel)
  {
    // Relative to the first voxel: sums of large numbers that hardly differ would lose what is asked for.
    if (this->Count++ == 0)
    {
      this->First = voxel;
    }
    const double k = double(voxel.VerticalIndex) - this->First.VerticalIndex;
    const double z = voxel.RealZ - this->First.RealZ;
    this->SumK += k;
    this->SumZ += z;
    this->SumKK += k * k;
    this->SumKZ += k * z;
  }

  SparseMatrixVerticalFit GetFit() const
  {
    const double count = static_cast<double>(this->Count);
    const double spread = count * this->SumKK - this->SumK * this->SumK;
    const double step = spread > 0.0 ? (count * this->SumKZ - this->SumK * this->SumZ) / spread : 0.0;
    if (step == 0.0 || !std::isfinite(step))
    {
      return {};
    }
    const double offset = (this->SumZ - step * this->SumK) / count;
    return { this->First.RealZ + offset - step * this->First.VerticalIndex, step };
  }

private:
  std::int64_t Count = 0;
  SparseMatrixVoxel First;
  double SumK = 0.0;
  double SumZ = 0.0;
  double SumKK = 0.0;
  double SumKZ = 0.0;
};

class CountingVisitor : public SparseMatrixVisitor
{
public:
  void VisitColumn(int, int, const std::vector<SparseMatrixVoxel>& voxels) override
  {
    for (const SparseMatrixVoxel& voxel : voxels)
    {
      int position = this->Positions.Find(voxel.SurfaceId);
      if (position == SurfacePositions::None)
      {
        position = static_cast<int>(this->Counts.size());
        this->Positions.Insert(voxel.SurfaceId, position);
        this->Counts.emplace_back(voxel.SurfaceId, 0);
      }
      ++this->Counts[static_cast<std::size_t>(position)].second;
      this->Fitter.Add(voxel);
    }
  }

  SparseMatrixCounts GetCounts() const { return SparseMatrixCounts(this->Counts.begin(), this->Counts.end()); }
  SparseMatrixVerticalFit GetVerticalFit() const { return this->Fitter.GetFit(); }

private:
  VerticalFitter Fitter;
  SurfacePositions Positions;
  std::vector<std::pair<int, std::int64_t>> Counts;
};

class LoadingVisitor : public SparseMatrixVisitor
{
public:
  LoadingVisitor(const SparseMatrixCounts& horizons, DuplicatePolicy policy)
    : Policy(policy)
    , Horizons(horizons.size())
  {
    int position = 0;
    for (const auto& [surfaceId, numberOfVoxels] : horizons)
    {
      this->Positions.Insert(surfaceId, position);
      Reserve(this->Horizons[static_cast<std::size_t>(position++)], surfaceId, numberOfVoxels);
    }
  }

  void VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels) override
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

  std::vector<HorizonVoxels> TakeHorizons() { return std::move(this->Horizons); }

private:
  static void Reserve(HorizonVoxels& horizon, int surfaceId, std::int64_t numberOfVoxels)
  {
    const auto capacity = static_cast<std::size_t>(std::max<std::int64_t>(numberOfVoxels, 0));
    horizon.SurfaceId = surfaceId;
    horizon.I.reserve(capacity);
    horizon.J.reserve(capacity);
    horizon.K.reserve(capacity);
    horizon.Thickness.reserve(capacity);
    horizon.Amplitude.reserve(capacity);
    horizon.RealZ.reserve(capacity);
  }

  void Add(HorizonVoxels& horizon, int i, int j, const SparseMatrixVoxel& voxel) const
  {
    // All voxels of a column come at once, so a duplicate can only be of the voxel before it.
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

  /// Whether a voxel replaces the last one of the horizon.
  bool Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const
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

  static void RemoveLast(HorizonVoxels& horizon)
  {
    horizon.I.pop_back();
    horizon.J.pop_back();
    horizon.K.pop_back();
    horizon.Thickness.pop_back();
    horizon.Amplitude.pop_back();
    horizon.RealZ.pop_back();
  }

  const DuplicatePolicy Policy;
  SurfacePositions Positions;
  std::vector<HorizonVoxels> Horizons;
};
}

#endif
