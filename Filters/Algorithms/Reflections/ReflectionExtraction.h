// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a seismic cube to horizons: the reflections on each trace, the strong ones of them, one pick for each, and picks
// of neighbouring traces joined to surfaces (thesis, 2.2.1, after Verney 2009).

#ifndef SeismicHorizonsReflectionExtraction_h
#define SeismicHorizonsReflectionExtraction_h

#include "Common/LatticeHorizon.h"
#include "Common/Monitor.h"
#include "ReflectionFinder.h"
#include "ReflectionLinks.h"
#include "TraceCube.h"

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

struct ExtractionOptions
{
  ReflectionOptions Reflections;
  SurfaceJoining Joining = SurfaceJoining::BestFirst;
  ColumnConnectivity Connectivity = ColumnConnectivity::Four;
  /// From a pick to the next one of its surface, in samples: at least 0. 0: 0.3 of the dominant period, at least 2.
  double LargestStep = 0.0;
  /// Of two linked picks, as a part of the median over all links: 0 to 1. Components do not look at it.
  double SmallestCorrelation = 0.85;
  /// Of two parts that are joined (BestFirst): 0 to 1.
  double SmallestContact = 0.5;
  std::int64_t SmallestSize = 100; // of a surface, in picks: at least 1
  std::int64_t LargestNumber = 100; // of surfaces, at least 1: the largest ones
};

struct Extraction
{
  /// The largest one first; of equal ones the positive, then that of the first column. Voxels are by ascending j and
  /// then i. RealZ is the place of the pick in samples, and the vertical index the sample nearest to it.
  std::vector<LatticeHorizon> Surfaces;

  std::int64_t Samples = 0; // that are not missing
  std::int64_t Picks = 0; // that reach the threshold
  float Threshold = 0.0F; // of absolute amplitude
  double Period = 0.0; // the dominant one, in samples (ReflectionFinder.h)
  double LargestStep = 0.0; // in samples
  double MedianCorrelation = 0.0; // of links, before those of less than the smallest correlation are dropped
  std::int64_t NumberOfSurfaces = 0; // of the smallest size or more
};

/// Throws InputError when an option is out of range, those of the reflections included.
void CheckOptions(const ExtractionOptions& options);

/// Gives the same on any number of threads. Throws InputError on options out of range, and when FindReflections does.
/// Takes about 30 bytes per pick beside the result.
Extraction ExtractReflections(
  const TraceCube& cube, const ExtractionOptions& options = ExtractionOptions(), const Monitor& monitor = Monitor());
}

#endif
