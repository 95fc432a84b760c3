// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CubeGenerator.h"

#include "SmoothNoise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// The wavelet is nothing beyond this: exp(-40) is 4e-18.
constexpr double LargestExponent = 40.0;

/// exp(-x) for x from 0 to LargestExponent: the series of a small part of it, squared again and again.
double NegativeExponential(double x)
{
  constexpr int squarings = 10;
  const double y = x / (1 << squarings);
  double power = 1.0 - y * (1.0 - y / 2.0 * (1.0 - y / 3.0 * (1.0 - y / 4.0 * (1.0 - y / 5.0 * (1.0 - y / 6.0)))));
  for (int n = 0; n < squarings; ++n)
  {
    power *= power;
  }
  return power;
}

/// A random number of mean 0 and variance 1, nearly normally distributed: the sum of twelve.
double NormalRandom(std::uint64_t seed, std::int64_t trace, std::int64_t sample)
{
  constexpr int numbers = 12;
  double sum = -numbers / 2.0;
  for (int n = 0; n < numbers; ++n)
  {
    sum += Random(seed, trace, sample * numbers + n);
  }
  return sum;
}

double TimeOf(double samples, double interval)
{
  return samples * interval / 1000.0;
}
}

//----------------------------------------------------------------------------------------------------------------------
double RickerWavelet(double frequency, double time)
{
  const double a = Pi * frequency * time * (Pi * frequency * time);
  return a < LargestExponent ? (1.0 - 2.0 * a) * NegativeExponential(a) : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
CubeGenerator::CubeGenerator(const CubeGeneratorOptions& options)
  : Given((CheckOptions(options), options))
  , Reflectors(options)
{
  const double reach = std::sqrt(LargestExponent) / (Pi * options.Frequency) * 1000.0 / options.SampleInterval;
  for (int sample = -int(reach); sample <= int(reach); ++sample)
  {
    this->Wavelet.push_back(RickerWavelet(options.Frequency, TimeOf(sample, options.SampleInterval)));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddWavelet(double place, double strength, float* trace) const
{
  if (!(place == place))
  {
    return;
  }
  const double reach = double(this->Wavelet.size()) / 2.0 + 1.0;
  const int first = std::max(0, int(std::ceil(place - reach)));
  const int last = std::min(this->Given.Size[2] - 1, int(std::floor(place + reach)));
  for (int sample = first; sample <= last; ++sample)
  {
    trace[sample] +=
      float(strength * RickerWavelet(this->Given.Frequency, TimeOf(sample - place, this->Given.SampleInterval)));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddSignal(int i, int j, float* trace) const
{
  for (int n = 0; n < this->Reflectors.Size(); ++n)
  {
    this->AddWavelet(this->Reflectors.Place(n, i, j), this->Reflectors.Strength(n, i, j), trace);
  }
  if (this->Given.HasChannel)
  {
    this->AddWavelet(this->Reflectors.ChannelPlace(i, j), this->Reflectors.ChannelStrength(), trace);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double CubeGenerator::NoiseHeight() const
{
  if (this->Given.Noise == NoiseKind::White)
  {
    return 1.0;
  }
  double energy = 0.0;
  for (const double value : this->Wavelet)
  {
    energy += value * value;
  }
  return std::sqrt(energy);
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddNoise(int i, int j, double height, float* trace) const
{
  const std::uint64_t seed = Mix(this->Given.Seed + 0xA5A5U);
  const std::int64_t number = i + std::int64_t(this->Given.Size[0]) * j;
  const auto width = int(this->Wavelet.size());
  const bool isWhite = this->Given.Noise == NoiseKind::White;
  std::vector<double> noise(std::size_t(this->Given.Size[2] + (isWhite ? 0 : width)));
  for (std::size_t sample = 0; sample < noise.size(); ++sample)
  {
    noise[sample] = NormalRandom(seed, number, std::int64_t(sample));
  }
  for (int sample = 0; sample < this->Given.Size[2]; ++sample)
  {
    double value = isWhite ? noise[std::size_t(sample)] : 0.0;
    for (int n = 0; !isWhite && n < width; ++n)
    {
      value += this->Wavelet[std::size_t(n)] * noise[std::size_t(sample + n)];
    }
    trace[sample] += float(height * value);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<float> CubeGenerator::MakeTraces() const
{
  const auto [nX, nY, nZ] = this->Given.Size;
  std::vector<float> traces(std::size_t(nX) * std::size_t(nY) * std::size_t(nZ), 0.0F);
  const auto forEachTrace = [&, nX = nX, nY = nY, nZ = nZ](auto&& work)
  {
    for (int j = 0; j < nY; ++j)
    {
      for (int i = 0; i < nX; ++i)
      {
        work(i, j, traces.data() + (std::size_t(j) * std::size_t(nX) + std::size_t(i)) * std::size_t(nZ));
      }
    }
  };
  forEachTrace([&](int i, int j, float* trace) { this->AddSignal(i, j, trace); });
  double energy = 0.0;
  for (const float value : traces)
  {
    energy += double(value) * double(value);
  }
  const double height = this->Given.NoiseFraction * std::sqrt(energy / double(traces.size())) / this->NoiseHeight();
  forEachTrace(
    [&, nZ = nZ](int i, int j, float* trace)
    {
      if (height > 0.0)
      {
        this->AddNoise(i, j, height, trace);
      }
      if (this->Reflectors.IsMissing(i, j))
      {
        std::fill(trace, trace + nZ, std::numeric_limits<float>::quiet_NaN());
      }
      else if (this->Reflectors.IsDead(i, j))
      {
        std::fill(trace, trace + nZ, 0.0F);
      }
    });
  return traces;
}
}
