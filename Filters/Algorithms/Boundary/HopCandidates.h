// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which long hops between points are worth a try. A hop is none when it passes over a point, or between two
// neighbouring ones. Points are looked up as bits, a row at a time, and what is near the start of a hop rules out most
// of its ends:
//
//        . . # # # # .
//        . . # # # . .        a and b are neighbouring points: from *, no hop leads between them, nor straight on over
//        . . a b . . .        one of them.
//        . . * . . . .

#ifndef SeismicHorizonsHopCandidates_h
#define SeismicHorizonsHopCandidates_h

#include "ColumnRaster.h"
#include "LongHops.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Memory: a bit per column of the raster.
class HopCandidates
{
public:
  /// The raster has an empty rim of at least k columns. Keeps references.
  HopCandidates(const ColumnRaster& raster, const HopVectors& hops, const LongHops& longHops);

  /// Calls visit(number) for the long hops from a column of the raster to another point, by their numbers and row by
  /// row, that no points at most NearRadius columns away are in the way of. Takes about k steps for each such point and
  /// pair of points, and one for each hop.
  template <typename Visitor>
  void ForEach(const PlanePoint& from, Visitor&& visit) const
  {
    Rows open = this->Ends;
    this->RuleOut(from, open);
    for (std::int32_t row = 0; row <= this->Radius; ++row)
    {
      Window ends = this->BitsAt(from.X - this->Radius, from.Y + row) & open[std::size_t(row)];
      for (; ends != 0; ends &= ends - 1)
      {
        visit(this->Long.NumberOf({ LowestBit(ends) - this->Radius, row }));
      }
    }
  }

  /// Whether a long hop passes neither over a point nor between two neighbouring ones.
  bool IsFree(std::int64_t place, const LongHop& hop) const
  {
    const auto has = [this, place](std::int64_t offset) { return this->Raster[place + offset] != NoPoint; };
    return std::none_of(hop.Gates.begin(), hop.Gates.end(),
             [&has](const Gate& gate) { return has(gate.Offset) && has(gate.OtherOffset); }) &&
      std::none_of(hop.Over.begin(), hop.Over.end(), has);
  }

private:
  static constexpr std::int32_t NearRadius = 3;
  static constexpr std::int32_t NearWidth = 2 * NearRadius + 1;
  // What can be in the way beside a column: itself, or it and the neighbour after one of the steps.
  static constexpr std::size_t Itself = NeighbourSteps.size();
  static constexpr std::size_t Kinds = Itself + 1;

  /// A bit for each of 2 k + 1 columns in a row, from the left.
  __extension__ typedef unsigned __int128 Window;
  static constexpr std::size_t MostRows = 33; // LargestRadius upwards, and the row of the place
  /// One for each row, from that of a place upwards.
  using Rows = std::array<Window, MostRows>;

  static std::int32_t LowestBit(Window window)
  {
    const auto low = static_cast<std::uint64_t>(window);
    return low != 0 ? __builtin_ctzll(low) : 64 + __builtin_ctzll(static_cast<std::uint64_t>(window >> 64));
  }

  /// The columns from a place to the right; at least the first 65 bits are valid.
  Window BitsAt(std::int64_t x, std::int64_t y) const
  {
    const std::uint64_t* const word = this->Words.data() + y * this->WordsPerRow + x / 64;
    const int shift = int(x % 64);
    const Window window = (Window(word[1]) << 64 | word[0]) >> shift;
    return shift == 0 ? window : window | Window(word[2]) << (128 - shift);
  }

  static std::size_t Slot(std::size_t kind, std::int32_t x, std::int32_t y)
  {
    return (kind * (NearRadius + 1) + std::size_t(y)) * NearWidth + std::size_t(x + NearRadius);
  }

  void RuleOut(const PlanePoint& from, Rows& open) const;
  void AddToShadow(std::size_t kind, const PlanePoint& column, const PlanePoint& end);

  const ColumnRaster& Raster;
  const LongHops& Long;
  const std::int32_t Radius;
  const std::int64_t WordsPerRow;
  std::vector<std::uint64_t> Words; // a bit per column, row by row, with room to read beyond the end
  Rows Ends; // of all long hops
  std::vector<Rows> Shadows; // by slot: the ends of the hops that something near the start is in the way of
};
}

#endif
