// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMeter.h"

#include "Common/FixedChunks.h"
#include "SurfaceSamples.h"

#include <cmath>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// The histogram is locked once for so many samples.
constexpr std::size_t EntriesAtOnce = 16384;

// The weight of all faces of both surfaces, in the integers of the histogram: small parts of it keep many digits, and
// sums stay below 2^64.
const double TotalWeight = std::ldexp(1.0, 60);

/// Measures samples on the triangles of one chunk.
class FaceMeter
{
public:
  FaceMeter(
    const MeasuredSurface& from, const MeasuredSurface& to, double density, std::uint64_t seed, Histograms& histograms)
    : From(from)
    , Probe(to.Search, from.Metrics)
    , Density(density)
    , Seed(seed)
    , InAll(histograms)
  {
    for (std::size_t metric = 0; metric < from.Metrics.size(); ++metric)
    {
      this->WeightPerArea[metric] = TotalWeight / (from.Area[metric] + to.Area[metric]);
    }
  }

  FaceSums Run(std::int64_t first, std::int64_t last)
  {
    this->From.Search.ForEachTriangle(first, last, [this](std::int32_t triangle) { this->MeasureTriangle(triangle); });
    this->EmptyEntries();
    for (std::size_t metric = 0; metric < this->From.Metrics.size(); ++metric)
    {
      this->Sums.In[metric].Largest = this->Probe.Largest()[metric];
    }
    return this->Sums;
  }

private:
  void MeasureTriangle(std::int32_t triangle)
  {
    const TriangleSurface& surface = this->From.Surface;
    const Corners& t = surface.Triangles[std::size_t(triangle)];
    const double area = this->From.Metrics[0].Area(surface, t);
    if (!(area > 0.0) || !surface.Counts(t))
    {
      return;
    }
    const std::int64_t count = std::max<std::int64_t>(1, std::int64_t(area * this->Density + 0.5));
    for (std::size_t metric = 0; metric < this->From.Metrics.size(); ++metric)
    {
      const double inMetric = metric == 0 ? area : this->From.Metrics[metric].Area(surface, t);
      this->Sums.In[metric].Area += inMetric;
      this->Share[metric] = inMetric / double(count);
      this->Weight[metric] = std::uint64_t(this->Share[metric] * this->WeightPerArea[metric]);
    }
    this->Sums.Samples += count;
    SampleTriangle(surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]), count,
      Scramble(this->Seed ^ Scramble(std::uint64_t(triangle))),
      [this](const Eigen::Vector3d& place) { this->MeasurePlace(place); });
  }

  void MeasurePlace(const Eigen::Vector3d& place)
  {
    const MetricValues& found = this->Probe(place);
    for (std::size_t metric = 0; metric < this->From.Metrics.size(); ++metric)
    {
      const double distance = found[metric];
      FaceSums::Sums& sums = this->Sums.In[metric];
      sums.Distance += this->Share[metric] * distance;
      sums.Square += this->Share[metric] * distance * distance;
      this->Entries[metric].push_back(WeightedHistogram::MakeEntry(distance, this->Weight[metric]));
    }
    if (this->Entries[0].size() == EntriesAtOnce)
    {
      this->EmptyEntries();
    }
  }

  void EmptyEntries()
  {
    for (std::size_t metric = 0; metric < this->From.Metrics.size(); ++metric)
    {
      this->InAll[metric].Add(this->Entries[metric]);
    }
  }

  const MeasuredSurface& From;
  DistanceProbe Probe;
  double Density;
  std::uint64_t Seed;
  Histograms& InAll;
  MetricValues WeightPerArea = {};
  FaceSums Sums;
  std::array<std::vector<WeightedHistogram::Entry>, MostMetrics> Entries;
  // Of each sample on the triangle that is measured.
  MetricValues Share = {};
  std::array<std::uint64_t, MostMetrics> Weight = {};
};
}

//----------------------------------------------------------------------------------------------------------------------
FaceSums MeasureFaces(const MeasuredSurface& from, const MeasuredSurface& to, double density, std::uint64_t seed,
  Histograms& histograms, const Monitor& monitor)
{
  return AddUpChunks<FaceSums>(from.Search.Pieces(), TriangleSearch::PiecesPerChunk, monitor,
    [&](FaceSums& sums, std::int64_t first, std::int64_t last)
    { sums = FaceMeter(from, to, density, seed, histograms).Run(first, last); });
}
}
