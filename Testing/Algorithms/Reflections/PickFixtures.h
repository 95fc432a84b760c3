// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Small cubes and picks for tests.

#ifndef SeismicHorizonsPickFixtures_h
#define SeismicHorizonsPickFixtures_h

#include "Common/Base/Parallel.h"
#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Generator/CubeGenerator.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace PickFixtures
{
using namespace SeismicHorizons;

/// Traces one after the other: that of column (i, j) is number i + nX j.
struct Traces
{
  std::array<int, 3> Size = { 0, 0, 0 };
  std::vector<float> Samples;

  TraceCube View() const
  {
    StridedSamples<float> samples;
    samples.First = this->Samples.data();
    samples.Strides = { this->Size[2], std::ptrdiff_t(this->Size[0]) * this->Size[2], 1 };
    return MakeTraceCube(this->Size, samples);
  }

  float* Trace(int i, int j)
  {
    return this->Samples.data() +
      (std::size_t(j) * std::size_t(this->Size[0]) + std::size_t(i)) * std::size_t(this->Size[2]);
  }
};

inline Traces Empty(const std::array<int, 3>& size)
{
  return { size, std::vector<float>(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]), 0.0F) };
}

inline Traces Generate(const CubeGeneratorOptions& options)
{
  return { options.Size, CubeGenerator(options).MakeTraces() };
}

/// Noise that is smooth along i and j, in which picks have neighbours, and wrong ones.
inline Traces Rough(const std::array<int, 3>& size, unsigned seed)
{
  Traces traces = Empty(size);
  std::mt19937 random(seed);
  std::vector<float> layer(static_cast<std::size_t>(size[2]));
  std::generate(layer.begin(), layer.end(), [&random]() { return float(random() % 2001) / 1000.0F - 1.0F; });
  for (float& sample : traces.Samples)
  {
    sample =
      layer[std::size_t(&sample - traces.Samples.data()) % layer.size()] + float(random() % 1001) / 1000.0F - 0.5F;
  }
  return traces;
}

/// Picks at these places, in samples: for each column a list that rises.
inline ReflectionPicks MakePicks(const std::array<int, 2>& columns, const std::vector<std::vector<double>>& places)
{
  ReflectionPicks picks;
  picks.Columns = columns;
  picks.Starts.push_back(0);
  for (const std::vector<double>& column : places)
  {
    for (const double place : column)
    {
      picks.Places.push_back(PickDepth(place * DepthsPerSample));
      picks.Strengths.push_back(CoarseStrength(1.0F));
    }
    picks.Starts.push_back(PointId(picks.Places.size()));
  }
  return picks;
}

/// All links, by rank; of equal ones that of the first pick first.
inline std::vector<LinkId> SortByRank(const ReflectionLinks& links)
{
  std::vector<std::pair<std::int64_t, LinkId>> ranked;
  links.ForEach(0, links.Size(), [&](PointId pick, int direction)
    { ranked.emplace_back(links.Rank(pick, direction), links.MakeId(pick, direction)); });
  std::sort(ranked.begin(), ranked.end());
  std::vector<LinkId> sorted;
  for (const auto& [rank, link] : ranked)
  {
    sorted.push_back(link);
  }
  return sorted;
}

/// Runs work() on one thread and on three, and gives both results.
template <typename Work>
auto OnThreads(Work&& work)
{
  int& threads = Detail::NumberOfThreads();
  const int usual = std::exchange(threads, 1);
  auto one = work();
  threads = 3;
  auto three = work();
  threads = usual;
  return std::make_pair(std::move(one), std::move(three));
}

/// A wavelet of three samples at a place.
inline void Put(float* trace, int sample, float strength)
{
  trace[sample - 1] += strength;
  trace[sample] += 2.0F * strength;
  trace[sample + 1] += strength;
}

inline Extraction Follow(const Traces& traces, const std::vector<Guide>& guides, const ExtractionOptions& options = {})
{
  return ExtractReflections(traces.View(), options, Monitor(), guides);
}
}

#endif
