// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// For each edge, the first of these that finds a point ends the search; points are looked up in a grid of square voxels
// with about one point each:
//
// 1. Nearby. Most often the point is in the voxel beside the edge. So a circle through a and b is searched, the part of
//    it to the left of the edge: one as large as the circle of the triangle on the other side of the edge suggests,
//    which is empty, or little higher than points are apart. When it has points, the third point is one of them.
//
// 2. A candidate in the square box of the edge (5.3.2), which is as far around its middle as the edge is long. It is
//    found by one of two strategies, and then better points in the circle through the candidate and the edge (the
//    Delaunay criterion, Alg. 5.1), so that both strategies end with the same point:
//
//           . c .             a-b    the edge, from a to b
//        .         .          c      the candidate
//      .       d     .        d      a better point: inside the circle, from where the edge is seen at a larger angle
//     .               .              than from c
//     .               .
//     .               .       Searched are the voxels that the part of the circle to the left of the edge may touch. Of
//      a-------------b        the points in it, that which sees the edge at the largest angle is the third point: its
//        .         .          own circle has none in the part to the left.
//           . . .
//
//    VoxelTraversal looks into the voxels along the perpendicular bisector, from the middle of the edge, and then into
//    those of its dilatations, until it finds a point. The n-th dilatation is the bisector's line of voxels moved by n
//    to either side, along the axis on which the line advances less (5.3.6.2):
//
//      1 0 1 2 . . .
//      1 0 1 2 . . .        a-b    the edge, from a to b: its left is above
//      2 1 0 1 2 . .        0      the perpendicular bisector
//      2 1 0 1 2 . .        1      the first dilatation, both lines of it
//      2 1 0 1 2 . .        2      the second one
//      . 2 1 0 1 2 b
//      . 2 1 0 1 2 .
//      a . . . . . .
//
//    Compactness takes that point of the box which makes the most compact triangle (eq. 5.9).
//
// 3. Far. When the box has no point, or is so large that going through it takes long, boxes of points are searched
//    (PointPyramid), from near to far.
//
// Words: the cotangent of a point is that of the angle at which it sees the edge. The smaller it is, the better the
// point. The query is the edge with the best point so far. A walk is the list of voxels that were looked into, for
// users who want to see the search; then the search is the thesis's alone, without 1 and 3.
//
// With constraints, a point counts only when the segment from the middle of the edge to it crosses no boundary edge.
// Looking from the middle is enough, which may surprise: the third point is seen from every place on the edge, and a
// point of the circle that is seen from the middle would be seen from inside the triangle as well, which a constrained
// Delaunay triangle excludes. As few edges have a boundary edge near, the best of all points is looked for first, seen
// or not; if it is seen, it is the third point.

#include "ThirdPointSearch.h"

#include "Common/Portable.h"
#include "Common/Predicates.h"

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

// ---- The scan of a block of voxels, four points at a time ----------------------------------------------------------
// Of the points to the left of the edge, that with the least cotangent is looked for. Cotangents are calculated in
// single precision for all points. Those that exceed the least one by no more than some slack are candidates: most
// often one, on a lattice often two. ThirdPointQuery::Consider compares candidates exactly. So all that matters is that
// the slack is larger than rounding.
//
// It is for points that are far enough from the line through the edge. In a box of size s, with an edge of length e,
// the scalar product and the doubled area of a point are right to r = 48 u s (s + e), where u is the rounding of a
// number of size 1. So their quotient c is right to r (1 + |c|) / area: for an area of 4 r / slack, to a quarter of the
// slack. Points that are nearer to the line are candidates as well, if they may be better than the caller asks for.
// Mostly these are the ends of the edge alone; then they are left out.
namespace
{
// 4 * 48 u, rounded up, and how much more than the least cotangent that of a candidate may be: so much of one more than
// its size.
constexpr float Rounding = 256.0f / 16777216.0f;
constexpr float Slack = 1.0f / 64.0f;

// Greater than the cotangents of all points in question.
constexpr float Unknown = 1e30f;

// The box around a circle is wider by this, and by so much of the radius: some ten times what rounding takes off.
constexpr float BoxMargin = 1.0f;
constexpr float BoxMarginPerRadius = 1e-5f;

// Farther than the grid is wide. Sums of it and coordinates fit 32 bits.
constexpr float FarOutside = 1073741824.0f;

/// Adds the voxels of a box to the walk.
void Trace(ThirdPointQuery& query, const VoxelBox& box)
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
  BoxScan(ThirdPointQuery& query, const VoxelBox& box, float bound)
    : Query(query)
    , EdgeX(float(query.B.X - query.A.X))
    , EdgeY(float(query.B.Y - query.A.Y))
    , Bound(bound)
  {
    const float size = float(query.Points.Voxels().CellSize()) *
      float(std::int32_t(std::max(box.LastX - box.FirstX, box.LastY - box.FirstY)) + 1);
    this->Near = Rounding / Slack * size * (size + std::abs(this->EdgeX) + std::abs(this->EdgeY));
    this->Lowest = FourTimes(query.OnlyVisible || query.Best != NoPoint ? bound : Unknown);
  }

