// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The strong reflections of a seismic cube (thesis, 2.2.1). A reflection is a run of samples of one sign on a trace;
// its pick is the one place on it that stands for it. Or it is where one run ends and one of the other sign begins: a
// zero crossing, positive where amplitudes become so.

#ifndef SeismicHorizonsReflectionFinder_h
#define SeismicHorizonsReflectionFinder_h

#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"
#include "TraceCube.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  Peak, // at each local maximum of the absolute amplitude, to parts of a sample
  ZeroCrossing // between a run and the next one, of the other sign, on the line through their samples
};

struct Reflection
{
  Depth Place = 0;
  std::int32_t Thickness = 0; // of the run, in samples; the mean of both beside a zero crossing
  float Amplitude = 0.0F; // the mean over the run; half the difference of both peaks beside a zero crossing
  /// The absolute amplitude at the peak; in the middle, the largest one of the run; at a zero crossing, that above.
  float Strength = 0.0F;
};

/// How the reflections of a trace are found.
struct ReflectionRules
{
  ReflectionPolarity Polarity = ReflectionPolarity::Both;
  ReflectionPosition Position = ReflectionPosition::Peak;
  /// With the middle: samples of smaller absolute amplitude belong to no run.
  float SampleThreshold = 0.0F;
};

/// Appends the reflections of a trace, downwards. Samples that are 0, missing (nan) or below the threshold end a run. A
/// peak of several equal samples is in their middle; one at an end of the trace, or beside a missing sample, is at its
/// sample; any other at the vertex of the parabola through its sample and the two beside it. Runs with more than one
/// sample of 0 between them do not cross zero.
void FindReflections(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found);

/// Between which places on each trace reflections count.
struct TraceLimits
{
  bool AreNone() const { return this->First.empty(); }
  /// Whether a place on a trace does: never where a limit is nan.
  bool Contain(std::int64_t column, Depth place) const
  {
    return this->AreNone() || (this->First[column] <= InSamples(place) && InSamples(place) <= this->Last[column]);
  }

  /// In samples, column by column, i fastest; none for whole traces.
  std::vector<double> First;
  std::vector<double> Last;
};

/// Leaves out those of the reflections from a number on, all of one trace, that are beyond its limits.
void LeaveOutBeyond(
  const TraceLimits& limits, std::int64_t column, std::size_t first, std::vector<Reflection>& reflections);

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
  int IOf(std::int32_t column) const { return column % this->Columns[0]; }
  int JOf(std::int32_t column) const { return column / this->Columns[0]; }

  PointId Begin(std::int64_t column) const { return this->Starts[column]; }
  PointId End(std::int64_t column) const { return this->Starts[column + 1]; }
  PointId Size() const { return PointId(this->Places.size()); }
  Depth PlaceOf(PointId pick) const { return this->Places[pick]; }
  std::uint16_t CoarseStrengthOf(PointId pick) const { return this->Strengths[pick]; }

  /// Calls visit(pick, column) for all picks in their order.
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

  /// Calls visit(a, b) for the pairs of picks of two columns that are at most a step apart.
  template <typename Visit>
  void ForEachPair(std::int64_t columnA, std::int64_t columnB, Depth largestStep, Visit&& visit) const
  {
    PointId low = this->Begin(columnB);
    const PointId endA = this->End(columnA);
    const PointId endB = this->End(columnB);
    for (PointId a = this->Begin(columnA); a < endA; ++a)
    {
      const Depth place = this->PlaceOf(a);
      while (low < endB && this->PlaceOf(low) < place - largestStep)
      {
        ++low;
      }
      for (PointId b = low; b < endB && this->PlaceOf(b) <= place + largestStep; ++b)
      {
        visit(a, b);
      }
    }
  }

  std::int32_t ColumnOf(PointId pick) const
  {
    return std::int32_t(std::upper_bound(this->Starts.begin(), this->Starts.end(), pick) - this->Starts.begin()) - 1;
  }

  /// The same for all picks.
  RawVector<std::int32_t> ListColumns() const
  {
    RawVector<std::int32_t> columns(this->Places.size());
    this->ForEach([&columns](PointId pick, std::int32_t column) { columns[pick] = column; });
    return columns;
  }

  /// Leaves where the picks of each column begin.
  void FreePicks()
  {
    this->Places = {};
    this->Strengths = {};
  }
};

/// What the threshold of amplitudes is.
enum class ThresholdKind
{
  Amplitude,
  Percentile // of the strengths of all picks of the polarity; with the middle, of all samples of it
};

struct ReflectionOptions
{
  ReflectionPolarity Polarity = ReflectionPolarity::Both;
  ReflectionPosition Position = ReflectionPosition::Peak;
  ThresholdKind Threshold = ThresholdKind::Percentile;
  double AmplitudeThreshold = 0.0; // at least 0
  double AmplitudePercentile = 25.0; // 0 to 100
};

/// Throws InputError when an option is out of range.
void CheckOptions(const ReflectionOptions& options);

struct CubeReflections
{
  std::array<ReflectionPicks, 2> BySign; // positive, negative
  std::int64_t Samples = 0; // that are not missing
  float Threshold = 0.0F; // the absolute amplitude that picks have at least
  /// The dominant period in samples: twice the median thickness of the runs of all picks, each as important as its
  /// energy, the square of its strength; between whole numbers by how much is as thick. Where there is no noise, the
  /// tails of wavelets are long runs of next to nothing. 0 without picks.
  double Period = 0.0;

  ReflectionRules Rules; // by which they were found on each trace

  /// Which of the signs a reflection belongs to: 0 or 1; -1 when it does not reach the threshold.
  int SignOf(const Reflection& reflection) const
  {
    return reflection.Strength < this->Threshold ? -1 : int(std::signbit(reflection.Amplitude));
  }

  std::int64_t CountPicks() const { return std::int64_t(this->BySign[0].Size()) + this->BySign[1].Size(); }
};

/// Rows are worked on by all threads. Throws InputError on options out of range, on a cube with a side below 1 or of
/// too many columns, samples or picks, and on one without a sample that is not missing. Takes 6 bytes per pick,
/// and 12 more per reflection, weak ones included, until they are told apart.
CubeReflections FindReflections(const TraceCube& cube, const ReflectionOptions& options = ReflectionOptions(),
  const Monitor& monitor = Monitor(), const TraceLimits& limits = TraceLimits());
}

#endif
