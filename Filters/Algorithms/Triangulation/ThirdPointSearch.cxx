// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointSearch.h"

#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"
#include "VoxelWalk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// The first circle that is looked into: its diameter when points are one apart on average, and the least one for an
// edge of length 1. Larger circles have more points than needed, smaller ones too often none.
constexpr double NearbyDiameter = 1.5;
constexpr double LeastDiameter = 1.1;

// A point whose cotangent is smaller by this part than that of a circle is inside the circle for certain.
constexpr double CotangentMargin = 1e-12;

// The longest edge, in voxels, whose box is searched. Most edges are shorter; for a longer one SearchFar is quicker.
constexpr std::int64_t LargestBoxToTraverse = 8;

/// The thesis's C (eq. 5.9) without its factor, 4 sqrt(3) / 2: `area` is twice that of the triangle.
double Compactness(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, std::int64_t area)
{
  return double(area) / (double(SquaredDistance(a, b)) + double(SquaredDistance(b, c)) + double(SquaredDistance(c, a)));
}
}

//----------------------------------------------------------------------------------------------------------------------
PointId ThirdPointSearch::Find(PointId a, PointId b, std::vector<WalkedVoxel>* walk) const
{
  ThirdPointQuery query(this->Points, a, b, walk);
  this->Search(query);
  if (query.Best != NoPoint && !query.IsVisible(query.Best))
  {
    query.OnlyVisible = true;
    query.Best = NoPoint;
    this->Search(query);
  }
  return query.Best;
}