  /// Gives how many points are near the line through the edge. A batch may have points more than the row has: they do
  /// no harm.
  template <bool WithNear>
  int Visit(const VoxelBox& box)
  {
    const std::int64_t width = this->Query.Points.Voxels().SizeX();
    const PointId* starts = this->Query.Points.VoxelStarts() + box.FirstY * width + box.FirstX;
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
  // So many batches are evaluated at a time. They are listed first, without a branch on how many a row has where it has
  // no more than three: a branch that a processor predicts wrongly takes it as long as a batch.
  static constexpr std::size_t Capacity = 8;
  static constexpr std::size_t MostPerRow = 3;

  /// Of batches by their first points. Cotangents of points that are not far enough to the left are not numbers, and so
  /// never less than another one.
  template <bool WithNear>
  int Evaluate(const PointId* batches, std::size_t count)
  {
    const PlanePoint& a = this->Query.A;
    const IntegerBatch start = { a.X, a.Y, a.X, a.Y };
    const FloatBatch edgeX = FourTimes(this->EdgeX);
    const FloatBatch edgeY = FourTimes(this->EdgeY);
    const FloatBatch nearArea = FourTimes(this->Near);
    // Twice as much as such a point can have whose cotangent is up to the bound.
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
      cotangents[n] = WithNear ? Select(near, FourTimes(-Unknown), cotangent) : cotangent;
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

  /// The greatest cotangent of a candidate, for the lowest so far.
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
  float Near; // the doubled area of a triangle whose third point is near the line through the edge
  FloatBatch Lowest; // of the cotangents so far
};
}

//----------------------------------------------------------------------------------------------------------------------
// From the start of the edge, four numbers stand for x and y, and for both with the other sign: of all four the least
// is looked for. It is that of the circle where that place of the circle is to the left of the edge, else that of an
// end of the edge.
VoxelBox VoxelsOfCircle(const ThirdPointQuery& query, float cotangent, float radius)
{
  const std::int32_t edgeX = query.B.X - query.A.X;
  const std::int32_t edgeY = query.B.Y - query.A.Y;
  const FloatBatch edge = ToFloats(IntegerBatch{ edgeX, edgeY, -edgeX, -edgeY });
  const FloatBatch turned = Rotate(edge);
  const FloatBatch centre = 0.5f * (edge - cotangent * turned);
  const FloatBatch squares = edge * edge;
  // Of the edge and the way from its start to the place: positive when that is to the left.
  const FloatBatch area = turned * radius + 0.5f * cotangent * (squares[0] + squares[1]);
  const float margin = BoxMargin + BoxMarginPerRadius * radius;
  const FloatBatch zero = {};
  const FloatBatch ends = Select(edge < zero, edge, zero);
  const FloatBatch least = Select(area > FourTimes(-4.0f * margin * radius), centre - radius, ends) - margin;
  const IntegerBatch places = ToIntegers(Select(least > FourTimes(-FarOutside), least, FourTimes(-FarOutside)));
  const SearchGrid& points = query.Points;
  // Rounded towards 0, a place moves by less than 1.
  return { points.VoxelX(query.A.X + places[0] - 1), points.VoxelY(query.A.Y + places[1] - 1),
    points.VoxelX(query.A.X - places[2] + 1), points.VoxelY(query.A.Y - places[3] + 1) };
}

//----------------------------------------------------------------------------------------------------------------------
VoxelBox VoxelsOfBest(const ThirdPointQuery& query)
{
  const float cotangent = float(query.BestCotangent);
  return VoxelsOfCircle(
    query, cotangent, 0.5f * std::sqrt((1.0f + cotangent * cotangent) * float(query.SquaredLength())));
}

//----------------------------------------------------------------------------------------------------------------------
void ScanBox(ThirdPointQuery& query, const VoxelBox& box, float bound)
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
/// The square box of an edge (thesis 5.3.2), in voxels: as far around its middle as it is long.
struct EdgeBox
{
  explicit EdgeBox(const ThirdPointQuery& query)
    : Grid(query.Points.Voxels())
    , MiddleX(this->Grid.InCellsX(query.Middle().X))
    , MiddleY(this->Grid.InCellsY(query.Middle().Y))
    , Size(std::max({ std::int64_t(1), std::abs(this->Grid.CellX(query.A.X) - this->Grid.CellX(query.B.X)),
        std::abs(this->Grid.CellY(query.A.Y) - this->Grid.CellY(query.B.Y)) }))
  {
  }

