// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointQuery.h"

#include "Common/Predicates.h"

namespace SeismicHorizons
{
namespace
{
// A cotangent is a quotient of two whole numbers that are rounded to doubles: right to three times 2^-53 of its size.
// For points whose cotangents are closer to each other than this part, InCircle decides.
constexpr double CotangentRounding = 1e-14;

PlanePoint Doubled(const PlanePoint& p)
{
  return { 2 * p.X, 2 * p.Y };
}
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointQuery::Consider(PointId candidate)
{
  const PlanePoint& place = this->Points.At(candidate);
  const std::int64_t area = SignedArea(this->A, this->B, place);
  if (area <= 0)
  {
    return;
  }
  const double cotangent = this->CotangentOf(place, area);
  if (this->IsBetter(place, candidate, cotangent) && (!this->OnlyVisible || this->IsVisible(candidate)))
  {
    this->Best = candidate;
    this->BestCotangent = cotangent;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointQuery::Take(PointId point, std::int64_t area)
{
  this->Best = point;
  this->BestCotangent = this->CotangentOf(this->Points.At(point), area);
}

//----------------------------------------------------------------------------------------------------------------------
// The cotangent of the angle at which a place to the left sees the edge. The smaller it is, the smaller is the part of
// the place's circle with the edge that lies to the left. Half of it times the length of the edge is how far the centre
// of that circle lies to the left.
double ThirdPointQuery::CotangentOf(const PlanePoint& place, std::int64_t area) const
{
  return double(ScalarProduct(place, this->A, this->B)) / double(area);
}

//----------------------------------------------------------------------------------------------------------------------
bool ThirdPointQuery::IsBetter(const PlanePoint& place, PointId candidate, double cotangent) const
{
  if (this->Best == NoPoint)
  {
    return true;
  }
  const double difference = cotangent - this->BestCotangent;
  const double uncertain = CotangentRounding * (std::abs(cotangent) + std::abs(this->BestCotangent));
  if (std::abs(difference) > uncertain)
  {
    return difference < 0.0;
  }
  return candidate != this->Best && InCircle(this->A, this->B, this->Points.At(this->Best), place) > 0;
}

//----------------------------------------------------------------------------------------------------------------------
// Whether a segment leads as many voxels away from its start as the nearest boundary edge is.
bool ThirdPointQuery::MayMeetEdges(const SegmentEnd& from, const SegmentEnd& to) const
{
  const CellGrid& voxels = this->Points.Voxels();
  const std::int64_t x = voxels.CellX(from.X);
  const std::int64_t y = voxels.CellY(from.Y);
  return std::max(std::abs(voxels.CellX(to.X) - x), std::abs(voxels.CellY(to.Y) - y)) >=
    this->Points.EdgeDistance(x, y);
}

//----------------------------------------------------------------------------------------------------------------------
// A segment that runs through the end of a boundary edge does not cross it, and the point behind counts as visible.
// That does no harm: the end of the edge is nearer, and lies inside the circle of the point behind it.
bool ThirdPointQuery::IsVisible(PointId point) const
{
  const PlanePoint& place = this->Points.At(point);
  const int shift = this->Points.VoxelShift();
  const std::int32_t cellX = this->DoubledMiddle().X >> (shift + 1);
  const std::int32_t cellY = this->DoubledMiddle().Y >> (shift + 1);
  if (std::max(std::abs((place.X >> shift) - cellX), std::abs((place.Y >> shift) - cellY)) < this->Points.EdgeDistance(cellX, cellY))
  {
    return true;
  }
  const SegmentEnd middle = this->Middle();
  const PlanePoint target = Doubled(place);
  bool visible = true;
  const auto blocks = [&](const Edge& edge)
  {
    return ProperlyCross(
      Doubled(this->Points.At(edge.From)), Doubled(this->Points.At(edge.To)), this->DoubledMiddle(), target);
  };
  this->Points.Voxels().ForEachCellAlong(middle, place,
    [&](std::int64_t cell)
    { visible = visible && std::none_of(this->Points.Edges().begin(cell), this->Points.Edges().end(cell), blocks); });
  return visible;
}
}
