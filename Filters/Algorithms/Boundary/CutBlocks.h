// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faulted links (LinkCuts.h) bar hops between columns. A block is a unit square with a column at each corner; its sides
// are links. Blocks with cut sides are open: long hops touch them with their ends only. A diagonal remains in a block
// with two adjacent cut sides. With one cut side, at the tip of a crack, both diagonals would remain and cross, so that
// none is kept and the graph of hops stays planar.
//
//       o---o     o   o     o---o     o   o       o              column
//       | /       | \       |   |     |   |       |, -, /, \     remaining hops
//       o   o     o---o     o   o     o   o
//       corner    corner    tip       opposite

#ifndef SeismicHorizonsCutBlocks_h
#define SeismicHorizonsCutBlocks_h

#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class CutBlocks
{
public:
  /// The index needs an empty rim of at least one column.
  CutBlocks(const LinkCuts& cuts, PlanePoints columns, const ColumnIndex& index);

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

  /// `step` must be a diagonal through an open block.
  bool LeavesDiagonal(std::int64_t place, const PlanePoint& step) const
  {
    return this->Has(this->BlockAt(place, step), step.X == step.Y ? RisingLeft : FallingLeft);
  }

  /// A block is identified by its least corner.
  bool IsOpen(std::int64_t block) const { return this->Has(block, Open); }

  bool IsBesideOpen(std::int64_t place) const { return this->Has(place, BesideOpen); }

  /// Bit n is set if place + n is a corner of an open block.
  std::uint64_t BesideOpenFrom(std::int64_t place) const;

private:
  enum Flag : unsigned char
  {
    CutEast = 1,
    CutNorth = 2,
    Open = 4,
    RisingLeft = 8, // to the north-east
    FallingLeft = 16, // to the south-east
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
