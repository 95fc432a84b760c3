// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which long hops between points may be admissible (PlanarHops.h). One that passes over a point, or between two
// neighbouring points, is not. The points in a row of columns are bits of one number, and each point or pair of points
// near the start of hops rules out all hops whose ends, the columns in its shadow, are behind it:
//
//        . . # # # # .        *    the start of hops
//        . . # # # . .        a, b    two neighbouring points
//        . . a b . . .        #    their shadow: no hop from * leads between a and b to these columns, nor over one of
//        . . * . . . .             them

#ifndef SeismicHorizonsHopCandidates_h
#define SeismicHorizonsHopCandidates_h

#include "ColumnRaster.h"
#include "ExteriorBoundary.h"
#include "LongHops.h"
#include "PlaceSet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class HopCandidates
{
public:
  /// `points` holds the places of the raster that count as points here. The raster has an empty rim of at least k
  /// columns. Keeps references.
  HopCandidates(const ColumnRaster& raster, const PlaceSet& points, const HopVectors& hops, const LongHops& longHops);

  /// Calls visit(number) for the long hops from a place to another point that are not ruled out by points at most
  /// NearRadius columns away from it, by their numbers in LongHops and row by row. Takes about k steps for each point
  /// and pair of points that near, and one for each hop.
  template <typename Visitor>
  void ForEach(std::int64_t from, Visitor&& visit) const
  {
    Rows ends;
    this->FindEndsBeyondNearest(from, ends);
    if (this->Count(ends) > FewEnds)
    {
      this->RuleOut(this->NearRowsAt(from, NearRadius), ends);
    }
    for (std::int32_t row = 0; row <= this->Radius; ++row)
    {
      for (Window left = ends[std::size_t(row)]; left != 0; left &= left - 1)
      {
        visit(this->Long.NumberOf({ FirstColumn(left) - this->Radius, row }));
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
  // What is near is known by the bits of so many rows of five columns.
  static constexpr std::int32_t NearestRadius = 2;
  static constexpr int NearestBits = (NearestRadius + 1) * (2 * NearestRadius + 1);
  // So few are better tried than ruled out by what is farther away.
  static constexpr int FewEnds = 8;

  using NearRows = std::array<unsigned, NearRadius + 2>; // and an empty one above
  // What can rule out hops: a point and its neighbour after one of NeighbourSteps, or a point alone.
  static constexpr std::size_t Itself = NeighbourSteps.size();
  static constexpr std::size_t Kinds = Itself + 1;

  /// A bit for each of 2 k + 1 columns in a row, from the left.
  using Window = PlaceSet::Window;
  static constexpr std::size_t MostRows = LargestRadius + 1;
  /// One window for each row, from that of a place upwards.
  using Rows = std::array<Window, MostRows>;

  static std::int32_t FirstColumn(Window window)
  {
    const auto low = static_cast<std::uint64_t>(window);
    return low != 0 ? LowestBit(low) : PlaceSet::WordBits + LowestBit(std::uint64_t(window >> PlaceSet::WordBits));
  }

  /// The position in Shadows of a point, or of a pair of points that begins with it, at a vector from the start.
  static std::size_t Slot(std::size_t kind, std::int32_t x, std::int32_t y)
  {
    return (kind * (NearRadius + 1) + std::size_t(y)) * NearWidth + std::size_t(x + NearRadius);
  }

  /// The points around a place that are at most a radius away along x, in its row and those above, a bit each.
  NearRows NearRowsAt(std::int64_t from, std::int32_t radius) const;
  /// Takes those ends away that such points are in the way of.
  void RuleOut(const NearRows& near, Rows& ends) const;
  /// The points that long hops from a place lead to, without those that points at most two columns away are in the way
  /// of. In a horizon with few gaps that is a look into a table.
  void FindEndsBeyondNearest(std::int64_t from, Rows& ends) const;

  int Count(const Rows& rows) const
  {
    int count = 0;
    for (std::size_t row = 0; row <= std::size_t(this->Radius); ++row)
    {
      count += __builtin_popcountll(std::uint64_t(rows[row])) + __builtin_popcountll(std::uint64_t(rows[row] >> 64));
    }
    return count;
  }
  void AddToShadow(std::size_t kind, const PlanePoint& column, const PlanePoint& end);

  const ColumnRaster& Raster;
  const PlaceSet& Points;
  const LongHops& Long;
  const std::int32_t Radius;
  Rows Ends; // the ends of all long hops
  mutable std::vector<Rows> OpenByNearest; // the ends that the nearest points leave, for what was found so far
  mutable std::vector<std::int32_t> OpenNumbers; // in that list, by the bits of the nearest points; -1 for none
  std::vector<Rows> Shadows; // by slot: the ends of the hops that a point or a pair of points rules out
};
}

#endif
