// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMergedPoints_h
#define SeismicHorizonsMergedPoints_h

#include "Common/Base/CountingSort.h"
#include "Lattice.h"
#include "Types.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// The place of an output point in the world. A point that was not averaged keeps that of its input point exactly.
template <typename PlaceOf>
Eigen::Vector3d WorldPlace(const Reduction& reduction, std::size_t target, const Lattice& lattice, PlaceOf&& placeOf)
{
  if (reduction.Averaged[target] == 0)
  {
    return placeOf(reduction.Source[target]);
  }
  const PlanePoint& place = reduction.Plane[target];
  const double perSubVoxel = 1.0 / reduction.SubVoxelsPerColumn; // exact
  return lattice.ToWorld({ place.X * perSubVoxel, place.Y * perSubVoxel, reduction.Height[target] });
}

/// The mean of finite values, which depends on their order by rounding.
struct FiniteMean
{
  double Sum = 0.0;
  double Weights = 0.0;

  void Add(double value, std::int64_t count)
  {
    if (std::isfinite(value))
    {
      this->Sum += double(count) * value;
      this->Weights += double(count);
    }
  }
  template <typename Otherwise>
  double Value(Otherwise&& otherwise) const
  {
    return this->Weights > 0.0 ? this->Sum / this->Weights : otherwise();
  }
};

/// The input points of each output point, in ascending order.
class MergedPoints
{
public:
  /// Counts are original points per input point; empty counts mean one.
  MergedPoints(const Reduction& reduction, std::vector<std::int64_t> counts)
    : Merged(reduction)
    , Counts(std::move(counts))
    , Points(std::int64_t(reduction.Source.size()),
        [&reduction](auto&& add)
        {
          for (std::size_t point = 0; point < reduction.Target.size(); ++point)
          {
            add(reduction.Target[point], PointId(point));
          }
        })
  {
  }

  std::int64_t Size() const { return std::int64_t(this->Merged.Source.size()); }

  std::int64_t SumCounts(std::int64_t target) const
  {
    if (this->Counts.empty())
    {
      return this->Points.end(target) - this->Points.begin(target);
    }
    return std::accumulate(this->Points.begin(target), this->Points.end(target), std::int64_t(0),
      [this](std::int64_t sum, PointId point) { return sum + this->Count(point); });
  }

  /// Averaged points get the mean of finite values, weighted by counts, or equally if all are 0, as of filled points;
  /// without such values, and as other points, they get the value of the nearest input point.
  template <typename ValueOf>
  double Average(std::int64_t target, ValueOf&& valueOf) const
  {
    FiniteMean mean;
    const auto addAll = [&](bool isWeighted)
    {
      std::int64_t counts = 0;
      for (const PointId* point = this->Points.begin(target); point < this->Points.end(target); ++point)
      {
        const std::int64_t count = isWeighted ? this->Count(*point) : 1;
        counts += count;
        mean.Add(valueOf(*point), count);
      }
      return counts > 0;
    };
    if (this->Merged.Averaged[target] != 0 && !addAll(true))
    {
      addAll(false);
    }
    return mean.Value([&]() { return valueOf(this->Merged.Source[target]); });
  }

private:
  std::int64_t Count(PointId point) const { return this->Counts.empty() ? 1 : this->Counts[point]; }

  const Reduction& Merged;
  const std::vector<std::int64_t> Counts;
  const ItemLists<PointId, std::uint32_t> Points;
};
}

#endif
