// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins linked picks to surfaces, the best links first (Kruskal's order), as long as the parts fit (PartFit.h).
//
// What a link does depends on the two parts it leads between, and on nothing else. So it may be tried as soon as it is
// the best one left of both: what comes out is the same as by one list of all links. Links are tried in windows of the
// columns, each of which fits the cache of a processor, by several threads; those that have to wait for one that leads
// out of the window, in windows of more columns; and the last ones in one window of all.

#ifndef SeismicHorizonsBestFirstJoining_h
#define SeismicHorizonsBestFirstJoining_h

#include "ReflectionLinks.h"
#include "SurfaceSets.h"
#include "WindowJoining.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace SeismicHorizons
{
class BestFirstJoining
{
public:
  /// Of sets that are one pick each. `windowPicks`: about how many picks a window of the first level has. The result
  /// is the same with any number.
  BestFirstJoining(const ReflectionPicks& picks, SurfaceSets& sets, double windowPicks = 32000.0)
    : Picks(picks)
    , WindowPicks(windowPicks)
    , Sets(sets)
  {
  }

  /// Tries all links, the best ones first, and in the end once more those of parts that were refused. May be called
  /// again, with other links and rules.
  void Run(const ReflectionLinks& links, const JoiningRules& rules, const Monitor& monitor);

private:
  std::vector<JoiningWindow> MakeWindows(int side) const;
  std::vector<JoiningWindow> MergeWindows(std::vector<JoiningWindow>& windows, int side) const;
  int FirstSide() const;

  const ReflectionPicks& Picks;
  const double WindowPicks;
  SurfaceSets& Sets;
  bool AreSingle = true; // windows hold all sets
  std::unordered_map<PointId, ColumnSet> Columns; // of large sets
};
}

#endif
