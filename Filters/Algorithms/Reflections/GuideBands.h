// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where horizons of guides can be, roughly, so that of a large cube only the traces near them are searched.
//
// Each guide is followed from column to column by the shift at which windows of traces are most alike, along the paths
// that lose least. Sweeps over rows, to and fro, find these paths (fast sweeping; Zhao 2005), so that a file is read in
// its order, and only some rows are in memory.

#ifndef SeismicHorizonsGuideBands_h
#define SeismicHorizonsGuideBands_h

#include "Common/Base/Monitor.h"
#include "GuidedJoining.h"
#include "TraceCube.h"

#include <vector>

namespace SeismicHorizons
{
struct BandOptions
{
  int HalfWidth = 15; // of windows, in samples
  int LargestStep = 3; // from column to column, in samples
};

/// Chooses one of each `step` rows, with a pick where there is one: a survey may lack most lines, and each second one in
/// particular.
std::vector<int> ChooseRows(int rows, int step, const std::vector<Guide>& guides);

/// Returns samples by guide and column, i fastest, everywhere: beyond faults and missing traces, guides go on level.
std::vector<std::vector<float>> FollowRoughly(
  const TraceCube& cube, const std::vector<Guide>& guides, const BandOptions& options, const Monitor& monitor);
}

#endif
