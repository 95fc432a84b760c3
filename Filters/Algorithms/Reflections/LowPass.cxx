// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LowPass.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// One side of a Lanczos kernel of three lobes, which leaves the dominant frequency as it is.
std::vector<float> MakeLanczosKernel(double period)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr int lobes = 3;
  const double zero = period / 4.0; // of the sine
  std::vector<double> weights = { 1.0 };
  double sum = 1.0;
  for (int n = 1; n < lobes * zero; ++n)
  {
    const double x = pi * n / zero;
    weights.push_back(std::sin(x) / x * std::sin(x / lobes) / (x / lobes));
    sum += 2.0 * weights.back();
  }
  std::vector<float> kernel;
  for (const double weight : weights)
  {
    kernel.push_back(float(weight / sum));
  }
  return kernel;
}

void Filter(const std::vector<float>& kernel, int samples, std::vector<float>& padded, float* trace)
{
  const int reach = int(kernel.size()) - 1;
  padded.assign(std::size_t(samples + 2 * reach), 0.0F);
  for (int k = 0; k < samples; ++k)
  {
    padded[std::size_t(k + reach)] = std::isnan(trace[k]) ? 0.0F : trace[k];
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
  filtered.Read = [cube, kernel = MakeLanczosKernel(period)](int j, int first, int count, float* traces)
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
