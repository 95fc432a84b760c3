// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds strong reflections of a seismic cube (thesis, 2.2.1). A reflection is a run of samples of one sign, with a pick
// at its middle or peak, or a zero crossing between two runs, positive where amplitudes become so.

#ifndef SeismicHorizonsReflectionFinder_h
#define SeismicHorizonsReflectionFinder_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"
#include "TraceCube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace SeismicHorizons
{
/// Places on a trace are integers, so that steps are exact.
using PickDepth = std::int32_t;

constexpr PickDepth DepthsPerSample = 8192;

constexpr int MostSamples = (1 << 18) - 1;

/// Places are positive, so this rounds half up.
inline int NearestSample(PickDepth place)
{
  return (place + DepthsPerSample / 2) / DepthsPerSample;
}

inline double InSamples(PickDepth place)
{
  return double(place) / DepthsPerSample;
}

inline PickDepth InDepths(double samples)
{
  return PickDepth(std::lround(samples * DepthsPerSample));
}

enum class ReflectionPolarity
{
  Both,
  Positive,
  Negative
};

enum class ReflectionPosition
{
  Middle, // of samples at or above the threshold, as in the thesis
  Peak, // at each local maximum of the absolute amplitude, interpolated
  ZeroCrossing // interpolated between two runs
};

struct Reflection
{
  PickDepth Place = 0;
  std::int32_t Thickness = 0; // of the run, in samples; the mean of both at a zero crossing
  float Amplitude = 0.0F; // mean of the run; half the difference of both peaks at a zero crossing
  /// At a peak this is its absolute amplitude, for Middle the largest of the run, at a zero crossing the absolute
  /// Amplitude.
  float Strength = 0.0F;
};

struct ReflectionRules
{
  ReflectionPolarity Polarity = ReflectionPolarity::Both;
  ReflectionPosition Position = ReflectionPosition::Peak;
  /// Middle ends runs below this absolute amplitude.
  float SampleThreshold = 0.0F;
};

/// Runs end at samples that are 0, NaN or below the threshold. Equal samples peak in their middle, samples beside an
/// end or a missing sample at themselves, the rest at the vertex of a parabola. One 0 may be a crossing.
void FindReflections(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found);

struct TraceLimits
{
  bool AreNone() const { return this->First.empty(); }
  /// Returns false if a limit is NaN.
  bool Contain(std::int64_t column, PickDepth place) const
  {
    const double sample = InSamples(place);
    const auto isNear = [&](const std::vector<float>& middle)
    { return std::abs(sample - double(middle[column])) <= this->HalfBand; };
    return (this->AreNone() || (this->First[column] <= sample && sample <= this->Last[column])) &&
      (this->Middles.empty() || std::any_of(this->Middles.begin(), this->Middles.end(), isNear));
  }

  /// Limits are in samples, by column, i fastest; empty limits mean whole traces.
  std::vector<double> First;
  std::vector<double> Last;
  /// Bands around any of these count, if there are some.
  std::vector<std::vector<float>> Middles;
  double HalfBand = 0.0;
};

void LeaveOutBeyond(
  const TraceLimits& limits, std::int64_t column, std::size_t first, std::vector<Reflection>& reflections);

/// The upper half of the bits sorts like strengths, to less than a hundredth.
inline std::uint16_t CoarseStrength(float strength)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &strength, sizeof(bits));
  return std::uint16_t(bits >> 16);
}

/// Picks are in order of columns, i fastest, then downwards. Other values are found again for the picks that come out.
struct ReflectionPicks
{
  std::array<int, 2> Columns = { 0, 0 };
  /// An additional entry ends the last column.
  std::vector<PointId> Starts;
  RawVector<PickDepth> Places;
  RawVector<std::uint16_t> Strengths; // coarse

  std::int64_t ColumnAt(int i, int j) const { return i + std::int64_t(this->Columns[0]) * j; }
  int IOf(std::int32_t column) const { return column % this->Columns[0]; }
  int JOf(std::int32_t column) const { return column / this->Columns[0]; }

