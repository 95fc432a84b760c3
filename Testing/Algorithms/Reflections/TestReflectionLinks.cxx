// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links between picks, beside correlations in double precision and a search of all pairs.

#include "Filters/Algorithms/Reflections/ReflectionLinks.h"
#include "PickFixtures.h"
#include "Tools/Check.h"

#include <cmath>
#include <limits>
#include <set>

using namespace PickFixtures;

namespace
{
std::int64_t CountLinks(const ReflectionLinks& links)
{
  std::int64_t number = 0;
  links.ForEach(0, links.Size(), [&number](PointId, int) { ++number; });
  return number;
}

/// The waveform of a pick, interpolated and scaled in double precision.
std::vector<double> Waveform(const float* trace, int samples, double place, int halfWidth)
{
  const auto at = [&](int sample) { return sample < 0 || sample >= samples ? 0.0 : double(trace[sample]); };
  std::vector<double> shape;
  double energy = 0.0;
  for (int n = -halfWidth; n <= halfWidth; ++n)
  {
    const double where = place + n;
    const int base = int(std::floor(where));
    const double t = where - base;
    const double s = 1.0 - t;
    shape.push_back(-0.5 * t * s * s * at(base - 1) + (1.0 + t * t * (1.5 * t - 2.5)) * at(base) +
      (1.0 + s * s * (1.5 * s - 2.5)) * at(base + 1) - 0.5 * s * t * t * at(base + 2));
    energy += shape.back() * shape.back();
  }
  for (double& value : shape)
  {
    value /= std::sqrt(energy);
  }
  return shape;
}

struct Case
{
  Traces Cube;
  ReflectionPicks Picks;
  LinkOptions Options;
  RawVector<std::int32_t> Columns;

  std::vector<double> WaveformOf(PointId pick)
  {
    const int column = this->Columns[std::size_t(pick)];
    const int i = column % this->Cube.Size[0];
    const int j = column / this->Cube.Size[0];
    return Waveform(
      this->Cube.Trace(i, j), this->Cube.Size[2], InSamples(this->Picks.Places[pick]), this->Options.HalfWidth);
  }

  double Correlation(PointId a, PointId b)
  {
    const std::vector<double> first = this->WaveformOf(a);
    const std::vector<double> second = this->WaveformOf(b);
    return std::inner_product(first.begin(), first.end(), second.begin(), 0.0);
  }

  double Score(PointId a, PointId b)
  {
    return this->Correlation(a, b) - 0.05 * std::abs(InSamples(this->Picks.Places[a] - this->Picks.Places[b]));
  }

