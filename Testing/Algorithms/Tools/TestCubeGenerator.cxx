// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The generator of seismic cubes: traces are what its reflectors say, options do what they promise, files are SEG-Y,
// and it makes what it always made.

#include "Check.h"
#include "Generator/CubeGenerator.h"
#include "Generator/SEGYPrinter.h"

#include <cmath>
#include <cstring>
#include <numeric>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
CubeGeneratorOptions SmallCube()
{
  CubeGeneratorOptions options;
  options.Size = { 40, 32, 220 };
  return options;
}

const float* TraceOf(const std::vector<float>& traces, const CubeGeneratorOptions& options, int i, int j)
{
  return traces.data() +
    (std::size_t(j) * std::size_t(options.Size[0]) + std::size_t(i)) * std::size_t(options.Size[2]);
}

/// The wavelet of the library's own functions.
void TestWavelet()
{
  for (double time = -0.08; time <= 0.08; time += 0.0007)
  {
    const double a = std::pow(3.14159265358979323846 * 30.0 * time, 2);
    CHECK(std::abs(RickerWavelet(30.0, time) - (1.0 - 2.0 * a) * std::exp(-a)) < 1e-11);
  }
  CHECK_EQUAL(RickerWavelet(30.0, 0.0), 1.0);
  CHECK_EQUAL(RickerWavelet(30.0, 1.0), 0.0);
}

/// A trace is the wavelet at each of its reflectors, far from each other on an easy cube: the vertex of the parabola
/// around it is there within three hundredths of a sample, and the trace fits its samples.
void TestTraces()
{
  const CubeGeneratorOptions options = SmallCube();
  const CubeGenerator cube(options);
  const std::vector<float> traces = cube.MakeTraces();
  int places = 0;
  int gaps = 0;
  for (int j = 0; j < options.Size[1]; ++j)
  {
    for (int i = 0; i < options.Size[0]; ++i)
    {
      for (int n = 0; n < cube.Truth().Size(); ++n)
      {
        const double place = cube.Truth().Place(n, i, j);
        const int sample = int(std::lround(place == place ? place : 0.0));
        if (!(place == place))
        {
          ++gaps;
        }
        else if (sample > 0 && sample + 1 < options.Size[2])
        {
          const float* const trace = TraceOf(traces, options, i, j) + sample;
          const double expected = cube.Truth().Strength(n, i, j) * RickerWavelet(30.0, 0.004 * (sample - place));
          CHECK(std::abs(double(trace[0]) - expected) < 2e-3);
          const double vertex = 0.5 * (trace[-1] - trace[1]) / (trace[-1] - 2.0 * trace[0] + trace[1]);
          CHECK(std::abs(sample + vertex - place) < 0.03);
          ++places;
        }
      }
    }
  }
  CHECK(places > 6000 && gaps > 100);
}

double RootMeanSquare(const std::vector<float>& values)
{
  double sum = 0.0;
  for (const float value : values)
  {
    sum += double(value) * double(value);
  }
  return std::sqrt(sum / double(values.size()));
}

void TestNoise()
{
  CubeGeneratorOptions options = SmallCube();
  const std::vector<float> quiet = CubeGenerator(options).MakeTraces();
  const auto isWave = [](NoiseKind kind) { return kind == NoiseKind::Coherent || kind == NoiseKind::Mixed; };
  for (const NoiseKind kind : { NoiseKind::White, NoiseKind::InBand, NoiseKind::Coherent, NoiseKind::Mixed })
  {
    options.NoiseFraction = 0.5;
    options.Noise = kind;
    std::vector<float> noise = CubeGenerator(options).MakeTraces();
    double neighbours = 0.0;
    for (std::size_t n = 0; n < noise.size(); ++n)
    {
      noise[n] -= quiet[n];
      neighbours += n > 0 ? double(noise[n]) * double(noise[n - 1]) : 0.0;
    }
    const double height = RootMeanSquare(noise);
    // The same waves go through all traces: there are few of them, and linear interpolation takes a little.
    CHECK(std::abs(height / RootMeanSquare(quiet) - 0.5) < (isWave(kind) ? 0.08 : 0.01));
    const double correlation = neighbours / double(noise.size()) / (height * height);
    CHECK(kind == NoiseKind::White ? std::abs(correlation) < 0.01 : correlation > 0.4);
  }
}

