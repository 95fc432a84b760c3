// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a horizon in a block, continued beyond the faults that bound it.

#ifndef SeismicHorizonsBlockHeights_h
#define SeismicHorizonsBlockHeights_h

#include "BlockTree.h"
#include "Common/Base/Monitor.h"
#include "SealedModel.h"
#include "Sheets.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// The lattice of the box and some columns around it.
struct BlockLattice
{
  static constexpr int Margin = 4;

  explicit BlockLattice(const SealingInput& input)
    : Step(input.Step)
    , Least({ input.Least.X - Margin, input.Least.Y - Margin })
    , Width(input.Greatest.X - input.Least.X + 1 + 2 * Margin)
    , Height(input.Greatest.Y - input.Least.Y + 1 + 2 * Margin)
  {
  }

  std::size_t Size() const { return std::size_t(this->Width) * std::size_t(this->Height); }
  bool Contains(const PlanePoint& column) const
  {
    return column.X >= this->Least.X && column.Y >= this->Least.Y && column.X < this->Least.X + this->Width &&
      column.Y < this->Least.Y + this->Height;
  }
  std::size_t NodeOf(const PlanePoint& column) const
  {
    return std::size_t(column.Y - this->Least.Y) * std::size_t(this->Width) + std::size_t(column.X - this->Least.X);
  }
  Eigen::Vector2d At(std::size_t node) const
  {
    const auto width = std::size_t(this->Width);
    return { this->Step.x() * (double(node % width) + this->Least.X),
      this->Step.y() * (double(node / width) + this->Least.Y) };
  }

  bool IsInBox(std::size_t node) const
  {
    const int x = int(node) % this->Width, y = int(node) / this->Width;
    return x >= Margin && y >= Margin && x < this->Width - Margin && y < this->Height - Margin;
  }

  Eigen::Vector2d Step;
  PlanePoint Least;
  int Width;
  int Height;
};

struct BlockHeights
{
  std::size_t Horizon = 0;
  BlockSides Sides;
  std::vector<double> Heights; // by node; NaN beyond the block and its margin
  std::vector<double> Nearest; // the nearest of these
  std::vector<unsigned char> IsKnown; // by node
  std::size_t Known = 0; // nodes
  bool IsGuessed = false; // without enough picks
};

struct HorizonBlocks
{
  std::vector<BlockHeights> Blocks; // of all horizons in turn
  std::vector<PickAccount> Accounts; // by horizon
};

/// Throws InputError if a horizon has too few picks.
HorizonBlocks FindBlockHeights(
  const SealingInput& input, const SealingOptions& options, const Monitor& monitor = Monitor());
}

#endif
