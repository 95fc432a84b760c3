// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plane graph whose outer face is the boundary by clockwise growth (thesis Alg. 3.2) for any k.
//
// Taken literally the thesis's sweep can jump over itself. Here it only takes admissible hops, which never cross:
//  1. Direct hops: no third point is nearer to both ends than they are to each other (IsNearer in HopVectors.h). Two of
//     them never cross: if a-b and c-d do, then ac + bd < ab + cd and ad + bc < ab + cd, and whichever way the
//     distances fall, an end of one hop lies between the ends of the other. They include a shortest spanning tree, so
//     that they connect all that hops of at most k connect (the relative neighbourhood graph of Toussaint, 1980, in
//     the norm of the thesis's neighbourhoods).
//  2. Then all others in the order of their Euclidean length, each if it passes over no point and crosses no admissible
//     hop before it. Of two equally long hops that cross, the one the clockwise sweep from the south meets first wins.
//
//          . . c . . .
//          . . . . a .     k = 4: the hop c-d is shorter than a-b and crosses it. Were it taken first, b would be cut
//          . . . . . .     off, as c and d are more than four columns away from it. But a lies between c and d: c-d is
//          . . . . . d     not direct, a-b is.
//          . . . . . .
//          b . . . . .
//
// Hops to neighbours need no search: all are admissible, but for one of the two diagonals of four neighbouring points.
// Longer ones only lead from points beside an empty column to others. First the direct ones are found; what crosses one
// of these is out. What is left, a few hops per point, is tried in order of length, and compared with the admissible
// hops that touch the same unit squares.

#ifndef SeismicHorizonsPlanarHops_h
#define SeismicHorizonsPlanarHops_h

#include "ColumnRaster.h"
#include "Common/Monitor.h"
#include "HopCandidates.h"
#include "HopVectors.h"
#include "LongHops.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Time: for each point beside an empty column its rows of 2 k + 1 columns, and at most about k^2 for each point among
/// them that no neighbouring points hide. Memory: 4 bytes and a bit per column of the raster, 24 per hop and 8 per unit
/// square that it touches, about 2 k at most; and tables of about 8 k^4 bytes.
class PlanarHops
{
public:
  /// The raster holds `points` points and has an empty rim of at least 2 k columns. Keeps references to it and to
  /// `hops`.
  PlanarHops(const ColumnRaster& raster, std::size_t points, const HopVectors& hops, const Monitor& monitor);

  /// The first admissible hop from a place in a clockwise sweep that begins after `from` and ends with it; NoHop when
  /// there is none.
  HopId Next(std::int64_t place, HopId from) const;

  /// Numbers the hops of all points beside an empty column, one for each direction, from 0. Size() for other hops.
  std::size_t NumberOf(PointId point, HopId hop) const;
  std::size_t Size() const { return this->Listed.size(); }

private:
  /// A long hop between two points, in columns of the raster.
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

  void FindBorder();
  void AddDirectHops(const HopCandidates& candidates, const Monitor& monitor);
  void AddFurtherHops(const HopCandidates& candidates, const Monitor& monitor);
  template <typename Visitor>
  void ForEachCandidate(const HopCandidates& candidates, const Monitor& monitor, Visitor&& visit) const;
  bool IsDirect(const PlacedHop& hop) const;
  bool IsCrossed(const PlacedHop& hop) const;
  void Add(const PlacedHop& hop);
  void ListByPoint(std::size_t points);
  template <typename Visitor>
  void ForEachShortHop(std::int64_t place, Visitor&& visit) const;

  bool Has(std::int64_t place) const { return this->Raster[place] != NoPoint; }
  std::int64_t StartOf(const PlacedHop& hop) const { return hop.From.Y * this->Raster.Width() + hop.From.X; }

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  const LongHops Long;
  std::vector<HopId> Short; // those to the eight neighbours
  std::vector<HopId> Inner; // those of a point without an empty column beside it
  std::vector<std::int64_t> Border; // places of the points beside an empty column, row by row
  std::vector<bool> IsOnBorder; // the same by point
  // Only while hops are tried.
  std::vector<PlacedHop> Placed; // admissible long hops
  std::vector<std::int32_t> First; // of the links of each unit square
  std::vector<Link> Links;
  // The hops of all points on the border, point by point, each in the order of a sweep.
  std::vector<std::size_t> Starts;
  std::vector<HopId> Listed;
};
}

#endif
