// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reflections of seismic traces: runs of samples of one sign (thesis, 2.2.1), and the one place on each that stands for
// it, its pick.

#ifndef SeismicHorizonsReflection_h
#define SeismicHorizonsReflection_h

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// A place on a trace as an integer, so that steps between places are exact.
using Depth = std::int32_t;

/// How many of them a sample has.
constexpr Depth DepthsPerSample = 8192;

/// The most samples of a trace.
constexpr int MostSamples = (1 << 18) - 1;

/// Places are positive: rounding is that of (x + 1/2), cut off.
inline int NearestSample(Depth place)
{
  return (place + DepthsPerSample / 2) / DepthsPerSample;
}

inline double InSamples(Depth place)
{
  return double(place) / DepthsPerSample;
}

/// Which runs are taken.
enum class ReflectionPolarity
{
  Both,
  Positive,
  Negative
};

/// Where the pick of a run is.
enum class ReflectionPosition
{
  Middle, // of its samples at or above the threshold, as in the thesis
  Peak // at each local maximum of the absolute amplitude, to parts of a sample
};

struct Reflection
{
  Depth Place = 0;
  std::int32_t Thickness = 0; // of the run, in samples
  float Amplitude = 0.0F; // the mean over the run
  float Strength = 0.0F; // the absolute amplitude at the peak; in the middle, the largest one of the run
};

/// The reflections of one sign, column by column, i fastest, and downwards in each.
struct ReflectionPicks
{
  std::array<int, 2> Columns = { 0, 0 };
  /// Where the picks of each column begin; one more entry for the end of the last.
  std::vector<PointId> Starts;
  RawVector<Reflection> Picks;

  std::int64_t ColumnAt(int i, int j) const { return i + std::int64_t(this->Columns[0]) * j; }
  PointId Begin(std::int64_t column) const { return this->Starts[std::size_t(column)]; }
  PointId End(std::int64_t column) const { return this->Starts[std::size_t(column) + 1]; }
  PointId Size() const { return PointId(this->Picks.size()); }
  const Reflection& operator[](PointId pick) const { return this->Picks[std::size_t(pick)]; }

  /// The column of each pick.
  RawVector<std::int32_t> ListColumns() const
  {
    RawVector<std::int32_t> columns(this->Picks.size());
    for (std::size_t column = 0; column + 1 < this->Starts.size(); ++column)
    {
      std::fill(
        columns.begin() + this->Starts[column], columns.begin() + this->Starts[column + 1], std::int32_t(column));
    }
    return columns;
  }
};
}

#endif