  /// The best pick of a column for a pick, and by how much it is better than the next.
  std::pair<PointId, double> Best(PointId pick, std::int64_t column)
  {
    PointId best = NoPoint;
    double score = -9.0;
    double next = -9.0;
    for (PointId other = this->Picks.Begin(column); other < this->Picks.End(column); ++other)
    {
      if (std::abs(this->Picks.Places[other] - this->Picks.Places[pick]) <= this->Options.LargestStep)
      {
        const double candidate = this->Score(pick, other);
        next = std::max(next, std::min(score, candidate));
        best = candidate > score ? other : best;
        score = std::max(score, candidate);
      }
    }
    return { best, score - next };
  }
};

Case MakeCase(unsigned seed, ColumnConnectivity connectivity)
{
  Case test;
  test.Cube = Rough({ 5, 19, 40 }, seed); // rows of two threads
  test.Options.Connectivity = connectivity;
  test.Options.LargestStep = 3 * DepthsPerSample;
  test.Options.HalfWidth = 7;
  test.Picks = FindReflections(test.Cube.View()).BySign[0];
  test.Columns = test.Picks.ListColumns();
  return test;
}

void CheckPick(Case& test, const ReflectionLinks& links, PointId pick, int direction)
{
  const ColumnStep step = TraceSteps[std::size_t(direction)];
  const int column = test.Columns[std::size_t(pick)];
  const int i = column % test.Cube.Size[0] + step.I;
  const int j = column / test.Cube.Size[0] + step.J;
  PointId expected = NoPoint;
  if (i >= 0 && i < test.Cube.Size[0] && j < test.Cube.Size[1])
  {
    const auto [best, margin] = test.Best(pick, test.Picks.ColumnAt(i, j));
    const auto [back, backMargin] = best == NoPoint ? std::make_pair(NoPoint, 1.0) : test.Best(best, column);
    if (margin < 1e-3 || backMargin < 1e-3)
    {
      return; // too near to tell in fewer digits
    }
    expected = back == pick ? best : NoPoint;
  }
  CHECK_EQUAL(links.Next(pick, direction), expected);
  if (expected != NoPoint)
  {
    CHECK_EQUAL(links.Previous(expected, direction), pick);
    CHECK(std::abs(links.Correlation(pick, direction) - test.Correlation(pick, expected)) < 5e-4);
    CHECK(std::abs(links.Score(pick, direction) - test.Score(pick, expected)) < 5e-4);
  }
}

void TestOracle(ColumnConnectivity connectivity)
{
  Case test = MakeCase(3, connectivity);
  const ReflectionLinks links(test.Cube.View(), test.Picks, test.Options);
  CHECK_EQUAL(links.Directions(), int(connectivity) / 2);
  CHECK(CountLinks(links) > test.Picks.Size());
  for (PointId pick = 0; pick < test.Picks.Size(); ++pick)
  {
    for (int direction = 0; direction < links.Directions(); ++direction)
    {
      CheckPick(test, links, pick, direction);
    }
  }
}

void TestSortedAndDropped()
{
  Case test = MakeCase(5, ColumnConnectivity::Four);
  ReflectionLinks links(test.Cube.View(), test.Picks, test.Options);
  const auto score = [&links](LinkId link) { return links.Score(links.PickOf(link), links.DirectionOf(link)); };
  const std::vector<LinkId> sorted = SortByRank(links);
  CHECK_EQUAL(std::int64_t(sorted.size()), CountLinks(links));
  CHECK_EQUAL(std::set<LinkId>(sorted.begin(), sorted.end()).size(), sorted.size());
  for (std::size_t n = 1; n < sorted.size(); ++n)
  {
    CHECK(score(sorted[n - 1]) >= score(sorted[n]) - 4e-5 || score(sorted[n - 1]) < -0.3);
  }
  const double median = links.MedianCorrelation();
  const std::int64_t size = CountLinks(links);
  links.Drop(median);
  CHECK(std::abs(double(CountLinks(links)) - 0.5 * double(size)) <= 2.0);
  for (const LinkId link : SortByRank(links))
  {
    CHECK(links.Correlation(links.PickOf(link), links.DirectionOf(link)) >= median);
  }
  std::int64_t backward = 0;
  for (PointId pick = 0; pick < test.Picks.Size(); ++pick)
  {
    for (int direction = 0; direction < 2; ++direction)
    {
      const PointId previous = links.Previous(pick, direction);
      backward += previous != NoPoint ? 1 : 0;
      CHECK(previous == NoPoint || links.Next(previous, direction) == pick);
    }
  }
  CHECK_EQUAL(backward, CountLinks(links));
}

void TestThreads()
{
  Case test = MakeCase(7, ColumnConnectivity::Eight);
  const auto [one, three] = OnThreads([&]() { return ReflectionLinks(test.Cube.View(), test.Picks, test.Options); });
  CHECK(SortByRank(one) == SortByRank(three));
}

/// Traces that are the same but for an amplitude and half a sample correlate fully; missing samples count as 0.
void TestShapes()
{
  Traces traces = Empty({ 2, 1, 60 });
  for (int sample = 0; sample < 60; ++sample)
  {
    traces.Trace(0, 0)[sample] = float(RickerWavelet(25.0, 0.004 * (sample - 30)));
    traces.Trace(1, 0)[sample] = 7.0F * float(RickerWavelet(25.0, 0.004 * (sample - 30.5)));
  }
  traces.Trace(0, 0)[2] = std::numeric_limits<float>::quiet_NaN();
  const ReflectionPicks picks = MakePicks({ 2, 1 }, { { 30.0 }, { 30.5 } });
  LinkOptions options;
  options.HalfWidth = 40; // beyond both ends
  const ReflectionLinks links(traces.View(), picks, options);
  CHECK_EQUAL(links.Next(0, 0), 1);
  CHECK(links.Correlation(0, 0) > 0.998);
  CHECK_EQUAL(CountLinks(ReflectionLinks(traces.View(), MakePicks({ 2, 1 }, { {}, {} }), options)), 0);
  CHECK_EQUAL(ReflectionLinks(traces.View(), MakePicks({ 2, 1 }, { {}, {} }), options).MedianCorrelation(), 0.0);
}

/// Links of picks of which one is three times as strong as the other are dropped.
void TestStrengths()
{
  Traces traces = Empty({ 4, 1, 9 });
  const std::array<float, 4> strengths = { 1.0F, 2.5F, 8.0F, 3.0F };
  for (int i = 0; i < 4; ++i)
  {
    traces.Trace(i, 0)[4] = strengths[std::size_t(i)];
  }
  ReflectionOptions all;
  all.AmplitudePercentile = 0.0;
  const ReflectionPicks picks = FindReflections(traces.View(), all).BySign[0];
  ReflectionLinks links(traces.View(), picks, LinkOptions());
  CHECK_EQUAL(CountLinks(links), 3);
  links.Drop(0.0);
  CHECK_EQUAL(links.Next(0, 0), 1);
  CHECK_EQUAL(links.Next(1, 0), NoPoint);
  CHECK_EQUAL(links.Previous(2, 0), NoPoint);
  CHECK_EQUAL(links.Next(2, 0), 3);
}
}

int TestReflectionLinks(int, char*[])
{
  TestOracle(ColumnConnectivity::Four);
  TestOracle(ColumnConnectivity::Eight);
  TestSortedAndDropped();
  TestThreads();
  TestShapes();
  TestStrengths();
  return Check::Result();
}