/// The Hilbert transform of the wavelet is odd, has its energy, and none of it in common with it; turned by 90 degrees,
/// a reflection is 0 at its place.
void TestPhase()
{
  double own = 0.0;
  double turned = 0.0;
  double common = 0.0;
  for (int n = -400; n <= 400; ++n)
  {
    const double time = n * 0.0002;
    const double a = RickerWavelet(30.0, time);
    const double b = TurnedRickerWavelet(30.0, time);
    CHECK(std::abs(b + TurnedRickerWavelet(30.0, -time)) < 1e-12);
    own += a * a;
    turned += b * b;
    common += a * b;
  }
  CHECK(std::abs(turned / own - 1.0) < 0.001);
  CHECK(std::abs(common / own) < 1e-9);
  CubeGeneratorOptions options;
  options.FoldHeight = 0.0;
  options.FaultThrow = 0.0;
  options.Phase = 180.0;
  const std::vector<float> reversed = CubeGenerator(options).MakeTraces();
  options.Phase = 0.0;
  const std::vector<float> plain = CubeGenerator(options).MakeTraces();
  for (std::size_t n = 0; n < plain.size(); ++n)
  {
    CHECK(std::abs(plain[n] + reversed[n]) < 1e-5F);
  }
}

/// Old layers are below the unconformity and cut off by it, young ones above it. Short faults throw layers by what is
/// left of their throw, and not at all beyond their ends.
void TestWildCube()
{
  int eroded = 0;
  int missing = 0;
  int thrown = 0;
  int same = 0;
  CubeGeneratorOptions options = WildCube(5);
  const CubeReflectors truth(options);
  options.ShortFaults = 0;
  options.Channels = 0;
  const CubeReflectors unbroken(options);
  options.HasUnconformity = false;
  const CubeReflectors plain(options);
  CHECK_EQUAL(truth.Size(), plain.Size() + 1);
  for (int j = 0; j < options.Size[1]; ++j)
  {
    for (int i = 0; i < options.Size[0]; ++i)
    {
      double last = -1.0;
      for (int n = 0; n < truth.Size(); ++n)
      {
        const double place = unbroken.Place(n, i, j);
        const double broken = truth.Place(n, i, j);
        const bool isPlain = n < plain.Size() && plain.Place(n, i, j) == plain.Place(n, i, j);
        missing += place == place ? 0 : 1;
        eroded += isPlain && !(place == place) ? 1 : 0;
        thrown += broken > place ? 1 : 0;
        same += broken == place ? 1 : 0;
        CHECK(!(broken < place));
        CHECK(!(place == place) || place > last);
        last = place == place ? place : last;
      }
    }
  }
  CHECK(eroded > 1000 && missing > eroded && thrown > 10000 && same > 10000);
}

/// The throw of the fault, its gap, the channel, and dead and missing traces.
void TestFeatures()
{
  CubeGeneratorOptions options = HardCube(7);
  options.DeadFraction = 0.1;
  options.MissingFraction = 0.1;
  const CubeGenerator cube(options);
  const CubeReflectors& truth = cube.Truth();
  CubeGeneratorOptions unbroken = options;
  unbroken.FaultThrow = 0.0;
  unbroken.Channels = 0;
  const CubeReflectors whole(unbroken);
  CHECK_EQUAL(whole.Size(), truth.Size());
  const std::vector<float> traces = cube.MakeTraces();
  int dead = 0;
  int missing = 0;
  int channel = 0;
  for (int j = 0; j < options.Size[1]; ++j)
  {
    for (int i = 0; i < options.Size[0]; ++i)
    {
      const double place = truth.Place(2, i, j);
      const double before = whole.Place(2, i, j);
      const bool isThrown = truth.FaultDistance(i, j, place) > 0.0;
      CHECK(!(place == place) || std::abs(place - before - (isThrown ? options.FaultThrow : 0.0)) < 1e-9);
      const float first = TraceOf(traces, options, i, j)[0];
      CHECK_EQUAL(first != first, truth.IsMissing(i, j));
      dead += truth.IsDead(i, j) ? 1 : 0;
      missing += truth.IsMissing(i, j) ? 1 : 0;
      const double bottom = truth.ChannelPlace(0, i, j);
      channel += bottom == bottom ? 1 : 0;
      CHECK(!(bottom == bottom) || !(truth.Place(truth.ChannelReflector(0), i, j) == bottom));
    }
  }
  CHECK(std::abs(dead / 5120.0 - 0.1) < 0.02 && std::abs(missing / 5120.0 - 0.1) < 0.02 && channel > 200);
}

