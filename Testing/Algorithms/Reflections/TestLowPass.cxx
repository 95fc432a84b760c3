// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The filter of noisy traces on waves, a spike and missing samples.

#include "Filters/Algorithms/Reflections/LowPass.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace PickFixtures;

namespace
{
constexpr double Period = 24.0;
constexpr int Samples = 480;

std::vector<float> FilterTrace(const std::vector<float>& samples)
{
  const Traces traces = { { 1, 1, int(samples.size()) }, samples };
  std::vector<float> filtered(samples.size());
  LowPass(traces.View(), Period).Read(0, 0, 1, filtered.data());
  return filtered;
}

/// The amplitude that is left of a wave, far from the ends of the trace.
double AmplitudeLeft(double period)
{
  std::vector<float> wave(Samples);
  for (int k = 0; k < Samples; ++k)
  {
    wave[k] = float(std::cos(6.283185307179586 * (k - 240) / period));
  }
  const std::vector<float> filtered = FilterTrace(wave);
  CHECK(std::abs(std::abs(filtered[240]) - *std::max_element(filtered.begin() + 120, filtered.end() - 120)) < 1e-6);
  return double(filtered[240]);
}

void TestWaves()
{
  CHECK(std::abs(AmplitudeLeft(Period) - 1.0) < 0.001);
  CHECK(std::abs(AmplitudeLeft(1e6) - 1.13) < 0.01);
  CHECK(std::abs(AmplitudeLeft(Period / 2.0) - 0.68) < 0.01);
  CHECK(std::abs(AmplitudeLeft(Period / 4.0) - 0.15) < 0.01);
  CHECK(std::abs(AmplitudeLeft(4.0)) < 0.02);
}

/// A spike stays where it is; missing samples stay missing, and leave the others as zeros would.
void TestSpike()
{
  std::vector<float> spike(Samples, 0.0F);
  spike[100] = 1.0F;
  const std::vector<float> filtered = FilterTrace(spike);
  CHECK(std::max_element(filtered.begin(), filtered.end()) == filtered.begin() + 100);
  CHECK(*std::min_element(filtered.begin(), filtered.end()) == 0.0F); // It makes no waves.
  for (int k = 1; k < 50; ++k)
  {
    CHECK_EQUAL(filtered[100 - k], filtered[100 + k]);
  }
  spike[97] = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> holed = FilterTrace(spike);
  CHECK(std::isnan(holed[97]));
  holed[97] = filtered[97];
  CHECK(holed == filtered);
}
}

int TestLowPass(int, char*[])
{
  TestWaves();
  TestSpike();
  return Check::Result();
}
