// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Square cells over the bounding box of a horizon, and lists of what lies in each of them.

#ifndef SeismicHorizonsCellGrid_h
#define SeismicHorizonsCellGrid_h

#include "Types.h"

#include <algorithm>
#include <vector>

namespace SeismicHorizons
{
/// A place in sub-voxels that may lie between them.
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

/// Cells are half open: a point on the border of two belongs to the one of greater coordinates.
class CellGrid
{
public:
  /// Covers `points` (at least one), beginning at their least X and Y, rounded down to a multiple of `unit`.
  CellGrid(const std::vector<PlanePoint>& points, std::int32_t unit, std::int64_t cellSize);

  std::int64_t SizeX() const { return this->CellsX; }
  std::int64_t SizeY() const { return this->CellsY; }
  /// The side of a cell, at most 2^31 - 1.
  std::int64_t CellSize() const { return this->Side; }
  std::int64_t Size() const { return this->CellsX * this->CellsY; }

  /// The column and the row of cells at a coordinate; outside the box that of the nearest cell.
  std::int64_t CellX(double x) const { return Clamp(this->InCellsX(x), this->CellsX); }
  std::int64_t CellY(double y) const { return Clamp(this->InCellsY(y), this->CellsY); }

  /// A coordinate in units of cells from the least corner.
  double InCellsX(double x) const { return this->InCells(x - this->MinX); }
  double InCellsY(double y) const { return this->InCells(y - this->MinY); }

  /// The least corner of a cell.
  PlanePoint CornerOf(std::int64_t cellX, std::int64_t cellY) const
  {
    return { std::int32_t(this->MinX + cellX * this->Side), std::int32_t(this->MinY + cellY * this->Side) };
  }

  std::int64_t Index(std::int64_t cellX, std::int64_t cellY) const { return cellY * this->CellsX + cellX; }
  std::int64_t CellOf(const PlanePoint& p) const
  {
    // 32 bits are enough, and much quicker to divide by.
    const std::uint32_t size = std::uint32_t(this->Side);
    return this->Index(std::uint32_t(p.X - this->MinX) / size, std::uint32_t(p.Y - this->MinY) / size);
  }

  /// The least corner of a cell.
  PlanePoint Corner(std::int64_t cell) const
  {
    return { std::int32_t(this->MinX + cell % this->CellsX * this->Side),
      std::int32_t(this->MinY + cell / this->CellsX * this->Side) };
  }

  /// Calls visit(cell) for every cell the segment between two places touches, and at times for one it just misses.
  template <typename Visitor>
  void ForEachCellAlong(const SegmentEnd& from, const SegmentEnd& to, Visitor&& visit) const
  {
    const SegmentEnd& low = from.Y <= to.Y ? from : to;
    const SegmentEnd& high = from.Y <= to.Y ? to : from;
    const bool level = low.Y == high.Y;
    const double slope = level ? 0.0 : (high.X - low.X) / (high.Y - low.Y);
    const std::int64_t lastRow = this->CellY(high.Y);
    for (std::int64_t row = this->CellY(low.Y); row <= lastRow; ++row)
    {
      const double bottom = std::max(low.Y, double(this->MinY + row * this->Side));
      const double top = std::min(high.Y, double(this->MinY + (row + 1) * this->Side));
      const double x0 = low.X + slope * (bottom - low.Y);
      const double x1 = level ? high.X : low.X + slope * (top - low.Y);
      // Far more than rounding can amount to.
      constexpr double Slack = 0.001;
      const std::int64_t last = this->CellX(std::max(x0, x1) + Slack);
      for (std::int64_t column = this->CellX(std::min(x0, x1) - Slack); column <= last; ++column)
      {
        visit(this->Index(column, row));
      }
    }
  }

private:
  /// A product where that is exact, as it is for powers of two: a division takes several times as long.
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
  std::int64_t Side = 1; // below 2^31
  double Inverse = 0.0; // of Side, when that is a power of two
  std::int64_t CellsX = 0;
  std::int64_t CellsY = 0;
};

/// Lists of items, one list per cell, in one piece of memory. Within a list items keep the order they came in.
template <typename Item>
class CellLists
{
public:
  /// `forEach(add)` calls add(cell, item) for all items; it is run twice, and must do the same both times.
  template <typename ForEach>
  CellLists(std::int64_t cells, ForEach&& forEach)
    : Ends(std::size_t(cells) + 1, 0)
  {
    forEach([this](std::int64_t cell, const Item&) { ++this->Ends[std::size_t(cell) + 1]; });
    for (std::size_t cell = 1; cell < this->Ends.size(); ++cell)
    {
      this->Ends[cell] += this->Ends[cell - 1];
    }
    // Ends[cell] is now where the list begins, and moves to its end while it is filled.
    this->Items.resize(this->Ends.back());
    forEach([this](std::int64_t cell, const Item& item) { this->Items[this->Ends[std::size_t(cell)]++] = item; });
  }

  const Item* begin(std::int64_t cell) const { return this->Items.data() + (cell == 0 ? 0 : this->Ends[cell - 1]); }
  /// Whether the cells from one to another, both included, have nothing.
  bool AreEmpty(std::int64_t first, std::int64_t last) const { return this->begin(first) == this->end(last); }

  const Item* end(std::int64_t cell) const { return this->Items.data() + this->Ends[std::size_t(cell)]; }

private:
  std::vector<std::size_t> Ends;
  std::vector<Item> Items;
};

/// A piece of a boundary loop between two of its points.
struct BoundaryEdge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
};

using PointLists = CellLists<PointId>;
using EdgeLists = CellLists<BoundaryEdge>;

/// The points in each cell.
PointLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points);

/// The boundary edges that touch each cell, and at times some that just miss it.
EdgeLists SortByCell(const CellGrid& grid, const std::vector<PlanePoint>& points, const Loops& boundary);
}

#endif
