// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LoopGuard.h"

#include "Common/Predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
}

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
  const SpacePoint place = this->Points[std::size_t(point)];
  return { std::llround(place.X * PartsPerColumn), std::llround(place.Y * PartsPerColumn) };
}

//----------------------------------------------------------------------------------------------------------------------
RowSegment LoopGuard::Side(PointId a, PointId b) const
{
  const SpacePoint from = this->Points[std::size_t(a)];
  const SpacePoint to = this->Points[std::size_t(b)];
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
    return point != a && point != m && point != b && !this->Removed[std::size_t(point)] &&
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
}
