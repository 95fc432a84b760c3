// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shapes of traces around picks. Each is cut out at the pick's place, to parts of a sample, and scaled to the same
// energy, so that the correlation of two is a sum of products: of whole numbers, which are the same in any order, and
// which compilers multiply eight at a time.

#ifndef SeismicHorizonsWaveforms_h
#define SeismicHorizonsWaveforms_h

#include "Reflection.h"
#include "TraceCube.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Cuts waveforms out of a trace.
class WaveformCutter
{
public:
  /// `halfWidth`: how many samples a waveform has before and behind its pick.
  explicit WaveformCutter(int halfWidth);

  /// How many values a waveform has in memory: a multiple of 8, the last ones are 0.
  int Width() const { return this->ValuesPerWaveform; }

  /// Samples that are missing, or beyond the ends of the trace, are 0.
  void SetTrace(const float* trace, int samples);
  void CutOut(Depth place, std::int16_t* waveform);

  static constexpr std::int32_t Length = 32000; // of a waveform as a vector

private:
  int HalfWidth;
  int ValuesPerWaveform;
  std::vector<float> Padded; // a trace between zeros
  std::vector<float> Shape;
};

/// The waveforms of the picks of a row.
class RowWaveforms
{
public:
  explicit RowWaveforms(int halfWidth)
    : Cutter(halfWidth)
  {
  }

  /// Reads a row of the cube.
  void Load(const TraceCube& cube, const ReflectionPicks& picks, int j);

  /// The correlation of two picks, each of its row, from -1 to 1, times One.
  static std::int32_t Correlate(const RowWaveforms& rowA, PointId a, const RowWaveforms& rowB, PointId b)
  {
    const std::int16_t* const first = rowA.WaveformOf(a);
    const std::int16_t* const second = rowB.WaveformOf(b);
    std::int32_t sum = 0;
    const int width = rowA.Cutter.Width();
    for (int n = 0; n < width; ++n)
    {
      sum += std::int32_t(first[n]) * std::int32_t(second[n]);
    }
    return sum;
  }

  static constexpr std::int32_t One = WaveformCutter::Length * WaveformCutter::Length;

private:
  const std::int16_t* WaveformOf(PointId pick) const
  {
    return this->Values.data() + std::size_t(pick - this->First) * std::size_t(this->Cutter.Width());
  }

  WaveformCutter Cutter;
  PointId First = 0; // pick of the row
  std::vector<std::int16_t> Values;
  std::vector<float> Block;
};
}

#endif