//----------------------------------------------------------------------------------------------------------------------
// The circle through the best point to the left has no point in its left part, and of all such circles the smallest
// right part. So the edge is Delaunay when that part has no point either. Seen from the right the edge is reversed, and
// the cotangent of the circle has the other sign.
bool ThirdPointSearch::IsDelaunay(PointId a, PointId b) const
{
  ThirdPointQuery left(this->Points, a, b, nullptr);
  this->Search(left);
  ThirdPointQuery right(this->Points, b, a, nullptr);
  right.BestCotangent = -left.BestCotangent;
  const VoxelBox box = this->LeftPartOf(EdgeCircle(right, right.BestCotangent), right);
  bool empty = true;
  for (std::int64_t row = box.FirstY; empty && row <= box.LastY; ++row)
  {
    this->VisitRow(right, row, box.FirstX, box.LastX,
      [&](PointId point)
      {
        empty = empty &&
          (SignedArea(right.A, right.B, this->At(point)) <= 0 ||
            InCircle(left.A, left.B, this->At(left.Best), this->At(point)) <= 0);
      });
  }
  return empty;
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::Search(ThirdPointQuery& query) const
{
  const bool isTraced = query.Walk != nullptr;
  const EdgeBox edgeBox(query, this->Grid);
  if (edgeBox.Size > LargestBoxToTraverse && !isTraced)
  {
    this->SearchFar(query);
    return;
  }
  if (this->Strategy == SearchStrategy::Compactness)
  {
    this->CompareBox(query, edgeBox);
  }
  else if (!isTraced && this->SearchNearby(query))
  {
    return;
  }
  else
  {
    this->TraverseBox(query, edgeBox);
  }
  query.Dilatation = -1;
  if (query.Best == NoPoint && !isTraced)
  {
    this->SearchFar(query);
    return;
  }
  if (query.Best == NoPoint)
  {
    this->SearchSquares(query, edgeBox);
  }
  if (query.Best != NoPoint)
  {
    const EdgeCircle circle(query, query.BestCotangent);
    this->SearchCircle(query, circle, this->LeftPartOf(circle, query));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Where points are as dense as on average, the third point lies in a circle through the ends of the edge that is little
// wider than points are apart: when the circle has points to the left of the edge, the third point is one of them.
// Where it has none, points are further apart, and a circle twice as wide is searched.
bool ThirdPointSearch::SearchNearby(ThirdPointQuery& query) const
{
  const double squaredLength = query.SquaredLength();
  const double nearby = NearbyDiameter * this->Points.Spacing();
  double squaredDiameter = std::max(nearby * nearby, LeastDiameter * LeastDiameter * squaredLength);
  double cotangent = 0.0;
  for (int look = 0; query.Best == NoPoint && look < 2; ++look)
  {
    cotangent = std::sqrt(squaredDiameter / squaredLength - 1.0);
    const EdgeCircle circle(query, cotangent, 0.5 * std::sqrt(squaredDiameter));
    const double reach = circle.Radius + circle.Margin;
    this->SearchCircle(query, circle,
      { this->Grid.CellX(query.A.X + circle.X - reach), this->Grid.CellY(query.A.Y + circle.Y - reach),
        this->Grid.CellX(query.A.X + circle.X + reach), this->Grid.CellY(query.A.Y + circle.Y + reach) });
    squaredDiameter *= 4.0;
  }
  // When the best point is in the margin of the circle, a better one may be outside.
  return query.Best != NoPoint && query.BestCotangent < cotangent * (1.0 - CotangentMargin);
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
        if (compactness > most && (!query.OnlyVisible || query.IsVisible(point)))
        {
          most = compactness;
          query.Take(point, area);
        }
      });
  }
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
  const auto mayHold = [&](const PlaneBox& box)
  {
    return (isLeft(box.Least.X, box.Least.Y) || isLeft(box.Greatest.X, box.Least.Y) ||
             isLeft(box.Least.X, box.Greatest.Y) || isLeft(box.Greatest.X, box.Greatest.Y)) &&
      (!circle || circle->MayReach(box));
  };
  this->Pyramid->Visit(
    mayHold, [&](const PlaneBox& box) { return SquaredDistanceToBox(middle, box); },
    [&](PointId point)
    {
      const PointId before = query.Best;
      query.Consider(point);
      if (query.Best != before)
      {
        circle.emplace(query, query.BestCotangent);
      }
    });
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
// The box of the circle's part to the left of the edge: around the ends of the edge, and those of the circle's
// leftmost, rightmost, lowest and highest points that are to the left.
VoxelBox ThirdPointSearch::LeftPartOf(const EdgeCircle& circle, const ThirdPointQuery& query) const
{
  const double bx = double(query.B.X) - query.A.X;
  const double by = double(query.B.Y) - query.A.Y;
  double minX = std::min(0.0, bx);
  double minY = std::min(0.0, by);
  double maxX = std::max(0.0, bx);
  double maxY = std::max(0.0, by);
  const double outermost[4][2] = { { circle.X - circle.Radius, circle.Y }, { circle.X + circle.Radius, circle.Y },
    { circle.X, circle.Y - circle.Radius }, { circle.X, circle.Y + circle.Radius } };
  const double nearlyLeft = -2.0 * circle.Margin * (std::abs(bx) + std::abs(by));
  for (const auto& point : outermost)
  {
    // Without branches: one that is not to the left counts as the start of the edge, which is in the box anyway.
    const bool left = bx * point[1] - by * point[0] > nearlyLeft;
    const double px = left ? point[0] : 0.0;
    const double py = left ? point[1] : 0.0;
    minX = std::min(minX, px);
    maxX = std::max(maxX, px);
    minY = std::min(minY, py);
    maxY = std::max(maxY, py);
  }
  return { this->Grid.CellX(query.A.X + minX - circle.Margin), this->Grid.CellY(query.A.Y + minY - circle.Margin),
    this->Grid.CellX(query.A.X + maxX + circle.Margin), this->Grid.CellY(query.A.Y + maxY + circle.Margin) };
}

//----------------------------------------------------------------------------------------------------------------------
// Points are tested in batches of fixed size, even where a row of voxels has fewer, and those inside are collected
// without branches. Which points are inside follows no pattern, and a branch that a processor predicts wrongly takes it
// longer than to test some points more.
void ThirdPointSearch::SearchCircle(ThirdPointQuery& query, const EdgeCircle& circle, const VoxelBox& box) const
{
  constexpr PointId Batch = SearchGrid::Padding;
  std::array<PointId, 16 * std::size_t(Batch)> inside;
  std::size_t count = 0;
  const auto considerAll = [&]()
  {
    for (std::size_t n = 0; n < count; ++n)
    {
      query.Consider(inside[n]);
    }
    count = 0;
  };
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    this->Trace(query, row, box.FirstX, box.LastX);
    const PointId end = this->Points.EndOf(this->Grid.Index(box.LastX, row));
    for (PointId first = this->Points.FirstIn(this->Grid.Index(box.FirstX, row)); first < end; first += Batch)
    {
      for (PointId point = first; point < first + Batch; ++point)
      {
        inside[count] = point;
        count +=
          std::size_t((point < end) & (point != query.From) & (point != query.To) & circle.MayHold(this->At(point)));
      }
      if (count > inside.size() - Batch)
      {
        considerAll();
      }
    }
  }
  considerAll();
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
  this->VisitRow(query, row, first, last, [&](PointId point) { query.Consider(point); });
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::Trace(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last) const
{
  for (std::int64_t column = first; query.Walk && column <= last; ++column)
  {
    query.Walk->push_back({ column, row, query.Dilatation });
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The points in a row of voxels are in one range.
template <typename Visitor>
void ThirdPointSearch::VisitRow(
  ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last, Visitor&& visit) const
{
  this->Trace(query, row, first, last);
  const PointId end = this->Points.EndOf(this->Grid.Index(last, row));
  for (PointId point = this->Points.FirstIn(this->Grid.Index(first, row)); point < end; ++point)
  {
    visit(point);
  }
}
}
