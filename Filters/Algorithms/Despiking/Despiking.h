// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points of a horizon that do not belong to it: spikes, which are far above or below all around, and narrow spurs,
// where tracking ran out over missing data.

#ifndef SeismicHorizonsDespiking_h
#define SeismicHorizonsDespiking_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
struct DespikingOptions
{
  /// A spike is more than so much above or below the points around it. Lattice units. 0: four times the noise.
  double Threshold = 0.0;
  /// How many columns along each axis points count as around.
  int Radius = 2;
  /// The largest width of a spur, in columns. 0: none are looked for.
  int SpurWidth = 0;
};

constexpr int LargestMedianRadius = 16;
constexpr int LargestSpurWidth = 64;

/// The values of the point array Spike.
enum class SpikeKind : unsigned char
{
  None = 0,
  Spike = 1,
  Spur = 2
};

struct Spikes
{
  std::vector<SpikeKind> Kind; // of each point
  double Threshold = 0.0; // as given, or the least one that followed from the noise; 0 without points
};

/// `columns` and `heights` have an entry for each point, no two points in one column (InputError).
///
/// The deviation of a point is its height less the median of those around, each taken along the dip to the column of
/// the point; the dip along an axis is the median of the differences between neighbours around. A point with less than
/// three others around has none, and is no spike: there is nothing to tell it by. Without a threshold, a spike deviates
/// by more than four times the noise of all points, and four times the median deviation of the points around it from
/// the same plane, so that rough places are compared with themselves.
///
/// A point is on a spur when no full square of columns one wider than SpurWidth covers it (a morphological opening); a
/// spike on a spur is a spike. Does not depend on the number of threads.
Spikes FindSpikes(PlanePoints columns, const std::vector<double>& heights, const DespikingOptions& options,
  const Monitor& monitor = Monitor());

/// The noise of heights, in lattice units: the root mean square of their deviations as above, with a radius of 2, those
/// above four times the median clipped; of heights that are whole, or multiples of less, at least what rounding does.
/// Of many points a part is looked at. 0 without points.
double MeasureNoise(PlanePoints columns, const std::vector<double>& heights);
}

#endif
