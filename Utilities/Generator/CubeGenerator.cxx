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

/// The cosine and sine of an angle of at most 360 degrees, by their series.
std::array<double, 2> CosineAndSine(double degrees)
{
  constexpr int terms = 40;
  const double angle = degrees / 180.0 * Pi;
  std::array<double, 2> sums = { 0.0, 0.0 };
  double term = 1.0;
  for (int n = 0; n < terms; ++n)
  {
    sums[std::size_t(n % 2)] += n / 2 % 2 == 0 ? term : -term;
    term *= angle / (n + 1);
  }
  return sums;
}

/// exp(-x^2) times the integral of exp(t^2) from 0 to x, for x^2 up to LargestExponent, by its series.
double DawsonIntegral(double x)
{
  double sum = 0.0;
  double power = x; // x^(2n+1) / n!
  for (int n = 0; std::abs(power) > 1e-17 * std::abs(sum) || n == 0; ++n)
  {
    sum += power / (2 * n + 1);
    power *= x * x / (n + 1);
  }
  return NegativeExponential(x * x) * sum;
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
double TurnedRickerWavelet(double frequency, double time)
{
  constexpr double twoByRootPi = 1.12837916709551257390;
  const double a = Pi * frequency * time;
  return a * a < LargestExponent ? twoByRootPi * (a + DawsonIntegral(a) * (1.0 - 2.0 * a * a)) : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
CubeGenerator::CubeGenerator(const CubeGeneratorOptions& options)
  : Given((CheckOptions(options), options))
  , Reflectors(options)
  , Turn(CosineAndSine(options.Phase))
{
  const double reach = std::sqrt(LargestExponent) / (Pi * options.Frequency) * 1000.0 / options.SampleInterval;
  for (int sample = -int(reach); sample <= int(reach); ++sample)
  {
    this->Wavelet.push_back(RickerWavelet(options.Frequency, TimeOf(sample, options.SampleInterval)));
  }
  this->MakePlaneWaves();
  this->MakeSmiles();
}

//----------------------------------------------------------------------------------------------------------------------
// Of every two one is at a side of the cube, where migration lacks the traces that would cancel it.
void CubeGenerator::MakeSmiles()
{
  const int smiles = this->Given.Has(Trouble::Smiles) ? 12 : 0;
  constexpr double columnsPerTime = 0.05; // 1 / ms: half of 2500 m/s, and columns of 25 m
  for (int n = 0; n < smiles; ++n)
  {
    const auto random = [&](int which) { return Random(Mix(this->Given.Seed + 0x7E7EU), n, which); };
    Smile smile;
    smile.Middle = { random(0) * this->Given.Size[0], random(1) * this->Given.Size[1] };
    if (n % 2 == 1)
    {
      const auto axis = std::size_t(n / 2 % 2);
      smile.Middle[axis] = random(2) < 0.5 ? 0.0 : this->Given.Size[axis] - 1.0;
    }
    smile.Bottom = (0.3 + 0.75 * random(3)) * this->Given.Size[2];
    smile.Radius = columnsPerTime * this->Given.SampleInterval * smile.Bottom;
    smile.Strength = (random(4) < 0.5 ? -1.0 : 1.0) * (0.4 + 0.5 * random(5));
    this->Smiles.push_back(smile);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddSmiles(int i, int j, float* trace) const
{
  constexpr double aperture = 0.8; // of the radius, where they have faded
  for (const Smile& smile : this->Smiles)
  {
    const double x = (i - smile.Middle[0]) / smile.Radius;
    const double y = (j - smile.Middle[1]) / smile.Radius;
    const double part = (x * x + y * y) / (aperture * aperture);
    if (part < 1.0)
    {
      // Migration stretches the wavelet where it dips.
      const double cosine = std::sqrt(1.0 - x * x - y * y);
      this->AddWavelet(smile.Bottom * cosine, smile.Strength * (1.0 - part), trace, cosine);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::MakePlaneWaves()
{
  constexpr int waves = 3;
  const std::uint64_t seed = Mix(this->Given.Seed + 0x5A5AU);
  for (int n = 0; n < waves; ++n)
  {
    PlaneWave wave;
    double reach = 2.0;
    for (const std::size_t axis : { 0U, 1U })
    {
      wave.Slope[axis] = (0.2 + 0.8 * Random(seed, n, std::int64_t(axis))) *
        (Random(seed, n, 2 + std::int64_t(axis)) < 0.5 ? -1.0 : 1.0);
      reach += std::abs(wave.Slope[axis]) * this->Given.Size[axis];
    }
    wave.First = -std::ceil(reach);
    std::vector<double> random(std::size_t(this->Given.Size[2] - 2.0 * wave.First) + this->Wavelet.size());
    for (std::size_t sample = 0; sample < random.size(); ++sample)
    {
      random[sample] = NormalRandom(seed, 4 + n, std::int64_t(sample));
    }
    wave.Samples = this->InBand(random);
    this->Waves.push_back(std::move(wave));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddWavelet(double place, double strength, float* trace, double times) const
{
  if (!(place == place))
  {
    return;
  }
  constexpr double fall = 0.6;
  const double frequency = times * this->Given.Frequency *
    (this->Given.Has(Trouble::Wavelet) ? 1.0 - fall * place / this->Given.Size[2] : 1.0);
  const double reach = std::sqrt(LargestExponent) / (Pi * frequency) * 1000.0 / this->Given.SampleInterval + 1.0;
  const int first = std::max(0, int(std::ceil(place - reach)));
  const int last = std::min(this->Given.Size[2] - 1, int(std::floor(place + reach)));
  for (int sample = first; sample <= last; ++sample)
  {
    const double time = TimeOf(sample - place, this->Given.SampleInterval);
    const double turned = this->Turn[1] == 0.0 ? 0.0 : this->Turn[1] * TurnedRickerWavelet(frequency, time);
    trace[sample] += float(strength * (this->Turn[0] * RickerWavelet(frequency, time) + turned));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddSignal(int i, int j, float* trace) const
{
  for (int n = 0; n < this->Reflectors.Size(); ++n)
  {
    const double place = this->Reflectors.Place(n, i, j);
    const double strength = this->Reflectors.Strength(n, i, j);
    this->AddWavelet(place, strength, trace);
    if (this->Given.Has(Trouble::Multiples))
    {
      constexpr double part = -0.35;
      this->AddWavelet(place + this->MultipleDelay(i, j), part * strength, trace);
    }
  }
  for (int channel = 0; channel < this->Given.Channels; ++channel)
  {
    this->AddWavelet(this->Reflectors.ChannelPlace(channel, i, j), this->Reflectors.ChannelStrength(channel), trace);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> CubeGenerator::InBand(const std::vector<double>& random) const
{
  double energy = 0.0;
  for (const double value : this->Wavelet)
  {
    energy += value * value;
  }
  const double height = 1.0 / std::sqrt(energy);
  std::vector<double> result(random.size() - this->Wavelet.size());
  for (std::size_t sample = 0; sample < result.size(); ++sample)
  {
    for (std::size_t n = 0; n < this->Wavelet.size(); ++n)
    {
      result[sample] += this->Wavelet[n] * random[sample + n];
    }
    result[sample] *= height;
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeGenerator::CoherentNoise(int i, int j, int sample) const
{
  double sum = 0.0;
  for (const PlaneWave& wave : this->Waves)
  {
    const double place = sample - wave.Slope[0] * i - wave.Slope[1] * j - wave.First;
    const auto before = std::size_t(place);
    const double part = place - double(before);
    sum += (1.0 - part) * wave.Samples[before] + part * wave.Samples[before + 1];
  }
  return sum / std::sqrt(double(this->Waves.size()));
}

//----------------------------------------------------------------------------------------------------------------------
// Between columns three apart, numbers change evenly.
std::vector<double> CubeGenerator::LateralRandom(std::uint64_t seed, int i, int j, std::size_t size) const
{
  constexpr int step = 3;
  const double x = double(i % step) / step;
  const double y = double(j % step) / step;
  const std::array<double, 4> weights = { (1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y };
  std::vector<double> random(size, 0.0);
  double squares = 0.0;
  for (std::size_t corner = 0; corner < weights.size(); ++corner)
  {
    const std::int64_t column = i / step + std::int64_t(corner % 2);
    const std::int64_t row = j / step + std::int64_t(corner / 2);
    squares += weights[corner] * weights[corner];
    for (std::size_t sample = 0; sample < size && weights[corner] > 0.0; ++sample)
    {
      const std::int64_t number = column + std::int64_t(this->Given.Size[0]) * row;
      random[sample] += weights[corner] * NormalRandom(seed, number, std::int64_t(sample));
    }
  }
  std::for_each(random.begin(), random.end(), [squares](double& value) { value /= std::sqrt(squares); });
  return random;
}

//----------------------------------------------------------------------------------------------------------------------
double CubeGenerator::MultipleDelay(int i, int j) const
{
  constexpr double width = 40.0; // columns
  return this->Given.Spacing * (1.7 + 0.8 * Noise(Mix(this->Given.Seed + 0x3C3CU), i / width, j / width));
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::Clip(std::vector<float>& traces) const
{
  constexpr double largest = 127.0;
  double energy = 0.0;
  std::int64_t count = 0;
  for (const float value : traces)
  {
    energy += std::isnan(value) ? 0.0 : double(value) * double(value);
    count += std::isnan(value) || value == 0.0F ? 0 : 1;
  }
  const double unit = std::sqrt(energy / double(std::max<std::int64_t>(1, count))) / largest;
  for (float& value : traces)
  {
    value = std::isnan(value) ? value : float(std::round(std::clamp(value / unit, -largest, largest)));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CubeGenerator::AddNoise(int i, int j, double height, float* trace) const
{
  const NoiseKind kind = this->Given.Noise;
  const bool isMixed = kind == NoiseKind::Mixed;
  const bool isLateral = kind == NoiseKind::Lateral;
  const double half = std::sqrt(0.5);
  const double white = kind == NoiseKind::White ? 1.0 : (isMixed ? 0.5 : (isLateral ? half : 0.0));
  const double inBand = kind == NoiseKind::InBand ? 1.0 : (isMixed || isLateral ? half : 0.0);
  const double coherent = kind == NoiseKind::Coherent ? 1.0 : (isMixed ? 0.5 : 0.0);
  const std::int64_t number = i + std::int64_t(this->Given.Size[0]) * j;
  const auto makeRandom = [&](std::uint64_t seed, std::size_t size)
  {
    std::vector<double> random(size);
    for (std::size_t sample = 0; sample < size; ++sample)
    {
      random[sample] = NormalRandom(seed, number, std::int64_t(sample));
    }
    return random;
  };
  const std::uint64_t seed = Mix(this->Given.Seed + 0xA5A5U);
  const auto samples = std::size_t(this->Given.Size[2]);
  const std::vector<double> random = makeRandom(isMixed || isLateral ? Mix(seed) : seed, white > 0.0 ? samples : 0);
  const std::size_t more = samples + this->Wavelet.size();
  const std::vector<double> band = inBand > 0.0
    ? this->InBand(isLateral ? this->LateralRandom(seed, i, j, more) : makeRandom(seed, more))
    : std::vector<double>();
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    const double value = (white > 0.0 ? white * random[sample] : 0.0) + (inBand > 0.0 ? inBand * band[sample] : 0.0) +
      (coherent > 0.0 ? coherent * this->CoherentNoise(i, j, int(sample)) : 0.0);
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
  const double height = this->Given.NoiseFraction * std::sqrt(energy / double(traces.size()));
  forEachTrace(
    [&, nZ = nZ](int i, int j, float* trace)
    {
      this->AddSmiles(i, j, trace);
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
      if (this->Given.Has(Trouble::Footprint))
      {
        constexpr double lines = 6.3; // columns
        const auto factor = float(1.0 + 0.4 * Wave(i / lines));
        std::for_each(trace, trace + nZ, [factor](float& value) { value *= factor; });
      }
    });
  if (this->Given.Has(Trouble::Clipped))
  {
    this->Clip(traces);
  }
  return traces;
}
}
