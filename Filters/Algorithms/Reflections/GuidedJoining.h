// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes surfaces that follow picks of an interpreter: parts of automatic surfaces where picks lie on them, and growth.

#ifndef SeismicHorizonsGuidedJoining_h
#define SeismicHorizonsGuidedJoining_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The sample may be fractional.
struct GuidePick
{
  int I = 0;
  int J = 0;
  double Place = 0.0;
};

/// Picks may be in any order.
struct Guide
{
  std::string Name;
  std::vector<GuidePick> Picks;
};

struct GuidanceOptions
{
  /// The distance to a peak is in samples; 0 chooses 0.2 dominant periods, at least 1.5.
  double Tolerance = 0.0;
  /// Neighbouring waveforms must correlate by this, 0 to 1.
  double GrowthCorrelation = 0.6;
  /// The reach is in columns; 0 disables growth.
  int GrowthReach = 1000;
  /// Picks of less confidence, 0 to 1, are dropped, except for given ones.
  double LeastConfidence = 0.0;
  /// Automatic surfaces are kept, without picks that guides took.
  bool KeepOthers = false;
  /// Cubes of more samples are searched near the guides alone, unless others are kept.
  std::int64_t LargestWhole = 100'000'000;
};

enum class PickOrigin : std::uint8_t
{
  Guide, // meant by a pick of the guide
  Part, // of an automatic surface
  Growth // grown
};

struct GuideSeed
{
  PointId Pick = NoPoint;
  std::int32_t Column = 0;
  std::size_t Number = 0; // of the pick in the guide

  friend bool operator==(const GuideSeed& a, const GuideSeed& b)
  {
    return a.Pick == b.Pick && a.Column == b.Column && a.Number == b.Number;
  }
};

struct GuidedPick
{
  PointId Pick = NoPoint;
  PickOrigin Origin = PickOrigin::Growth;
  int Distance = 0; // to the nearest seed, the larger of i and j
  float Confidence = 1.0F; // probability that it is right
  float Correlation = 1.0F; // largest with the nearest given picks, -1 to 1
  std::int32_t Block = 0; // from 1
  std::int32_t Seed = -1; // number of the given pick that is nearest along the block, -1 for none
};

struct GuidedSurface
{
  std::vector<GuidedPick> Picks; // one per column, ascending
  std::vector<std::size_t> Strays; // picks of the guide that contradict others; they are kept
  std::int64_t Doubtful = 0; // picks dropped for their confidence
  std::int64_t Seams = 0; // pairs of neighbours along i and j more than half a period apart where no fault is
  std::int64_t Stopped = 0; // empty columns just beyond the reach of growth
};

/// A guide that has been followed.
struct FollowedGuide
{
  std::vector<GuideSeed> Seeds;
  GuidedSurface Surface;
};

/// The picks of each automatic surface.
struct SurfaceMembers
{
  SurfaceMembers(const ReflectionPicks& picks, const RawVector<PointId>& surfaces);

  RawVector<std::int32_t> Columns; // by pick
  std::vector<PointId> Starts; // by label of the surface, into Picks
  RawVector<PointId> Picks;
};

class GuidedJoining
{
public:
  /// `surfaces` come from BestFirstJoining, and have the members. Picks are compared with given ones by waveforms of `halfWidth` samples.
  GuidedJoining(const TraceCube& cube, const ReflectionPicks& picks, const RawVector<PointId>& surfaces,
    const SurfaceMembers& members, const GrowthLinks& links, int halfWidth, double period,
    const GuidanceOptions& options);

  /// Seeds must be in different columns. Threads may call it in parallel.
  GuidedSurface Follow(std::vector<GuideSeed> seeds) const;

private:
  class Follower;

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  const RawVector<PointId>& Surfaces;
  const SurfaceMembers& Members;
  const GrowthLinks& Links;
  const int HalfWidth;
  const GuidanceOptions Options;
  const PickDepth Quarter; // period: nearer picks are the same event
};
}

#endif
