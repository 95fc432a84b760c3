// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plane graph whose faces are the loops of clockwise growth (thesis Alg. 3.2) for any k.
//
// Taken literally, the thesis's sweep can take hops that cross others it took before. Here it takes only admissible
// hops, which never cross:
//  1. Direct hops: no third point is nearer to both ends than they are to each other (IsNearer in Hops.h). Two of
//     them never cross: if a-b and c-d did, then ac + bd < ab + cd and ad + bc < ab + cd, from which it follows that
//     one of the four points is nearer to both ends of the other hop than these are to each other. Direct hops include
//     a shortest spanning tree, so that they connect all that hops of at most k connect (the relative neighbourhood
//     graph of Toussaint, 1980, in the norm of the thesis's neighbourhoods).
//  2. Then all others in the order of their Euclidean length, each if it passes over no point and crosses no admissible
//     hop before it. Of two that are equally long and cross, that which a clockwise sweep from the south meets first.
//
//          . . c . . .
//          . . . . a .     k = 4: the hop c-d is shorter than a-b and crosses it. Were it taken first, b would be cut
//          . . . . . .     off, as c and d are more than four columns away from it. But a lies between c and d: c-d is
//          . . . . . d     not direct, a-b is.
//          . . . . . .
//          b . . . . .
//
// Hops to neighbours need no search: all are admissible, but for one of the two diagonals of four neighbouring points.
// And the eight points around a single empty column let no other hops between them than that from south to north over
// the column:
//
//          a - a - a       a    points
//          | / | \ |       .    the empty column, under the hop
//          a   .   a
//          | \ | / |
//          a - a - a
//
// So longer hops are only looked for between points beside gaps, which are two or more empty columns side by side.
// First the direct ones are found, and hops that cross one of these are ruled out. The rest, a few per point, is tried
// in order of length, and each is compared with the admissible hops that touch the same unit squares.
//
// With faulted links, those hops are left out that these bar (CutBlocks.h), and points beside open blocks count as
// beside gaps. Points that only a barred hop connects are in different components then. With the hops across cuts,
// which are those that cuts alone keep from being admissible, the graph is plane, too.

#ifndef SeismicHorizonsPlanarHops_h
#define SeismicHorizonsPlanarHops_h

#include "Common/ColumnIndex.h"
#include "Common/CountingSort.h"
#include "Common/Monitor.h"
#include "CutBlocks.h"
#include "Hops.h"
#include "SeamGaps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class HopCandidates;

/// A hop from a place to a point, along a faulted link or over an open block (CutBlocks.h).
struct HopAcrossCut
{
  std::int64_t Place;
  HopId Hop;

  friend bool operator<(const HopAcrossCut& a, const HopAcrossCut& b)
  {
    return a.Place != b.Place ? a.Place < b.Place : a.Hop < b.Hop;
  }
};

/// Takes time, for each point beside a gap, for the rows of 2 k + 1 columns above it, and for each hop to a
/// point in these that is not ruled out at most about k^2. Takes memory for 4 bytes and 4 bits per column of the
/// index, 24 bytes per long hop and 8 per unit square that it touches, of which there are about 2 k at most; and
/// tables of about 8 k^4 bytes.
class PlanarHops
{
public:
  /// The index holds `points` points and has an empty rim of at least 2 k columns. Keeps references to it, to `hops`
  /// and to `gaps`, and to `cuts` when there are some.
  PlanarHops(const ColumnIndex& index, const HopVectors& hops, const SeamGaps& gaps, const CutBlocks* cuts,
    const Monitor& monitor);

  /// The places of the points beside gaps, row by row. Only these are on outlines, or on faces with columns inside.
  const std::vector<std::int64_t>& PlacesBesideGaps() const { return this->Border; }

  /// Calls visit(hop) for enough of the admissible hops from a place that those of all places connect what hops do.
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

  /// The first admissible hop from a place that a clockwise sweep after `from` meets, where `from` comes last; NoHop
  /// when there is none.
  HopId Next(std::int64_t place, HopId from) const;

  /// The hops from points beside gaps have numbers from 0 to below Size(). For other hops this is Size().
  std::size_t NumberOf(std::int64_t place, HopId hop) const;
  std::size_t Size() const { return this->Listed.Size(); }

  /// The hops across cuts, in both directions, by place and hop.
  const std::vector<HopAcrossCut>& HopsAcrossCuts() const { return this->Across; }

private:
  /// A long hop between two points, in columns of the index.
  struct PlacedHop
  {
    PlanePoint From;
    PlanePoint To;
    std::int32_t Number; // in the long hops
  };

  /// One of the hops that touch a unit square.
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
  const SeamGaps& Gaps; // the hops of their columns are those to the left and to the right
  const CutBlocks* const Cuts;
  const LongHops Long;
  std::vector<HopId> Short; // hops to the eight neighbours
  const HopId South; // the hops over a single empty column
  const HopId North;
  std::vector<std::int64_t> Border; // places of the points beside gaps, row by row
  PlaceNumbers BorderNumbers; // their positions in that list
  // Only while hops are tried.
  std::vector<PlacedHop> Placed; // admissible long hops, then those across cuts
  std::vector<std::int32_t> First; // for each unit square the first link of its list
  std::vector<Link> Links;
  // Then, for each point beside a gap, its admissible hops in the order of a sweep.
  ItemLists<HopId> Listed;
  std::vector<HopAcrossCut> Across;
};
}

#endif
