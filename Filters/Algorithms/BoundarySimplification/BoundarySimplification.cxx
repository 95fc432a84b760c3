// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: LoopGuard, which prevents loops from crossing; passes over straight runs and corners of a loop, or the
// fewest points (FewestPoints.h); the side of the new loops on which dropped points lie.

#include "BoundarySimplification.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/CellGrid.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/SpacePoints.h"
#include "FewestPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// Sub-voxels are not finer than this (Lattice.h).
constexpr double PartsPerColumn = 1 << 20;

std::vector<PlanePoint> FindColumns(const SpacePoints& points)
{
  std::vector<PlanePoint> columns;
  columns.reserve(points.size());
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const SpacePoint point = points[n];
    columns.push_back({ std::int32_t(std::floor(point.X)), std::int32_t(std::floor(point.Y)) });
  }
  return columns;
}

RowSegment::Range RangeBetween(const std::array<RowSegment, 3>& sides, double bottom, double top)
{
  RowSegment::Range range = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  for (const RowSegment& side : sides)
  {
    if (side.GreatestY() >= bottom && side.LeastY() <= top)
    {
      const RowSegment::Range ofSide = side.Between(bottom, top);
      range = { std::min(range.First, ofSide.First), std::max(range.Last, ofSide.Last) };
    }
  }
  return range;
}

/// Returns 1 for a left turn, -1 for a right turn, and 0 for points on a line.
template <typename Point>
int TurnAt(const Point& a, const Point& b, const Point& c)
{
  return Sign(Int128(b.X - a.X) * (c.Y - a.Y) - Int128(b.Y - a.Y) * (c.X - a.X));
}

// If a loop goes straight from a to b instead of through m, only the triangle a, m, b changes sides:
//
//         m
//        / \         If no other point lies in the triangle or on its edges, no other loop does: it would cross a-m or
//    ---a---b---     m-b, or have a point inside. Thus loops still do not cross, and no point changes sides.
//
// Points dropped from other edges count as well. Answers are exact for multiples of 2^-20 of a column.
class LoopGuard
{
public:
  explicit LoopGuard(const SpacePoints& points)
    : Points(points)
    , Columns(FindColumns(points))
    , Grid(this->Columns, 1, 1)
    , InColumn(SortByCell(this->Grid, this->Columns))
    , Position(points.size(), 0)
  {
  }

  void SetLoop(const std::vector<PointId>& loop, const std::vector<unsigned char>& visits)
  {
    for (const PointId point : this->Loop)
    {
      this->Position[point] = 0;
    }
    this->Loop = loop;
    for (std::size_t n = 0; n < loop.size(); ++n)
    {
      this->Position[loop[n]] = visits[loop[n]] > 1 ? 0 : n + 1;
    }
  }

