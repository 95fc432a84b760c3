// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Marks faulted links: each column has a bit for the link to the east (i + 1) and one for the link to the north (j +
// 1), even without points. Blocks of 8 by 8 columns with a cut are in a hash table with open addressing, at
// most a quarter full, so that nearly all look-ups end at the first key.

#ifndef SeismicHorizonsLinkCuts_h
#define SeismicHorizonsLinkCuts_h

#include "PlaneGeometry.h"
#include "Types.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class LinkCuts
{
public:
  /// Links of columns outside the box are never cut.
  explicit LinkCuts(const PlaneBox& box)
    : Box(box)
  {
  }

  void CutEast(const PlanePoint& column) { this->Take(column).East |= Bit(column); }
  void CutNorth(const PlanePoint& column) { this->Take(column).North |= Bit(column); }

  bool IsCutEast(const PlanePoint& column) const
  {
    const Block* const block = this->Find(column);
    return block && (block->East & Bit(column)) != 0;
  }
  bool IsCutNorth(const PlanePoint& column) const
  {
    const Block* const block = this->Find(column);
    return block && (block->North & Bit(column)) != 0;
  }

  bool IsCutBeside(const PlanePoint& column, const PlanePoint& step) const
  {
    const PlanePoint least = { std::min(column.X, column.X + step.X), std::min(column.Y, column.Y + step.Y) };
    const PlanePoint across = { least.X + std::abs(step.X), least.Y };
    const PlanePoint above = { least.X, least.Y + std::abs(step.Y) };
    return (step.X != 0 && (this->IsCutEast(least) || this->IsCutEast(above))) ||
      (step.Y != 0 && (this->IsCutNorth(least) || this->IsCutNorth(across)));
  }

  /// Calls visit(column, isEast) for each cut, in no particular order.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (std::size_t slot = 0; slot < this->Keys.size(); ++slot)
    {
      for (std::int32_t n = 0; this->Keys[slot] != NoKey && n < 64; ++n)
      {
        const auto first = [&](std::uint64_t part) { return std::int32_t(std::uint32_t(part) << 3); };
        const PlanePoint column{ first(this->Keys[slot]) + n % 8, first(this->Keys[slot] >> 32) + n / 8 };
        for (const bool isEast : { true, false })
        {
          if (((isEast ? this->Blocks[slot].East : this->Blocks[slot].North) & Bit(column)) != 0)
          {
            visit(column, isEast);
          }
        }
      }
    }
  }

private:
  struct Block
  {
    std::uint64_t East = 0;
    std::uint64_t North = 0;
  };

  // Real keys do not have the highest bits.
  static constexpr std::uint64_t NoKey = ~std::uint64_t(0);

  static std::uint64_t Bit(const PlanePoint& column)
  {
    return std::uint64_t(1) << (8 * (column.Y & 7) + (column.X & 7));
  }

  static std::uint64_t KeyOf(const PlanePoint& column)
  {
    return std::uint64_t(std::uint32_t(column.Y) >> 3) << 32 | std::uint32_t(column.X) >> 3;
  }

  /// A free slot must exist.
  std::size_t SlotOf(std::uint64_t key) const
  {
    // The golden ratio scatters consecutive keys (Knuth, 6.4).
    std::size_t slot = std::size_t((key * 0x9E3779B97F4A7C15U) >> 32) & this->Mask;
    while (this->Keys[slot] != key && this->Keys[slot] != NoKey)
    {
      slot = (slot + 1) & this->Mask;
    }
    return slot;
  }

  const Block* Find(const PlanePoint& column) const
  {
    if (!this->Box.Contains(column))
    {
      return nullptr;
    }
    const std::size_t slot = this->SlotOf(KeyOf(column));
    return this->Keys[slot] == NoKey ? nullptr : &this->Blocks[slot];
  }

  Block& Take(const PlanePoint& column)
  {
    assert(this->Box.Contains(column));
    const std::uint64_t key = KeyOf(column);
    std::size_t slot = this->SlotOf(key);
    if (this->Keys[slot] == NoKey)
    {
      if (4 * ++this->Taken > this->Keys.size())
      {
        this->Grow();
        slot = this->SlotOf(key);
      }
      this->Keys[slot] = key;
    }
    return this->Blocks[slot];
  }

  void Grow()
  {
    LinkCuts larger(this->Box);
    larger.Keys.assign(4 * this->Keys.size(), NoKey);
    larger.Blocks.resize(larger.Keys.size());
    larger.Mask = larger.Keys.size() - 1;
    larger.Taken = this->Taken;
    for (std::size_t slot = 0; slot < this->Keys.size(); ++slot)
    {
      if (this->Keys[slot] != NoKey)
      {
        const std::size_t place = larger.SlotOf(this->Keys[slot]);
        larger.Keys[place] = this->Keys[slot];
        larger.Blocks[place] = this->Blocks[slot];
      }
    }
    *this = std::move(larger);
  }

  PlaneBox Box;
  // Indexed by slot; the size is a power of two.
  std::vector<std::uint64_t> Keys = std::vector<std::uint64_t>(16, NoKey);
  std::vector<Block> Blocks = std::vector<Block>(16);
  std::size_t Mask = 15;
  std::size_t Taken = 0;
};
}

#endif