  /// As far around the middle as that, or as the grid.
  VoxelBox Around(std::int64_t radius) const
  {
    const std::int64_t x = std::int64_t(this->MiddleX);
    const std::int64_t y = std::int64_t(this->MiddleY);
    return { std::max<std::int64_t>(x - radius, 0), std::max<std::int64_t>(y - radius, 0),
      std::min(x + radius, this->Grid.SizeX() - 1), std::min(y + radius, this->Grid.SizeY() - 1) };
  }

  const CellGrid& Grid;
  const double MiddleX;
  const double MiddleY;
  const std::int64_t Size; // the longer one of the edge's two extents: the thesis's k
};

/// The voxels that a ray passes through, one after the other (Amanatides and Woo, "A fast voxel traversal algorithm for
/// ray tracing", 1987). At each step two borders are ahead of the ray, one across x and one across y. It continues into
/// the voxel behind the one that it meets first. (Thesis Alg. 5.2 advances along both axes at once.)
///
///      +-------+-------+-------+
///      |       |       | 4   / |        The ray starts at *, in voxel 0. It meets the border to the right of that
///      +-------+-------+---/---+        voxel before the one above, and continues into voxel 1. Of voxel 1 it meets
///      |       |       | / 3   |        the border above first, and continues into voxel 2.
///      |       | 2     /       |
///      |       |     / |       |
///      +-------+---/---+-------+
///      |       | / 1   |       |
///      | 0     /       |       |
///      |     * |       |       |
///      +-------+-------+-------+
class VoxelWalk
{
public:
  /// Starts at a place, in units of voxels and not below 0. The direction must not be zero.
  VoxelWalk(double x, double y, double directionX, double directionY)
    : AlongX(x, directionX)
    , AlongY(y, directionY)
  {
  }

  /// The voxel in which the walk is.
  std::int64_t X() const { return this->AlongX.Voxel; }
  std::int64_t Y() const { return this->AlongY.Voxel; }

  void Next()
  {
    Axis& nearest = this->AlongX.NextBorder < this->AlongY.NextBorder ? this->AlongX : this->AlongY;
    nearest.Voxel += nearest.Step;
    nearest.NextBorder += nearest.BorderDistance;
  }

private:
  struct Axis
  {
    Axis(double start, double direction)
      : Voxel(std::int64_t(start))
      , Step(direction < 0.0 ? -1 : 1)
    {
      if (direction != 0.0)
      {
        const double border = double(this->Voxel) + (direction < 0.0 ? 0.0 : 1.0);
        this->NextBorder = (border - start) / direction;
        this->BorderDistance = 1.0 / std::abs(direction);
      }
    }

    std::int64_t Voxel;
    std::int64_t Step;
    // How far the next border is along the ray, and how far apart borders are, in units of the direction's length.
    double NextBorder = std::numeric_limits<double>::infinity();
    double BorderDistance = std::numeric_limits<double>::infinity();
  };