  PointId Begin(std::int64_t column) const { return this->Starts[column]; }
  PointId End(std::int64_t column) const { return this->Starts[column + 1]; }
  PointId Size() const { return PointId(this->Places.size()); }
  float StrengthOf(PointId pick) const
  {
    const std::uint32_t bits = std::uint32_t(this->Strengths[pick]) << 16;
    float strength = 0.0F;
    std::memcpy(&strength, &bits, sizeof(strength));
    return strength;
  }

  template <typename Visit>
  void ForEach(Visit&& visit) const
  {
    for (std::size_t column = 0; column + 1 < this->Starts.size(); ++column)
    {
      for (PointId pick = this->Starts[column]; pick < this->Starts[column + 1]; ++pick)
      {
        visit(pick, std::int32_t(column));
      }
    }
  }

  template <typename Visit>
  void ForEachPair(std::int64_t columnA, std::int64_t columnB, PickDepth largestStep, Visit&& visit) const
  {
    PointId low = this->Begin(columnB);
    const PointId endA = this->End(columnA);
    const PointId endB = this->End(columnB);
    for (PointId a = this->Begin(columnA); a < endA; ++a)
    {
      const PickDepth place = this->Places[a];
      while (low < endB && this->Places[low] < place - largestStep)
      {
        ++low;
      }
      for (PointId b = low; b < endB && this->Places[b] <= place + largestStep; ++b)
      {
        visit(a, b);
      }
    }
  }

  std::int32_t ColumnOf(PointId pick) const
  {
    return std::int32_t(std::upper_bound(this->Starts.begin(), this->Starts.end(), pick) - this->Starts.begin()) - 1;
  }

  RawVector<std::int32_t> ListColumns() const
  {
    RawVector<std::int32_t> columns(this->Places.size());
    this->ForEach([&columns](PointId pick, std::int32_t column) { columns[pick] = column; });
    return columns;
  }

  /// Starts remain.
  void FreePicks()
  {
    this->Places = {};
    this->Strengths = {};
  }
};

enum class ThresholdKind
{
  Amplitude,
  Percentile // of the magnitudes of samples of the polarity, other than 0
};

struct ReflectionOptions
{
  ReflectionPolarity Polarity = ReflectionPolarity::Both;
  ReflectionPosition Position = ReflectionPosition::Peak;
  ThresholdKind Threshold = ThresholdKind::Percentile;
  double AmplitudeThreshold = 0.0; // at least 0
  double AmplitudePercentile = 40.0; // 0 to 100
};

void CheckOptions(const ReflectionOptions& options);

struct CubeReflections
{
  std::array<ReflectionPicks, 2> BySign; // positive, negative
  std::int64_t Samples = 0; // not missing
  std::int64_t LiveSamples = 0; // within the limits, without what is missing or 0 at either end of traces
  float Threshold = 0.0F; // absolute amplitude
  /// The dominant period, in samples, is twice the median thickness of runs, weighted by energy, as tails of wavelets
  /// without noise are long, weak runs; 0 without picks.
  double Period = 0.0;

  ReflectionRules Rules;

  /// Returns 0 or 1, or -1 below the threshold.
  int SignOf(const Reflection& reflection) const
  {
    return reflection.Strength < this->Threshold ? -1 : int(std::signbit(reflection.Amplitude));
  }

  std::int64_t CountPicks() const { return std::int64_t(this->BySign[0].Size()) + this->BySign[1].Size(); }
};

/// Throws InputError on options out of range, and on cubes that are empty, too large or without a sample. Takes 6 bytes
/// per pick, and at first 12 more per reflection.
CubeReflections FindReflections(const TraceCube& cube, const ReflectionOptions& options = ReflectionOptions(),
  const Monitor& monitor = Monitor(), const TraceLimits& limits = TraceLimits());
}

#endif
