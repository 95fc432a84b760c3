// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: what corners can be cut off without a loop coming to cross another (LoopGuard); the passes over
// straight runs and corners of one loop, or the fewest points of it (FewestPoints.h); what was dropped, and how far off
// it is.

#include "BoundarySimplification.h"

#include "Common/CellGrid.h"
#include "Common/Parameters.h"
#include "Common/Predicates.h"
#include "Common/SpacePoints.h"
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
// As fine as sub-voxels can be (Lattice.h).
constexpr double PartsPerColumn = 1 << 20;

/// The column with each point: that of the greatest whole coordinates that are not greater than its own.
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

/// Where the sides of a triangle are from one y to another.
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

/// 1 when a, b and c turn to the left, -1 when to the right, 0 when they are on one line.
template <typename Point>
int Turn(const Point& a, const Point& b, const Point& c)
{
  return Sign(Int128(b.X - a.X) * (c.Y - a.Y) - Int128(b.Y - a.Y) * (c.X - a.X));
}

// Which corners of the boundary loops of a horizon can be cut off, so that no loops come to cross and every point stays
// on its side of them.
//
// When a loop goes straight from a to b instead of by way of m, only the triangle a, m, b changes sides:
//
//          m
//         / \         As long as no other point lies in the triangle or on its sides, no other loop does: it would have
//     ---a---b---     to cross a-m or m-b, or to have a point inside. So loops that did not cross still do not, and no
//                     point changes sides or lies on the new edge.
//
/// Answers are exact for places that are multiples of 2^-20 of a column, as all on a lattice are.
class LoopGuard
{
public:
  /// `points` are all points of the horizon, in lattice units, on the boundary or inside.
  explicit LoopGuard(const SpacePoints& points);

  /// True when no point that is left lies in the triangle a, m, b or on its sides, other than these three.
  bool IsClear(PointId a, PointId m, PointId b) const;

  /// Takes a point away.
  void Remove(PointId point) { this->Removed[point] = true; }

private:
  /// A place in the plane, in whole parts of a column.
  struct FinePoint
  {
    std::int64_t X;
    std::int64_t Y;
  };

  FinePoint Fine(PointId point) const;
  RowSegment Side(PointId a, PointId b) const;
  bool IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const;

  const SpacePoints& Points;
  const std::vector<PlanePoint> Columns; // of each point
  const CellGrid Grid;
  const PointLists InColumn;
  std::vector<bool> Removed;
};

//----------------------------------------------------------------------------------------------------------------------
LoopGuard::LoopGuard(const SpacePoints& points)
  : Points(points)
  , Columns(FindColumns(points))
  , Grid(this->Columns, 1, 1)
  , InColumn(SortByCell(this->Grid, this->Columns))
  , Removed(points.size(), false)
{
}

//----------------------------------------------------------------------------------------------------------------------
LoopGuard::FinePoint LoopGuard::Fine(PointId point) const
{
  const SpacePoint place = this->Points[point];
  return { std::llround(place.X * PartsPerColumn), std::llround(place.Y * PartsPerColumn) };
}

//----------------------------------------------------------------------------------------------------------------------
RowSegment LoopGuard::Side(PointId a, PointId b) const
{
  const SpacePoint from = this->Points[a];
  const SpacePoint to = this->Points[b];
  return RowSegment({ from.X, from.Y }, { to.X, to.Y });
}

//----------------------------------------------------------------------------------------------------------------------
bool LoopGuard::IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const
{
  const FinePoint p = this->Fine(point);
  const int sides[3] = { Turn(a, m, p), Turn(m, b, p), Turn(b, a, p) };
  const bool isInside = *std::min_element(sides, sides + 3) >= 0 || *std::max_element(sides, sides + 3) <= 0;
  // For a triangle without area the sides say nothing about how far out on its line the point is.
  return isInside && p.X >= std::min({ a.X, m.X, b.X }) && p.X <= std::max({ a.X, m.X, b.X }) &&
    p.Y >= std::min({ a.Y, m.Y, b.Y }) && p.Y <= std::max({ a.Y, m.Y, b.Y });
}

//----------------------------------------------------------------------------------------------------------------------
bool LoopGuard::IsClear(PointId a, PointId m, PointId b) const
{
  const std::array<FinePoint, 3> corner = { this->Fine(a), this->Fine(m), this->Fine(b) };
  const auto isIn = [&](PointId point)
  {
    return point != a && point != m && point != b && !this->Removed[point] &&
      this->IsIn(point, corner[0], corner[1], corner[2]);
  };
  const std::array<RowSegment, 3> sides = { this->Side(a, m), this->Side(m, b), this->Side(b, a) };
  const double bottom = std::floor(std::min(sides[0].LeastY(), sides[1].LeastY()));
  const std::int64_t firstRow = this->Grid.CellY(bottom);
  const std::int64_t lastRow = this->Grid.CellY(std::max(sides[0].GreatestY(), sides[1].GreatestY()));
  // Row by row: a triangle can be long, but is thin.
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

// ---- Loops ---------------------------------------------------------------------------------------------------------
/// Whether an edge could lead across a band that an index leaves out.
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

/// Simplifies one loop after the other. Positions in a loop count from its first point; beyond its end they go on with
/// the first point again.
class LoopSimplifier
{
public:
  LoopSimplifier(const SpacePoints& points, const Loops& boundary, const BoundarySimplificationOptions& options,
    BoundarySimplification& result, const Monitor& monitor)
    : Points(points)
    , Options(options)
    , Result(result)
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
        options.OutlineTolerance, options.DistanceThreshold, [this]() { this->Watch.Progress(this->Part); });
    }
    else if (options.OutlineTolerance > 0.0)
    {
      this->Guard.emplace(points);
    }
  }

  /// A loop that comes when this part of the work is done.
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

