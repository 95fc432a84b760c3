// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the nearest triangle of a surface that is nearly a height field, by square cells in plan.
//
// The triangle above or below a place bounds the distance, so mostly one cell is searched. If the bound is poor, on
// steep, distant or ending surfaces, a pyramid of boxes over the cells is searched.
//
// Surfaces of any shape are searched correctly, but slowly if many triangles share a cell; their raster stays empty
// (IsWorthwhile).

#ifndef SeismicHorizonsTriangleRaster_h
#define SeismicHorizonsTriangleRaster_h

#include "Common/Base/CountingSort.h"
#include "Common/Base/Monitor.h"
#include "TriangleSurface.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Corners may be in either order.
struct PlanTriangle
{
  std::array<Eigen::Vector2d, 3> Corner;

  explicit PlanTriangle(const std::array<Eigen::Vector3d, 3>& corners)
    : Corner{ corners[0].head<2>(), corners[1].head<2>(), corners[2].head<2>() }
  {
  }

  PlanTriangle(const TriangleSurface& surface, const Corners& t)
    : Corner{ surface.Point(t[0]).head<2>(), surface.Point(t[1]).head<2>(), surface.Point(t[2]).head<2>() }
  {
  }

  /// Returns twice the area, positive if the place is left of the edge.
  double DoubledArea(std::size_t side, const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d along = this->Corner[(side + 1) % 3] - this->Corner[side];
    const Eigen::Vector2d to = place - this->Corner[side];
    return along.x() * to.y() - along.y() * to.x();
  }
  /// Positive for counter-clockwise corners.
  double DoubledArea() const { return this->DoubledArea(0, this->Corner[2]); }

  double SquaredLongest() const
  {
    return std::max({ (this->Corner[1] - this->Corner[0]).squaredNorm(),
      (this->Corner[2] - this->Corner[1]).squaredNorm(), (this->Corner[0] - this->Corner[2]).squaredNorm() });
  }

