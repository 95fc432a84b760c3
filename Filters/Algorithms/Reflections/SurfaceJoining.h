// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Three ways to join the picks of a sign to surfaces: BestFirstJoining.cxx, ContinuousJoining.cxx, ConnectedPicks.cxx.

#ifndef SeismicHorizonsSurfaceJoining_h
#define SeismicHorizonsSurfaceJoining_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <limits>
#include <memory>

namespace SeismicHorizons
{
/// Which parts of surfaces may become one.
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
  /// which they face each other, and the mean waveforms of both sides correlate so much. Never without a correlation,
  /// which only a second run may have.
  std::int64_t FewestWidePairs = 10;
  double SmallestWideContact = 0.7;
  double SmallestWideCorrelation = 0.9;
  ContactCorrelation Correlate;
};

/// Joins picks by the best links first (Kruskal's order), as long as the parts fit.
class BestFirstJoining
{
public:
  /// `windowPicks`: about how many picks a window of the first level has. The result is the same with any number.
  explicit BestFirstJoining(const ReflectionPicks& picks, double windowPicks = 32000.0);
  ~BestFirstJoining();

  /// Tries all links, the best ones first, and in the end once more those of parts that were refused. May be called
  /// again, with other links and rules.
  void Run(const ReflectionLinks& links, const JoiningRules& rules, const Monitor& monitor);

  /// The surface of each pick, by the number of one of its picks; NoPoint for picks that were dropped.
  RawVector<PointId> TakeSurfaces();

private:
  struct Parts;

  const ReflectionPicks& Picks;
  const double WindowPicks;
  const std::unique_ptr<Parts> Joined;
};

/// Lets surfaces grow one after the other, each from the strongest pick that is left, over the best link of its rim,
/// onto picks in columns that it does not have yet (Prim's order). So strong events come out whole, through steep and
/// noisy places; and sometimes across faults. Gives the surface of each pick: the number of the pick it began with.
RawVector<PointId> JoinContinuously(
  const ReflectionPicks& picks, const ReflectionLinks& links, const Monitor& monitor = Monitor());

/// Joins all picks of neighbouring columns that are at most a step apart (thesis, 2.2.1). Gives the component of each
/// pick: the number of its first pick. A component may have several picks in a column.
RawVector<PointId> FindConnectedPicks(
  const ReflectionPicks& picks, ColumnConnectivity connectivity, Depth largestStep, const Monitor& monitor = Monitor());
}

#endif
