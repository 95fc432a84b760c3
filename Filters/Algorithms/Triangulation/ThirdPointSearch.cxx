// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ThirdPointSearch.h"

#include "Common/PlaneGeometry.h"
#include "Common/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// The first circle that is looked into: its diameter when points are one apart on average, and the least one for an
// edge of length 1. Larger circles have more points than needed, smaller ones too often none.
constexpr double NearbyDiameter = 1.5;
constexpr double LeastDiameter = 1.1;

// A cotangent is a quotient of two whole numbers that are rounded to doubles: right to three times 2^-53 of its size.
// For points whose cotangents are closer to each other than this part, InCircle decides.
constexpr double CotangentRounding = 1e-14;

// A point whose cotangent is smaller by this part than that of a circle is inside the circle for certain, and not in
// its margin.
constexpr double CotangentMargin = 1e-12;

// In voxels. Shorter edges are most; beyond, going through the box of an edge takes longer than SearchFar.
constexpr std::int64_t LargestBoxToTraverse = 8;

PlanePoint Doubled(const PlanePoint& p)
{
  return { 2 * p.X, 2 * p.Y };
}

}

//----------------------------------------------------------------------------------------------------------------------
PointId ThirdPointSearch::Find(PointId a, PointId b, std::vector<WalkedVoxel>* walk) const
{
  ThirdPointQuery query(this->Points, a, b, walk);
  this->Search(query);
  if (query.Best != NoPoint && !this->IsVisible(query, query.Best))
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
      this->Consider(query, inside[n]);
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
void ThirdPointSearch::Trace(ThirdPointQuery& query, std::int64_t row, std::int64_t first, std::int64_t last) const
{
  for (std::int64_t column = first; query.Walk && column <= last; ++column)
  {
    query.Walk->push_back({ column, row, query.Dilatation });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::Consider(ThirdPointQuery& query, PointId candidate) const
{
  const PlanePoint& place = this->At(candidate);
  const std::int64_t area = SignedArea(query.A, query.B, place);
  if (area <= 0)
  {
    return;
  }
  const double cotangent = Cotangent(query.A, query.B, place, area);
  if (this->IsBetter(query, candidate, cotangent) && (!query.OnlyVisible || this->IsVisible(query, candidate)))
  {
    query.Best = candidate;
    query.BestCotangent = cotangent;
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool ThirdPointSearch::IsBetter(const ThirdPointQuery& query, PointId candidate, double cotangent) const
{
  if (query.Best == NoPoint)
  {
    return true;
  }
  const double difference = cotangent - query.BestCotangent;
  const double uncertain = CotangentRounding * (std::abs(cotangent) + std::abs(query.BestCotangent));
  if (std::abs(difference) > uncertain)
  {
    return difference < 0.0;
  }
  return candidate != query.Best && InCircle(query.A, query.B, this->At(query.Best), this->At(candidate)) > 0;
}

//----------------------------------------------------------------------------------------------------------------------
// Whether a segment leads as many voxels away from its start as the nearest boundary edge is.
bool ThirdPointSearch::MayMeetEdges(const SegmentEnd& from, const SegmentEnd& to) const
{
  const std::int64_t x = this->Grid.CellX(from.X);
  const std::int64_t y = this->Grid.CellY(from.Y);
  return std::max(std::abs(this->Grid.CellX(to.X) - x), std::abs(this->Grid.CellY(to.Y) - y)) >=
    this->Points.EdgeDistance(x, y);
}

//----------------------------------------------------------------------------------------------------------------------
// A segment that runs through the end of a boundary edge does not cross it, and the point behind counts as visible.
// That does no harm: the end of the edge is nearer, and lies inside the circle of the point behind it.
bool ThirdPointSearch::IsVisible(const ThirdPointQuery& query, PointId candidate) const
{
  const SegmentEnd middle = query.Middle();
  if (!this->MayMeetEdges(middle, this->At(candidate)))
  {
    return true;
  }
  const PlanePoint target = Doubled(this->At(candidate));
  bool visible = true;
  const auto blocks = [&](const Edge& edge)
  { return ProperlyCross(Doubled(this->At(edge.From)), Doubled(this->At(edge.To)), query.DoubledMiddle(), target); };
  this->Grid.ForEachCellAlong(middle, this->At(candidate),
    [&](std::int64_t cell)
    { visible = visible && std::none_of(this->Points.Edges().begin(cell), this->Points.Edges().end(cell), blocks); });
  return visible;
}
}
