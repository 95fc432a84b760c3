// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Likeness is the correlation of waveforms, cut out of traces around picks by cubic convolution (Keys 1981), and scaled
// to equal energy. Sums of products of integers do not depend on the order, and vectorize.

#ifndef SeismicHorizonsWaveformCutter_h
#define SeismicHorizonsWaveformCutter_h

#include "ReflectionFinder.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class WaveformCutter
{
public:
  static constexpr std::int32_t Length = 32000; // of a waveform as a vector
  static constexpr std::int32_t One = Length * Length; // correlation of equal waveforms

  /// `halfWidth` is in samples before and after the pick.
  explicit WaveformCutter(int halfWidth);

  /// Values are padded by zeros to a multiple of 8.
  int Width() const { return this->ValuesPerWaveform; }

  /// Missing samples are 0.
  void SetTrace(const float* trace, int samples);

  void CutOut(PickDepth place, std::int16_t* waveform);

  /// Returns the correlation, -1 to 1, times One.
  std::int32_t Correlate(const std::int16_t* first, const std::int16_t* second) const
  {
    std::int32_t sum = 0;
    for (int n = 0; n < this->ValuesPerWaveform; ++n)
    {
      sum += std::int32_t(first[n]) * std::int32_t(second[n]);
    }
    return sum;
  }

private:
  int HalfWidth;
  int ValuesPerWaveform;
  std::vector<float> Padded; // between zeros
  std::vector<float> Shape;
};
}

#endif
