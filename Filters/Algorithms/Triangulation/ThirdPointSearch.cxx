// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The first step that finds a point ends the search:
//  1. Nearby: the segment of a circle through a and b that is to the left of the edge is searched, with a size that the
//     adjacent circumcircle or the spacing of points suggests.
//  2. A candidate in the square box of the edge (5.3.2), then better points in its circle (Delaunay criterion, Alg.
//     5.1). VoxelTraversal searches the cells along the perpendicular bisector, then dilatations, which shift this line
//     to either side along the axis on which it advances less (5.3.6.2); Compactness takes the most compact triangle
//     (eq. 5.9).
//  3. Far: if the box has no point, or is large, boxes of points are searched from near to far (PointPyramid).
//
//          . c .             a-b    edge from a to b
//       .         .          c      candidate
//     .       d     .        d      better point: inside the circle, it sees the edge at a larger angle
//    .               .
//    .               .       All cells that this segment of the circle may touch are searched. The point with the
//    .               .       largest angle is the third point, as its own circle has no point in the
//     a-------------b        segment.
//       .         .
//          . . .
//
//     1 0 1 2 . . .
//     1 0 1 2 . . .        a-b    edge
//     2 1 0 1 2 . .        0      perpendicular bisector
//     2 1 0 1 2 . .        1      first dilatation
//     2 1 0 1 2 . .        2      second dilatation
//     . 2 1 0 1 2 b
//     . 2 1 0 1 2 .
//     a . . . . . .
//
// Points are ranked by the cotangent of the angle at which they see the edge; less is better. A walk lists visited
// cells for display, and omits steps 1 and 3.
//
// With constraints, no boundary edge may cross the segment from the middle of the edge to the point. The middle
// suffices: the third point is visible from the whole edge, and a point of the circle that is visible from the middle
// would be visible from inside the triangle. The best point is first searched without this test, as few edges have a
// boundary edge nearby.

#include "ThirdPointSearch.h"

