// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plane graph whose faces are the loops of clockwise growth (thesis Alg. 3.2) for any k. The sweep of the thesis may
// take hops that cross earlier hops. Here it takes admissible hops only, which never cross:
//  1. Direct hops: no third point is nearer to both ends than these are to each other (IsNearer in Hops.h). If direct
//     hops a-b and c-d crossed, then ac + bd < ab + cd and ad + bc < ab + cd, so that one of the four points would be
//     nearer to both ends of the other hop. Direct hops include a minimum spanning tree and thus connect all points
//     that hops connect (relative neighbourhood graph of Toussaint, 1980, in the norm of the thesis).
//  2. Other hops by Euclidean length, then in the order of a clockwise sweep from the south, if they pass over no point
//     and cross no hop admitted before.
//
//         . . c . . .
//         . . . . a .     k = 4: hop c-d is shorter than a-b and crosses it. If c-d came first, b would be cut off, as
//         . . . . . .     it is more than four columns from c and d. But a lies between c and d: c-d is not direct, and
//         . . . . . d     a-b is.
//         . . . . . .
//         b . . . . .
//
// All hops to neighbours are admissible, except one of the two diagonals of four points. The eight points around a
// single empty column admit only one longer hop, from south to north:
//
//         a - a - a       a    points
//         | / | \ |       .    empty column, under the hop
//         a   .   a
//         | \ | / |
//         a - a - a
//
// Therefore long hops are only tried between points beside two or more adjacent empty columns. Direct hops come first;
// the rest, a few per point, is tried by length against admissible hops in the same unit squares.
//
// With faulted links, barred hops are left out (CutBlocks), and points beside open blocks count as beside empty
// columns. The graph stays plane with hops across cuts, which only cuts keep from being admissible.

#ifndef SeismicHorizonsPlanarHops_h
#define SeismicHorizonsPlanarHops_h

#include "Common/Base/CountingSort.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/ColumnIndex.h"
#include "Common/Horizon/LinkCuts.h"
#include "Common/Horizon/Types.h"
#include "ExteriorBoundary.h"
#include "Hops.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
// Faulted links (LinkCuts.h) bar hops between columns. A block is a unit square with a column at each corner; its sides
// are links. Blocks with cut sides are open: long hops touch them with their ends only. A diagonal remains in a block
// with two adjacent cut sides. With one cut side, at the tip of a crack, both diagonals would remain and cross, so that
// none is kept and the graph of hops stays planar.
//
//       o---o     o   o     o---o     o   o       o              column
//       | /       | \       |   |     |   |       |, -, /, \     remaining hops
//       o   o     o---o     o   o     o   o
//       corner    corner    tip       opposite
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

class HopCandidates;

/// The hop follows a faulted link or crosses an open block (CutBlocks).
struct HopAcrossCut
{
  std::int64_t Place;
  HopId Hop;

  friend bool operator<(const HopAcrossCut& a, const HopAcrossCut& b)
  {
    return a.Place != b.Place ? a.Place < b.Place : a.Hop < b.Hop;
  }
};

/// Each point beside empty columns takes time for the rows of 2 k + 1 columns above it, and about k^2 per remaining
/// hop. Memory is 4 bytes and 4 bits per column of the index, 24 bytes per long hop, and 8 per unit square touched
/// (about 2 k per hop).
class PlanarHops
{
public:
  /// The index needs an empty rim of at least 2 k columns. The object keeps references; `cuts` may be null.
  PlanarHops(const ColumnIndex& index, const HopVectors& hops, const CutBlocks* cuts, const Monitor& monitor);

  /// Only these places are on outlines, or on faces with columns inside.
  const std::vector<std::int64_t>& PlacesBesideGaps() const { return this->Border; }

  /// The hops visited from all places together connect all points that hops connect.
  template <typename Visitor>
  void ForEachConnection(std::int64_t place, Visitor&& visit) const
  {
    const std::int64_t number = this->BorderNumbers[place];
    if (number != PlaceNumbers::None)
    {
      std::for_each(this->Listed.begin(number), this->Listed.end(number), visit);
      return;
    }
    for (const PlanePoint& step : { PlanePoint{ 1, 0 }, PlanePoint{ 0, 1 } })
    {
      if (this->Has(place + this->Hops.OffsetOf(step)))
      {
        visit(this->Hops.Find(step));
      }
    }
  }

  /// Returns the first hop after `from` in a clockwise sweep, `from` last; NoHop if there is none.
  HopId Next(std::int64_t place, HopId from) const;

  /// Hops from points beside empty columns are numbered below Size(); for any other hop this returns Size().
  std::size_t NumberOf(std::int64_t place, HopId hop) const;
  std::size_t Size() const { return this->Listed.Size(); }

  const std::vector<HopAcrossCut>& HopsAcrossCuts() const { return this->Across; }

private:
  struct PlacedHop
  {
    PlanePoint From;
    PlanePoint To;
    std::int32_t Number; // in Long
  };

  struct Link
  {
    std::int32_t Hop;
    std::int32_t Next;
  };

  PlaceSet FindBorder();
  void AddDirectHops(const HopCandidates& candidates, const Monitor& monitor);
  std::vector<PlacedHop> AddFurtherHops(const HopCandidates& candidates, const Monitor& monitor);
  template <typename Visitor>
  void ForEachCandidate(const HopCandidates& candidates, const Monitor& monitor, Visitor&& visit) const;
  bool IsDirect(const PlacedHop& hop) const;
  bool IsCrossed(const PlacedHop& hop) const;
  void Add(const PlacedHop& hop);
  void AddUncrossed(std::vector<PlacedHop>& hops, const Monitor& monitor);
  ItemLists<HopId> ListByPoint(std::size_t admissible) const;
  std::vector<HopAcrossCut> ListAcross(std::size_t admissible) const;
  bool IsShortAcross(std::int64_t place, const PlanePoint& step) const;
  template <typename Visitor>
  void ForEachShortHop(std::int64_t place, Visitor&& visit) const;
  HopId NextShort(std::int64_t place, HopId from) const;
  bool IsAdmissible(std::int64_t place, const PlanePoint& step) const;
  bool IsSingleGap(std::int64_t place) const;
  bool IsOverCut(const PlacedHop& hop) const;

  bool Has(std::int64_t place) const { return this->Index.Has(place); }
  std::int64_t StartOf(const PlacedHop& hop) const { return hop.From.Y * this->Index.Width() + hop.From.X; }

  const ColumnIndex& Index;
  const HopVectors& Hops;
  const CutBlocks* const Cuts;
  const LongHops Long;
  const HopId South; // These hops pass over a single empty column.
  const HopId North;
  std::vector<std::int64_t> Border;
  PlaceNumbers BorderNumbers; // positions in Border
  // These exist only while hops are tried.
  std::vector<PlacedHop> Placed; // Admissible hops come first, then hops across cuts.
  std::vector<std::int32_t> First; // by unit square
  std::vector<Link> Links;
  ItemLists<HopId> Listed; // then, by point of Border, in the order of a sweep
  std::vector<HopAcrossCut> Across;
};
}

#endif
