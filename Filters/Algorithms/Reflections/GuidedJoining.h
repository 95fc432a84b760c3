// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that follow picks of an interpreter. Parts of surfaces that were found without him are taken where his picks
// are on them, and what lies between and beyond grows from them, pick by pick.

#ifndef SeismicHorizonsGuidedJoining_h
#define SeismicHorizonsGuidedJoining_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A place that a horizon passes: a column, and the sample, to parts of one.
struct GuidePick
{
  int I = 0;
  int J = 0;
  double Place = 0.0;
};

/// What an interpreter picked of a horizon, in any order.
struct Guide
{
  std::string Name;
  std::vector<GuidePick> Picks;
};

struct GuidanceOptions
{
  /// How far a pick may be from the peak that it means, in samples: at least 0. 0: 0.2 of the dominant period, at
  /// least 1.5.
  double Tolerance = 0.0;
  /// What the waveforms of neighbouring picks correlate at least where a surface grows: 0 to 1.
  double GrowthCorrelation = 0.6;
  /// How far a surface grows from guides and parts of surfaces, in columns: at least 0. 0: not at all.
  int GrowthReach = 60;
  /// Whether the surfaces that no guide asked for come too, less what guided ones took.
  bool KeepOthers = false;
};

/// How a pick came to its surface.
enum class PickOrigin : std::uint8_t
{
  Guide, // it is what a pick of the guide means
  Part, // its part of a surface was taken
  Growth // it grew
};

/// A pick of a guide, and what it means.
struct GuideSeed
{
  PointId Pick = NoPoint;
  std::int32_t Column = 0;
  std::size_t Number = 0; // of the pick in the guide
};

struct GuidedPick
{
  PointId Pick = NoPoint;
  PickOrigin Origin = PickOrigin::Growth;
  int Distance = 0; // to the nearest column with a seed, in columns: the larger one of those along i and along j
};

struct GuidedSurface
{
  std::vector<GuidedPick> Picks; // by ascending column, one in each
  std::vector<std::size_t> Strays; // numbers of picks of the guide that the others contradict; they were not followed
};

class GuidedJoining
{
public:
  /// `surfaces`: of the picks, as BestFirstJoining gives them. `links`: of short waveforms, with diagonal neighbours.
  GuidedJoining(const ReflectionPicks& picks, const RawVector<PointId>& surfaces, const ReflectionLinks& links,
    double period, const GuidanceOptions& options);

  /// The surface of one guide, whose seeds are in different columns. The order of the seeds does not matter. May be
  /// called by several threads.
  GuidedSurface Follow(std::vector<GuideSeed> seeds) const;

private:
  class Follower;

  const ReflectionPicks& Picks;
  const RawVector<PointId>& Surfaces;
  const ReflectionLinks& Links;
  const GuidanceOptions Options;
  const Depth Quarter; // of the period: what is nearer is the same event
  RawVector<std::int32_t> Columns; // of picks
  std::vector<PointId> Starts; // of the members of each surface, by its label
  RawVector<PointId> Members; // of surfaces, ascending in each
};
}

#endif
