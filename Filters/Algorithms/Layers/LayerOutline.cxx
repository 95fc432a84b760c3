// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LayerOutline.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/SpacePoints.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// Loops are simplified for the first horizon. Edges too far from another one keep its farthest point, until none is.
class OutlineMaker
{
public:
  OutlineMaker(PlanePoints columns, const HeightStack& heights, const std::vector<std::vector<unsigned char>>& known,
    const std::vector<HorizonView>& horizons, const std::vector<ColumnIndex>& indices, double error, double tolerance)
    : Columns(columns)
    , Heights(heights)
    , Known(known)
    , Horizons(horizons)
    , Indices(indices)
  {
    this->Options.Method = OutlineMethod::FewestPoints;
    this->Options.DistanceThreshold = error;
    this->Options.OutlineTolerance = tolerance;
    if (tolerance > 0.0) // without a tolerance outlines pass over no other columns
    {
      this->Index.emplace(columns);
    }
  }

  LayerOutline Run(const ExteriorBoundary& boundary, const std::vector<PointId>& fixed, const Monitor& monitor)
  {
    this->Options.Fixed = fixed;
    const std::vector<PointId> ends = boundary.OpenCracks.PointsOfOpenEnds();
    this->Options.Fixed.insert(this->Options.Fixed.end(), ends.begin(), ends.end());
    BoundarySimplification simplified;
    const SpacePoints points(this->Columns, this->Heights.front(), 1);
    std::vector<PointId> far;
    Monitor step = monitor;
    do
    {
      this->Options.Fixed.insert(this->Options.Fixed.end(), far.begin(), far.end());
      simplified = SimplifyBoundary(points, boundary.Boundary, this->Options, step);
      step = monitor.Step(1.0, 1.0);
      far = this->FindFar(boundary.Boundary, simplified.Boundary.MarkPoints(this->Columns.size()));
    } while (!far.empty());
    LayerOutline outline;
    outline.Boundary = std::move(simplified.Boundary);
    outline.Patch = boundary.Patch;
    for (const DroppedPoint& dropped : simplified.Dropped)
    {
      outline.Patch[std::size_t(dropped.Point)] = NoPatch;
    }
    return outline;
  }

private:
  std::vector<PointId> FindFar(const Loops& loops, const std::vector<unsigned char>& isKept) const
  {
    std::vector<PointId> far;
    for (std::size_t loop = 0; loop < loops.Size(); ++loop)
    {
      const PointId* const points = loops.begin(loop);
      const std::size_t length = loops.Length(loop);
      const auto at = [&](std::size_t n) { return points[n % length]; };
      const auto first = std::size_t(
        std::find_if(points, points + length, [&](PointId point) { return isKept[std::size_t(point)] != 0; }) - points);
      for (std::size_t from = first; from < first + length && first < length;)
      {
        std::size_t to = from + 1;
        while (isKept[std::size_t(at(to))] == 0)
        {
          ++to;
        }
        std::size_t farthest = this->FindFarthest(at, from, to);
        farthest = farthest == from ? this->FindBesidePassed(at, from, to) : farthest;
        if (farthest != from)
        {
          far.push_back(at(farthest));
        }
        from = to;
      }
    }
    return far;
  }

  /// The point between two kept ones at which a horizon is farthest from the edge, if too far, or `from`.
  template <typename PointAt>
  std::size_t FindFarthest(const PointAt& at, std::size_t from, std::size_t to) const
  {
    std::size_t farthest = from;
    double largest = this->Options.DistanceThreshold + this->Slack();
    for (std::size_t n = from + 1; n < to; ++n)
    {
      for (std::size_t horizon = 1; horizon < this->Heights.size(); ++horizon)
      {
        const bool counts = this->Known.empty() || this->Known[horizon][std::size_t(at(n))] != 0;
        const double distance = counts ? this->DistanceFrom(at(from), at(to), at(n), this->Heights[horizon]) : 0.0;
        farthest = distance > largest ? n : farthest;
        largest = std::max(largest, distance);
      }
    }
    return farthest;
  }

  /// The point half-way if the edge is too far from points that the stack does not have, or `from`.
  template <typename PointAt>
  std::size_t FindBesidePassed(const PointAt& at, std::size_t from, std::size_t to) const
  {
    const PlanePoint& a = this->Columns[std::size_t(at(from))];
    const PlanePoint& b = this->Columns[std::size_t(at(to))];
    bool isFar = false;
    const auto look = [&](const PlanePoint& place, double part)
    {
      const bool isOther = this->Index->PointAt(place) == NoPoint;
      for (std::size_t horizon = 0; isOther && horizon < this->Indices.size(); ++horizon)
      {
        const double start = this->Heights[horizon][std::size_t(at(from))];
        const double end = this->Heights[horizon][std::size_t(at(to))];
        const double distance = std::abs(start + (end - start) * part - this->HeightAt(horizon, place));
        isFar = isFar || distance > this->Options.DistanceThreshold + this->Slack();
      }
    };
    if (to > from + 1 && this->Index)
    {
      ForEachColumnBetween(a, b, look);
    }
    return isFar ? from + (to - from) / 2 : from;
  }

  double HeightAt(std::size_t horizon, const PlanePoint& column) const
  {
    const PointId point = this->Indices[horizon].PointAt(column);
    return point == NoPoint ? std::nan("") : this->Horizons[horizon].Heights[point];
  }

  double DistanceFrom(PointId from, PointId to, PointId point, const std::vector<double>& heights) const
  {
    const PlanePoint& a = this->Columns[std::size_t(from)];
    const PlanePoint& b = this->Columns[std::size_t(to)];
    const auto length = double(SquaredDistance(a, b));
    const auto along = double(ScalarProduct(a, b, this->Columns[std::size_t(point)]));
    const double part = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
    const double start = heights[std::size_t(from)];
    return std::abs(start + part * (heights[std::size_t(to)] - start) - heights[std::size_t(point)]);
  }

  double Slack() const { return 1e-9 * std::max(1.0, this->Options.DistanceThreshold); }

  PlanePoints Columns;
  const HeightStack& Heights;
  const std::vector<std::vector<unsigned char>>& Known;
  const std::vector<HorizonView>& Horizons;
  std::optional<ColumnIndex> Index; // of the columns of the stack
  const std::vector<ColumnIndex>& Indices; // of the columns of the horizons
  BoundarySimplificationOptions Options;
};
}

//----------------------------------------------------------------------------------------------------------------------
LayerOutline SimplifyOutline(PlanePoints columns, const HeightStack& heights,
  const std::vector<std::vector<unsigned char>>& known, const std::vector<HorizonView>& horizons,
  const std::vector<ColumnIndex>& indices, const ExteriorBoundary& boundary, const LayerOutlineOptions& options,
  const Monitor& monitor)
{
  return OutlineMaker(columns, heights, known, horizons, indices, options.MaximumError, options.Tolerance)
    .Run(boundary, options.Fixed, monitor);
}
}