#include "Common/Base/Portable.h"
#include "Common/Horizon/Predicates.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace SeismicHorizons
{
// ---- The query: which of two points is better, and whether a point is seen ------------------------------------------
namespace
{
// The error of a cotangent, a quotient of two rounded integers, is below three times 2^-53 of its size. InCircle
// decides between closer values.
constexpr double CotangentRounding = 1e-14;

// For shorter segments it is faster to test all cells of their box than to find the cells along them.
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
// A smaller cotangent means a smaller segment of the circle to the left. Half the cotangent times the length of the edge
// is the distance of the centre to the left.
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
// A point behind the end of a boundary edge counts as visible. This is harmless, as the end is nearer, and inside its
// circle.
bool ThirdPointQuery::IsVisible(PointId point) const
{
  const PlanePoint& place = this->Points.At(point);
  const PlanePoint middle = this->DoubledMiddle();
  const std::int64_t fromX = this->Points.CellX(middle.X >> 1);
  const std::int64_t fromY = this->Points.CellY(middle.Y >> 1);
  const std::int64_t toX = this->Points.CellX(place.X);
  const std::int64_t toY = this->Points.CellY(place.Y);
  const std::int64_t steps = std::max(std::abs(toX - fromX), std::abs(toY - fromY));
  if (steps < std::max(this->Points.EdgeDistance(fromX, fromY), this->Points.EdgeDistance(toX, toY)))
  {
    return true;
  }
  const PlanePoint target = Doubled(place);
  const EdgeLists& edges = this->Points.Edges();
  bool visible = true;
  const auto look = [&](std::int64_t cell)
  {
    visible = visible &&
      std::none_of(edges.begin(cell), edges.end(cell),
        [&](const Edge& edge) {
          return ProperlyCross(middle, target, Doubled(this->Points.At(edge.From)), Doubled(this->Points.At(edge.To)));
        });
  };
  if (steps > MostStepsInBox)
  {
    this->Points.Cells().ForEachCellAlong(this->Middle(), place, look);
    return visible;
  }
  for (std::int64_t y = std::min(fromY, toY); y <= std::max(fromY, toY); ++y)
  {
    for (std::int64_t x = std::min(fromX, toX); x <= std::max(fromX, toX); ++x)
    {
      look(this->Points.Cells().Index(x, y));
    }
  }
  return visible;
}

// ---- The scan of a block of cells, four points at a time ----------------------------------------------------------
// Cotangents of four points at a time are computed in single precision. Points within some slack of the least one are
// candidates, mostly one, on a lattice often two, which ThirdPointQuery::Consider compares exactly. The slack must
// exceed rounding.
//
// In a box of size s, with an edge of length e, scalar product and doubled area have an error below r = 48 u s (s + e),
// with u the rounding of 1, and their quotient c below r (1 + |c|) / area: a quarter of the slack for an area of 4 r /
// slack. Points nearer to the line of the edge, mostly its ends alone, are treated separately.
namespace
{
// FloatRounding is 4 * 48 u, rounded up. Slack is absolute, and relative to the size of the cotangent.
constexpr float FloatRounding = 256.0f / 16777216.0f;
constexpr float Slack = 1.0f / 64.0f;

constexpr float UnknownCotangent = 1e30f;

// The margins around the box of a circle are about ten times the rounding error.
constexpr float BoxMargin = 1.0f;
constexpr float BoxMarginPerRadius = 1e-5f;

constexpr float FarOutside = 1073741824.0f; // beyond the grid

void Trace(ThirdPointQuery& query, const CellBox& box)
{
  for (std::int64_t row = box.FirstY; query.Walk && row <= box.LastY; ++row)
  {
    for (std::int64_t column = box.FirstX; column <= box.LastX; ++column)
    {
      query.Walk->push_back({ column, row, query.Dilatation });
    }
  }
}

class BoxScan
{
public:
  BoxScan(ThirdPointQuery& query, const CellBox& box, float bound)
    : Query(query)
    , EdgeX(float(query.B.X - query.A.X))
    , EdgeY(float(query.B.Y - query.A.Y))
    , Bound(bound)
  {
    const float size = float(query.Points.Cells().CellSize()) *
      float(std::int32_t(std::max(box.LastX - box.FirstX, box.LastY - box.FirstY)) + 1);
    this->Near = FloatRounding / Slack * size * (size + std::abs(this->EdgeX) + std::abs(this->EdgeY));
    this->Lowest = FourTimes(query.OnlyVisible || query.Best != NoPoint ? bound : UnknownCotangent);
  }

  /// Returns the number of points near the line. A batch may exceed its row.
  template <bool WithNear>
  int Visit(const CellBox& box)
  {
    const std::int64_t width = this->Query.Points.Cells().SizeX();
    const PointId* starts = this->Query.Points.CellStarts() + box.FirstY * width + box.FirstX;
    PointId batches[Capacity + MostPerRow];
    std::size_t count = 0;
    int near = 0;
    const auto evaluateFull = [&]()
    {
      if (count >= Capacity)
      {
        near += this->Evaluate<WithNear>(batches, Capacity);
        std::copy_n(batches + Capacity, MostPerRow, batches);
        count -= Capacity;
      }
    };
    for (std::int64_t row = box.FirstY; row <= box.LastY; ++row, starts += width)
    {
      PointId first = starts[0];
      const PointId end = starts[box.LastX - box.FirstX + 1];
      for (; end - first > PointId(MostPerRow) * BatchSize; first += BatchSize)
      {
        evaluateFull();
        batches[count++] = first;
      }
      evaluateFull();
      for (std::size_t n = 0; n < MostPerRow; ++n)
      {
        batches[count + n] = first + PointId(n) * BatchSize;
      }
      count += std::size_t(end - first + BatchSize - 1) / BatchSize;
    }
    evaluateFull();
    return near + this->Evaluate<WithNear>(batches, count);
  }

private:
  // Batches are collected before evaluation, without a branch for rows of up to three batches: a mispredicted branch
  // costs as much as a batch.
  static constexpr std::size_t Capacity = 8;
  static constexpr std::size_t MostPerRow = 3;

  /// Cotangents of points not far enough to the left are NaN, which never compare as less.
  template <bool WithNear>
  int Evaluate(const PointId* batches, std::size_t count)
  {
    const PlanePoint& a = this->Query.A;
    const IntegerBatch start = { a.X, a.Y, a.X, a.Y };
    const FloatBatch edgeX = FourTimes(this->EdgeX);
    const FloatBatch edgeY = FourTimes(this->EdgeY);
    const FloatBatch nearArea = FourTimes(this->Near);
    // This is twice the maximum for points whose cotangent is within the bound.
    const FloatBatch nearProduct = nearArea * (2.0f * std::max(1.0f, this->Bound));
    const PlanePoint* const places = &this->Query.Points.At(0);
    FloatBatch cotangents[Capacity];
    FloatBatch lowest = this->Lowest;
    IntegerBatch nearCount = {};
    for (std::size_t n = 0; n < count; ++n)
    {
      IntegerBatch even;
      IntegerBatch odd;
      std::memcpy(&even, places + batches[n], sizeof(even));
      std::memcpy(&odd, places + batches[n] + 2, sizeof(odd));
      const FloatBatch first = ToFloats(even - start);
      const FloatBatch second = ToFloats(odd - start);
      const FloatBatch x = EvenOnes(first, second);
      const FloatBatch y = OddOnes(first, second);
      const FloatBatch area = edgeX * y - edgeY * x;
      const FloatBatch product = x * (x - edgeX) + y * (y - edgeY);
      const IntegerBatch notLeft = area <= nearArea;
      const IntegerBatch near = notLeft & (area >= -nearArea) & (product <= nearProduct);
      nearCount -= near;
      const FloatBatch cotangent = BitsAs<FloatBatch>(BitsAs<IntegerBatch>(product / area) | notLeft);
      lowest = Select(cotangent < lowest, cotangent, lowest);
      cotangents[n] = WithNear ? Select(near, FourTimes(-UnknownCotangent), cotangent) : cotangent;
    }
    this->Lowest = lowest;
    const FloatBatch limit = FourTimes(this->LimitFor(lowest));
    BitBatch bit = { 1, 2, 4, 8 };
    BitBatch marks = {};
    for (std::size_t n = 0; n < count; ++n, bit <<= BatchSize)
    {
      marks |= BitsAs<BitBatch>(cotangents[n] <= limit) & bit;
    }
    for (std::uint32_t left = marks[0] | marks[1] | marks[2] | marks[3]; left != 0; left &= left - 1)
    {
      const int number = LowestBit(left);
      const PointId point = batches[number / BatchSize] + number % BatchSize;
      if (point < this->Query.Points.NumberOfPoints())
      {
        this->Query.Consider(point);
      }
    }
    return nearCount[0] + nearCount[1] + nearCount[2] + nearCount[3];
  }

  float LimitFor(const FloatBatch& lowest) const
  {
    const float least =
      this->Query.OnlyVisible ? this->Bound : std::min(std::min(lowest[0], lowest[1]), std::min(lowest[2], lowest[3]));
    return least + Slack * (1.0f + std::abs(least));
  }

  ThirdPointQuery& Query;
  const float EdgeX;
  const float EdgeY;
  const float Bound;
  float Near;
  FloatBatch Lowest;
};
}

//----------------------------------------------------------------------------------------------------------------------
// The four components are x, y, -x and -y from the start of the edge, each to be minimized: by the circle if its
// extreme place is to the left of the edge, else by an end of the edge.
CellBox CellsOfCircle(const ThirdPointQuery& query, float cotangent, float radius)
{
  const std::int32_t edgeX = query.B.X - query.A.X;
  const std::int32_t edgeY = query.B.Y - query.A.Y;
  const FloatBatch edge = ToFloats(IntegerBatch{ edgeX, edgeY, -edgeX, -edgeY });
  const FloatBatch turned = Rotate(edge);
  const FloatBatch centre = 0.5f * (edge - cotangent * turned);
  const FloatBatch squares = edge * edge;
  const FloatBatch area = turned * radius + 0.5f * cotangent * (squares[0] + squares[1]);
  const float margin = BoxMargin + BoxMarginPerRadius * radius;
  const FloatBatch zero = {};
  const FloatBatch ends = Select(edge < zero, edge, zero);
  const FloatBatch least = Select(area > FourTimes(-4.0f * margin * radius), centre - radius, ends) - margin;
  const IntegerBatch places = ToIntegers(Select(least > FourTimes(-FarOutside), least, FourTimes(-FarOutside)));
  const SearchGrid& points = query.Points;
  // Rounding towards 0 moves a place by less than 1.
  return { points.CellX(query.A.X + places[0] - 1), points.CellY(query.A.Y + places[1] - 1),
    points.CellX(query.A.X - places[2] + 1), points.CellY(query.A.Y - places[3] + 1) };
}

//----------------------------------------------------------------------------------------------------------------------
CellBox CellsOfBest(const ThirdPointQuery& query)
{
  const float cotangent = float(query.BestCotangent);
  return CellsOfCircle(
    query, cotangent, 0.5f * std::sqrt((1.0f + cotangent * cotangent) * float(query.SquaredLength())));
}

//----------------------------------------------------------------------------------------------------------------------
void ScanBox(ThirdPointQuery& query, const CellBox& box, float bound)
{
  constexpr int ends = 2;
  Trace(query, box);
  BoxScan scan(query, box, bound);
  if (scan.Visit<false>(box) > ends)
  {
    scan.Visit<true>(box);
  }
}

// ---- Candidates in the box of an edge -------------------------------------------------------------------------------
namespace
{
struct EdgeBox
{
  explicit EdgeBox(const ThirdPointQuery& query)
    : Grid(query.Points.Cells())
    , MiddleX(this->Grid.InCellsX(query.Middle().X))
    , MiddleY(this->Grid.InCellsY(query.Middle().Y))
    , Size(std::max({ std::int64_t(1), std::abs(this->Grid.CellX(query.A.X) - this->Grid.CellX(query.B.X)),
        std::abs(this->Grid.CellY(query.A.Y) - this->Grid.CellY(query.B.Y)) }))
  {
  }

  CellBox Around(std::int64_t radius) const
  {
    const std::int64_t x = std::int64_t(this->MiddleX);
    const std::int64_t y = std::int64_t(this->MiddleY);
    return { std::max<std::int64_t>(x - radius, 0), std::max<std::int64_t>(y - radius, 0),
      std::min(x + radius, this->Grid.SizeX() - 1), std::min(y + radius, this->Grid.SizeY() - 1) };
  }

  const CellGrid& Grid;
  const double MiddleX;
  const double MiddleY;
  const std::int64_t Size; // k of the thesis
};

/// Search cells along a ray (Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", 1987): the ray
/// continues into the cell behind the nearer one of its next borders across x and y. (Thesis Alg. 5.2 advances along
/// both axes at once.)
class CellWalk
{
public:
  CellWalk(double x, double y, double directionX, double directionY)
    : AlongX(x, directionX)
    , AlongY(y, directionY)
  {
  }

  std::int64_t X() const { return this->AlongX.Cell; }
  std::int64_t Y() const { return this->AlongY.Cell; }

  void Next()
  {
    Axis& nearest = this->AlongX.NextBorder < this->AlongY.NextBorder ? this->AlongX : this->AlongY;
    nearest.Cell += nearest.Step;
    nearest.NextBorder += nearest.BorderDistance;
  }

private:
  struct Axis
  {
    Axis(double start, double direction)
      : Cell(std::int64_t(start))
      , Step(direction < 0.0 ? -1 : 1)
    {
      if (direction != 0.0)
      {
        const double border = double(this->Cell) + (direction < 0.0 ? 0.0 : 1.0);
        this->NextBorder = (border - start) / direction;
        this->BorderDistance = 1.0 / std::abs(direction);
      }
    }

    std::int64_t Cell;
    std::int64_t Step;
    double NextBorder = std::numeric_limits<double>::infinity(); // in lengths of the direction
    double BorderDistance = std::numeric_limits<double>::infinity();
  };

  Axis AlongX;
  Axis AlongY;
};

template <typename Visitor>
void VisitBox(ThirdPointQuery& query, const CellBox& box, Visitor&& visit)
{
  Trace(query, box);
  const CellGrid& grid = query.Points.Cells();
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    const PointId end = query.Points.EndOf(grid.Index(box.LastX, row));
    for (PointId point = query.Points.FirstIn(grid.Index(box.FirstX, row)); point < end; ++point)
    {
      visit(point);
    }
  }
}

void ConsiderBox(ThirdPointQuery& query, const CellBox& box)
{
  VisitBox(query, box, [&query](PointId point) { query.Consider(point); });
}

void SearchDilatation(ThirdPointQuery& query, const EdgeBox& edgeBox, std::int64_t shift)
{
  const double x = double(query.A.Y) - query.B.Y;
  const double y = double(query.B.X) - query.A.X;
  const std::int64_t shiftX = std::abs(x) < std::abs(y) ? shift : 0;
  const std::int64_t shiftY = shift - shiftX;
  CellWalk walk(edgeBox.MiddleX, edgeBox.MiddleY, x, y);
  const std::int64_t startX = walk.X();
  const std::int64_t startY = walk.Y();
  for (; std::max(std::abs(walk.X() - startX), std::abs(walk.Y() - startY)) <= edgeBox.Size; walk.Next())
  {
    const std::int64_t cellX = walk.X() + shiftX;
    const std::int64_t cellY = walk.Y() + shiftY;
    if (cellX >= 0 && cellX < edgeBox.Grid.SizeX() && cellY >= 0 && cellY < edgeBox.Grid.SizeY())
    {
      ConsiderBox(query, { cellX, cellY, cellX, cellY });
    }
  }
}

void TraverseBox(ThirdPointQuery& query, const EdgeBox& edgeBox)
{
  for (int dilatation = 0; query.Best == NoPoint && dilatation <= edgeBox.Size; ++dilatation)
  {
    query.Dilatation = dilatation;
    SearchDilatation(query, edgeBox, dilatation);
    if (dilatation > 0)
    {
      SearchDilatation(query, edgeBox, -dilatation);
    }
  }
  query.Dilatation = -1;
}

/// This is C of the thesis (eq. 5.9) without the factor 4 sqrt(3) / 2; `area` is doubled.
double Compactness(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, std::int64_t area)
{
  return double(area) / (double(SquaredDistance(a, b)) + double(SquaredDistance(b, c)) + double(SquaredDistance(c, a)));
}

void CompareBox(ThirdPointQuery& query, const EdgeBox& edgeBox)
{
  double most = 0.0;
  VisitBox(query, edgeBox.Around(edgeBox.Size),
    [&](PointId point)
    {
      const PlanePoint& place = query.Points.At(point);
      const std::int64_t area = SignedArea(query.A, query.B, place);
      const double compactness = Compactness(query.A, query.B, place, area);
      if (compactness > most && (!query.OnlyVisible || query.IsVisible(point)))
      {
        most = compactness;
        query.Take(point, area);
      }
    });
}

void SearchSquares(ThirdPointQuery& query, const EdgeBox& edgeBox)
{
  const std::int64_t everything = std::max(edgeBox.Grid.SizeX(), edgeBox.Grid.SizeY());
  for (std::int64_t radius = edgeBox.Size; query.Best == NoPoint && radius < 2 * everything; radius = 2 * radius + 1)
  {
    ConsiderBox(query, edgeBox.Around(radius));
  }
}
}

// ---- The search -----------------------------------------------------------------------------------------------------
namespace
{
// Heights of the first circle segment: in diameters of the adjacent circumcircle, or else in spacings, with a limit.
// Larger segments have needless points, smaller segments too often none.
constexpr float HeightPerNeighbor = 1.15f;
constexpr float HeightPerSpacing = 1.3f;
constexpr float MostHeightPerSpacing = 4.0f;

// A cotangent smaller by this fraction is certainly inside the circle.
constexpr float CotangentMargin = 1e-5f;

// This is in search cells; boxes around long oblique edges have many points.
constexpr std::int64_t LongestNearby = 16;

// This is in search cells; for longer edges, which are rare, SearchFar is faster.
constexpr std::int64_t LargestBoxToTraverse = 8;

// Centre and radius have a relative error of some 10^-16, and coordinates below 2^30 an error of 10^-6. Points farther
// outside than these margins are certainly outside.
constexpr double CircleMargin = 1e-6;
constexpr double CircleMarginPerRadius = 1e-12;

/// Points on this circle to the left see the edge at an angle with the cotangent. Coordinates are relative to its start.
struct EdgeCircle
{
  EdgeCircle(const ThirdPointQuery& query, double cotangent)
    : Start(query.A)
    , EdgeX(double(query.B.X) - query.A.X)
    , EdgeY(double(query.B.Y) - query.A.Y)
    , X(0.5 * (this->EdgeX - this->EdgeY * cotangent))
    , Y(0.5 * (this->EdgeY + this->EdgeX * cotangent))
  {
    const double radius = 0.5 * std::sqrt((1.0 + cotangent * cotangent) * query.SquaredLength());
    const double reach = radius + CircleMargin + CircleMarginPerRadius * radius;
    this->SquaredReach = reach * reach;
  }

  /// Returns false only if the point is certainly outside or to the right. There are no branches, since they would be
  /// unpredictable.
  bool MayHold(const PlanePoint& point) const
  {
    const double x = double(point.X - this->Start.X);
    const double y = double(point.Y - this->Start.Y);
    const double fromX = x - this->X;
    const double fromY = y - this->Y;
    // Rounding preserves the order of these products, or makes them equal.
    return (fromX * fromX + fromY * fromY <= this->SquaredReach) & (this->EdgeX * y >= this->EdgeY * x);
  }

  /// Returns false only if no place of the box is inside, on either side of the edge.
  bool MayReach(const PlaneBox& box) const
  {
    return SquaredDistanceToBox({ this->X + this->Start.X, this->Y + this->Start.Y }, box) <= this->SquaredReach;
  }

  PlanePoint Start;
  double EdgeX;
  double EdgeY;
  double X;
  double Y;
  double SquaredReach;
};
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPointSearch::ThirdPointSearch(const SearchGrid& points, SearchStrategy strategy)
  : Strategy(strategy)
  , Points(points)
  , UsualHeight(HeightPerSpacing * float(points.Spacing()))
  , GreatestHeight(MostHeightPerSpacing * float(points.Spacing()))
{
}

//----------------------------------------------------------------------------------------------------------------------
ThirdPoint ThirdPointSearch::Find(PointId a, PointId b, float neighbor, std::vector<WalkedCell>* walk) const
{
  assert(a != b);
  ThirdPointQuery query(this->Points, a, b, walk);
  const float height =
    neighbor > 0.0f ? std::min(HeightPerNeighbor * neighbor, this->GreatestHeight) : this->UsualHeight;
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
// The circle through the best point on the left has the least segment on the right, which must be empty, too. From the
// right the cotangent changes sign.
bool ThirdPointSearch::IsDelaunay(PointId a, PointId b) const
{
  ThirdPointQuery left(this->Points, a, b, nullptr);
  this->Search(left, this->UsualHeight);
  assert(left.Best != NoPoint);
  ThirdPointQuery right(this->Points, b, a, nullptr);
  right.BestCotangent = -left.BestCotangent;
  const EdgeCircle circle(right, right.BestCotangent);
  const PlanePoint& best = this->Points.At(left.Best);
  const CellBox box = CellsOfBest(right);
  bool empty = true;
  for (std::int64_t row = box.FirstY; empty && row <= box.LastY; ++row)
  {
    VisitBox(right, { box.FirstX, row, box.LastX, row },
      [&](PointId point)
      {
        const PlanePoint& place = this->Points.At(point);
        empty = empty &&
          (!circle.MayHold(place) || SignedArea(right.A, right.B, place) <= 0 ||
            InCircle(left.A, left.B, best, place) <= 0);
      });
  }
  return empty;
}

//----------------------------------------------------------------------------------------------------------------------
void ThirdPointSearch::Search(ThirdPointQuery& query, float height) const
{
  const bool isTraced = query.Walk != nullptr;
  const std::int64_t cellSize = this->Points.Cells().CellSize();
  if (!isTraced)
  {
    const std::int64_t extent = std::max(std::abs(query.A.X - query.B.X), std::abs(query.A.Y - query.B.Y));
    if (this->Strategy == SearchStrategy::VoxelTraversal && extent < LongestNearby * cellSize &&
      this->SearchNearby(query, height))
    {
      return;
    }
    if (extent >= LargestBoxToTraverse * cellSize)
    {
      this->SearchFar(query);
      return;
    }
  }
  const EdgeBox edgeBox(query);
  if (this->Strategy == SearchStrategy::Compactness)
  {
    CompareBox(query, edgeBox);
  }
  else
  {
    TraverseBox(query, edgeBox);
  }
  if (query.Best == NoPoint && !isTraced)
  {
    this->SearchFar(query);
    return;
  }
  if (query.Best == NoPoint)
  {
    SearchSquares(query, edgeBox);
  }
  if (query.Best != NoPoint)
  {
    ScanBox(query, CellsOfBest(query), float(query.BestCotangent));
  }
}

//----------------------------------------------------------------------------------------------------------------------
// The search covers the segment of the given height of a circle through the ends of the edge:
//
//          . * .         -
//       .         .      | height     The centre is (height - rest) / 2 to the left of the edge, and the radius is
//      a-----------b     -            (height + rest) / 2, where rest is the height of the other part of the circle.
//       .         .      | rest
//          . . .         -
//
// If the segment is empty, but other points are near, the circle of the best one is searched if its height is at most
// twice as large; otherwise this height is tried next.
bool ThirdPointSearch::SearchNearby(ThirdPointQuery& query, float height) const
{
  const float squaredLength = float(query.SquaredLength());
  const float perLength = 1.0f / std::sqrt(squaredLength);
  for (; height <= this->GreatestHeight; height *= 2.0f)
  {
    const float rest = 0.25f * squaredLength / height;
    const float cotangent = (height - rest) * perLength;
    const float cotangentOfTwice = (2.0f * height - 0.5f * rest) * perLength;
    ScanBox(query, CellsOfCircle(query, cotangent, 0.5f * (height + rest)), cotangent);
    if (query.Best != NoPoint && query.BestCotangent <= cotangentOfTwice)
    {
      if (query.BestCotangent >= cotangent - CotangentMargin * std::abs(cotangent))
      {
        ScanBox(query, CellsOfBest(query), float(query.BestCotangent));
      }
      return true;
    }
    query.Best = NoPoint;
  }
  return false;
}

//----------------------------------------------------------------------------------------------------------------------
// A box may hold a better point if a corner is to the left of the edge, and it reaches into the circle of the best
// point. Near boxes come first, as better points shrink that circle.
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
}
