// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OutlineGuard.h"

#include "Common/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr double PartsPerColumn = 1 << 20;

std::vector<PlanePoint> FindColumns(const std::vector<SpacePoint>& points)
{
  std::vector<PlanePoint> columns;
  columns.reserve(points.size());
  for (const SpacePoint& point : points)
  {
    columns.push_back({ std::int32_t(std::floor(point.X)), std::int32_t(std::floor(point.Y)) });
  }
  return columns;
}

struct Range
{
  double First;
  double Last;
};

/// Where the sides of a triangle are between y and y + 1, and a little more than rounding can amount to.
Range RangeInRow(const std::array<SpacePoint, 3>& triangle, double y)
{
  const double margin = 1e-3;
  Range range = { std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest() };
  for (std::size_t side = 0; side < 3; ++side)
  {
    const SpacePoint& one = triangle[side];
    const SpacePoint& other = triangle[(side + 1) % 3];
    const SpacePoint& low = one.Y <= other.Y ? one : other;
    const SpacePoint& high = one.Y <= other.Y ? other : one;
    if (high.Y < y || low.Y > y + 1.0)
    {
      continue;
    }
    const double slope = high.Y > low.Y ? (high.X - low.X) / (high.Y - low.Y) : 0.0;
    const double x0 = low.X + slope * (std::max(y, low.Y) - low.Y);
    const double x1 = high.Y > low.Y ? low.X + slope * (std::min(y + 1.0, high.Y) - low.Y) : high.X;
    range = { std::min({ range.First, x0 - margin, x1 - margin }), std::max({ range.Last, x0 + margin, x1 + margin }) };
  }
  return range;
}

template <typename Point>
int Turn(const Point& a, const Point& b, const Point& c)
{
  return Sign(Int128(b.X - a.X) * (c.Y - a.Y) - Int128(b.Y - a.Y) * (c.X - a.X));
}
}

//----------------------------------------------------------------------------------------------------------------------
OutlineGuard::OutlineGuard(const std::vector<SpacePoint>& points)
  : Points(points)
  , Columns(FindColumns(points))
  , Grid(this->Columns, 1, 1)
  , InColumn(SortByCell(this->Grid, this->Columns))
  , Removed(points.size(), false)
{
}

//----------------------------------------------------------------------------------------------------------------------
OutlineGuard::FinePoint OutlineGuard::Fine(PointId point) const
{
  const SpacePoint& place = this->Points[std::size_t(point)];
  return { std::llround(place.X * PartsPerColumn), std::llround(place.Y * PartsPerColumn) };
}

//----------------------------------------------------------------------------------------------------------------------
bool OutlineGuard::IsIn(PointId point, const FinePoint& a, const FinePoint& m, const FinePoint& b) const
{
  const FinePoint p = this->Fine(point);
  const int sides[3] = { Turn(a, m, p), Turn(m, b, p), Turn(b, a, p) };
  const bool isInside = *std::min_element(sides, sides + 3) >= 0 || *std::max_element(sides, sides + 3) <= 0;
  // For a triangle without area the sides say nothing about how far out on its line the point is.
  return isInside && p.X >= std::min({ a.X, m.X, b.X }) && p.X <= std::max({ a.X, m.X, b.X }) &&
    p.Y >= std::min({ a.Y, m.Y, b.Y }) && p.Y <= std::max({ a.Y, m.Y, b.Y });
}

//----------------------------------------------------------------------------------------------------------------------
bool OutlineGuard::IsClear(PointId a, PointId m, PointId b) const
{
  const std::array<FinePoint, 3> corner = { this->Fine(a), this->Fine(m), this->Fine(b) };
  const std::array<SpacePoint, 3> triangle = { this->Points[std::size_t(a)], this->Points[std::size_t(m)],
    this->Points[std::size_t(b)] };
  const auto isIn = [&](PointId point)
  {
    return point != a && point != m && point != b && !this->Removed[std::size_t(point)] &&
      this->IsIn(point, corner[0], corner[1], corner[2]);
  };
  const auto y = std::minmax({ triangle[0].Y, triangle[1].Y, triangle[2].Y });
  // Row by row: a triangle can be long, but is thin.
  for (std::int64_t row = this->Grid.CellY(y.first); row <= this->Grid.CellY(y.second); ++row)
  {
    const Range range = RangeInRow(triangle, std::floor(y.first) + double(row - this->Grid.CellY(y.first)));
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
}
