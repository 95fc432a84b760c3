// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WaveformCutter.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr int VectorLanes = 8;

// Interpolation reads zeros beyond the half width.
constexpr int Margin = 2;

/// The place lies between the second and third of four samples (cubic convolution; Keys 1981).
std::array<float, 4> CubicWeights(float t)
{
  const float s = 1.0F - t;
  return { -0.5F * t * s * s, 1.0F + t * t * (1.5F * t - 2.5F), 1.0F + s * s * (1.5F * s - 2.5F), -0.5F * s * t * t };
}

/// Lanes let compilers vectorize the sum.
float Energy(const std::vector<float>& values)
{
  std::array<float, VectorLanes> sums = {};
  for (std::size_t n = 0; n < values.size(); n += VectorLanes)
  {
    for (std::size_t lane = 0; lane < VectorLanes; ++lane)
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
  , ValuesPerWaveform((2 * halfWidth + 1 + VectorLanes - 1) / VectorLanes * VectorLanes)
  , Shape(this->ValuesPerWaveform, 0.0F)
{
}

//----------------------------------------------------------------------------------------------------------------------
void WaveformCutter::SetTrace(const float* trace, int samples)
{
  const int pad = this->HalfWidth + Margin;
  // The cut covers the padded width.
  const std::size_t size = samples + pad + Margin + this->ValuesPerWaveform;
  if (this->Padded.size() != size)
  {
    this->Padded.assign(size, 0.0F);
  }
  std::transform(
    trace, trace + samples, this->Padded.begin() + pad, [](float value) { return value == value ? value : 0.0F; });
}

//----------------------------------------------------------------------------------------------------------------------
void WaveformCutter::CutOut(PickDepth place, std::int16_t* waveform)
{
  const auto weights = CubicWeights(float(place % DepthsPerSample) / float(DepthsPerSample));
  // Values lie between the second and third sample from here.
  const int first = place / DepthsPerSample + Margin - 1;
  assert(std::size_t(first + this->ValuesPerWaveform + 3) <= this->Padded.size());
  const float* const samples = this->Padded.data() + first;
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
}
