// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointSearch.h"

#include "BoxScan.h"
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
#ifndef HPD
#define HPD 1.15f
#define HPS 1.31f
#define GH 3.0f
#endif
constexpr float HeightPerDiameter = HPD;
constexpr float HeightPerSpacing = HPS;
constexpr float GreatestHeight = GH;

// The longest edge, in voxels, whose box is searched. Most edges are shorter; for a longer one SearchFar is quicker.
constexpr std::int32_t LargestBoxToTraverse = 8;
constexpr std::int32_t LongestToScan = 16;

/// The thesis's C (eq. 5.9) without its factor, 4 sqrt(3) / 2: `area` is twice that of the triangle.
double Compactness(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, std::int64_t area)
{
  return double(area) / (double(SquaredDistance(a, b)) + double(SquaredDistance(b, c)) + double(SquaredDistance(c, a)));
}
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPoint ThirdPointSearch::Find(PointId a, PointId b, float squaredHint, std::vector<WalkedVoxel>* walk) const
{
  ThirdPointQuery query(this->Points, a, b, walk);
  query.SquaredHint = squaredHint;
  this->Search(query);
  if (query.Best != NoPoint && !query.IsVisible(query.Best))
  {
    query.OnlyVisible = true;
    query.Best = NoPoint;
    this->Search(query);
  }
  return { query.Best, float((1.0 + query.BestCotangent * query.BestCotangent) * query.SquaredLength()) };
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
  const EdgeCircle circle(right, right.BestCotangent);
  const VoxelBox box = this->LeftPartOf(circle, right);
  bool empty = true;
  for (std::int64_t row = box.FirstY; empty && row <= box.LastY; ++row)
  {
    this->VisitRow(right, row, box.FirstX, box.LastX,
      [&](PointId point)
      {
        empty = empty &&
          (!circle.MayHold(this->At(point)) || SignedArea(right.A, right.B, this->At(point)) <= 0 ||
            InCircle(left.A, left.B, this->At(left.Best), this->At(point)) <= 0);
      });
  }
  return empty;
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::Search(ThirdPointQuery& query) const
{
  const bool isTraced = query.Walk != nullptr;
  const std::int32_t extent =
    std::max(std::abs(query.A.X - query.B.X), std::abs(query.A.Y - query.B.Y)) >> this->Points.VoxelShift();
  if (!isTraced && this->Strategy == SearchStrategy::VoxelTraversal && extent < LongestToScan &&
    this->SearchNearby(query))
  {
    return;
  }
  if (!isTraced && extent >= LargestBoxToTraverse)
  {
    this->SearchFar(query);
    return;
  }
  const EdgeBox edgeBox(query, this->Grid);
  if (this->Strategy == SearchStrategy::Compactness)
  {
    this->CompareBox(query, edgeBox);
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
    this->ScanBox(query, this->LeftPartOf(circle, query), float(query.BestCotangent));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// XXX
bool ThirdPointSearch::SearchNearby(ThirdPointQuery& query) const
{
  const float length = std::sqrt(float(query.SquaredLength()));
  const float greatest = GreatestHeight * float(this->Points.Spacing());
  float height = query.SquaredHint > 0.0f ? std::min(HeightPerDiameter * std::sqrt(query.SquaredHint), greatest)
                                          : HeightPerSpacing * float(this->Points.Spacing());
  const auto cotangentFor = [length](float h) { return h / length - 0.25f * length / h; };
  for (int look = 0; look < 3; ++look)
  {
    const float cotangent = cotangentFor(height);
    height *= 2.0f;
    this->ScanBox(query, this->BoxOf(query, cotangent), cotangent);
    if (query.Best != NoPoint && query.BestCotangent <= cotangentFor(height))
    {
      if (query.BestCotangent >= cotangent - 1e-5f * std::abs(cotangent))
      {
        const float best = float(query.BestCotangent);
        this->ScanBox(query, this->BoxOf(query, best), best);
      }
      return true;
    }
    query.Best = NoPoint;
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
VoxelBox ThirdPointSearch::BoxOf(const ThirdPointQuery& query, float cotangent) const
{
  using Floats = float __attribute__((vector_size(16)));
  using Integers = std::int32_t __attribute__((vector_size(16)));
  const float edgeX = float(query.B.X - query.A.X);
  const float edgeY = float(query.B.Y - query.A.Y);
  const float squaredLength = edgeX * edgeX + edgeY * edgeY;
  const float radius = 0.5f * std::sqrt((1.0f + cotangent * cotangent) * squaredLength);
  const float cross = 0.5f * cotangent * squaredLength;
  const float x = 0.5f * (edgeX - edgeY * cotangent);
  const float y = 0.5f * (edgeY + edgeX * cotangent);
  const Floats centre = { x, y, -x, -y };
  const Floats edge = { edgeX, edgeY, -edgeX, -edgeY };
  const Floats turned = { edgeY, -edgeX, -edgeY, edgeX };
  const Floats zero = {};
  const float margin = 1.0f + 4e-6f * (radius + std::abs(x) + std::abs(y));
  // The least x, the least y, and the greatest of both with the other sign.
  const Floats outermost = centre - radius;
  const Floats ends = edge < zero ? edge : zero;
  const Floats least = (cross + turned * radius > -margin * (std::abs(edgeX) + std::abs(edgeY)) ? outermost : ends) - margin;
  const Integers whole = __builtin_convertvector(least, Integers);
  const int shift = this->Points.VoxelShift();
  return { std::max((query.A.X + whole[0] - 1) >> shift, 0), std::max((query.A.Y + whole[1] - 1) >> shift, 0),
    std::min((query.A.X - whole[2] + 1) >> shift, std::int32_t(this->Grid.SizeX() - 1)),
    std::min((query.A.Y - whole[3] + 1) >> shift, std::int32_t(this->Grid.SizeY() - 1)) };
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
  std::call_once(this->PyramidFlag, [this]() { this->Pyramid = std::make_unique<PointPyramid>(this->Points); });
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
void ThirdPointSearch::ScanBox(ThirdPointQuery& query, const VoxelBox& box, float bound) const
{
  for (std::int64_t row = box.FirstY; query.Walk && row <= box.LastY; ++row)
  {
    this->Trace(query, row, box.FirstX, box.LastX);
  }
  BoxScan(this->Points, query, box, bound);
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
