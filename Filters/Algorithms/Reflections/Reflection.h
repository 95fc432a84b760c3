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
#include <cstring>
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

/// A strength, which has no sign, by the upper half of its bits: they sort as strengths do, and tell them apart by less
/// than a hundredth.
inline std::uint16_t CoarseStrength(float strength)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &strength, sizeof(bits));
  return std::uint16_t(bits >> 16);
}

inline float StrengthOf(std::uint16_t coarse)
{
  const std::uint32_t bits = std::uint32_t(coarse) << 16;
  float strength = 0.0F;
  std::memcpy(&strength, &bits, sizeof(strength));
  return strength;
}

/// The reflections of one sign, column by column, i fastest, and downwards in each: what it takes to join them. The
/// rest is found once more for those that come out.
struct ReflectionPicks
{
  std::array<int, 2> Columns = { 0, 0 };
  /// Where the picks of each column begin; one more entry for the end of the last.
  std::vector<PointId> Starts;
  RawVector<Depth> Places;
  RawVector<std::uint16_t> Strengths; // coarse

  std::int64_t ColumnAt(int i, int j) const { return i + std::int64_t(this->Columns[0]) * j; }
  PointId Begin(std::int64_t column) const { return this->Starts[std::size_t(column)]; }
  PointId End(std::int64_t column) const { return this->Starts[std::size_t(column) + 1]; }
  PointId Size() const { return PointId(this->Places.size()); }
  Depth PlaceOf(PointId pick) const { return this->Places[std::size_t(pick)]; }
  std::uint16_t CoarseStrengthOf(PointId pick) const { return this->Strengths[std::size_t(pick)]; }

  /// Leaves where the picks of each column begin.
  void FreePicks()
  {
    this->Places = {};
    this->Strengths = {};
  }

  /// The column of each pick.
  RawVector<std::int32_t> ListColumns() const
  {
    RawVector<std::int32_t> columns(this->Places.size());
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