  /// Points of the loop between the three positions do not count. `after` may be the length of the loop, for its first
  /// point.
  bool IsClear(std::size_t before, std::size_t middle, std::size_t after) const
  {
    const PointId a = this->Loop[before];
    const PointId m = this->Loop[middle];
    const PointId b = this->Loop[after % this->Loop.size()];
    const std::array<FinePoint, 3> corner = { this->Fine(a), this->Fine(m), this->Fine(b) };
    const auto isIn = [&](PointId point)
    {
      const bool isBetween = this->Position[point] > before + 1 && this->Position[point] <= after;
      return point != a && point != m && point != b && !isBetween && this->IsIn(point, corner[0], corner[1], corner[2]);
    };
    const std::array<RowSegment, 3> sides = { this->Side(a, m), this->Side(m, b), this->Side(b, a) };
    const double bottom = std::floor(std::min(sides[0].LeastY(), sides[1].LeastY()));
    const std::int64_t firstRow = this->Grid.CellY(bottom);
    const std::int64_t lastRow = this->Grid.CellY(std::max(sides[0].GreatestY(), sides[1].GreatestY()));
    // Triangles can be long, but they are thin, so that they are searched row by row.
    for (std::int64_t row = firstRow; row <= lastRow; ++row)
    {
      const double y = bottom + double(row - firstRow);
      const RowSegment::Range range = RangeBetween(sides, y, y + 1.0);
      for (std::int64_t x = this->Grid.CellX(range.First); x <= this->Grid.CellX(range.Last); ++x)
      {
        const std::int64_t cell = this->Grid.Index(x, row);
        if (std::any_of(this->InColumn.begin(cell), this->InColumn.end(cell), isIn))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  /// Coordinates are multiples of 1 / PartsPerColumn columns.
  struct FinePoint
  {
    std::int64_t X;
    std::int64_t Y;
  };

  FinePoint Fine(PointId point) const
  {
    const SpacePoint place = this->Points[point];
    return { std::llround(place.X * PartsPerColumn), std::llround(place.Y * PartsPerColumn) };
  }

  RowSegment Side(PointId a, PointId b) const
  {
    const SpacePoint from = this->Points[a];
    const SpacePoint to = this->Points[b];
    return RowSegment({ from.X, from.Y }, { to.X, to.Y });
  }

  bool IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const
  {
    const FinePoint p = this->Fine(point);
    const int sides[3] = { TurnAt(a, m, p), TurnAt(m, b, p), TurnAt(b, a, p) };
    const bool isInside = *std::min_element(sides, sides + 3) >= 0 || *std::max_element(sides, sides + 3) <= 0;
    // In a triangle without area, turns do not show whether the point is beyond the ends of the line.
    return isInside && p.X >= std::min({ a.X, m.X, b.X }) && p.X <= std::max({ a.X, m.X, b.X }) &&
      p.Y >= std::min({ a.Y, m.Y, b.Y }) && p.Y <= std::max({ a.Y, m.Y, b.Y });
  }

  const SpacePoints& Points;
  const std::vector<PlanePoint> Columns;
  const CellGrid Grid;
  const PointLists InColumn;
  std::vector<PointId> Loop;
  // The value is 0 for points elsewhere, and for points that must stay.
  std::vector<std::size_t> Position;
};

// ---- Loops ---------------------------------------------------------------------------------------------------------
/// An edge may cross an empty band that an index would remove.
bool HasLongEdges(const SpacePoints& points, const Loops& boundary)
{
  bool hasLong = false;
  boundary.ForEachEdge(
    [&](PointId from, PointId to)
    {
      const SpacePoint a = points[from];
      const SpacePoint b = points[to];
      hasLong = hasLong || std::max(std::abs(a.X - b.X), std::abs(a.Y - b.Y)) > ColumnIndex::LongestReach;
    });
  return hasLong;
}

struct SpannedPoint
{
  DroppedPoint Point;
  double InHeight;
};

/// Positions beyond the end of a loop continue from its first point.
class LoopSimplifier
{
public:
  LoopSimplifier(const SpacePoints& points, const Loops& boundary, const BoundarySimplificationOptions& options,
    BoundarySimplification& result, std::vector<SpannedPoint>& spanned, const Monitor& monitor)
    : Points(points)
    , Options(options)
    , Result(result)
    , Spanned(spanned)
    , Watch(monitor)
    , Visits(points.size(), 0)
  {
    boundary.ForEachPoint([this](PointId point) { this->CountVisit(point); });
    for (const PointId point : options.Fixed)
    {
      this->Visits[point] = 2;
    }
    if (options.Method == OutlineMethod::FewestPoints)
    {
      if (!options.Index)
      {
        this->OwnIndex.emplace(
          points.Columns(), 1, HasLongEdges(points, boundary) ? ColumnIndex::AllBands : ColumnIndex::LongestReach);
      }
      this->Fewest.emplace(points, options.Index ? *options.Index : *this->OwnIndex, this->Visits,
        options.OutlineTolerance, options.DistanceThreshold, options.Known ? *options.Known : this->OwnKnown,
        [this]() { this->Watch.Progress(this->Part); });
    }
    else if (options.OutlineTolerance > 0.0)
    {
      this->Guard.emplace(points);
    }
  }

  void Simplify(const PointId* first, const PointId* last, double part)
  {
    this->Part = part;
    this->Loop.assign(first, last);
    if (this->Fewest)
    {
      this->Kept = this->Fewest->Simplify(this->Loop);
    }
    else
    {
      this->DropStepByStep();
    }
    this->WriteLoop();
  }

  void Keep(const PointId* first, const PointId* last, const std::vector<unsigned char>& isKept)
  {
    this->Loop.assign(first, last);
    this->Kept.clear();
    for (std::size_t n = 0; n < this->Loop.size(); ++n)
    {
      if (isKept[this->Loop[n]] != 0)
      {
        this->Kept.push_back(n);
      }
    }
    this->WriteLoop();
  }

private:
  /// The loop is rotated to the end of a run, since loops from other sources may begin within a run.
  void DropStepByStep()
  {
    this->Kept.clear();
    std::rotate(this->Loop.begin(), this->Loop.begin() + std::ptrdiff_t(this->FirstRunEnd()), this->Loop.end());
    for (std::size_t from = 0; from < this->Loop.size();)
    {
      std::size_t to = from + 1;
      while (to < this->Loop.size() && !this->EndsRun(to))
      {
        ++to;
      }
      this->SimplifyRun(from, to);
      this->Kept.insert(this->Kept.end(), this->Run.begin(), this->Run.end() - 1);
      from = to;
    }
    if (this->Guard)
    {
      this->DropCorners();
    }
  }

  void CountVisit(PointId point)
  {
    unsigned char& visits = this->Visits[point];
    visits = static_cast<unsigned char>(std::min(visits + 1, 2));
  }

  PointId At(std::size_t n) const { return this->Loop[n % this->Loop.size()]; }
  bool IsShared(std::size_t n) const { return this->Visits[this->At(n)] > 1; }

  Eigen::Vector3d Place(PointId point) const
  {
    const SpacePoint place = this->Points[point];
    return { place.X, place.Y, place.Z };
  }

  /// Boundary points have whole coordinates, so that these products are exact.
  bool EndsRun(std::size_t n) const
  {
    if (this->IsShared(n))
    {
      return true;
    }
    const Eigen::Vector2d here = this->Place(this->At(n)).head<2>();
    const Eigen::Vector2d in = here - this->Place(this->At(n + this->Loop.size() - 1)).head<2>();
    const Eigen::Vector2d out = this->Place(this->At(n + 1)).head<2>() - here;
    return in.x() * out.y() != in.y() * out.x() || in.dot(out) <= 0.0;
  }

  std::size_t FirstRunEnd() const
  {
    std::size_t n = 0;
    while (n + 1 < this->Loop.size() && !this->EndsRun(n))
    {
      ++n;
    }
    return n;
  }

  void SimplifyRun(std::size_t from, std::size_t to)
  {
    this->Run.resize(to - from + 1);
    std::iota(this->Run.begin(), this->Run.end(), from);
    const auto canDrop = [this](std::size_t before, std::size_t middle, std::size_t after)
    { return this->CanDropInRun(before, middle, after); };
    while (DropOnce(this->Run, canDrop))
    {
    }
  }

  /// After a drop, the pass skips the next position, so that no two neighbours are dropped in one pass. Returns whether
  /// it has dropped any.
  template <typename CanDrop>
  static bool DropOnce(std::vector<std::size_t>& line, CanDrop&& canDrop)
  {
    if (line.size() < 3)
    {
      return false;
    }
    std::size_t kept = 1;
    std::size_t middle = 1;
    while (middle + 1 < line.size())
    {
      if (canDrop(line[kept - 1], line[middle], line[middle + 1]))
      {
        ++middle;
      }
      line[kept++] = line[middle++];
    }
    if (middle < line.size())
    {
      line[kept++] = line[middle];
    }
    const bool dropped = kept < line.size();
    line.resize(kept);
    return dropped;
  }

  bool CanDropInRun(std::size_t before, std::size_t middle, std::size_t after) const
  {
    const double threshold = this->Options.DistanceThreshold;
    if (!(this->DistanceToLine(this->At(middle), this->At(before), this->At(after)) < threshold))
    {
      return false;
    }
    const SpanningEdge edge = this->EdgeBetween(this->At(before), this->At(after));
    return !this->Options.BoundDeviation ||
      this->AllBetween(
        before, after, [&](const Eigen::Vector3d& place) { return edge.OnMap(place).InHeight <= threshold; });
  }

  double DistanceToLine(PointId point, PointId a, PointId b) const
  {
    const Eigen::Vector3d along = this->Place(b) - this->Place(a);
    return along.cross(this->Place(point) - this->Place(a)).norm() / along.norm();
  }

  SpanningEdge EdgeBetween(PointId a, PointId b) const { return { this->Place(a), this->Place(b) }; }

  template <typename Condition>
  bool AllBetween(std::size_t before, std::size_t after, Condition&& condition) const
  {
    for (std::size_t n = before + 1; n < after; ++n)
    {
      if (!condition(this->Place(this->At(n))))
      {
        return false;
      }
    }
    return true;
  }

  void DropCorners()
  {
    this->Corners = this->Kept.size();
    this->Guard->SetLoop(this->Loop, this->Visits);
    const auto canDrop = [this](std::size_t before, std::size_t middle, std::size_t after)
    { return this->DropCorner(before, middle, after); };
    this->Kept.push_back(this->Loop.size());
    while (DropOnce(this->Kept, canDrop))
    {
    }
    this->Kept.pop_back();
  }

  /// A corner also stays if loops visit both of its neighbours more than once: an edge may already connect these.
  bool DropCorner(std::size_t before, std::size_t middle, std::size_t after)
  {
    const PointId a = this->At(before);
    const PointId b = this->At(after);
    const bool isBound = this->IsShared(middle) || (this->IsShared(before) && this->IsShared(after)) || a == b;
    if (isBound || this->Corners <= 3 || !this->IsNear(before, middle, after) ||
      !this->Guard->IsClear(before, middle, after))
    {
      return false;
    }
    --this->Corners;
    return true;
  }

  bool IsNear(std::size_t before, std::size_t middle, std::size_t after) const
  {
    const double threshold = this->Options.DistanceThreshold;
    const SpanningEdge edge = this->EdgeBetween(this->At(before), this->At(after));
    return edge.OnMap(this->Place(this->At(middle))).InHeight < threshold &&
      this->AllBetween(
        before, after,
        [&](const Eigen::Vector3d& place)
        {
          const MapDistances distances = edge.OnMap(place);
          return distances.InPlan <= this->Options.OutlineTolerance &&
            (!this->Options.BoundDeviation || distances.InHeight <= threshold);
        });
  }

  void WriteLoop()
  {
    this->Kept.push_back(this->Kept.front() + this->Loop.size());
    for (std::size_t n = 0; n + 1 < this->Kept.size(); ++n)
    {
      const PointId a = this->At(this->Kept[n]);
      const PointId b = this->At(this->Kept[n + 1]);
      this->Result.Boundary.Append(a);
      for (std::size_t between = this->Kept[n] + 1; between < this->Kept[n + 1]; ++between)
      {
        this->AddSpanned(this->At(between), a, b);
      }
    }
    this->Result.Boundary.Close();
  }

  void AddSpanned(PointId point, PointId a, PointId b)
  {
    const SpanningEdge edge = this->EdgeBetween(a, b);
    const MapDistances distances = edge.OnMap(this->Place(point));
    this->Result.Deviation = std::max(this->Result.Deviation, edge.InSpace(this->Place(point)));
    this->Result.OutlineDeviation = std::max(this->Result.OutlineDeviation, distances.InPlan);
    const auto toEnd = [&](PointId end) { return (this->Place(point) - this->Place(end)).head<2>().norm(); };
    this->Spanned.push_back({ { point, toEnd(b) < toEnd(a) ? b : a }, distances.InHeight });
  }

  const SpacePoints& Points;
  const BoundarySimplificationOptions& Options;
  BoundarySimplification& Result;
  std::vector<SpannedPoint>& Spanned;
  const Monitor& Watch;
  double Part = 0.0;
  std::vector<unsigned char> Visits; // 2 for more than one
  std::optional<LoopGuard> Guard;
  std::optional<ColumnIndex> OwnIndex;
  KeptOfChains OwnKnown;
  std::optional<FewestPoints> Fewest;
  std::vector<PointId> Loop;
  std::vector<std::size_t> Run;
  std::vector<std::size_t> Kept;
  std::size_t Corners = 0;
};
// ---- Sides ---------------------------------------------------------------------------------------------------------
enum class LoopSide
{
  Outside,
  On,
  Inside
};

/// A point is inside if an odd number of edges crosses its row to the left. An edge includes its lower end, but not its
/// upper end.
class SideFinder
{
public:
  SideFinder(const SpacePoints& points, const std::vector<PointId>& which)
    : Points(points)
    , Order(which.size())
    , Sides(which.size(), LoopSide::Outside)
    , Crossings(which.size(), 0)
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    ParallelSort(this->Order,
      [&](std::size_t a, std::size_t b) { return PrecedesByRow(this->ColumnOf(which[a]), this->ColumnOf(which[b])); });
    for (const std::size_t n : this->Order)
    {
      const PlanePoint column = this->ColumnOf(which[n]);
      if (this->Columns.empty() || this->Columns.back().Y != column.Y)
      {
        this->RowStarts.push_back(this->Columns.size());
      }
      this->Columns.push_back(column);
    }
    this->RowStarts.push_back(this->Columns.size());
  }

  std::vector<LoopSide> Find(const Loops& loops)
  {
    loops.ForEachEdge([this](PointId from, PointId to) { this->Cross(this->ColumnOf(from), this->ColumnOf(to)); });
    for (std::size_t row = 0; row + 1 < this->RowStarts.size(); ++row)
    {
      bool isInside = false;
      for (std::size_t n = this->RowStarts[row]; n < this->RowStarts[row + 1]; ++n)
      {
        isInside = isInside != (this->Crossings[n] != 0);
        LoopSide& side = this->Sides[this->Order[n]];
        side = side == LoopSide::On ? side : isInside ? LoopSide::Inside : LoopSide::Outside;
      }
    }
    return std::move(this->Sides);
  }

private:
  PlanePoint ColumnOf(PointId point) const
  {
    const SpacePoint place = this->Points[point];
    return { std::int32_t(place.X), std::int32_t(place.Y) };
  }

  void Cross(PlanePoint low, PlanePoint high)
  {
    if (PrecedesByRow(high, low))
    {
      std::swap(low, high);
    }
    const auto isBelow = [this](std::size_t start, std::int32_t y) { return this->Columns[start].Y < y; };
    const auto end = this->RowStarts.end() - 1;
    for (auto row = std::lower_bound(this->RowStarts.begin(), end, low.Y, isBelow);
         row != end && this->Columns[*row].Y <= high.Y; ++row)
    {
      this->CrossRow(low, high, row[0], row[1]);
    }
  }

  void CrossRow(const PlanePoint& low, const PlanePoint& high, std::size_t first, std::size_t last)
  {
    const bool isLevel = low.Y == high.Y;
    const auto isLeft = [&](const PlanePoint& column)
    { return isLevel ? column.X < low.X : SignedArea(low, high, column) > 0; };
    const auto isOn = [&](const PlanePoint& column)
    { return isLevel ? column.X <= high.X : SignedArea(low, high, column) == 0; };
    const auto begin = this->Columns.begin();
    std::size_t right =
      std::size_t(std::partition_point(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(last), isLeft) - begin);
    for (; right < last && isOn(this->Columns[right]); ++right)
    {
      this->Sides[this->Order[right]] = LoopSide::On;
    }
    if (right < last && this->Columns[right].Y < high.Y)
    {
      this->Crossings[right] ^= 1;
    }
  }

  const SpacePoints& Points;
  std::vector<std::size_t> Order;
  std::vector<PlanePoint> Columns;
  std::vector<std::size_t> RowStarts;
  std::vector<LoopSide> Sides; // in the order given
  std::vector<unsigned char> Crossings; // 1 for an odd number since the previous point of the row
};

double PlanDistance(const SpacePoints& points, PointId a, PointId b)
{
  return std::hypot(points[a].X - points[b].X, points[a].Y - points[b].Y);
}

/// Drops points on the loops or outside.
void FindSides(const SpacePoints& points, const std::vector<SpannedPoint>& spanned, BoundarySimplification& result)
{
  std::vector<PointId> left;
  left.reserve(spanned.size());
  for (const SpannedPoint& one : spanned)
  {
    left.push_back(one.Point.Point);
  }
  // Loops that did not change in plan pass through all of these points.
  const std::vector<LoopSide> sides = result.OutlineDeviation > 0.0 ? SideFinder(points, left).Find(result.Boundary)
                                                                    : std::vector<LoopSide>(left.size(), LoopSide::On);
  for (std::size_t n = 0; n < spanned.size(); ++n)
  {
    if (sides[n] != LoopSide::Inside)
    {
      result.Dropped.push_back(spanned[n].Point);
      result.HeightDeviation = std::max(result.HeightDeviation, spanned[n].InHeight);
      result.NumberOutside += sides[n] == LoopSide::Outside ? 1 : 0;
    }
  }
  ParallelSort(result.Dropped, [](const DroppedPoint& a, const DroppedPoint& b) { return a.Point < b.Point; });
}

BoundarySimplification SimplifyDivided(const SpacePoints& points, const Loops& boundary, const Loops& simplified,
  BoundarySimplificationOptions options, const Monitor& monitor)
{
  const double longest = options.LongestEdge;
  const std::vector<PointId> fixed = DivideEdges(points, boundary, simplified,
    [&](PointId from, PointId to) { return std::ceil(PlanDistance(points, from, to) / longest); });
  options.Fixed.insert(options.Fixed.end(), fixed.begin(), fixed.end());
  options.LongestEdge = 0.0;
  return SimplifyBoundary(points, boundary, options, monitor);
}
}

//----------------------------------------------------------------------------------------------------------------------
BoundarySimplification SimplifyBoundary(const SpacePoints& points, const Loops& boundary,
  const BoundarySimplificationOptions& options, const Monitor& monitor)
{
  CheckAtLeast("distance threshold", options.DistanceThreshold, 0.0, " lattice units");
  CheckAtLeast("outline tolerance", options.OutlineTolerance, 0.0, " columns");
  BoundarySimplification result;
  std::vector<SpannedPoint> spanned;
  LoopSimplifier simplifier(points, boundary, options, result, spanned, monitor);
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    const double part = double(loop) / double(boundary.Size());
    if (loop % 64 == 0)
    {
      monitor.Progress(part);
    }
    simplifier.Simplify(boundary.begin(loop), boundary.end(loop), part);
  }
  FindSides(points, spanned, result);
  return options.LongestEdge > 0.0 ? SimplifyDivided(points, boundary, result.Boundary, options, monitor) : result;
}