std::uint32_t Number(const std::string& bytes, std::size_t position, std::size_t size)
{
  std::uint32_t value = 0;
  for (std::size_t n = 0; n < size; ++n)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[position - 1 + n]);
  }
  return value;
}

void TestFile()
{
  CubeGeneratorOptions options = SmallCube();
  options.Size = { 5, 4, 60 };
  options.MissingFraction = 0.3;
  options.Seed = 3;
  const CubeGenerator cube(options);
  const std::vector<float> traces = cube.MakeTraces();
  std::ostringstream stream;
  WriteSEGY(options, traces, CubeSurvey(), stream);
  const std::string file = stream.str();
  CHECK_EQUAL(Number(file, 1, 4), 0xC340F140u); // "C 1 "
  CHECK_EQUAL(Number(file, 3200 + 17, 2), 4000u);
  CHECK_EQUAL(Number(file, 3200 + 21, 2), 60u);
  CHECK_EQUAL(Number(file, 3200 + 25, 2), 5u);
  std::size_t position = 3600;
  for (int column = 0; column < 20; ++column)
  {
    if (cube.Truth().IsMissing(column % 5, column / 5))
    {
      continue;
    }
    const std::string trace = file.substr(position, 240 + 4 * 60);
    CHECK_EQUAL(Number(trace, 189, 4), 1001u + std::uint32_t(column / 5));
    CHECK_EQUAL(Number(trace, 193, 4), 2001u + std::uint32_t(column % 5));
    CHECK_EQUAL(
      Number(trace, 181, 4), 60432125u + std::uint32_t(column % 5) * 2165u - std::uint32_t(column / 5) * 1250u);
    CHECK_EQUAL(Number(trace, 71, 2), 0xFFFFu - 99u);
    const std::uint32_t bits = Number(trace, 240 + 4 * 30 + 1, 4);
    float sample = 0.0F;
    std::memcpy(&sample, &bits, sizeof(bits));
    CHECK_EQUAL(sample, TraceOf(traces, options, column % 5, column / 5)[30]);
    position += trace.size();
  }
  CHECK_EQUAL(position, file.size());
  CHECK(position < 3600u + 20 * 480);
  std::ostringstream truth;
  WriteTruth(cube, CubeSurvey(), truth);
  CHECK_EQUAL(truth.str().substr(0, 43), "Horizon Inline Crossline X Y Z Sample Side\n");
}

/// A hash of the bytes: the same on all machines and for all times.
void TestSame()
{
  CubeGeneratorOptions options = HardCube(1);
  options.Size = { 24, 20, 120 };
  options.NoiseFraction = 0.2;
  options.Noise = NoiseKind::InBand;
  std::ostringstream stream;
  WriteSEGY(options, CubeGenerator(options).MakeTraces(), CubeSurvey(), stream);
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char byte : stream.str())
  {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3u;
  }
  CHECK_EQUAL(hash, 4762826659664679606u);
}

void TestErrors()
{
  const auto refuse = [](auto&& change, const std::string& message)
  {
    CubeGeneratorOptions options;
    change(options);
    CHECK_THROWS_WITH(CubeGenerator(options), message);
  };
  refuse([](auto& options) { options.Size[1] = 0; }, "rows 0, expected 1 to 100000");
  refuse([](auto& options) { options.Spacing = 1.0; }, "spacing 1, expected 4 to 32767 samples");
  refuse([](auto& options) { options.Frequency = 200.0; }, "frequency 200, expected 0.1 to 125 Hz");
  refuse([](auto& options) { options.NoiseFraction = std::nan(""); }, "noise nan, expected 0 to 100");
}
}

int TestCubeGenerator(int, char*[])
{
  TestWavelet();
  TestTraces();
  TestNoise();
  TestPhase();
  TestWildCube();
  TestFeatures();
  TestFile();
  TestSame();
  TestErrors();
  return Check::Result();
}
