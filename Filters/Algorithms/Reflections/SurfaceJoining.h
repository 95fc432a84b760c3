// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins picks of a sign to surfaces (BestFirstJoining.cxx).

#ifndef SeismicHorizonsSurfaceJoining_h
#define SeismicHorizonsSurfaceJoining_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <limits>
#include <memory>

namespace SeismicHorizons
{
struct JoiningRules
{
  /// The smaller part may share this fraction of its columns; its picks there are dropped.
  double LargestShare = 0.03;
  /// This fraction of facing pairs in neighbouring columns must be linked.
  double SmallestContact = 0.5;
  /// Smaller parts need no contact.
  PointId ContactSize = 30;
  /// From this size on, smaller parts may only have this mean width, in columns, along their contact.
  PointId LargestFilled = std::numeric_limits<PointId>::max();
  double LargestFilledWidth = 0.0;
  /// Wider parts are joined if enough pairs link them, these cover this fraction of the facing pairs, and the mean
  /// waveforms correlate.
  std::int64_t FewestWidePairs = 10;
  double SmallestWideContact = 0.7;
  double SmallestWideCorrelation = 0.9;
  ContactCorrelation Correlate;
};

class BestFirstJoining
{
public:
  /// The result does not depend on windowPicks.
  explicit BestFirstJoining(const ReflectionPicks& picks, double windowPicks = 32000.0);
  ~BestFirstJoining();

  /// Refused links are tried again at the end. It may run again with other links and rules.
  void Run(const ReflectionLinks& links, const JoiningRules& rules, const Monitor& monitor);

  /// Returns the surface of each pick, named by one of its picks, or NoPoint for dropped picks.
  RawVector<PointId> TakeSurfaces();

private:
  struct Parts;

  const ReflectionPicks& Picks;
  const double WindowPicks;
  const std::unique_ptr<Parts> Joined;
};

/// Components have the number of their first pick, and may have several picks in a column (thesis, 2.2.1).
RawVector<PointId> FindConnectedPicks(const ReflectionPicks& picks, ColumnConnectivity connectivity,
  PickDepth largestStep, const Monitor& monitor = Monitor());
}

#endif
