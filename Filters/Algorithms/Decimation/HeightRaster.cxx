// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightRaster.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/ColumnIndex.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>

namespace SeismicHorizons
{
namespace
{
template <typename Four>
double LargestOf(const Four& four)
{
  return double(std::max(std::max(four[0], four[1]), std::max(four[2], four[3])));
}

template <typename Four>
double SumOf(const Four& four)
{
  return (double(four[0]) + four[1]) + (double(four[2]) + four[3]);
}

constexpr std::int64_t ColumnGrain = 1 << 15;

// Measures that may end early are checked after this number of steps.
constexpr int StepsBetweenLooks = 4;

// Relative to the height range, this bounds the rounding of corners, slopes, sums and the column.
constexpr double UnitsOfFloats = 16.0 * std::numeric_limits<float>::epsilon();

// Rounding below this fraction of the bound is negligible in sums.
constexpr double RoundingFraction = 1.0 / 64;

struct HeightRange
{
  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();

  void Add(const HeightRange& other)
  {
    this->Lowest = std::min(this->Lowest, other.Lowest);
    this->Highest = std::max(this->Highest, other.Highest);
  }
};
}

//----------------------------------------------------------------------------------------------------------------------
RawVector<PointId> HeightRaster::MakePlaces()
{
  assert(!this->Box.IsEmpty());
  this->Width = std::int64_t(this->Box.Greatest.X) - this->Box.Least.X + 1;
  const std::int64_t rows = std::int64_t(this->Box.Greatest.Y) - this->Box.Least.Y + 1;
  RawVector<PointId> points;
  points.resize(std::size_t(this->Width * rows + Beyond));
  ParallelFor(std::int64_t(points.size()), ColumnGrain,
    [&points](std::int64_t first, std::int64_t last)
    { std::fill(points.begin() + first, points.begin() + last, NoPoint); });
  return points;
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::Add(PointId point, const PlanePoint& column)
{
  PointId& place = (*this->Points)[std::size_t(this->Place(column.X, column.Y))];
  if (place != NoPoint)
  {
    throw SameColumnError(place, point, column);
  }
  place = point;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::pair<std::int64_t, PointId>> HeightRaster::PlacesOf(
  const std::vector<PointId>& points, PlanePoints columns) const
{
  std::vector<std::pair<std::int64_t, PointId>> places;
  std::transform(points.begin(), points.end(), std::back_inserter(places),
    [&](PointId point) { return std::make_pair(this->Place(columns[point].X, columns[point].Y), point); });
  std::sort(places.begin(), places.end());
  return places;
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::SetDropped(const std::vector<PointId>& points, PlanePoints columns)
{
  assert(this->Points.use_count() == 1);
  for (const auto& [place, point] : this->Dropped)
  {
    const double height = this->Heights[point];
    (*this->Points)[std::size_t(place)] = point;
    this->Floats[std::size_t(place)] = float(height - this->Middle);
    this->Lowest = std::min(this->Lowest, height);
    this->Highest = std::max(this->Highest, height);
  }
  this->Dropped = this->PlacesOf(points, columns);
  for (const auto& [place, point] : this->Dropped)
  {
    assert((*this->Points)[std::size_t(place)] == point);
    (*this->Points)[std::size_t(place)] = NoPoint;
    this->Floats[std::size_t(place)] = std::numeric_limits<float>::quiet_NaN();
  }
}

//----------------------------------------------------------------------------------------------------------------------
double HeightRaster::DroppedHeight(const PlanePoint& column) const
{
  return this->Box.Contains(column) ? this->DroppedHeightAt(this->Place(column.X, column.Y))
                                    : std::numeric_limits<double>::quiet_NaN();
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::FindDropped(
  const RaisedPoint& from, const RaisedPoint& to, double bound, std::vector<PointId>& found) const
{
  if (this->Dropped.empty() || this->IsEdgeWithin(from, to, bound))
  {
    return;
  }
  double largest = bound;
  std::array<PointId, 2> farthest = { NoPoint, NoPoint };
  this->ForEachCrossing<double>(from, to,
    [&](const Crossing& crossing)
    {
      if (std::abs(crossing.Error) > largest)
      {
        const std::array<PointId, 2> dropped = { this->DroppedAt(crossing.Place), this->DroppedAt(crossing.Beyond) };
        if (dropped[0] != NoPoint || dropped[1] != NoPoint)
        {
          largest = std::abs(crossing.Error);
          farthest = dropped;
        }
      }
      return true;
    });
  std::copy_if(
    farthest.begin(), farthest.end(), std::back_inserter(found), [](PointId point) { return point != NoPoint; });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::SetFloats(const std::vector<unsigned char>* isKnown)
{
  const RawVector<PointId>& points = *this->Points;
  const auto size = std::int64_t(points.size());
  const HeightRange range = AddUpChunks<HeightRange>(size, ColumnGrain, Monitor(),
    [&](HeightRange& part, std::int64_t first, std::int64_t last)
    {
      for (auto place = std::size_t(first); place < std::size_t(last); ++place)
      {
        if (points[place] != NoPoint)
        {
          part.Add({ this->Heights[points[place]], this->Heights[points[place]] });
        }
      }
    });
  this->Lowest = range.Lowest;
  this->Highest = range.Highest;
  this->Middle = 0.5 * range.Lowest + 0.5 * range.Highest;
  this->Floats.resize(points.size());
  ParallelFor(size, ColumnGrain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto place = std::size_t(first); place < std::size_t(last); ++place)
      {
        const PointId point = points[place];
        const bool hasHeight = point != NoPoint && (!isKnown || (*isKnown)[point] != 0);
        this->Floats[place] =
          hasHeight ? float(this->Heights[point] - this->Middle) : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightRaster::ReadHeights(const PlaneBox& box, double less, RawVector<double>& heights) const
{
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    for (std::int64_t place = this->Place(box.Least.X, y); place <= this->Place(box.Greatest.X, y); ++place)
    {
      heights.push_back(this->At<double>(place) - less);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
double HeightRaster::FloatRounding(double bound) const
{
  constexpr double Least = 64.0 * std::numeric_limits<float>::min();
  return UnitsOfFloats * (this->Highest - this->Lowest + bound) + Least;
}

//----------------------------------------------------------------------------------------------------------------------
bool HeightRaster::IsFloatEnough(double bound) const
{
  return this->FloatRounding(bound) <= RoundingFraction * bound;
}

//----------------------------------------------------------------------------------------------------------------------
// Ends early if an error exceeds the bound.
template <typename Real>
HeightError HeightRaster::MeasureAs(const RaisedTriangle& triangle, const ErrorSquares& squares, double bound) const
{
  using Four = FourColumns<Real>;
  const auto perUnit = Real(1.0 / squares.Unit);
  Four largest = Four::Zero();
  Four sums = Four::Zero();
  int steps = 0;
  this->ForEachHeight<Real>(triangle, EdgeColumns(),
    [&](std::int64_t place, const Four& heights, const Four&, const Four&, const Four& isIn)
    {
      const Four distances = AtLeastZero(Four((heights - this->FourAt<Real>(place)).abs())) * isIn;
      largest = largest.max(distances);
      if (squares.AreSummed)
      {
        sums += (distances * perUnit).square();
      }
      return bound == Infinity || ++steps % StepsBetweenLooks != 0 || LargestOf(largest) <= bound;
    });
  return { LargestOf(largest), NoPoint, squares.AreSummed ? SumOf(sums) : 0.0 };
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Real>
PointId HeightRaster::FindPointAs(const RaisedTriangle& triangle, double error) const
{
  using Four = FourColumns<Real>;
  PointId point = NoPoint;
  this->ForEachHeight<Real>(triangle, EdgeColumns(),
    [&](std::int64_t place, const Four& heights, const Four&, const Four&, const Four& isIn)
    {
      const Four distances = AtLeastZero(Four((heights - this->FourAt<Real>(place)).abs())) * isIn;
      if (LargestOf(distances) == error)
      {
        int n = 0;
        while (double(distances[n]) != error)
        {
          ++n;
        }
        point = (*this->Points)[place + n];
      }
      return point == NoPoint;
    });
  return point;
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::Measure(const RaisedTriangle& triangle, const ErrorSquares& squares) const
{
  return this->MeasureAs<double>(triangle, squares, Infinity);
}

//----------------------------------------------------------------------------------------------------------------------
// The point is searched at once, while its columns are cached.
HeightError HeightRaster::MeasureAbove(const RaisedTriangle& triangle, double bound) const
{
  const bool isFloatEnough = this->IsFloatEnough(bound);
  const double rounding = isFloatEnough ? this->FloatRounding(bound) : Infinity;
  double largest = isFloatEnough ? this->MeasureAs<float>(triangle, ErrorSquares(), Infinity).Largest : bound;
  if (std::abs(largest - bound) <= rounding)
  {
    largest = this->Measure(triangle).Largest;
  }
  return largest > bound ? HeightError{ largest, this->FindPoint(triangle, largest, bound) } : HeightError();
}

//----------------------------------------------------------------------------------------------------------------------
PointId HeightRaster::FindPoint(const RaisedTriangle& triangle, double error, double bound) const
{
  const PointId point = this->IsFloatEnough(bound) ? this->FindPointAs<float>(triangle, error) : NoPoint;
  return point == NoPoint ? this->FindPointAs<double>(triangle, error) : point;
}

//----------------------------------------------------------------------------------------------------------------------
bool HeightRaster::IsWithin(const RaisedTriangle& triangle, double bound) const
{
  if (this->IsFloatEnough(bound))
  {
    const double rounding = this->FloatRounding(bound);
    const double largest = this->MeasureAs<float>(triangle, ErrorSquares(), bound + rounding).Largest;
    if (std::abs(largest - bound) > rounding)
    {
      return largest <= bound;
    }
  }
  return this->MeasureAs<double>(triangle, ErrorSquares(), bound).Largest <= bound;
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightRaster::MeasureEdge(
  const RaisedPoint& from, const RaisedPoint& to, const std::vector<unsigned char>& marks) const
{
  HeightError error;
  this->ForEachCrossing<double>(from, to,
    [&](const Crossing& crossing)
    {
      const double distance = std::abs(crossing.Error);
      const auto isMarked = [&](std::int64_t place)
      {
        const PointId point = this->DroppedAt(place);
        return point != NoPoint && marks[point] != 0;
      };
      if (distance > error.Largest && !isMarked(crossing.Place) && !isMarked(crossing.Beyond))
      {
        const bool isFirstNear = crossing.FractionOfColumn < 0.5;
        const PointId near = (*this->Points)[isFirstNear ? crossing.Place : crossing.Beyond];
        const PointId far = (*this->Points)[isFirstNear ? crossing.Beyond : crossing.Place];
        const auto isFree = [&marks](PointId point) { return point != NoPoint && marks[point] == 0; };
        const PointId point = isFree(near) ? near : far;
        error = isFree(point) ? HeightError{ distance, point } : error;
      }
      return true;
    });
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
CrossingErrors HeightRaster::MeasureCrossings(const RaisedPoint& from, const RaisedPoint& to) const
{
  CrossingErrors errors;
  this->ForEachCrossing<double>(from, to,
    [&](const Crossing& crossing)
    {
      const bool isBeside = std::isnan(this->Floats[crossing.Place]) || std::isnan(this->Floats[crossing.Beyond]);
      double& largest = isBeside ? errors.BesideLoops : errors.Inside;
      largest = std::max(largest, std::abs(crossing.Error));
      return true;
    });
  return errors;
}

//----------------------------------------------------------------------------------------------------------------------
bool HeightRaster::IsEdgeWithin(const RaisedPoint& from, const RaisedPoint& to, double bound) const
{
  const double rounding = this->FloatRounding(bound);
  double largest = 0.0;
  this->ForEachCrossing<float>(from, to,
    [&](const Crossing& crossing)
    {
      largest = std::max(largest, std::abs(crossing.Error));
      return largest <= bound + rounding;
    });
  const bool isInDoubt = std::abs(largest - bound) <= rounding;
  return isInDoubt ? this->MeasureCrossings(from, to).Largest() <= bound : largest <= bound;
}
}