  double Low(int axis) const
  {
    return std::min({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }
  double High(int axis) const
  {
    return std::max({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }

  bool MayReach(const Eigen::Vector3d& place, double tolerance) const
  {
    const auto low = this->Corner[0].array().min(this->Corner[1].array()).min(this->Corner[2].array());
    const auto high = this->Corner[0].array().max(this->Corner[1].array()).max(this->Corner[2].array());
    const auto plan = place.head<2>().array();
    return (low - plan).max(plan - high).maxCoeff() <= tolerance;
  }
};

/// Edges count as beyond up to rounding.
inline bool IsBeyondSide(const PlanTriangle& triangle, double doubledArea, const PlanTriangle& other)
{
  const double turn = doubledArea < 0.0 ? -1.0 : 1.0;
  const double rounding = 1e-12 * std::abs(doubledArea);
  for (std::size_t side = 0; side < 3; ++side)
  {
    if (turn * triangle.DoubledArea(side, other.Corner[0]) <= rounding &&
      turn * triangle.DoubledArea(side, other.Corner[1]) <= rounding &&
      turn * triangle.DoubledArea(side, other.Corner[2]) <= rounding)
    {
      return true;
    }
  }
  return false;
}

/// Ignores overlaps by rounding. One of two disjoint convex shapes is beyond an edge of the other. Without area, boxes
/// decide.
inline bool Overlap(const PlanTriangle& a, const PlanTriangle& b)
{
  if (a.High(0) < b.Low(0) || b.High(0) < a.Low(0) || a.High(1) < b.Low(1) || b.High(1) < a.Low(1))
  {
    return false;
  }
  const double areaOfA = a.DoubledArea();
  const double areaOfB = b.DoubledArea();
  return areaOfA == 0.0 || areaOfB == 0.0 || (!IsBeyondSide(a, areaOfA, b) && !IsBeyondSide(b, areaOfB, a));
}

/// Returns the range of x between two values of y.
inline std::array<double, 2> SpanWithin(const PlanTriangle& triangle, double low, double high)
{
  std::array<double, 2> span = { triangle.High(0), triangle.Low(0) };
  const auto add = [&span](double x) { span = { std::min(span[0], x), std::max(span[1], x) }; };
  for (std::size_t side = 0; side < 3; ++side)
  {
    const Eigen::Vector2d& from = triangle.Corner[side];
    const Eigen::Vector2d& to = triangle.Corner[(side + 1) % 3];
    if (from.y() >= low && from.y() <= high)
    {
      add(from.x());
    }
    for (const double y : { low, high })
    {
      if ((from.y() < y) != (to.y() < y))
      {
        add(from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
      }
    }
  }
  return span;
}

/// The range is empty if Last is below First.
struct CellRange
{
  std::int64_t First;
  std::int64_t Last;
  std::int64_t Size() const { return this->Last - this->First + 1; }
};

struct RasterGrid
{
  Eigen::Array2d Low = Eigen::Array2d::Zero(); // of the first cell
  double Side = 1.0;
  double CellsPerUnit = 1.0;
  // Triangles are shrunk by this, and boxes widened (TriangleRaster.cxx). It exceeds rounding.
  double Slack = 0.0;
  std::int64_t Size[2] = { 0, 0 };

  std::int64_t Cells() const { return this->Size[0] * this->Size[1]; }

  CellRange Range(int axis, double low, double high) const
  {
    // Truncation is faster than std::floor for non-negative numbers.
    const double first = (low - this->Low[axis]) * this->CellsPerUnit;
    const double last = (high - this->Low[axis]) * this->CellsPerUnit;
    return { std::int64_t(std::clamp(first, 0.0, double(this->Size[axis]))),
      last < 0.0 ? -1 : std::int64_t(std::min(last, double(this->Size[axis] - 1))) };
  }

  /// Returns -1 outside.
  std::int64_t CellOf(const Eigen::Vector3d& place) const
  {
    const double x = (place.x() - this->Low[0]) * this->CellsPerUnit;
    const double y = (place.y() - this->Low[1]) * this->CellsPerUnit;
    const bool inside = x >= 0.0 && y >= 0.0 && x < double(this->Size[0]) && y < double(this->Size[1]);
    return inside ? std::int64_t(y) * this->Size[0] + std::int64_t(x) : -1;
  }
};

/// Sorts at most four boxes, the nearest last, faster than std::sort.
template <typename Waiting>
void SortByDistance(Waiting* first, Waiting* last)
{
  for (Waiting* next = first + 1; next < last; ++next)
  {
    const Waiting moved = *next;
    Waiting* place = next;
    for (; place > first && (place - 1)->SquaredDistance < moved.SquaredDistance; --place)
    {
      *place = *(place - 1);
    }
    *place = moved;
  }
}

class TriangleRaster
{
public:
  /// The surface must pass CheckSurface() and outlive the raster. Takes linear time, and about 15 bytes per triangle.
  explicit TriangleRaster(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  bool IsWorthwhile() const { return this->Grid.Cells() > 0; }

  std::int64_t Cells() const { return this->Grid.Cells(); }

  template <typename Visitor>
  void ForEachTriangle(std::int64_t firstCell, std::int64_t lastCell, Visitor&& visit) const
  {
    for (std::uint32_t n = this->Sort.First(firstCell); n < this->Sort.First(lastCell); ++n)
    {
      if ((this->Items[n] & OwnerBit) != 0)
      {
        visit(this->TriangleOf(n));
      }
    }
  }

  /// Calls visit(triangle) until it returns false, for triangles that may overlap in plan, some more than once.
  template <typename Visitor>
  bool ForEachNear(const PlanTriangle& plan, Visitor&& visit) const
  {
    const CellRange box = this->Grid.Range(0, plan.Low(0) - this->Slack(), plan.High(0) + this->Slack());
    const CellRange rows = this->Grid.Range(1, plan.Low(1) - this->Slack(), plan.High(1) + this->Slack());
    for (std::int64_t row = rows.First; row <= rows.Last; ++row)
    {
      CellRange cells = box;
      if (box.Size() > 2)
      {
        const double low = this->Grid.Low[1] + double(row) * this->Grid.Side;
        const auto [first, last] = SpanWithin(plan, low - this->Slack(), low + this->Grid.Side + this->Slack());
        cells = this->Grid.Range(0, std::min(first, last) - this->Slack(), std::max(first, last) + this->Slack());
      }
      const std::uint32_t end = cells.Size() > 0 ? this->Sort.End(row * this->Grid.Size[0] + cells.Last) : 0;
      for (std::uint32_t n = end > 0 ? this->Sort.First(row * this->Grid.Size[0] + cells.First) : 0; n < end; ++n)
      {
        if (!visit(this->TriangleOf(n)))
        {
          return false;
        }
      }
    }
    return true;
  }

  const TriangleSurface& GetSurface() const { return this->Surface; }

  /// Returns -1 for none. Rounding may put the place outside.
  std::int32_t FindAcross(const Eigen::Vector3d& place) const;

  /// Strips narrower than Slack along its edges may overlap.
  bool IsAlone(std::int32_t triangle) const { return this->Overlaps[triangle].load(std::memory_order_relaxed) == 0; }

  /// Triangles exceed their cells by at most twice the slack of the grid, along both axes.
  double Slack() const { return 4.0 * this->Grid.Slack; }

  /// `best` is the squared distance to the triangle `nearest`; both are improved.
  void Search(const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const;

  /// See TriangleTree::FindHeight.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  static constexpr std::uint32_t OwnerBit = std::uint32_t(1) << 31U;

  /// Heights are relative to Middle; Low is above High in an empty cell.
  struct Heights
  {
    float Low;
    float High;
  };
  struct Level
  {
    std::int64_t Size[2];
    double Side;
    std::vector<Heights> Cells;
  };
  struct Waiting;

  std::int32_t TriangleOf(std::uint32_t item) const { return std::int32_t(this->Items[item] & ~OwnerBit); }
  bool MakeGrid();
  std::vector<std::uint32_t> FindOnlyCells() const;
  bool SortIntoCells();
  bool IsCrowded() const;
  bool FindOverlaps();
  void MakePyramid();
  Heights HeightsOf(std::int64_t cell) const;
  Waiting* PushChildren(
    const Eigen::Vector3d& place, const Metric& metric, const Waiting& box, double best, Waiting* end) const;
  void SearchCells(const Eigen::Vector3d& place, const Metric& metric, const CellRange& x, const CellRange& y,
    std::int32_t& nearest, double& best) const;
  void SearchPyramid(const Eigen::Vector3d& place, const Metric& metric, std::int32_t& nearest, double& best) const;

  const TriangleSurface& Surface;
  RasterGrid Grid;
  CountingSort<std::uint32_t> Sort;
  std::vector<std::uint32_t> Items; // by cell; a bit marks the first cell of a triangle
  std::vector<std::atomic<unsigned char>> Overlaps; // by triangle
  std::vector<Level> Pyramid;
  double Middle = 0.0;
  float Margin = 0.0F; // exceeds rounding
};
}

#endif
