// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The strong reflections of a whole cube (thesis, 2.2.1).

#ifndef SeismicHorizonsReflectionFinder_h
#define SeismicHorizonsReflectionFinder_h

#include "Common/Monitor.h"
#include "Reflection.h"
#include "ReflectionRuns.h"
#include "TraceCube.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
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
CubeReflections FindReflections(
  const TraceCube& cube, const ReflectionOptions& options = ReflectionOptions(), const Monitor& monitor = Monitor());
}

#endif
