// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The searches for a first candidate, and the one far from the edge. They are a file of their own, apart from the
// circle search, which is all that nearly every edge needs.

#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"
#include "ThirdPointSearch.h"
#include "VoxelWalk.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
/// The thesis's C (eq. 5.9) without its factor, 4 sqrt(3) / 2: `area` is twice that of the triangle.
double Compactness(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, std::int64_t area)
{
  return double(area) / (double(SquaredDistance(a, b)) + double(SquaredDistance(b, c)) + double(SquaredDistance(c, a)));
}

/// From a place to the nearest place of a box.
double SquaredDistance(const SegmentEnd& place, const PointBox& box)
{
  const double x = std::max({ box.Low.X - place.X, 0.0, place.X - box.High.X });
  const double y = std::max({ box.Low.Y - place.Y, 0.0, place.Y - box.High.Y });
  return x * x + y * y;
}
}

//----------------------------------------------------------------------------------------------------------------------
// The bisector, then one line of voxels more on either side of it at a time, as far as the box reaches.
void ThirdPointSearch::TraverseBox(ThirdPointQuery& query, const EdgeBox& edgeBox) const
{
  for (int dilatation = 0; query.Best == NoPoint && dilatation <= edgeBox.Size; ++dilatation)
  {
    query.Dilatation = dilatation;
    this->SearchDilatation(query, edgeBox, dilatation);
    if (dilatation > 0)
    {
      this->SearchDilatation(query, edgeBox, -dilatation);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
// One line of a dilatation: the bisector's line of voxels, moved along the axis on which it advances less.
void ThirdPointSearch::SearchDilatation(ThirdPointQuery& query, const EdgeBox& edgeBox, std::int64_t shift) const
{
  const double x = double(query.A.Y) - query.B.Y;
  const double y = double(query.B.X) - query.A.X;
  const std::int64_t shiftX = std::abs(x) < std::abs(y) ? shift : 0;
  const std::int64_t shiftY = shift - shiftX;
  VoxelWalk walk(edgeBox.MiddleX, edgeBox.MiddleY, x, y);
  const std::int64_t startX = walk.X();
  const std::int64_t startY = walk.Y();
  for (; std::max(std::abs(walk.X() - startX), std::abs(walk.Y() - startY)) <= edgeBox.Size; walk.Next())
  {
    const std::int64_t cellX = walk.X() + shiftX;
    const std::int64_t cellY = walk.Y() + shiftY;
    if (cellX >= 0 && cellX < this->Grid.SizeX() && cellY >= 0 && cellY < this->Grid.SizeY())
    {
      this->SearchRow(query, cellY, cellX, cellX);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::CompareBox(ThirdPointQuery& query, const EdgeBox& edgeBox) const
{
  double most = 0.0;
  const VoxelBox box = this->SquareAround(edgeBox, edgeBox.Size);
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    this->VisitRow(query, row, box.FirstX, box.LastX,
      [&](PointId point)
      {
        const std::int64_t area = SignedArea(query.A, query.B, this->At(point));
        const double compactness = Compactness(query.A, query.B, this->At(point), area);
        if (compactness > most && (!query.OnlyVisible || this->IsVisible(query, point)))
        {
          most = compactness;
          query.Best = point;
          query.BestCotangent = Cotangent(query.A, query.B, this->At(point), area);
        }
      });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::SearchSquares(ThirdPointQuery& query, const EdgeBox& edgeBox) const
{
  const std::int64_t everything = std::max(this->Grid.SizeX(), this->Grid.SizeY());
  for (std::int64_t radius = edgeBox.Size; query.Best == NoPoint && radius < 2 * everything; radius = 2 * radius + 1)
  {
    this->SearchBox(query, this->SquareAround(edgeBox, radius));
  }
}

//----------------------------------------------------------------------------------------------------------------------
VoxelBox ThirdPointSearch::SquareAround(const EdgeBox& edgeBox, std::int64_t radius) const
{
  const std::int64_t x = std::int64_t(edgeBox.MiddleX);
  const std::int64_t y = std::int64_t(edgeBox.MiddleY);
  return { std::max<std::int64_t>(x - radius, 0), std::max<std::int64_t>(y - radius, 0),
    std::min(x + radius, this->Grid.SizeX() - 1), std::min(y + radius, this->Grid.SizeY() - 1) };
}

//----------------------------------------------------------------------------------------------------------------------
// A box can hold a better point when a corner of it is to the left of the edge, and it reaches into the circle of the
// best one. Every better point makes that circle smaller, which is why near boxes come first.
void ThirdPointSearch::SearchFar(ThirdPointQuery& query) const
{
  if (!this->Pyramid)
  {
    this->Pyramid = std::make_unique<PointPyramid>(this->Points);
  }
  std::optional<EdgeCircle> circle;
  const SegmentEnd middle = query.Middle();
  const auto isLeft = [&](std::int32_t x, std::int32_t y) { return SignedArea(query.A, query.B, { x, y }) > 0; };
  const auto mayHold = [&](const PointBox& box)
  {
    return (isLeft(box.Low.X, box.Low.Y) || isLeft(box.High.X, box.Low.Y) || isLeft(box.Low.X, box.High.Y) ||
             isLeft(box.High.X, box.High.Y)) &&
      (!circle || circle->MayReach(box.Low, box.High));
  };
  this->Pyramid->Visit(
    mayHold, [&](const PointBox& box) { return SquaredDistance(middle, box); },
    [&](PointId point)
    {
      const PointId before = query.Best;
      this->Consider(query, point);
      if (query.Best != before)
      {
        circle.emplace(query, query.BestCotangent);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::SearchBox(ThirdPointQuery& query, const VoxelBox& box) const
{
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    this->SearchRow(query, row, box.FirstX, box.LastX);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::SearchRow(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last) const
{
  this->VisitRow(query, row, first, last, [&](PointId point) { this->Consider(query, point); });
}
}