private:
  /// Runs are taken from the first point that ends one. That of our own loops is their first point, a corner; a loop of
  /// someone else may begin anywhere.
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

  /// Boundary points stand on whole columns, so that the products below are exact.
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

  /// The first position that ends a run. There is one, as a closed loop turns somewhere.
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

  /// One pass over a line of positions whose ends stay: after a drop it goes on from the third of three, else from the
  /// middle one. False when nothing was dropped.
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
      this->AllBetween(before, after, [&](const Eigen::Vector3d& place) { return edge.InSpace(place) <= threshold; });
  }

  double DistanceToLine(PointId point, PointId a, PointId b) const
  {
    const Eigen::Vector3d along = this->Place(b) - this->Place(a);
    return along.cross(this->Place(point) - this->Place(a)).norm() / along.norm();
  }

  SpanningEdge EdgeBetween(PointId a, PointId b) const { return { this->Place(a), this->Place(b) }; }

  /// Whether a condition holds for the places of all points that an edge spans.
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
    const auto canDrop = [this](std::size_t before, std::size_t middle, std::size_t after)
    { return this->DropCorner(before, middle, after); };
    this->Kept.push_back(this->Loop.size());
    for (const std::size_t n : Dropped(this->Kept))
    {
      this->Guard->Remove(this->At(n));
    }
    while (DropOnce(this->Kept, canDrop))
    {
    }
    this->Kept.pop_back();
  }

  /// The positions between the first and the last of a list that the list leaves out.
  static std::vector<std::size_t> Dropped(const std::vector<std::size_t>& kept)
  {
    std::vector<std::size_t> dropped;
    for (std::size_t n = 1; n < kept.size(); ++n)
    {
      for (std::size_t between = kept[n - 1] + 1; between < kept[n]; ++between)
      {
        dropped.push_back(between);
      }
    }
    return dropped;
  }

  /// Drops a corner if it can. It has to stay when loops visit it more than once, and when they so visit both of its
  /// neighbours: there may be an edge between these already.
  bool DropCorner(std::size_t before, std::size_t middle, std::size_t after)
  {
    const PointId a = this->At(before);
    const PointId b = this->At(after);
    const bool isBound = this->IsShared(middle) || (this->IsShared(before) && this->IsShared(after)) || a == b;
    if (isBound || this->Corners <= 3 || !this->IsNear(before, middle, after) ||
      !this->Guard->IsClear(a, this->At(middle), b))
    {
      return false;
    }
    this->Guard->Remove(this->At(middle));
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

  /// Adds what is left of the loop to the result. Every dropped point counts for the nearer end, in plan, of the edge
  /// that spans it.
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
        this->WriteDropped(this->At(between), a, b);
      }
    }
    this->Result.Boundary.Close();
  }

  void WriteDropped(PointId point, PointId a, PointId b)
  {
    const SpanningEdge edge = this->EdgeBetween(a, b);
    this->Result.Deviation = std::max(this->Result.Deviation, edge.InSpace(this->Place(point)));
    this->Result.OutlineDeviation = std::max(this->Result.OutlineDeviation, edge.OnMap(this->Place(point)).InPlan);
    const auto toEnd = [&](PointId end) { return (this->Place(point) - this->Place(end)).head<2>().norm(); };
    this->Result.Dropped.push_back({ point, toEnd(b) < toEnd(a) ? b : a });
  }

  const SpacePoints& Points;
  const BoundarySimplificationOptions& Options;
  BoundarySimplification& Result;
  const Monitor& Watch;
  double Part = 0.0;
  std::vector<unsigned char> Visits; // 0, 1 or 2 for more than one
  std::optional<LoopGuard> Guard;
  std::optional<ColumnIndex> OwnIndex;
  std::optional<FewestPoints> Fewest;
  std::vector<PointId> Loop; // that is being simplified
  std::vector<std::size_t> Run; // the positions that are left of the run that is being simplified
  std::vector<std::size_t> Kept; // the positions that are left of the loop
  std::size_t Corners = 0; // how many points the loop still has
};
}

//----------------------------------------------------------------------------------------------------------------------
BoundarySimplification SimplifyBoundary(const SpacePoints& points, const Loops& boundary,
  const BoundarySimplificationOptions& options, const Monitor& monitor)
{
  CheckAtLeast("distance threshold", options.DistanceThreshold, 0.0, " lattice units");
  CheckAtLeast("outline tolerance", options.OutlineTolerance, 0.0, " columns");
  BoundarySimplification result;
  LoopSimplifier simplifier(points, boundary, options, result, monitor);
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    const double part = double(loop) / double(boundary.Size());
    if (loop % 64 == 0)
    {
      monitor.Progress(part);
    }
    simplifier.Simplify(boundary.begin(loop), boundary.end(loop), part);
  }
  std::sort(result.Dropped.begin(), result.Dropped.end(),
    [](const DroppedPoint& a, const DroppedPoint& b) { return a.Point < b.Point; });
  return result;
}
}
