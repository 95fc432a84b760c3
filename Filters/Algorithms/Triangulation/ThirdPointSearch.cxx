// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointSearch.h"

#include "BoxScan.h"
#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"
#include "VoxelWalk.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// How high the part of a circle is that is looked into first: in diameters of the circle of the triangle on the other
// side of the edge, or where there is none in distances between points, as at most. Larger ones have more points than
// needed, smaller ones too often none.
constexpr float HeightPerNeighbor = 1.15f;
constexpr float HeightPerSpacing = 1.3f;
constexpr float MostHeightPerSpacing = 4.0f;

// A point whose cotangent is smaller by this part than that of a circle is inside the circle for certain.
constexpr float CotangentMargin = 1e-5f;

// The longest edge, in voxels, that is looked at in this way: a box around a long slanted one has many points.
constexpr std::int64_t LongestNearby = 16;

// The longest edge, in voxels, whose box is searched. Most edges are shorter; for a longer one SearchFar is quicker.
constexpr std::int64_t LargestBoxToTraverse = 8;

/// The thesis's C (eq. 5.9) without its factor, 4 sqrt(3) / 2: `area` is twice that of the triangle.
double Compactness(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, std::int64_t area)
{
  return double(area) / (double(SquaredDistance(a, b)) + double(SquaredDistance(b, c)) + double(SquaredDistance(c, a)));
}
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPointSearch::ThirdPointSearch(const SearchGrid& grid, SearchStrategy strategy)
  : Strategy(strategy)
  , Points(grid)
  , Grid(grid.Voxels())
  , UsualHeight(HeightPerSpacing * float(grid.Spacing()))
  , GreatestHeight(MostHeightPerSpacing * float(grid.Spacing()))
{
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPoint ThirdPointSearch::Find(PointId a, PointId b, float neighbor, std::vector<WalkedVoxel>* walk) const
{
  ThirdPointQuery query(this->Points, a, b, walk);
  const float height = this->FirstHeight(neighbor);
  this->Search(query, height);
  if (query.Best != NoPoint && !query.IsVisible(query.Best))
  {
    query.OnlyVisible = true;
    query.Best = NoPoint;
    this->Search(query, height);
  }
  const double cotangent = query.BestCotangent;
  return { query.Best, std::sqrt(float((1.0 + cotangent * cotangent) * query.SquaredLength())) };
}

//----------------------------------------------------------------------------------------------------------------------
// The circle through the best point to the left has no point in its left part, and of all such circles the smallest
// right part. So the edge is Delaunay when that part has no point either. Seen from the right the edge is reversed, and
// the cotangent of the circle has the other sign.
bool ThirdPointSearch::IsDelaunay(PointId a, PointId b) const
{
  ThirdPointQuery left(this->Points, a, b, nullptr);
  this->Search(left, this->UsualHeight);
  ThirdPointQuery right(this->Points, b, a, nullptr);
  right.BestCotangent = -left.BestCotangent;
  const EdgeCircle circle(right, right.BestCotangent);
  const VoxelBox box = VoxelsOfBest(right);
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
void ThirdPointSearch::Search(ThirdPointQuery& query, float height) const
{
  const bool isTraced = query.Walk != nullptr;
  if (!isTraced)
  {
    const std::int64_t extent = std::max(std::abs(query.A.X - query.B.X), std::abs(query.A.Y - query.B.Y));
    if (this->Strategy == SearchStrategy::VoxelTraversal && extent < LongestNearby * this->Grid.CellSize() &&
      this->SearchNearby(query, height))
    {
      return;
    }
    if (extent >= LargestBoxToTraverse * this->Grid.CellSize())
    {
      this->SearchFar(query);
      return;
    }
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
    this->ScanBox(query, VoxelsOfBest(query), float(query.BestCotangent));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The third point is looked for in the part of a circle through the ends of the edge that is to its left and so high:
//
//          . * .         -
//       .         .      | height     The centre is (height - rest) / 2 to the left of the edge, and the radius is
//      a-----------b     -            (height + rest) / 2, where rest is the height of the other part of the circle.
//       .         .      | rest
//          . . .         -
//
// When that part has points, the third point is one of them. When it has none, but others are near, the circle of the
// best of these is searched, as long as it is not higher than twice as much; else that height is the next to be tried.
bool ThirdPointSearch::SearchNearby(ThirdPointQuery& query, float height) const
{
  const float squaredLength = float(query.SquaredLength());
  const float perLength = 1.0f / std::sqrt(squaredLength);
  for (; height <= this->GreatestHeight; height *= 2.0f)
  {
    const float rest = 0.25f * squaredLength / height;
    const float cotangent = (height - rest) * perLength;
    const float cotangentOfTwice = (2.0f * height - 0.5f * rest) * perLength;
    this->ScanBox(query, VoxelsOfCircle(query, cotangent, 0.5f * (height + rest)), cotangent);
    if (query.Best != NoPoint && query.BestCotangent <= cotangentOfTwice)
    {
      if (query.BestCotangent >= cotangent - CotangentMargin * std::abs(cotangent))
      {
        this->ScanBox(query, VoxelsOfBest(query), float(query.BestCotangent));
      }
      return true;
    }
    query.Best = NoPoint;
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// As high as the neighbour suggests, or as points are apart.
float ThirdPointSearch::FirstHeight(float neighbor) const
{
  return neighbor > 0.0f ? std::min(HeightPerNeighbor * neighbor, this->GreatestHeight) : this->UsualHeight;
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
void ThirdPointSearch::ScanBox(ThirdPointQuery& query, const VoxelBox& box, float bound) const
{
  for (std::int64_t row = box.FirstY; query.Walk && row <= box.LastY; ++row)
  {
    this->Trace(query, row, box.FirstX, box.LastX);
  }
  BoxScan::Run(query, box, bound);
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
