// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LowPass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// One side of a Gaussian, which makes no waves of its own, with a gain that leaves the dominant frequency as it is.
std::vector<float> MakeGaussianKernel(double period)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double deviationPerPeriod = 1.0 / 10.0;
  constexpr double reach = 4.0; // in standard deviations
  const double deviation = deviationPerPeriod * period;
  std::vector<float> kernel;
  const double gain =
    std::exp(2.0 * pi * pi * deviationPerPeriod * deviationPerPeriod) / (deviation * std::sqrt(2.0 * pi));
  for (int n = 0; n <= reach * deviation; ++n)
  {
    kernel.push_back(float(gain * std::exp(-0.5 * n * n / (deviation * deviation))));
  }
  return kernel;
}

void Filter(const std::vector<float>& kernel, int samples, std::vector<float>& padded, float* trace)
{
  const int reach = int(kernel.size()) - 1;
  padded.clear();
  for (int k = -reach; k < samples + reach; ++k)
  {
    const float sample = trace[std::clamp(k, 0, samples - 1)];
    padded.push_back(std::isnan(sample) ? 0.0F : sample);
  }
  for (int k = 0; k < samples; ++k)
  {
    const float* const here = padded.data() + k + reach;
    float sum = kernel[0] * here[0];
    for (int n = 1; n <= reach; ++n)
    {
      sum += kernel[std::size_t(n)] * (here[-n] + here[n]);
    }
    trace[k] = std::isnan(trace[k]) ? trace[k] : sum;
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
TraceCube LowPass(const TraceCube& cube, double period)
{
  TraceCube filtered = cube;
  filtered.Read = [cube, kernel = MakeGaussianKernel(period)](int j, int first, int count, float* traces)
  {
    cube.Read(j, first, count, traces);
    std::vector<float> padded;
    for (int n = 0; n < count; ++n)
    {
      Filter(kernel, cube.Size[2], padded, traces + std::ptrdiff_t(n) * cube.Size[2]);
    }
  };
  return filtered;
}
}
