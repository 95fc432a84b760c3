// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins linked picks to surfaces, the best links first (Kruskal's order), as long as the parts fit: they may not lie
// over each other, and where they face each other most of their picks have to be linked. A link that is wrong, across a
// fault or onto the next layer, joins parts that face each other along a line with few links.

#ifndef SeismicHorizonsBestFirstJoining_h
#define SeismicHorizonsBestFirstJoining_h

#include "ReflectionLinks.h"
#include "SurfaceSets.h"

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
struct JoiningRules
{
  /// Of the smaller part's columns: so many may be shared with the other; its picks there are dropped.
  double LargestShare = 0.03;
  /// Of the pairs of picks, one of each part, in neighbouring columns: so many have to be linked.
  double SmallestContact = 0.5;
  /// Smaller parts than this need no contact.
  PointId ContactSize = 30;
  /// Smaller parts of that many picks or more are joined only when they are so many columns wide at most, on average
  /// along their contact.
  PointId LargestFilled = std::numeric_limits<PointId>::max();
  double LargestFilledWidth = 0.0;
};

class BestFirstJoining
{
public:
  BestFirstJoining(
    const ReflectionPicks& picks, const ReflectionLinks& links, const JoiningRules& rules, SurfaceSets& sets)
    : Picks(picks)
    , Links(links)
    , Rules(rules)
    , Sets(sets)
  {
  }

  /// Tries all links, the best ones first, and in the end once more those of parts that were refused.
  void Run(const Monitor& monitor);

private:
  /// Two picks that are linked.
  struct Pair
  {
    PointId From = NoPoint;
    PointId To = NoPoint;
  };

  void TryAll(const std::vector<LinkId>& links, const Monitor& monitor);
  /// False when the parts of the picks were refused.
  bool Try(const Pair& pair);
  bool MayJoin(PointId big, PointId small, std::int64_t& shared) const;
  bool FaceEachOther(PointId big, PointId small) const;
  bool WasRefused(PointId big, PointId small) const;

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;
  const JoiningRules Rules;
  SurfaceSets& Sets;

  std::unordered_map<std::uint64_t, std::int64_t> Refusals; // the size both had, by their numbers
  std::vector<LinkId> Refused;
};
}

#endif