//----------------------------------------------------------------------------------------------------------------------
BoundarySimplification KeepOnly(
  const SpacePoints& points, const Loops& boundary, const std::vector<unsigned char>& isKept)
{
  BoundarySimplification result;
  std::vector<SpannedPoint> spanned;
  const BoundarySimplificationOptions options;
  LoopSimplifier simplifier(points, boundary, options, result, spanned, Monitor());
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    simplifier.Keep(boundary.begin(loop), boundary.end(loop), isKept);
  }
  FindSides(points, spanned, result);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
void ForEachChain(const Loops& boundary, const Loops& simplified, std::size_t points,
  const std::function<void(const std::vector<PointId>&)>& visit)
{
  const std::vector<unsigned char> isEnd = simplified.MarkPoints(points);
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    const auto first = std::find_if(
      boundary.begin(loop), boundary.end(loop), [&](PointId point) { return isEnd[std::size_t(point)] != 0; });
    if (first == boundary.end(loop)) // the loop was dropped
    {
      continue;
    }
    std::vector<PointId> around(first, boundary.end(loop));
    around.insert(around.end(), boundary.begin(loop), first + 1);
    std::vector<PointId> chain(1, around.front());
    for (std::size_t n = 1; n < around.size(); ++n)
    {
      chain.push_back(around[n]);
      if (isEnd[std::size_t(around[n])] != 0)
      {
        visit(chain);
        chain.assign(1, around[n]);
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<PointId> DivideEdges(const SpacePoints& points, const Loops& boundary, const Loops& simplified,
  const std::function<double(PointId, PointId)>& partsOf)
{
  std::vector<PointId> found;
  ForEachChain(boundary, simplified, points.size(),
    [&](const std::vector<PointId>& chain)
    {
      found.push_back(chain.front());
      const double parts = partsOf(chain.front(), chain.back());
      const double whole = PlanDistance(points, chain.front(), chain.back());
      double part = 1.0;
      for (std::size_t n = 1; n + 1 < chain.size() && part < parts; ++n)
      {
        if (PlanDistance(points, chain.front(), chain[n]) >= part * whole / parts)
        {
          found.push_back(chain[n]);
          part += 1.0;
        }
      }
    });
  return found;
}
}
