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

// A segment that leads no more voxels away from its start is looked for boundary edges in the whole box around it: to
// find the voxels that it touches takes longer.
constexpr std::int64_t MostStepsInBox = 1;

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
// A segment that runs through the end of a boundary edge does not cross it, and the point behind counts as visible.
// That does no harm: the end of the edge is nearer, and lies inside the circle of the point behind it.
bool ThirdPointQuery::IsVisible(PointId point) const
{
  const PlanePoint& place = this->Points.At(point);
  const PlanePoint middle = this->DoubledMiddle();
  const std::int64_t fromX = this->Points.VoxelX(middle.X >> 1);
  const std::int64_t fromY = this->Points.VoxelY(middle.Y >> 1);
  const std::int64_t toX = this->Points.VoxelX(place.X);
  const std::int64_t toY = this->Points.VoxelY(place.Y);
  const std::int64_t steps = std::max(std::abs(toX - fromX), std::abs(toY - fromY));
  if (steps < std::max(this->Points.EdgeDistance(fromX, fromY), this->Points.EdgeDistance(toX, toY)))
  {
    return true;
  }
  const PlanePoint target = Doubled(place);
  const EdgeLists& edges = this->Points.Edges();
  bool visible = true;
  const auto look = [&](std::int64_t voxel)
  {
    visible = visible &&
      std::none_of(edges.begin(voxel), edges.end(voxel),
        [&](const Edge& edge) {
          return ProperlyCross(middle, target, Doubled(this->Points.At(edge.From)), Doubled(this->Points.At(edge.To)));
        });
  };
  if (steps > MostStepsInBox)
  {
    this->Points.Voxels().ForEachCellAlong(this->Middle(), place, look);
    return visible;
  }
  for (std::int64_t y = std::min(fromY, toY); y <= std::max(fromY, toY); ++y)
  {
    for (std::int64_t x = std::min(fromX, toX); x <= std::max(fromX, toX); ++x)
    {
      look(this->Points.Voxels().Index(x, y));
    }
  }
  return visible;
}
}
