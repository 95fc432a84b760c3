// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reflections of a cube: thresholds, the dominant period, the order of picks, threads, samples in any order,
// errors.

#include "PickFixtures.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

#include <cmath>
#include <limits>

using namespace PickFixtures;

namespace
{
ReflectionOptions Amplitude(double threshold)
{
  ReflectionOptions options;
  options.Threshold = ThresholdKind::Amplitude;
  options.AmplitudeThreshold = threshold;
  return options;
}

ReflectionOptions Percentile(double percentile, ReflectionPosition position = ReflectionPosition::Peak)
{
  ReflectionOptions options;
  options.AmplitudePercentile = percentile;
  options.Position = position;
  return options;
}

/// The smallest of sorted numbers that so many percent are below.
float Select(std::vector<float> numbers, double percentile)
{
  std::sort(numbers.begin(), numbers.end());
  const double rank = std::ceil(percentile / 100.0 * double(numbers.size()));
  return numbers[std::min(numbers.size() - 1, std::size_t(rank))];
}

/// Traces of one sample: their strengths are the numbers. Those of 0 are no reflections.
void TestSelection()
{
  std::mt19937 random(1);
  std::vector<float> numbers;
  for (int size = 1; size < 300; size += 7)
  {
    while (int(numbers.size()) < size)
    {
      numbers.push_back(std::ldexp(float(1 + random() % 1000), int(random() % 40) - 20));
    }
    for (const double percentile : { 50.0, 99.7, 1.0 + size % 100 })
    {
      const Traces traces = { { size, 1, 1 }, numbers };
      const float expected = Select(numbers, percentile);
      for (const ReflectionPosition position : { ReflectionPosition::Peak, ReflectionPosition::Middle })
      {
        const float found = FindReflections(traces.View(), Percentile(percentile, position)).Threshold;
        if (found != expected)
        {
          CHECK_EQUAL(found, expected);
          return;
        }
      }
    }
  }
  CHECK_EQUAL(FindReflections(Empty({ 2, 2, 2 }).View(), Percentile(50.0)).Threshold, 0.0F);
}

/// Ten traces with a peak of 1, 2 to 10.
Traces Stairs()
{
  Traces traces = Empty({ 5, 2, 7 });
  for (int n = 0; n < 10; ++n)
  {
    float* const trace = traces.Trace(n % 5, n / 5);
    trace[3] = float(n + 1) * (n % 2 == 0 ? 1.0F : -1.0F);
    trace[2] = trace[4] = 0.5F * trace[3];
  }
  return traces;
}

void TestThresholds()
{
  const Traces traces = Stairs();
  const auto count = [&](const ReflectionOptions& options)
  { return FindReflections(traces.View(), options).CountPicks(); };
  CHECK_EQUAL(count(Amplitude(0.0)), 10);
  CHECK_EQUAL(count(Amplitude(7.0)), 4); // 7 itself is strong enough
  CHECK_EQUAL(count(Amplitude(7.1)), 3);
  CHECK_EQUAL(count(Amplitude(11.0)), 0);
  CHECK_EQUAL(count(Percentile(0.0)), 10);
  // Samples other than 0: twice 0.5 to 5 and once 1 to 10; 4 comes 18th to 20th.
  CHECK_EQUAL(count(Percentile(60.0)), 7);
  CHECK_EQUAL(count(Percentile(100.0)), 1);
  CHECK_EQUAL(FindReflections(traces.View(), Percentile(60.0)).Threshold, 4.0F);
  ReflectionOptions positive = Percentile(40.0);
  positive.Polarity = ReflectionPolarity::Positive;
  CHECK_EQUAL(FindReflections(traces.View(), positive).Threshold, 2.5F);
  CHECK_EQUAL(count(positive), 4);
  const CubeReflections middle = FindReflections(traces.View(), Percentile(60.0, ReflectionPosition::Middle));
  CHECK_EQUAL(middle.Threshold, 4.0F);
  CHECK_EQUAL(middle.CountPicks(), 7);
  CHECK_EQUAL(middle.Rules.SampleThreshold, 4.0F); // what belongs to a run
  positive.Position = ReflectionPosition::Middle;
  CHECK_EQUAL(FindReflections(traces.View(), positive).Threshold, 2.5F);
}

void TestOrder()
{
  Traces traces = Empty({ 2, 2, 8 });
  traces.Trace(1, 0)[1] = 1.0F;
  traces.Trace(1, 0)[3] = -2.0F;
  traces.Trace(1, 0)[5] = 3.0F;
  traces.Trace(0, 1)[7] = 4.0F;
  const CubeReflections found = FindReflections(traces.View(), Amplitude(0.0));
  CHECK((found.BySign[0].Starts == std::vector<PointId>{ 0, 0, 2, 3, 3 }));
  CHECK((found.BySign[1].Starts == std::vector<PointId>{ 0, 0, 1, 1, 1 }));
  CHECK_EQUAL(found.BySign[0].Places[1], 5 * DepthsPerSample);
  CHECK_EQUAL(found.BySign[0].StrengthOf(2), 4.0F);
  CHECK_EQUAL(found.BySign[0].ListColumns()[2], 2);
  CHECK_EQUAL(found.Samples, 32);
}

/// Runs of 4 samples, and a long one of next to nothing. Without noise, the run around a Ricker wavelet is 0.45 / f.
void TestPeriod()
{
  Traces traces = Empty({ 1, 1, 60 });
  std::fill_n(traces.Trace(0, 0), 4, 1.0F);
  std::fill_n(traces.Trace(0, 0) + 10, 40, 0.01F);
  CHECK(std::abs(FindReflections(traces.View(), Amplitude(0.0)).Period - 8.0) < 0.1);
  CHECK_EQUAL(FindReflections(traces.View(), Amplitude(2.0)).Period, 0.0);
  CubeGeneratorOptions options;
  options.Size = { 10, 10, 220 };
  options.Frequency = 20.0;
  CHECK(std::abs(FindReflections(Generate(options).View()).Period - 0.9 / 20.0 / 0.004) < 1.0);
}

/// Samples of any type in any order, with marks, give the same.
void TestStrides()
{
  const Traces traces = Rough({ 70, 3, 37 }, 4); // more than a block, and no multiple of a square
  std::vector<double> samples(traces.Samples.size());
  std::vector<unsigned char> marks(samples.size(), 1);
  Traces blanked = traces;
  const auto [nX, nY, nZ] = traces.Size;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const std::size_t k = n % std::size_t(nZ);
    const std::size_t column = n / std::size_t(nZ);
    const std::size_t place = column + k * std::size_t(nX * nY);
    samples[place] = traces.Samples[n];
    if (n % 11 == 3)
    {
      marks[place] = 6;
      blanked.Samples[n] = std::numeric_limits<float>::quiet_NaN();
    }
    else if (n % 17 == 5)
    {
      samples[place] = std::numeric_limits<double>::infinity();
      blanked.Samples[n] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  StridedSamples<double> strided;
  strided.First = samples.data();
  strided.Strides = { 1, nX, std::ptrdiff_t(nX) * nY };
  strided.Marks = marks.data();
  strided.MissingMask = 2;
  const CubeReflections expected = FindReflections(blanked.View());
  const CubeReflections found = FindReflections(MakeTraceCube(traces.Size, strided));
  CHECK_EQUAL(found.Samples, expected.Samples);
  CHECK(found.Samples < std::int64_t(samples.size()));
  for (const std::size_t sign : { 0, 1 })
  {
    CHECK(found.BySign[sign].Starts == expected.BySign[sign].Starts);
    CHECK(found.BySign[sign].Places == expected.BySign[sign].Places);
    CHECK(found.BySign[sign].Strengths == expected.BySign[sign].Strengths);
  }
}

void TestErrors()
{
  const Traces traces = Stairs();
  CHECK_THROWS_WITH(FindReflections(traces.View(), Amplitude(-1.0)), "AmplitudeThreshold -1, expected at least 0");
  CHECK_THROWS_WITH(FindReflections(traces.View(), Amplitude(std::nan(""))),
    "AmplitudeThreshold nan, expected a finite number, at least 0");
  CHECK_THROWS_WITH(
    FindReflections(traces.View(), Percentile(101.0)), "AmplitudePercentile 101, expected 0 to 100 percent");
  CHECK_THROWS_WITH(FindReflections(traces.View(), Percentile(-1.0)), "AmplitudePercentile -1, expected 0 to 100");
  CHECK_THROWS_WITH(
    FindReflections(traces.View(), Percentile(std::nan(""))), "AmplitudePercentile nan, expected 0 to 100");
  CHECK_THROWS_WITH(
    FindReflections(Empty({ 3, 0, 5 }).View()), "a cube of 3 x 0 traces of 5 samples, expected at least one each way");
  CHECK_THROWS_WITH(FindReflections(TraceCube{ { 1, 1, 1 << 18 }, nullptr }),
    "a cube of 1 x 1 traces of 262144 samples, expected at most 262143 samples each");
  CHECK_THROWS_WITH(FindReflections(TraceCube{ { 1 << 16, 1 << 15, 1 }, nullptr }), "expected less than 2^31 traces");
  Traces missing = Empty({ 2, 2, 2 });
  std::fill(missing.Samples.begin(), missing.Samples.end(), std::numeric_limits<float>::quiet_NaN());
  CHECK_THROWS_WITH(FindReflections(missing.View()),
    "no amplitude: all samples of the cube are blanked or not finite, expected numbers");
  CHECK_EQUAL(FindReflections(Empty({ 2, 2, 2 }).View()).CountPicks(), 0); // dead traces
}

void TestMonitor()
{
  const Traces traces = Rough({ 4, 40, 30 }, 1);
  CHECK_EQUAL(MonitorChecker::Check(2,
                [&](const Monitor& monitor)
                { FindReflections(traces.View(), Percentile(50.0, ReflectionPosition::Middle), monitor); }),
    "");
}
}

int TestReflectionFinder(int, char*[])
{
  TestSelection();
  TestThresholds();
  TestOrder();
  TestPeriod();
  TestStrides();
  TestErrors();
  TestMonitor();
  return Check::Result();
}
