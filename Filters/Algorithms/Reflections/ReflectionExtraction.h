// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a seismic cube to horizons: the reflections on each trace, the strong ones of them, one pick for each, and picks
// of neighbouring traces joined to surfaces (thesis, 2.2.1, after Verney 2009).

#ifndef SeismicHorizonsReflectionExtraction_h
#define SeismicHorizonsReflectionExtraction_h

#include "Common/LatticeHorizon.h"
#include "Common/Monitor.h"
#include "GuidedJoining.h"
#include "ReflectionFinder.h"
#include "ReflectionLinks.h"
#include "TraceCube.h"
#include "WaveletPhase.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// How picks become surfaces.
enum class SurfaceJoining
{
  BestFirst, // the best links first, where parts fit (BestFirstJoining.h)
  Continuous, // each surface as far as links lead (ContinuousJoining.h)
  Components // whatever touches, as in the thesis; of several picks in a column the strongest stays
};

/// Which surfaces come first.
enum class SurfaceOrder
{
  Strength, // those of the largest sum of cubed strengths: by squares, more side lobes are among the first
  Size // those of most columns
};

struct ExtractionOptions
{
  /// By how much the phase of the wavelet is turned before anything else, in degrees: -180 to 180.
  double PhaseRotation = 0.0;
  ReflectionOptions Reflections;
  SurfaceJoining Joining = SurfaceJoining::BestFirst;
  ColumnConnectivity Connectivity = ColumnConnectivity::Four;
  /// From a pick to the next one of its surface, in samples: at least 0. 0: 0.3 of the dominant period, at least 2.
  double LargestStep = 0.0;
  /// Of two linked picks, as a part of the median over all links: 0 to 1. Components do not look at it.
  double SmallestCorrelation = 0.85;
  /// Of two parts that are joined (BestFirst): 0 to 1.
  double SmallestContact = 0.5;
  std::int64_t SmallestSize = 0; // of a surface, in picks: at least 0; 0: a twentieth of the traces, 10 to 100
  std::int64_t LargestNumber = 100; // of surfaces, at least 1: the first ones
  SurfaceOrder Order = SurfaceOrder::Strength;
  GuidanceOptions Guidance;
};

/// What became of the picks of a guide.
struct GuideUse
{
  bool IsNegative = false; // the sign of the reflections that it means
  std::int64_t OtherSign = 0; // picks that mean a reflection of the other sign, better than one of this
  std::vector<std::size_t> Unused; // numbers of picks without a reflection of the sign in tolerance
  std::vector<std::size_t> Strays; // numbers of picks that the others contradict
  std::int64_t Shared = 0; // picks of the surface that belong rather to another guide
  std::size_t SharedWith = 0; // the first one of these
};

struct Extraction
{
  /// Those of guides in their order. Then the others in the order asked for; of equal ones the positive, then that of
  /// the first column. Voxels are by ascending j and then i. RealZ is the place of the pick in samples, and the
  /// vertical index the sample nearest to it. Those of guides have the attributes Origin (PickOrigin) and
  /// GuideDistance, to the nearest column with a pick of the guide, in columns.
  std::vector<LatticeHorizon> Surfaces;
  std::vector<GuideUse> Guides;

  std::int64_t Samples = 0; // that are not missing
  std::int64_t Picks = 0; // that reach the threshold
  float Threshold = 0.0F; // of absolute amplitude
  double Period = 0.0; // the dominant one, in samples (ReflectionFinder.h)
  WaveletPhase Phase; // after the rotation
  double LargestStep = 0.0; // in samples
  double MedianCorrelation = 0.0; // of links, before those of less than the smallest correlation are dropped
  std::int64_t SmallestSize = 0; // of a surface, as given or chosen
  std::int64_t NumberOfSurfaces = 0; // of that size or more
};

/// Throws InputError when an option is out of range, those of the reflections included.
void CheckOptions(const ExtractionOptions& options);

/// With guides, reflections of all percentiles count; with limits, those within these. Gives the same on any number of
/// threads, and in any order of the picks of a guide. Throws InputError on options out of range, when FindReflections
/// does, and on guides without picks, with some outside of the cube, with none near a reflection, or with two of them
/// that contradict each other in a column. Takes about 30 bytes per pick beside the result, and 90 with guides.
Extraction ExtractReflections(const TraceCube& cube, const ExtractionOptions& options = ExtractionOptions(),
  const Monitor& monitor = Monitor(), const std::vector<Guide>& guides = {}, const TraceLimits& limits = TraceLimits());
}

#endif