  Axis AlongX;
  Axis AlongY;
};

/// Calls visit(point) for the points of a box. Those in a row of voxels are in one range.
template <typename Visitor>
void VisitBox(ThirdPointQuery& query, const VoxelBox& box, Visitor&& visit)
{
  Trace(query, box);
  const CellGrid& grid = query.Points.Voxels();
  for (std::int64_t row = box.FirstY; row <= box.LastY; ++row)
  {
    const PointId end = query.Points.EndOf(grid.Index(box.LastX, row));
    for (PointId point = query.Points.FirstIn(grid.Index(box.FirstX, row)); point < end; ++point)
    {
      visit(point);
    }
  }
}

void ConsiderBox(ThirdPointQuery& query, const VoxelBox& box)
{
  VisitBox(query, box, [&query](PointId point) { query.Consider(point); });
}

/// One line of a dilatation: the bisector's line of voxels, moved along the axis on which it advances less.
void SearchDilatation(ThirdPointQuery& query, const EdgeBox& edgeBox, std::int64_t shift)
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
    if (cellX >= 0 && cellX < edgeBox.Grid.SizeX() && cellY >= 0 && cellY < edgeBox.Grid.SizeY())
    {
      ConsiderBox(query, { cellX, cellY, cellX, cellY });
    }
  }
}

/// The bisector, then one line of voxels more on either side of it at a time, as far as the box reaches.
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

/// The thesis's C (eq. 5.9) without its factor, 4 sqrt(3) / 2: `area` is twice that of the triangle.
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

/// Around a box without a point, for a search that is to be shown.
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

// The centre and the radius of a circle are right to some units in the last place, 10^-16 of their size, and
// coordinates, which are below 2^30, to 10^-6. What is farther outside than this is outside for certain.
constexpr double CircleMargin = 1e-6;
constexpr double CircleMarginPerRadius = 1e-12;

/// The circle of the points to the left of an edge that see it at an angle with some cotangent, in coordinates from the
/// start of the edge. In plain doubles: a point within the margin may be inside or outside.
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

  /// False only when the point is for certain outside, or to the right of the edge. Without branches: points are inside
  /// or outside in no order that a processor could predict.
  bool MayHold(const PlanePoint& point) const
  {
    const double x = double(point.X - this->Start.X);
    const double y = double(point.Y - this->Start.Y);
    const double fromX = x - this->X;
    const double fromY = y - this->Y;
    // Rounding keeps the order of the two products, or makes them equal.
    return (fromX * fromX + fromY * fromY <= this->SquaredReach) & (this->EdgeX * y >= this->EdgeY * x);
  }

  /// False only when no place of a box is inside, left or right of the edge.
  bool MayReach(const PlaneBox& box) const
  {
    return SquaredDistanceToBox({ this->X + this->Start.X, this->Y + this->Start.Y }, box) <= this->SquaredReach;
  }

  PlanePoint Start;
  double EdgeX; // the vector of the edge
  double EdgeY;
  double X; // the centre
  double Y;
  double SquaredReach; // of the radius and the margin
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
ThirdPoint ThirdPointSearch::Find(PointId a, PointId b, float neighbor, std::vector<WalkedVoxel>* walk) const
{
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
// The circle through the best point to the left has no point in its left part, and of all such circles the smallest
// right part. So the edge is Delaunay when that part has no point either. Seen from the right the edge is reversed, and
// the cotangent of the circle has the other sign.
bool ThirdPointSearch::IsDelaunay(PointId a, PointId b) const
{
  ThirdPointQuery left(this->Points, a, b, nullptr);
  this->Search(left, this->UsualHeight);
  assert(left.Best != NoPoint);
  ThirdPointQuery right(this->Points, b, a, nullptr);
  right.BestCotangent = -left.BestCotangent;
  const EdgeCircle circle(right, right.BestCotangent);
  const PlanePoint& best = this->Points.At(left.Best);
  const VoxelBox box = VoxelsOfBest(right);
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
  const std::int64_t voxelSize = this->Points.Voxels().CellSize();
  if (!isTraced)
  {
    const std::int64_t extent = std::max(std::abs(query.A.X - query.B.X), std::abs(query.A.Y - query.B.Y));
    if (this->Strategy == SearchStrategy::VoxelTraversal && extent < LongestNearby * voxelSize &&
      this->SearchNearby(query, height))
    {
      return;
    }
    if (extent >= LargestBoxToTraverse * voxelSize)
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
    ScanBox(query, VoxelsOfBest(query), float(query.BestCotangent));
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
    ScanBox(query, VoxelsOfCircle(query, cotangent, 0.5f * (height + rest)), cotangent);
    if (query.Best != NoPoint && query.BestCotangent <= cotangentOfTwice)
    {
      if (query.BestCotangent >= cotangent - CotangentMargin * std::abs(cotangent))
      {
        ScanBox(query, VoxelsOfBest(query), float(query.BestCotangent));
      }
      return true;
    }
    query.Best = NoPoint;
  }
  return false;
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
}
