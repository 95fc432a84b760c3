// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds spikes, far above or below all around, and narrow spurs, where tracking ran out over missing data.
//
// The deviation of a point is its height less the median of the heights around, moved along the dip to its column; the
// dip is the median difference between neighbours. Without a threshold, a spike exceeds four times the noise, and four
// times the median deviation around it, so that rough areas are compared with themselves. No full square wider than
// SpurWidth covers a spur (morphological opening).

#ifndef SeismicHorizonsDespiking_h
#define SeismicHorizonsDespiking_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct DespikingOptions
{
  /// Spikes deviate by more than this, in lattice units; 0 means four times the noise.
  double Threshold = 0.0;
  /// Points around lie within this number of columns along each axis.
  int Radius = 2;
  /// This is the largest width of a spur, in columns; 0 finds none.
  int SpurWidth = 0;
};

constexpr int LargestMedianRadius = 16;
constexpr int LargestSpurWidth = 64;

/// The point array Spike holds these values.
enum class SpikeKind : unsigned char
{
  None = 0,
  Spike = 1,
  Spur = 2
};

struct Spikes
{
  std::vector<SpikeKind> Kind; // by point
  double Threshold = 0.0; // as given or from the noise; 0 without points
};

/// Throws InputError if points share a column. Points with fewer than three around are no spikes; spikes on spurs are
/// spikes.
Spikes FindSpikes(PlanePoints columns, const std::vector<double>& heights, const DespikingOptions& options,
  const Monitor& monitor = Monitor());

/// Returns the root mean square of deviations at radius 2, in lattice units, clipped at four medians, and at least the
/// rounding of heights. Many points are sampled.
double MeasureNoise(PlanePoints columns, const std::vector<double>& heights);
}

#endif
