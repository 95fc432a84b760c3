// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "WaveletPhase.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// A wavelet of phase 0 has its peak, and its pick, on the interface; at 90 degrees a zero crossing between two picks.
// A turn by an angle a makes x cos a + h sin a of a trace x with Hilbert transform h. Fourth moments of x and h give
// the kurtosis at any angle without turning traces.
constexpr double Pi = 3.14159265358979323846;
constexpr std::int64_t MostSampledTraces = 2000;

// The kernel reaches this number of samples to each side, which limits the wavelength.
constexpr int KernelReach = 63;

/// The kernel is 2 / (pi n) at odd n, tapered against ripples.
std::array<float, KernelReach + 1> MakeKernel()
{
  std::array<float, KernelReach + 1> kernel = {};
  for (int n = 1; n <= KernelReach; n += 2)
  {
    const double taper = 0.5 * (1.0 + std::cos(Pi * n / (KernelReach + 1)));
    kernel[std::size_t(n)] = float(2.0 / (Pi * n) * taper);
  }
  return kernel;
}

class HilbertTransform
{
public:
  void Run(const float* trace, int samples)
  {
    this->Padded.assign(std::size_t(samples + 2 * KernelReach), 0.0F);
    for (int k = 0; k < samples; ++k)
    {
      this->Padded[std::size_t(k + KernelReach)] = std::isnan(trace[k]) ? 0.0F : trace[k];
    }
    this->Turned.assign(std::size_t(samples), 0.0F);
    for (int n = 1; n <= KernelReach; n += 2)
    {
      const float weight = this->Kernel[std::size_t(n)];
      const float* const before = this->Padded.data() + KernelReach - n;
      const float* const after = this->Padded.data() + KernelReach + n;
      for (int k = 0; k < samples; ++k)
      {
        this->Turned[std::size_t(k)] += weight * (before[k] - after[k]);
      }
    }
  }

  float At(int k) const { return this->Padded[std::size_t(k + KernelReach)]; }
  float TurnedAt(int k) const { return this->Turned[std::size_t(k)]; }

private:
  const std::array<float, KernelReach + 1> Kernel = MakeKernel();
  std::vector<float> Padded;
  std::vector<float> Turned;
};

/// Sums of products are in the order x^2, xh, h^2 and x^4, x^3 h, x^2 h^2, x h^3, h^4.
struct Moments
{
  std::array<double, 3> Second = { 0.0, 0.0, 0.0 };
  std::array<double, 5> Fourth = { 0.0, 0.0, 0.0, 0.0, 0.0 };

  void Add(double x, double h)
  {
    this->Second[0] += x * x;
    this->Second[1] += x * h;
    this->Second[2] += h * h;
    this->Fourth[0] += x * x * x * x;
    this->Fourth[1] += x * x * x * h;
    this->Fourth[2] += x * x * h * h;
    this->Fourth[3] += x * h * h * h;
    this->Fourth[4] += h * h * h * h;
  }

  void Add(const Moments& other)
  {
    std::transform(this->Second.begin(), this->Second.end(), other.Second.begin(), this->Second.begin(), std::plus<>());
    std::transform(this->Fourth.begin(), this->Fourth.end(), other.Fourth.begin(), this->Fourth.begin(), std::plus<>());
  }

  double Kurtosis(double angle) const
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double second = c * c * this->Second[0] + 2.0 * c * s * this->Second[1] + s * s * this->Second[2];
    const double fourth = c * c * c * c * this->Fourth[0] + 4.0 * c * c * c * s * this->Fourth[1] +
      6.0 * c * c * s * s * this->Fourth[2] + 4.0 * c * s * s * s * this->Fourth[3] + s * s * s * s * this->Fourth[4];
    return second > 0.0 ? fourth / (second * second) : 0.0;
  }
};

constexpr std::size_t Parts = 8;

/// Traces are dealt out to the parts in turn.
std::array<Moments, Parts> SumMoments(const TraceCube& cube)
{
  const std::int64_t traces = std::int64_t(cube.Size[0]) * cube.Size[1];
  const std::int64_t step = std::max<std::int64_t>(1, traces / MostSampledTraces);
  std::vector<Moments> ofTraces(std::size_t((traces + step - 1) / step));
  ParallelFor(std::int64_t(ofTraces.size()), 16,
    [&](std::int64_t begin, std::int64_t end)
    {
      HilbertTransform transform;
      std::vector<float> trace(std::size_t(cube.Size[2]));
      for (std::int64_t n = begin; n < end; ++n)
      {
        const std::int64_t column = n * step;
        cube.Read(int(column / cube.Size[0]), int(column % cube.Size[0]), 1, trace.data());
        transform.Run(trace.data(), cube.Size[2]);
        for (int k = 0; k < cube.Size[2]; ++k)
        {
          ofTraces[std::size_t(n)].Add(transform.At(k), transform.TurnedAt(k));
        }
      }
    });
  std::array<Moments, Parts> sums;
  for (std::size_t n = 0; n < ofTraces.size(); ++n)
  {
    sums[n % Parts].Add(ofTraces[n]);
  }
  return sums;
}

/// A turn by minus the phase gives the largest kurtosis.
int FindPhase(const Moments& moments)
{
  int phase = 0;
  double most = moments.Kurtosis(0.0);
  for (int degrees = -90; degrees < 90; ++degrees)
  {
    const double kurtosis = moments.Kurtosis(-degrees / 180.0 * Pi);
    phase = kurtosis > most ? degrees : phase;
    most = std::max(most, kurtosis);
  }
  return phase;
}

/// Phases have a period of 180 degrees.
int Difference(int a, int b)
{
  const int difference = std::abs(a - b);
  return std::min(difference, 180 - difference);
}

class PhaseTurn
{
public:
  explicit PhaseTurn(double degrees)
    : Cosine(float(std::cos(degrees / 180.0 * Pi)))
    , Sine(float(std::sin(degrees / 180.0 * Pi)))
  {
  }

  void operator()(float* trace, int samples)
  {
    this->Transform.Run(trace, samples);
    for (int k = 0; k < samples; ++k)
    {
      trace[k] = std::isnan(trace[k]) ? trace[k]
                                      : this->Cosine * this->Transform.At(k) + this->Sine * this->Transform.TurnedAt(k);
    }
  }

private:
  const float Cosine;
  const float Sine;
  HilbertTransform Transform;
};
}

//----------------------------------------------------------------------------------------------------------------------
WaveletPhase EstimatePhase(const TraceCube& cube)
{
  const std::array<Moments, Parts> parts = SumMoments(cube);
  Moments sum;
  for (const Moments& part : parts)
  {
    sum.Add(part);
  }
  const int phase = FindPhase(sum);
  double squares = 0.0;
  for (const Moments& part : parts)
  {
    const double difference = Difference(FindPhase(part), phase);
    squares += difference * difference;
  }
  return { double(phase), std::sqrt(squares / double(Parts)) };
}

//----------------------------------------------------------------------------------------------------------------------
TraceCube TurnPhase(const TraceCube& cube, double degrees)
{
  return ChangeTraces(cube, PhaseTurn(degrees));
}
}
