// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What faulted links (LinkCuts.h) leave of the hops between columns. A block is a unit square with a column at each
// corner; its sides are links.
//
//  - No hop leads along a faulted link.
//  - A diagonal is left when its ends are joined along sides of its block that are not cut, and not just one side is:
//
//        o---o       o---o       o   o       o | o       o | o        o    columns
//        |   |       | \         | \         |   |       |   |        |, --    links, or cuts across these
//        o---o       o | o       o---o       o---o       o | o
//        none        one corner  the same    one: tip    both parts
//
//    With the diagonals of a tip both would be left, and cross. So the block with the tip of a crack is open, and with
//    what is left the graph of hops is planar.
//  - Blocks with cut sides are open blocks: hops longer than to a neighbour touch none of them but with their ends.

#ifndef SeismicHorizonsCutBlocks_h
#define SeismicHorizonsCutBlocks_h

#include "Common/ColumnIndex.h"
#include "Common/LinkCuts.h"
#include "Common/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A byte for each column of a index.
class CutBlocks
{
public:
  /// The index is that of the columns, and has a rim of one at least.
  CutBlocks(const LinkCuts& cuts, PlanePoints columns, const ColumnIndex& index);

  /// Whether no hop may lead from a place to a neighbour, by the step there.
  bool IsBarred(std::int64_t place, const PlanePoint& step) const
  {
    if (step.X == 0)
    {
      return this->Has(step.Y > 0 ? place : place - this->Width, CutNorth);
    }
    if (step.Y == 0)
    {
      return this->Has(step.X > 0 ? place : place - 1, CutEast);
    }
    return this->IsOpen(this->BlockAt(place, step)) && !this->LeavesDiagonal(place, step);
  }

  /// Whether the diagonal of an open block that leads from a place by a step is left.
  bool LeavesDiagonal(std::int64_t place, const PlanePoint& step) const
  {
    return this->Has(this->BlockAt(place, step), step.X == step.Y ? RisingLeft : FallingLeft);
  }

  /// Whether a block, given by its least corner, has cut sides.
  bool IsOpen(std::int64_t block) const { return this->Has(block, Open); }

  /// Whether a column is a corner of an open block.
  bool IsBesideOpen(std::int64_t place) const { return this->Has(place, BesideOpen); }

  /// The columns that are corners of open blocks, of 64 places, a bit each.
  std::uint64_t BesideOpenFrom(std::int64_t place) const;

private:
  enum Flag : unsigned char
  {
    CutEast = 1,
    CutNorth = 2,
    Open = 4,
    RisingLeft = 8, // the diagonal to the north-east
    FallingLeft = 16, // that to the south-east
    BesideOpen = 32
  };

  bool Has(std::int64_t place, Flag flag) const { return (this->Flags[place] & flag) != 0; }
  void Add(std::int64_t place, unsigned flag) { this->Flags[place] |= static_cast<unsigned char>(flag); }
  std::int64_t BlockAt(std::int64_t place, const PlanePoint& step) const
  {
    return place - (step.X > 0 ? 0 : 1) - (step.Y > 0 ? 0 : this->Width);
  }
  void OpenBlock(std::int64_t block);

  std::int64_t Width;
  std::vector<unsigned char> Flags;
};
}

#endif
