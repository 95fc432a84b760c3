// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles in plan: which cells of a raster they touch, and whether they overlap.

#ifndef SeismicHorizonsCellSpans_h
#define SeismicHorizonsCellSpans_h

#include "TriangleRaster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
/// A triangle in plan. Its sides may turn either way.
struct PlanTriangle
{
  std::array<Eigen::Vector2d, 3> Corner;

  PlanTriangle(const TriangleSurface& surface, const Corners& t)
    : Corner{ surface.Point(t[0]).head<2>(), surface.Point(t[1]).head<2>(), surface.Point(t[2]).head<2>() }
  {
  }

  /// Twice the area of a side and a place: positive where the place is on the left.
  double DoubledArea(std::size_t side, const Eigen::Vector2d& place) const
  {
    const Eigen::Vector2d along = this->Corner[(side + 1) % 3] - this->Corner[side];
    const Eigen::Vector2d to = place - this->Corner[side];
    return along.x() * to.y() - along.y() * to.x();
  }
  /// Positive where sides turn left.
  double DoubledArea() const { return this->DoubledArea(0, this->Corner[2]); }

  double Low(int axis) const
  {
    return std::min({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }
  double High(int axis) const
  {
    return std::max({ this->Corner[0][axis], this->Corner[1][axis], this->Corner[2][axis] });
  }
};

/// Whether all of another triangle is beyond one side of a triangle of that area, up to rounding.
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

/// Whether two triangles overlap in plan, by more than rounding. Convex shapes do not where one is beyond a side of the
/// other. One without an area counts as overlapping where the boxes do.
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

/// The part of a triangle between two values of y, along x.
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

/// The cells of an interval that is taken to be smaller by the slack at both ends, but not empty.
inline CellRange ShrunkRange(const RasterGrid& grid, int axis, double low, double high)
{
  const double middle = 0.5 * (low + high);
  return grid.Range(axis, std::min(low + grid.Slack, middle), std::max(high - grid.Slack, middle));
}

/// Calls visit(cell) for all cells that a triangle touches. Each place of the triangle is in one of them, or beyond it
/// by twice the slack at most.
template <typename Visitor>
void ForEachCell(const RasterGrid& grid, const PlanTriangle& triangle, Visitor&& visit)
{
  const CellRange x = ShrunkRange(grid, 0, triangle.Low(0), triangle.High(0));
  const CellRange y = ShrunkRange(grid, 1, triangle.Low(1), triangle.High(1));
  const bool isBox = x.Size() == 1 || y.Size() == 1;
  for (std::int64_t row = y.First; row <= y.Last; ++row)
  {
    CellRange cells = x;
    if (!isBox)
    {
      const double low = grid.Low[1] + double(row) * grid.Side - grid.Slack;
      const std::array<double, 2> span = SpanWithin(triangle, low, low + grid.Side + 2.0 * grid.Slack);
      cells = ShrunkRange(grid, 0, std::min(span[0], span[1]), std::max(span[0], span[1]));
    }
    for (std::int64_t cell = row * grid.Size[0] + cells.First; cell <= row * grid.Size[0] + cells.Last; ++cell)
    {
      visit(cell);
    }
  }
}

constexpr std::uint32_t ManyCells = 0xffffffffU;

/// The one cell that a triangle touches, or ManyCells.
inline std::uint32_t OnlyCell(const RasterGrid& grid, const PlanTriangle& triangle)
{
  const CellRange x = ShrunkRange(grid, 0, triangle.Low(0), triangle.High(0));
  const CellRange y = ShrunkRange(grid, 1, triangle.Low(1), triangle.High(1));
  const bool isOne = x.First == x.Last && y.First == y.Last;
  return isOne ? std::uint32_t(y.First * grid.Size[0] + x.First) : ManyCells;
}

struct HeightRange
{
  double Low;
  double High;
};

/// The heights of a triangle, or of its plane within a square where these are fewer.
inline HeightRange HeightsWithin(
  const TriangleSurface& surface, const Corners& t, const Eigen::Array2d& middle, double reach)
{
  const Eigen::Vector3d& a = surface.Point(t[0]);
  const Eigen::Vector3d& b = surface.Point(t[1]);
  const Eigen::Vector3d& c = surface.Point(t[2]);
  const double low = std::min({ a.z(), b.z(), c.z() });
  const double high = std::max({ a.z(), b.z(), c.z() });
  const auto offset = [&middle](const Eigen::Vector3d& v) { return (v.head<2>().array() - middle).abs().maxCoeff(); };
  if (std::max({ offset(a), offset(b), offset(c) }) <= reach)
  {
    return { low, high };
  }
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const Eigen::Array2d slope = -normal.head<2>().array() / normal.z();
  const double height = a.z() + (slope * (middle - a.head<2>().array())).sum();
  // Of a needle in plan the slope is wrong by a part of the height over the width; 16 digits leave these few.
  const double change = slope.abs().sum() * reach + 1e-9 * (high - low);
  const double longer = std::max((b - a).head<2>().squaredNorm(), (c - a).head<2>().squaredNorm());
  const bool isPlane = std::abs(normal.z()) > 1e-5 * longer && std::isfinite(height);
  return isPlane ? HeightRange{ std::max(low, height - change), std::min(high, height + change) }
                 : HeightRange{ low, high };
}
}

#endif
