// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Waveforms.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr int Lanes = 8;

// Zeros around a trace beyond the half width: samples that interpolation looks at.
constexpr int Margin = 2;

/// The weights of four samples for a place between the second and the third of them (cubic convolution; Keys 1981).
std::array<float, 4> CubicWeights(float t)
{
  const float s = 1.0F - t;
  return { -0.5F * t * s * s, 1.0F + t * t * (1.5F * t - 2.5F), 1.0F + s * s * (1.5F * s - 2.5F), -0.5F * s * t * t };
}

/// The sum of squares, added up in lanes, so that compilers may add several at a time.
float Energy(const std::vector<float>& values)
{
  std::array<float, Lanes> sums = {};
  for (std::size_t n = 0; n < values.size(); n += Lanes)
  {
    for (std::size_t lane = 0; lane < Lanes; ++lane)
    {
      sums[lane] += values[n + lane] * values[n + lane];
    }
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}
}

//----------------------------------------------------------------------------------------------------------------------
WaveformCutter::WaveformCutter(int halfWidth)
  : HalfWidth(halfWidth)
  , ValuesPerWaveform((2 * halfWidth + 1 + Lanes - 1) / Lanes * Lanes)
  , Shape(std::size_t(this->ValuesPerWaveform), 0.0F)
{
}

//----------------------------------------------------------------------------------------------------------------------
void WaveformCutter::SetTrace(const float* trace, int samples)
{
  const int pad = this->HalfWidth + Margin;
  // A waveform is cut out as wide as it lies in memory.
  const std::size_t size = std::size_t(samples + pad + Margin + this->ValuesPerWaveform);
  if (this->Padded.size() != size)
  {
    this->Padded.assign(size, 0.0F);
  }
  std::transform(
    trace, trace + samples, this->Padded.begin() + pad, [](float value) { return value == value ? value : 0.0F; });
}

//----------------------------------------------------------------------------------------------------------------------
void WaveformCutter::CutOut(Depth place, std::int16_t* waveform)
{
  const auto weights = CubicWeights(float(place % DepthsPerSample) / float(DepthsPerSample));
  // The first value is half a width before the place, and interpolated between the second and third sample from here.
  const float* const samples = this->Padded.data() + place / DepthsPerSample + Margin - 1;
  float* const shape = this->Shape.data();
  for (int n = 0; n < this->ValuesPerWaveform; ++n)
  {
    shape[n] = (weights[0] * samples[n] + weights[1] * samples[n + 1]) +
      (weights[2] * samples[n + 2] + weights[3] * samples[n + 3]);
  }
  std::fill(this->Shape.begin() + 2 * this->HalfWidth + 1, this->Shape.end(), 0.0F);
  const float energy = Energy(this->Shape);
  const float scale = energy > 0.0F ? float(Length) / std::sqrt(energy) : 0.0F;
  for (int n = 0; n < this->ValuesPerWaveform; ++n)
  {
    waveform[n] = std::int16_t(std::int32_t(scale * shape[n]));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void RowWaveforms::Load(const TraceCube& cube, const ReflectionPicks& picks, int j)
{
  const int samples = cube.Size[2];
  const auto width = std::size_t(this->Cutter.Width());
  const std::int64_t firstColumn = picks.ColumnAt(0, j);
  this->First = picks.Begin(firstColumn);
  this->Values.resize(std::size_t(picks.End(firstColumn + cube.Size[0] - 1) - this->First) * width);
  this->Block.resize(std::size_t(std::min(TracesPerBlock, cube.Size[0])) * std::size_t(samples));
  std::int16_t* waveform = this->Values.data();
  for (int first = 0; first < cube.Size[0]; first += TracesPerBlock)
  {
    const int count = std::min(TracesPerBlock, cube.Size[0] - first);
    cube.Read(j, first, count, this->Block.data());
    for (int n = 0; n < count; ++n)
    {
      this->Cutter.SetTrace(this->Block.data() + std::size_t(n) * std::size_t(samples), samples);
      for (PointId pick = picks.Begin(firstColumn + first + n); pick < picks.End(firstColumn + first + n); ++pick)
      {
        this->Cutter.CutOut(picks.PlaceOf(pick), waveform);
        waveform += width;
      }
    }
  }
}
}
