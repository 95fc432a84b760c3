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
  constexpr double deviationPerPeriod = 0.08;
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

class Filter
{
public:
  explicit Filter(double period)
    : Kernel(MakeGaussianKernel(period))
  {
  }

  void operator()(float* trace, int samples)
  {
    const int reach = int(this->Kernel.size()) - 1;
    this->Padded.clear();
    for (int k = -reach; k < samples + reach; ++k)
    {
      const float sample = trace[std::clamp(k, 0, samples - 1)];
      this->Padded.push_back(std::isnan(sample) ? 0.0F : sample);
    }
    for (int k = 0; k < samples; ++k)
    {
      const float* const here = this->Padded.data() + k + reach;
      float sum = this->Kernel[0] * here[0];
      for (int n = 1; n <= reach; ++n)
      {
        sum += this->Kernel[std::size_t(n)] * (here[-n] + here[n]);
      }
      trace[k] = std::isnan(trace[k]) ? trace[k] : sum;
    }
  }

private:
  const std::vector<float> Kernel;
  std::vector<float> Padded;
};
}

//----------------------------------------------------------------------------------------------------------------------
TraceCube LowPass(const TraceCube& cube, double period)
{
  return ChangeTraces(cube, Filter(period));
}
}
