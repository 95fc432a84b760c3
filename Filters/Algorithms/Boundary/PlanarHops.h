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

#ifndef SeismicHorizonsPlanarHops_h
#define SeismicHorizonsPlanarHops_h

#include "ColumnRaster.h"
#include "HopVectors.h"

#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
/// Every question is answered from the points at most 2 k columns around, and answers that took long are remembered.
class PlanarHops
{
public:
  /// The raster has an empty rim of at least 2 k columns.
  PlanarHops(const ColumnRaster& raster, const HopVectors& hops);

  /// The first admissible hop from a place in a clockwise sweep that begins after `from` and ends with it; NoHop when
  /// there is none.
  HopId Next(std::int64_t place, HopId from);

  bool IsAdmissible(std::int64_t place, HopId hop);

private:
  /// A hop that crosses another one, and from where, as seen from the start of that one.
  struct Crossing
  {
    std::int64_t Offset;
    HopId Hop;
    bool IsBefore; // in the order of step 2
  };

  /// What can be in the way of a hop. Offsets are from its start.
  struct Obstacles
  {
    std::vector<std::int64_t> Over; // places the hop passes over
    std::vector<std::int64_t> Between; // places nearer to both of its ends than they are to each other
    std::vector<Crossing> Crossings; // shortest first: those are admissible most often
    bool HasCrossings = false; // they are found when they are first asked for
  };

  bool Has(std::int64_t place) const { return this->Raster[place] != NoPoint; }
  bool IsDirect(std::int64_t place, HopId hop) const;
  bool IsCrossed(std::int64_t place, HopId hop);
  bool IsBefore(HopId a, HopId b) const;
  void FindPlaces(HopId hop);
  void FindCrossings(HopId hop);

  const ColumnRaster& Raster;
  const HopVectors& Hops;
  std::vector<HopId> Rising; // hops upwards, or level to the right; every other one is the opposite of one of them
  std::vector<Obstacles> InTheWay; // of each rising hop
  std::unordered_map<std::int64_t, bool> Known; // by place and hop
};
}

#endif
