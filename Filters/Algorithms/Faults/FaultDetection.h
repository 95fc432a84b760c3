// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds faults in a horizon: lines along which the heights of neighbouring columns differ by more than dip and noise.
//
//  1. Of each link, the height difference less the median of those around: its deviation.
//  2. Candidates are the links where that is at least `Low`, strong ones those where it is at least `High`; and the
//     links in the middle of gaps of a few missing columns whose two sides are as far apart.
//  3. Candidates join where their cuts meet in a corner, and over one or two links between where one of them ends. A
//     group stays when it has five strong candidates and is long enough.
//  4. Of a group the maximum spanning tree over its corners stays: the links of the largest steps, without loops. Short
//     branches are pruned. What is left is split into lines, the longest path through each tree first (FaultForest.h).
//
// So a fault that ends inside the horizon, or meets another one, is found; of one that closes upon itself, one link
// stays whole.

#ifndef SeismicHorizonsFaultDetection_h
#define SeismicHorizonsFaultDetection_h

#include "ColumnHeights.h"
#include "Common/Monitor.h"
#include "FaultLines.h"

namespace SeismicHorizons
{
struct FaultDetectionOptions
{
  double SmallestThrow = 4.0; // vertical indices
  double Noise = 0.0; // standard deviation of height differences in vertical indices; 0 to measure it
  int SmallestExtent = 20; // columns along i or j that a group spans
  int SmallestBranch = 10; // links
  int LargestGap = 5; // missing columns
  int LargestRamp = 7; // columns over which a fault bends the surface; 0 or 1 looks for steps alone
  bool JoinThroughHoles = true; // lines on both sides of a hole
};

/// Throws InputError on a throw or a noise that is negative or not finite, and on sizes below 0.
void CheckOptions(const FaultDetectionOptions& options);

struct FaultDetection
{
  FaultLines Lines;
  double Noise = 0.0; // as measured or given
  double Low = 0.0; // least size of a candidate's step
  double High = 0.0; // least size of a strong one's
};

/// Linear time; the result does not depend on the number of threads. About 16 bytes per column of the raster with the
/// heights, and 100 per candidate.
FaultDetection DetectFaults(
  const ColumnHeights& heights, const FaultDetectionOptions& options, const Monitor& monitor = Monitor());
}

#endif
