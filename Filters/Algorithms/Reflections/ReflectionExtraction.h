// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Extracts horizons from a seismic cube: reflections of each trace, strong picks, and surfaces of picks (thesis, 2.2.1,
// after Verney 2009).

#ifndef SeismicHorizonsReflectionExtraction_h
#define SeismicHorizonsReflectionExtraction_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/LatticeHorizon.h"
#include "GuideSeeds.h"
#include "GuidedJoining.h"
#include "ReflectionFinder.h"
#include "ReflectionLinks.h"
#include "TraceCube.h"
#include "WaveletPhase.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
enum class SurfaceJoining
{
  BestFirst, // best links first, if parts fit
  Components // all that touch, as in the thesis; one pick per column stays
};

enum class SurfaceOrder
{
  Strength, // sum of cubes; squares would rank side lobes higher
  Size
};

struct ExtractionOptions
{
  /// The phase of the wavelet is rotated by this, from -180 to 180 degrees.
  double PhaseRotation = 0.0;
  ReflectionOptions Reflections;
  SurfaceJoining Joining = SurfaceJoining::BestFirst;
  ColumnConnectivity Connectivity = ColumnConnectivity::Four;
  /// The step is in samples; 0 chooses 0.3 dominant periods, at least 2.
  double LargestStep = 0.0;
  /// Links need this fraction of the median, 0 to 1, except for Components.
  double SmallestCorrelation = 0.85;
  /// With BestFirst, joined parts need this fraction of linked pairs, 0 to 1.
  double SmallestContact = 0.5;
  std::int64_t SmallestSize = 0; // picks; 0 chooses a twentieth of the traces, 10 to 100
  std::int64_t LargestNumber = 100; // of surfaces, at least 1
  SurfaceOrder Order = SurfaceOrder::Strength;
  GuidanceOptions Guidance;
};

struct Extraction
{
  /// Surfaces of guides come first. RealZ is the fractional sample of a pick. Guided surfaces have attributes
  /// GuideDistance (columns), Confidence and Correlation, and labels Origin (PickOrigin), Block and Seed.
  std::vector<LatticeHorizon> Surfaces;
  std::vector<GuideUse> Guides;

  double HalfBand = 0.0; // around guides, in samples, if they alone were searched
  std::int64_t Samples = 0; // not missing
  std::int64_t Picks = 0; // above the threshold
  float Threshold = 0.0F; // of absolute amplitude
  double Period = 0.0; // in samples
  bool IsSmoothed = false;
  bool IsBiased = false; // Most amplitudes have one sign throughout half a trace.
  WaveletPhase Phase; // after rotation
  double LargestStep = 0.0; // in samples
  double MedianCorrelation = 0.0; // of all links, before any is dropped
  std::int64_t SmallestSize = 0; // as given or chosen
  std::int64_t NumberOfSurfaces = 0; // of at least this size
};

void CheckOptions(const ExtractionOptions& options);

/// Picks of a cube, and their links and surfaces, that guides share.
struct JoinedReflections;

/// With guides, all percentiles count. Throws InputError on options out of range, and on guides that do not fit.
/// Takes about 60 bytes per pick beside the result, 100 with guides. These leave what does not depend on them in `kept`,
/// about 80 bytes per pick, from which the next extraction starts, unless only bands around guides were searched. It must
/// have the same cube and limits.
Extraction ExtractReflections(const TraceCube& cube, const ExtractionOptions& options = ExtractionOptions(),
  const Monitor& monitor = Monitor(), const std::vector<Guide>& guides = {}, const TraceLimits& limits = TraceLimits(),
  std::shared_ptr<JoinedReflections>* kept = nullptr);
}

#endif
