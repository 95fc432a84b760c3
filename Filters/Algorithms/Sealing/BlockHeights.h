// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a horizon in a block, continued beyond the faults that bound it.

#ifndef SeismicHorizonsBlockHeights_h
#define SeismicHorizonsBlockHeights_h

#include "BlockTree.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "SealedModel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Columns by row.
struct BlockWindow : PlaneBox
{
  std::size_t Width() const { return std::size_t(this->Greatest.X - this->Least.X + 1); }
  std::size_t Size() const { return this->Width() * std::size_t(this->Greatest.Y - this->Least.Y + 1); }
  std::size_t NodeOf(const PlanePoint& column) const
  {
    return std::size_t(column.Y - this->Least.Y) * this->Width() + std::size_t(column.X - this->Least.X);
  }
  PlanePoint ColumnOf(std::size_t node) const
  {
    return { this->Least.X + std::int32_t(node % this->Width()), this->Least.Y + std::int32_t(node / this->Width()) };
  }
  /// Calls visit(column, node).
  template <typename Visit>
  void ForEach(Visit&& visit) const
  {
    std::size_t node = 0;
    for (PlanePoint column = this->Least; column.Y <= this->Greatest.Y; ++column.Y)
    {
      for (column.X = this->Least.X; column.X <= this->Greatest.X; ++column.X)
      {
        visit(column, node++);
      }
    }
  }
  /// The nearest column of the window.
  PlanePoint Clamp(const PlanePoint& column) const
  {
    return { std::clamp(column.X, this->Least.X, this->Greatest.X),
      std::clamp(column.Y, this->Least.Y, this->Greatest.Y) };
  }
  /// Wider by some columns, within limits.
  BlockWindow Grown(std::int32_t columns, const BlockWindow& limits) const
  {
    BlockWindow grown;
    grown.Least = limits.Clamp({ this->Least.X - columns, this->Least.Y - columns });
    grown.Greatest = limits.Clamp({ this->Greatest.X + columns, this->Greatest.Y + columns });
    return grown;
  }
};

/// The box of the model and some columns around it.
inline BlockWindow WindowOf(const SealingInput& input, std::int32_t margin = 0)
{
  BlockWindow window;
  window.Least = { input.Least.X - margin, input.Least.Y - margin };
  window.Greatest = { input.Greatest.X + margin, input.Greatest.Y + margin };
  return window;
}

enum BlockNode : unsigned char // flags
{
  HasPick = 1, // that is used
  IsMeshed = 2, // in the block, or a few columns around
  IsShared = 4, // continued in another block, beyond the tips of a fault
  IsThere = 8 // in the block and in the walls
};

struct BlockHeights
{
  std::size_t Horizon = 0;
  BlockSides Sides;
  BlockWindow Window; // of all nodes that are meshed
  std::vector<double> Heights; // by node, beyond the block, too
  std::vector<unsigned char> Nodes; // flags
  std::size_t Known = 0; // picks
  bool IsGuessed = false; // without enough picks
  bool IsInBox = false; // somewhere

  double HeightNear(const PlanePoint& column) const
  {
    return this->Heights[this->Window.NodeOf(this->Window.Clamp(column))];
  }
  bool Has(const PlanePoint& column, BlockNode flag) const
  {
    return this->Window.Contains(column) && (this->Nodes[this->Window.NodeOf(column)] & flag) != 0;
  }
  bool HasPickNear(const PlanePoint& column, std::int32_t columns) const
  {
    bool isThere = false;
    for (std::int32_t y = column.Y - columns; y <= column.Y + columns && !isThere; ++y)
    {
      for (std::int32_t x = column.X - columns; x <= column.X + columns && !isThere; ++x)
      {
        isThere = this->Has({ x, y }, HasPick);
      }
    }
    return isThere;
  }
};

struct HorizonBlocks
{
  std::vector<BlockHeights> Blocks; // of all horizons in turn
  std::vector<PickAccount> Accounts; // by horizon
  std::vector<TipStep> Steps; // of faults that picks continue
};

/// Where picks step beyond the tips of a fault, its tip loop grows around them. Throws InputError if a horizon has too few
/// picks.
HorizonBlocks FindBlockHeights(SealingInput& input, const SealingOptions& options, const Monitor& monitor = Monitor());
}

#endif
