// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCellGrid_h
#define SeismicHorizonsCellGrid_h

#include "Common/Base/CountingSort.h"
#include "Types.h"

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
/// Coordinates may be fractions.
struct SegmentEnd
{
  double X;
  double Y;

  SegmentEnd(double x, double y)
    : X(x)
    , Y(y)
  {
  }
  SegmentEnd(const PlanePoint& p)
    : X(p.X)
    , Y(p.Y)
  {
  }
};

/// Widens ranges on a segment so that rounding omits no cell; with coordinates below 2^29 their ends are exact to
/// 10^-6.
constexpr double SegmentSlack = 1e-3;

class RowSegment
{
public:
  RowSegment(const SegmentEnd& a, const SegmentEnd& b)
    : Low(a.Y <= b.Y ? a : b)
    , High(a.Y <= b.Y ? b : a)
    , IsLevel(a.Y == b.Y)
    , Slope(this->IsLevel ? 0.0 : (this->High.X - this->Low.X) / (this->High.Y - this->Low.Y))
  {
  }

  double LeastY() const { return this->Low.Y; }
  double GreatestY() const { return this->High.Y; }

  struct Range
  {
    double First;
    double Last;
  };

  /// The segment must reach the range, which is widened by SegmentSlack.
  Range Between(double bottom, double top) const
  {
    const double x0 = this->Low.X + this->Slope * (std::max(bottom, this->Low.Y) - this->Low.Y);
    const double x1 =
      this->IsLevel ? this->High.X : this->Low.X + this->Slope * (std::min(top, this->High.Y) - this->Low.Y);
    return { std::min(x0, x1) - SegmentSlack, std::max(x0, x1) + SegmentSlack };
  }

private:
  const SegmentEnd Low;
  const SegmentEnd High;
  const bool IsLevel;
  const double Slope; // X per Y
};

/// Cells are half open: a point on an edge belongs to the cell of greater coordinates.
class CellGrid
{
public:
  /// Starts at the least X and Y of the points, rounded down to a multiple of `unit`.
  CellGrid(const std::vector<PlanePoint>& points, std::int32_t unit, std::int64_t cellSize);

  std::int64_t SizeX() const { return this->CellsX; }
  std::int64_t SizeY() const { return this->CellsY; }
  /// At most 2^31 - 1.
  std::int64_t CellSize() const { return this->Side; }
  std::int64_t Size() const { return this->CellsX * this->CellsY; }

  /// Coordinates outside the box give the nearest cell.
  std::int64_t CellX(double x) const { return Clamp(this->InCellsX(x), this->CellsX); }
  std::int64_t CellY(double y) const { return Clamp(this->InCellsY(y), this->CellsY); }

  double InCellsX(double x) const { return this->InCells(x - this->MinX); }
  double InCellsY(double y) const { return this->InCells(y - this->MinY); }

  PlanePoint CornerOf(std::int64_t cellX, std::int64_t cellY) const
  {
    return { std::int32_t(this->MinX + cellX * this->Side), std::int32_t(this->MinY + cellY * this->Side) };
  }

  PlanePoint Corner(std::int64_t cell) const { return this->CornerOf(cell % this->CellsX, cell / this->CellsX); }

  std::int64_t Index(std::int64_t cellX, std::int64_t cellY) const { return cellY * this->CellsX + cellX; }
  std::int64_t CellOf(const PlanePoint& p) const
  {
    // A 32-bit division is faster.
    const std::uint32_t size = std::uint32_t(this->Side);
    return this->Index(std::uint32_t(p.X - this->MinX) / size, std::uint32_t(p.Y - this->MinY) / size);
  }

  /// Calls visit(cell), row by row, for cells that the segment touches, and some that it misses by less than
  /// SegmentSlack.
  template <typename Visitor>
  void ForEachCellAlong(const SegmentEnd& from, const SegmentEnd& to, Visitor&& visit) const
  {
    const RowSegment segment(from, to);
    const std::int64_t lastRow = this->CellY(segment.GreatestY());
    for (std::int64_t row = this->CellY(segment.LeastY()); row <= lastRow; ++row)
    {
      const RowSegment::Range range =
        segment.Between(double(this->MinY + row * this->Side), double(this->MinY + (row + 1) * this->Side));
      const std::int64_t last = this->CellX(range.Last);
      for (std::int64_t column = this->CellX(range.First); column <= last; ++column)
      {
        visit(this->Index(column, row));
      }
    }
  }

private:
  /// For powers of two a product is exact and several times faster.
  double InCells(double distance) const
  {
    return this->Inverse > 0.0 ? distance * this->Inverse : distance / double(this->Side);
  }

  static std::int64_t Clamp(double cell, std::int64_t size)
  {
    return std::int64_t(std::min(std::max(cell, 0.0), double(size - 1)));
  }

  std::int64_t MinX = 0;
  std::int64_t MinY = 0;
  std::int64_t Side = 1;
  double Inverse = 0.0; // 1 / Side for powers of two, else 0
  std::int64_t CellsX = 0;
  std::int64_t CellsY = 0;
};

using PointLists = ItemLists<PointId>;
using EdgeLists = ItemLists<Edge>;

PointLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points);

/// May include edges that miss the cell by less than SegmentSlack.
EdgeLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points, const Loops& boundary);
}

#endif
