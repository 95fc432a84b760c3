// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether two parts of surfaces fit together: they may not lie over each other, and where they face each other most of
// their picks have to be linked. A link that is wrong, across a fault or onto the next layer, leads between parts that
// face each other along a line with few links.

#ifndef SeismicHorizonsPartFit_h
#define SeismicHorizonsPartFit_h

#include "ColumnSet.h"
#include "ReflectionLinks.h"
#include "SurfaceSets.h"

#include <cstdint>
#include <functional>
#include <limits>
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
  /// Wider ones are joined nevertheless where they are linked by so many pairs, these are that part of those along
  /// which they face each other, and the mean waveforms of both sides correlate so much. Never without a correlation.
  std::int64_t FewestWidePairs = 10;
  double SmallestWideContact = 0.7;
  double SmallestWideCorrelation = 0.9;
  std::function<double(std::vector<Edge> pairs)> Correlate;
};

/// Reads nothing but the two parts, and their columns in the window: parts that have nothing in common may be looked at
/// by several threads.
class PartFit
{
public:
  PartFit(
    const ReflectionPicks& picks, const ReflectionLinks& links, const JoiningRules& rules, const SurfaceSets& sets)
    : Picks(picks)
    , Links(links)
    , Rules(rules)
    , Sets(sets)
  {
  }

  /// Whether two sets, the larger one first, may become one. If so, `shared` is how many columns both have. `columns`:
  /// those of the larger one, or null, where its picks are looked for.
  /// `window`: columns that hold both.
  bool MayJoin(
    PointId big, const ColumnSet* columns, PointId small, const ColumnWindow& window, std::int64_t& shared) const;

  const ReflectionPicks& Picks;
  const ReflectionLinks& Links;

private:
  struct Contact
  {
    std::int64_t Facing = 0; // pairs of picks
    std::int64_t Linked = 0;
  };

  template <typename HasColumn>
  bool MayJoin(
    PointId big, PointId small, const ColumnWindow& window, HasColumn&& hasColumn, std::int64_t& shared) const;
  bool IsEnough(PointId big, PointId small, const Contact& contact) const;
  /// From picks of the smaller set to those of the larger one.
  std::vector<Edge> ListPairs(PointId big, PointId small) const;

  const JoiningRules Rules;
  const SurfaceSets& Sets;
};
}

#endif
