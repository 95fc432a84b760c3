// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The links of a lattice and its corners. A link joins a column to its neighbour to the east (i + 1) or to the north
// (j + 1). A corner lies in the middle of two by two columns, or half a column outside the lattice. A cut of a link is
// a step from a corner to the next corner, across the link:
//
//       o     o         o  columns
//      p   n  q         n  link to the north of the column below, cut by the step from corner p to corner q
//       o     o

#ifndef SeismicHorizonsLinkGrid_h
#define SeismicHorizonsLinkGrid_h

#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Types.h"

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
/// The numbers are written to an array (Documentation/DataModel.md).
enum class LinkSide : unsigned char
{
  East = 0,
  North = 1
};

/// A link is identified by its column of lesser coordinates.
struct LatticeLink
{
  PlanePoint Column;
  LinkSide Side = LinkSide::East;

  PlanePoint Beyond() const
  {
    return this->Side == LinkSide::East ? PlanePoint{ this->Column.X + 1, this->Column.Y }
                                        : PlanePoint{ this->Column.X, this->Column.Y + 1 };
  }
  friend bool operator==(const LatticeLink& a, const LatticeLink& b)
  {
    return a.Column == b.Column && a.Side == b.Side;
  }
};

/// A forward line goes north across a link to the east, or east across a link to the north.
inline bool IsLeftBeyond(LinkSide side, bool isForward)
{
  return (side == LinkSide::North) == isForward;
}

/// Columns, links (east before north) and corners of a box are numbered row by row, including links to columns outside.
/// Numbers fit 64 bits for any box (PlaneGeometry.h), so that containers indexed by them must be sparse.
class LinkGrid
{
public:
  explicit LinkGrid(const PlaneBox& box)
    : Least(box.Least)
    , SizeX(std::int64_t(box.Greatest.X) - box.Least.X + 1)
    , SizeY(std::int64_t(box.Greatest.Y) - box.Least.Y + 1)
  {
  }

  std::int64_t Width() const { return this->SizeX; }
  std::int64_t Height() const { return this->SizeY; }
  std::int64_t NumberOfColumns() const { return this->SizeX * this->SizeY; }
  std::int64_t NumberOfLinks() const { return 2 * this->NumberOfColumns(); }

  const PlanePoint& Origin() const { return this->Least; }
  std::int64_t ColumnOf(const PlanePoint& column) const
  {
    return (std::int64_t(column.Y) - this->Least.Y) * this->SizeX + (std::int64_t(column.X) - this->Least.X);
  }

  static std::int64_t LinkOf(std::int64_t column, LinkSide side) { return 2 * column + std::int64_t(side); }
  std::int64_t LinkOf(std::int64_t x, std::int64_t y, LinkSide side) const { return LinkOf(y * this->SizeX + x, side); }
  static std::int64_t FirstColumn(std::int64_t link) { return link / 2; }
  static LinkSide SideOf(std::int64_t link) { return static_cast<LinkSide>(link % 2); }
  std::int64_t SecondColumn(std::int64_t link) const
  {
    return link / 2 + (SideOf(link) == LinkSide::East ? 1 : this->SizeX);
  }

  LatticeLink ToLink(std::int64_t link) const
  {
    const std::int64_t column = FirstColumn(link);
    return { { std::int32_t(this->Least.X + column % this->SizeX), std::int32_t(this->Least.Y + column / this->SizeX) },
      SideOf(link) };
  }

  bool IsInside(std::int64_t link) const
  {
    const std::int64_t column = FirstColumn(link);
    return SideOf(link) == LinkSide::East ? column % this->SizeX + 1 < this->SizeX
                                          : column / this->SizeX + 1 < this->SizeY;
  }

  std::int64_t CornerOf(std::int64_t x, std::int64_t y) const { return (y + 1) * (this->SizeX + 1) + x + 1; }
  std::int64_t CornerX(std::int64_t corner) const { return corner % (this->SizeX + 1) - 1; }
  std::int64_t CornerY(std::int64_t corner) const { return corner / (this->SizeX + 1) - 1; }

  /// A cut leads north across a link to the east, and east across a link to the north.
  std::array<std::int64_t, 2> CornersOf(std::int64_t link) const
  {
    const std::int64_t column = FirstColumn(link);
    const std::int64_t end = this->CornerOf(column % this->SizeX, column / this->SizeX);
    return { SideOf(link) == LinkSide::East ? end - (this->SizeX + 1) : end - 1, end };
  }

private:
  PlanePoint Least;
  std::int64_t SizeX;
  std::int64_t SizeY;
};

/// Lanes are the rows of a grid for links to the east, and its columns for links to the north.
struct Lanes
{
  const LinkGrid& Grid;
  LinkSide Side;

  bool IsEast() const { return this->Side == LinkSide::East; }
  Lanes Others() const { return { this->Grid, this->IsEast() ? LinkSide::North : LinkSide::East }; }

  std::int64_t Length() const { return this->IsEast() ? this->Grid.Width() : this->Grid.Height(); }
  std::int64_t Number() const { return this->Others().Length(); }

  std::int64_t Column(std::int64_t along, std::int64_t lane) const
  {
    return this->IsEast() ? lane * this->Grid.Width() + along : along * this->Grid.Width() + lane;
  }
  std::int64_t AlongOf(std::int64_t column) const
  {
    return this->IsEast() ? column % this->Grid.Width() : column / this->Grid.Width();
  }
  std::int64_t LaneOf(std::int64_t column) const { return this->Others().AlongOf(column); }

  std::int64_t Link(std::int64_t along, std::int64_t lane) const
  {
    return LinkGrid::LinkOf(this->Column(along, lane), this->Side);
  }
  /// Returns the link to the next lane.
  std::int64_t Across(std::int64_t along, std::int64_t lane) const
  {
    return LinkGrid::LinkOf(this->Column(along, lane), this->Others().Side);
  }
};
}

#endif
