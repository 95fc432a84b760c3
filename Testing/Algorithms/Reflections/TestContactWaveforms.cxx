// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Mean waveforms on both sides of a contact, in cubes of noise.

#include "Filters/Algorithms/Reflections/ReflectionLinks.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

using namespace PickFixtures;

namespace
{
constexpr int Rows = 60;

/// Two columns of reflections at sample 30, with another one 12 samples below in the first column, and so far below in
/// the second. Noise is as strong as the signal.
Traces MakeTraces(int distance)
{
  Traces traces = Empty({ 2, Rows, 60 });
  std::mt19937 random(3);
  for (int n = 0; n < 2 * Rows; ++n)
  {
    float* const trace = traces.Trace(n % 2, n / 2);
    const int second = 30 + (n % 2 == 0 ? 12 : distance);
    for (int sample = 0; sample < 60; ++sample)
    {
      const double noise = double(random() % 2001) / 1000.0 - 1.0;
      trace[sample] = float(
        RickerWavelet(30.0, 0.004 * (sample - 30)) + RickerWavelet(30.0, 0.004 * (sample - second)) + 0.5 * noise);
    }
  }
  return traces;
}

double Correlate(int distance, int rows)
{
  const Traces traces = MakeTraces(distance);
  const TraceCube cube = traces.View();
  const ReflectionPicks picks =
    MakePicks({ 2, Rows }, std::vector<std::vector<double>>(std::size_t(2 * Rows), { 30.0 }));
  std::vector<Edge> pairs;
  for (PointId j = 0; j < rows; ++j)
  {
    pairs.push_back({ 2 * j, 2 * j + 1 });
  }
  const double correlation = MakeContactCorrelation(cube, picks, 20)(pairs);
  std::reverse(pairs.begin(), pairs.end());
  CHECK_EQUAL(MakeContactCorrelation(cube, picks, 20)(pairs), correlation);
  return correlation;
}
}

int TestContactWaveforms(int, char*[])
{
  CHECK(Correlate(12, 1) < 0.7);
  CHECK(Correlate(12, Rows) > 0.95);
  CHECK(Correlate(15, Rows) < 0.8);
  CHECK_EQUAL(Correlate(12, 0), 0.0);
  return Check::Result();
}
