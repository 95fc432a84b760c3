// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds faults in a horizon: lines along which heights of neighbouring columns differ by more than dip and noise.
//
//  1. The deviation of a link is its height difference minus the median of differences around it.
//  2. Candidates have a deviation of at least `Low`, strong candidates of at least `High`; bands of a few missing
//     columns with such a throw have a candidate in their middle.
//  3. Candidates are connected if their cuts meet in a corner, or over one or two links at their ends. A group needs
//     five strong candidates and a minimum extent.
//  4. The maximum spanning tree of a group keeps the largest steps. Short branches are pruned, and the rest is split
//     into lines, longest path first (FaultForest.h).
//
// Faults that end inside the horizon or meet other faults are found. A closed fault keeps one whole link. Time is
// linear, memory is about 16 bytes per column of the raster and 100 per candidate.

#ifndef SeismicHorizonsFaultDetection_h
#define SeismicHorizonsFaultDetection_h

#include "ColumnHeights.h"
#include "Common/Base/Monitor.h"
#include "FaultLines.h"

#include <vector>

namespace SeismicHorizons
{
struct FaultDetectionOptions
{
  double SmallestThrow = 4.0; // This is in vertical indices.
  double Noise = 0.0; // This is in vertical indices, and measured if 0.
  int SmallestExtent = 20; // Extents, missing columns and ramps are in columns, branches in links.
  int SmallestBranch = 10;
  int LargestGap = 5;
  int LargestRamp = 7; // A fault bends the surface over at most this number of columns; 0 or 1 finds steps only.
  bool JoinThroughHoles = true;
};

/// Throws InputError for values that are negative or not finite.
void CheckOptions(const FaultDetectionOptions& options);

/// Terrain and tracking leave steps of a few times the noise, so that throws must be larger. The noise of differences is
/// measured if it is 0.
double ThrowAboveNoise(PlanePoints columns, const std::vector<double>& heights, double noiseOfDifferences);

struct FaultDetection
{
  FaultLines Lines;
  double Noise = 0.0;
  double Low = 0.0;
  double High = 0.0;
};

FaultDetection DetectFaults(
  const ColumnHeights& heights, const FaultDetectionOptions& options, const Monitor& monitor = Monitor());
}

#endif
