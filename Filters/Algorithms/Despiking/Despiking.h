// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a horizon that do not belong to it: spikes, which are far above or below all around, and threads, by which
// tracking ran out over a gap.

#ifndef SeismicHorizonsDespiking_h
#define SeismicHorizonsDespiking_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct DespikingOptions
{
  /// A spike is more than so much above or below the median of the points around it. Lattice units.
  double Threshold = 4.0;
  /// How many columns along each axis points count as around.
  int Radius = 2;
  /// Strips and spurs that are at most so many columns wide are threads. 0: none are.
  int ThreadWidth = 0;
};

constexpr int LargestMedianRadius = 16;
constexpr int LargestThreadWidth = 64;

/// The values of the point array Spike.
enum class SpikeKind : unsigned char
{
  None = 0,
  Spike = 1,
  Thread = 2
};

/// What each point is; a spike on a thread is a spike. `columns` and `heights` have an entry for each point, no two
/// points in one column (InputError). A point with less than three others around is no spike: there is nothing to tell
/// it by. A point is of a thread when no full square of columns one wider than ThreadWidth covers it (a morphological
/// opening). Does not depend on the number of threads of the computer.
std::vector<SpikeKind> FindSpikes(PlanePoints columns, const std::vector<double>& heights,
  const DespikingOptions& options, const Monitor& monitor = Monitor());
}

#endif
