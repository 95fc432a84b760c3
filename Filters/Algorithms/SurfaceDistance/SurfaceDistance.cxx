// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each direction takes five passes:
//
// MeasurePoints: all points, which are results, too
// MeasureEdges: samples of edges that may be farther than any place so far
// FaceMeter: samples of faces, by area, for means and percentiles
// FindLargestDistance (LargestDistance.h): bounds of all distances
// MeasureOutline: outlines, in plan
//
//
// Faces follow the order of their own search structure, so that each search begins near the last result. Chunks, seeds
// by edge or triangle, and integer weights make results independent of the number of threads.

#include "SurfaceDistance.h"

#include "Common/Base/FixedChunks.h"
#include "DistanceProbe.h"
#include "LargestDistance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// ---- Percentiles ----------------------------------------------------------------------------------------------------

/// Bins are 1/1024 of the value wide, from 2^-64 to 2^64; smaller values count as 0, larger as infinite. Integer
/// weights make sums independent of their order.
class WeightedHistogram
{
public:
  struct Entry
  {
    std::uint32_t Bin;
    std::uint64_t Weight;
  };

  static Entry MakeEntry(double value, std::uint64_t weight) { return { BinOf(value), weight }; }

  /// Clears the list. Threads may call it in parallel.
  void Add(std::vector<Entry>& entries)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const Entry& entry : entries)
    {
      this->Weights[entry.Bin] += entry.Weight;
    }
    entries.clear();
  }

  void Add(const WeightedHistogram& other)
  {
    std::transform(this->Weights.begin(), this->Weights.end(), other.Weights.begin(), this->Weights.begin(),
      [](std::uint64_t a, std::uint64_t b) { return a + b; });
  }

  /// `fraction` is 0 to 1. Returns a value to 1/1024, or NaN without weight.
  double Percentile(double fraction) const
  {
    const double wanted =
      fraction * double(std::accumulate(this->Weights.begin(), this->Weights.end(), std::uint64_t(0)));
    std::uint64_t below = 0;
    for (std::uint32_t bin = 0; bin < Bins; ++bin)
    {
      const std::uint64_t weight = this->Weights[bin];
      if (weight > 0 && double(below + weight) >= wanted)
      {
        const double within = (wanted - double(below)) / double(weight);
        return bin == 0     ? 0.0
          : bin == Bins - 1 ? std::numeric_limits<double>::infinity()
                            : LowEnd(bin) + within * (LowEnd(bin + 1) - LowEnd(bin));
      }
      below += weight;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// Returns 0 to 1.
  double FractionUpTo(double value) const
  {
    const std::uint32_t last = BinOf(value);
    const auto bin = this->Weights.begin() + std::ptrdiff_t(last);
    const bool hasEnds = last > 0 && last < Bins - 1;
    const double within = hasEnds ? (value - LowEnd(last)) / (LowEnd(last + 1) - LowEnd(last)) : 1.0;
    const double below = double(std::accumulate(this->Weights.begin(), bin, std::uint64_t(0)));
    const double all = double(std::accumulate(bin, this->Weights.end(), std::uint64_t(0))) + below;
    return (below + within * double(*bin)) / all;
  }

private:
  static constexpr int LeastExponent = -64;
  static constexpr int GreatestExponent = 64;
  static constexpr std::uint32_t BinsPerOctave = 1024; // of equal width
  // The first bin is for 0, the last for infinity.
  static constexpr std::uint32_t Bins = std::uint32_t(GreatestExponent - LeastExponent) * BinsPerOctave + 2;

  static std::uint32_t BinOf(double value)
  {
    assert(value >= 0.0);
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent); // from 1/2 to below 1
    if (value == 0.0 || exponent <= LeastExponent)
    {
      return 0;
    }
    if (!std::isfinite(value) || exponent > GreatestExponent)
    {
      return Bins - 1;
    }
    return 1 + std::uint32_t(exponent - 1 - LeastExponent) * BinsPerOctave +
      std::uint32_t((2.0 * fraction - 1.0) * BinsPerOctave);
  }

  static double LowEnd(std::uint32_t bin)
  {
    const double fraction = 1.0 + double((bin - 1) % BinsPerOctave) / BinsPerOctave;
    return std::ldexp(fraction, int((bin - 1) / BinsPerOctave) + LeastExponent);
  }

  std::mutex Mutex;
  std::vector<std::uint64_t> Weights = std::vector<std::uint64_t>(Bins, 0);
};

constexpr std::int64_t TrianglesPerGradingChunk = 4096; // per lock of the histogram

// ---- A surface to measure from and to -------------------------------------------------------------------------------

constexpr std::int64_t TrianglesPerAreaChunk = 16384;

/// Sums are by metric.
struct FaceSums
{
  struct Sums
  {
    double Area = 0.0;
    double Distance = 0.0; // weighted by area
    double Square = 0.0; // weighted by area
    double Largest = 0.0;
  };
  std::array<Sums, MostMetrics> In;
  std::int64_t Samples = 0;

  void Add(const FaceSums& other)
  {
    for (std::size_t metric = 0; metric < MostMetrics; ++metric)
    {
      this->In[metric].Area += other.In[metric].Area;
      this->In[metric].Distance += other.In[metric].Distance;
      this->In[metric].Square += other.In[metric].Square;
      this->In[metric].Largest = std::max(this->In[metric].Largest, other.In[metric].Largest);
    }
    this->Samples += other.Samples;
  }
};

FaceSums MeasureAreas(const TriangleSurface& surface, const std::vector<Metric>& metrics)
{
  return AddUpChunks<FaceSums>(std::int64_t(surface.Triangles.size()), TrianglesPerAreaChunk, Monitor(),
    [&](FaceSums& sums, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const Corners& corners = surface.Triangles[n];
        for (std::size_t metric = 0; metric < metrics.size() && surface.Counts(corners); ++metric)
        {
          sums.In[metric].Area += metrics[metric].Area(surface, corners);
        }
      }
    });
}

struct MeasuredSurface
{
  const TriangleSurface& Surface;
  const std::vector<Metric>& Metrics;
  TriangleSearch Search;
  std::unique_ptr<PlanOverlay> Overlay; // null without a raster
  SurfaceEdges Edges;
  TriangleSurface Outline;
  FaceSums Areas;

  MeasuredSurface(const TriangleSurface& surface, const std::vector<Metric>& metrics, const Monitor& monitor)
    : Surface(surface)
    , Metrics(metrics)
    , Search(surface, monitor.Step(0.0, 0.7))
    , Edges(surface)
  {
    monitor.Progress(0.8);
    if (this->Search.GetRaster() != nullptr)
    {
      this->Overlay = std::make_unique<PlanOverlay>(*this->Search.GetRaster());
    }
    this->Outline = FindOutline(surface, this->Edges);
    monitor.Progress(0.9);
    this->Areas = MeasureAreas(surface, metrics);
  }
};

// ---- Points ---------------------------------------------------------------------------------------------------------

// Chunks are large, as each begins with a slow search.
constexpr std::int64_t PointsPerChunk = 4096;

struct LargestValues
{
  MetricValues Values = {};

  void Add(const LargestValues& other) { KeepLarger(other.Values, this->Values); }
};

std::vector<unsigned char> MarkCorners(const TriangleSurface& surface)
{
  std::vector<unsigned char> marks(surface.Points.size(), 0);
  for (const Corners& triangle : surface.Triangles)
  {
    for (const PointId corner : triangle)
    {
      marks[corner] = surface.Counts(corner) ? 1 : 0;
    }
  }
  return marks;
}

/// Returns the largest distances of corners that count. A tolerance above 0 (FindHeight) also measures heights above
/// the other surface, in the first metric; `nearest` may be null.
MetricValues MeasurePoints(const TriangleSurface& from, const TriangleSearch& to, const std::vector<Metric>& metrics,
  double tolerance, std::vector<PointDistances>& points, std::vector<NearestTriangles>* nearest, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(from.Points.size());
  points.resize(metrics.size());
  for (PointDistances& distances : points)
  {
    distances.Distance.resize(size);
  }
  points[0].Vertical.resize(tolerance > 0.0 ? size : 0);
  if (nearest != nullptr)
  {
    nearest->resize(size);
  }
  const std::vector<unsigned char> corners = MarkCorners(from);
  const LargestValues all = AddUpChunks<LargestValues>(size, PointsPerChunk, monitor,
    [&](LargestValues& largest, std::int64_t first, std::int64_t last)
    {
      DistanceProbe probe(to, metrics);
      for (std::int64_t point = first; point < last; ++point)
      {
        const Eigen::Vector3d& place = from.Points[point];
        const MetricValues& found = probe(place);
        for (std::size_t metric = 0; metric < metrics.size(); ++metric)
        {
          points[metric].Distance[point] = found[metric];
        }
        if (nearest != nullptr)
        {
          (*nearest)[point] = probe.Triangles();
        }
        if (tolerance > 0.0)
        {
          points[0].Vertical[point] = place.z() - probe.FindHeight(place, tolerance);
        }
        if (corners[point] != 0)
        {
          KeepLarger(found, largest.Values);
        }
      }
    });
  return all.Values;
}

// ---- Edges ----------------------------------------------------------------------------------------------------------

// Only needles need more than about four samples per point.
constexpr double MostEdgeSamples = 1e5;
constexpr double MostEdgeSamplesPerPoint = 64.0;

double LengthOf(const TriangleSurface& surface, PointId low, PointId high, const Metric& metric)
{
  return metric.Length(surface.Point(high) - surface.Point(low));
}

/// Distances of two places differ by at most their own distance, so none exceeds half of the edge plus the distances of
/// its ends.
bool MayExceed(const TriangleSurface& surface, PointId low, PointId high, const std::vector<Metric>& metrics,
  const std::vector<PointDistances>& points, const MetricValues& largest)
{
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    const std::vector<double>& distance = points[metric].Distance;
    const double most = 0.5 * (LengthOf(surface, low, high, metrics[metric]) + distance[low] + distance[high]);
    if (!(most <= largest[metric]))
    {
      return true;
    }
  }
  return false;
}

/// Widens the spacing, made from areas, where edges of needles or steep surfaces would give too many samples.
double SpacingOnEdges(const TriangleSurface& surface, const SurfaceEdges& edges, const Metric& metric, double spacing)
{
  const std::int64_t size = std::int64_t(surface.Points.size());
  std::vector<double> lengths(CountChunks(size, PointsPerChunk), 0.0);
  ForEachChunk(size, PointsPerChunk, Monitor(),
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      edges.ForEach(first, last,
        [&](PointId low, PointId high, std::uint32_t) { lengths[chunk] += LengthOf(surface, low, high, metric); });
    });
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  return std::max(spacing, total / (MostEdgeSamples + MostEdgeSamplesPerPoint * double(size)));
}

/// Includes the points. Edges get a sample per `spacing` in the first metric, shorter edges none.
MetricValues MeasureEdges(const TriangleSurface& from, const SurfaceEdges& edges, const TriangleSearch& to,
  const std::vector<Metric>& metrics, const std::vector<PointDistances>& points, const MetricValues& ofPoints,
  double spacing, std::uint64_t seed, const Monitor& monitor)
{
  assert(points.size() == metrics.size() && points[0].Distance.size() == from.Points.size());
  const std::int64_t size = std::int64_t(from.Points.size());
  const double wide = SpacingOnEdges(from, edges, metrics[0], spacing);
  LargestValues all = AddUpChunks<LargestValues>(size, PointsPerChunk, monitor,
    [&](LargestValues& largest, std::int64_t first, std::int64_t last)
    {
      DistanceProbe probe(to, metrics);
      probe.Largest = ofPoints;
      edges.ForEach(first, last,
        [&](PointId low, PointId high, std::uint32_t)
        {
          const std::int64_t count = std::int64_t(LengthOf(from, low, high, metrics[0]) / wide);
          if (count > 0 && from.Counts(low) && from.Counts(high) &&
            MayExceed(from, low, high, metrics, points, probe.Largest))
          {
            const std::uint64_t edge = (std::uint64_t(low) << 32U) | std::uint64_t(high);
            SampleEdge(from.Point(low), from.Point(high), count, Scramble(seed ^ Scramble(edge)),
              [&probe](const Eigen::Vector3d& place) { probe.RaiseLargest(place); });
          }
        });
      largest.Values = probe.Largest;
    });
  KeepLarger(ofPoints, all.Values);
  return all.Values;
}

// ---- Outline --------------------------------------------------------------------------------------------------------

/// Returns NaN if an outline is empty.
MetricValues MeasureOutline(const MeasuredSurface& from, const MeasuredSurface& to, double spacing, std::uint64_t seed)
{
  MetricValues largest;
  largest.fill(std::numeric_limits<double>::quiet_NaN());
  if (!from.Outline.Triangles.empty() && !to.Outline.Triangles.empty())
  {
    const TriangleSearch search(to.Outline);
    std::vector<PointDistances> points;
    largest = MeasurePoints(from.Outline, search, from.Metrics, 0.0, points, nullptr, Monitor());
    largest = MeasureEdges(
      from.Outline, SurfaceEdges(from.Outline), search, from.Metrics, points, largest, spacing, seed, Monitor());
  }
  return largest;
}

// ---- Faces ----------------------------------------------------------------------------------------------------------

// per lock of the histogram
constexpr std::size_t EntriesAtOnce = 16384;

// This weight of all faces keeps digits of small fractions, and sums below 2^64.
const double TotalWeight = std::ldexp(1.0, 60);

using Histograms = std::array<WeightedHistogram, MostMetrics>;

/// Takes `density` samples per area in the first metric, at least one per triangle. Distances are weighted by area, and
/// any two surfaces weigh the same.
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
      this->WeightPerArea[metric] = TotalWeight / (from.Areas.In[metric].Area + to.Areas.In[metric].Area);
    }
  }

  FaceSums Run(std::int64_t first, std::int64_t last)
  {
    this->From.Search.ForEachTriangle(first, last, [this](std::int32_t triangle) { this->MeasureTriangle(triangle); });
    this->EmptyEntries();
    for (std::size_t metric = 0; metric < this->From.Metrics.size(); ++metric)
    {
      this->Sums.In[metric].Largest = this->Probe.Largest[metric];
    }
    return this->Sums;
  }

private:
  void MeasureTriangle(std::int32_t triangle)
  {
    const TriangleSurface& surface = this->From.Surface;
    const Corners& t = surface.Triangles[triangle];
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
  // These are per sample of the current triangle.
  MetricValues Share = {};
  std::array<std::uint64_t, MostMetrics> Weight = {};
};

// ---- Figures --------------------------------------------------------------------------------------------------------

// Rounding may put places of an outline outside by less than this, in spacings of samples.
constexpr double HeightTolerance = 1e-6;

struct Direction
{
  std::vector<DistanceFigures> Figures; // by metric
  std::vector<PointDistances> Points; // by metric
  FaceSums Sums;
  Histograms Histogram;
};

void SetFaceFigures(const Direction& faces, std::size_t metric, DistanceFigures& figures)
{
  const FaceSums::Sums& in = faces.Sums.In[metric];
  figures.Mean = in.Distance / in.Area;
  figures.Rms = std::sqrt(in.Square / in.Area);
  figures.Samples = faces.Sums.Samples;
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    // Bins may end beyond the largest distance.
    figures.Percentile[n] = std::min(faces.Histogram[metric].Percentile(0.01 * Percentiles[n]), in.Largest);
  }
  double below = 0.0;
  for (std::size_t bin = 0; bin < DistanceBins; ++bin)
  {
    const double end = figures.Percentile.back() * double(bin + 1) / double(DistanceBins - 1);
    const double upTo = bin + 1 < DistanceBins ? faces.Histogram[metric].FractionUpTo(end) : 1.0;
    figures.Share[bin] = upTo - below;
    below = upTo;
  }
}

// Small surfaces have this effort at least.
constexpr std::int64_t LeastEffort = 100000;

void MeasureDirection(const MeasuredSurface& from, const MeasuredSurface& to, double samples,
  const SurfaceDistanceOptions& options, Direction& result, const Monitor& monitor)
{
  const double density = samples / from.Areas.In[0].Area;
  const double spacing = 1.0 / std::sqrt(density);
  const double tolerance = options.Vertical ? HeightTolerance * spacing : 0.0;
  std::vector<NearestTriangles> nearest;
  const MetricValues ofPoints =
    MeasurePoints(from.Surface, to.Search, from.Metrics, tolerance, result.Points, &nearest, monitor.Step(0.0, 0.2));
  MetricValues found = MeasureEdges(from.Surface, from.Edges, to.Search, from.Metrics, result.Points, ofPoints, spacing,
    options.Seed, monitor.Step(0.2, 0.4));
  result.Sums = AddUpChunks<FaceSums>(from.Search.Pieces(), TriangleSearch::PiecesPerChunk, monitor.Step(0.4, 0.8),
    [&](FaceSums& sums, std::int64_t first, std::int64_t last)
    { sums = FaceMeter(from, to, density, options.Seed, result.Histogram).Run(first, last); });
  for (std::size_t metric = 0; metric < MostMetrics; ++metric)
  {
    found[metric] = std::max(found[metric], result.Sums.In[metric].Largest);
  }
  const KnownDistances known = { from.Surface, to.Search, to.Overlay.get(), from.Metrics, result.Points, nearest,
    found };
  const LargestDistance largest =
    FindLargestDistance(known, result.Sums.Samples + LeastEffort, monitor.Step(0.8, 0.95));
  monitor.Progress(0.95);
  const MetricValues ofOutline = MeasureOutline(from, to, spacing, options.Seed);
  result.Figures.resize(from.Metrics.size());
  for (std::size_t metric = 0; metric < from.Metrics.size(); ++metric)
  {
    result.Figures[metric].Largest = largest.Most[metric];
    result.Figures[metric].LargestFound = largest.Found[metric];
    result.Figures[metric].Outline = ofOutline[metric];
    SetFaceFigures(result, metric, result.Figures[metric]);
  }
}

void AddFaces(const Direction& other, Direction& direction)
{
  direction.Sums.Add(other.Sums);
  for (std::size_t metric = 0; metric < MostMetrics; ++metric)
  {
    direction.Histogram[metric].Add(other.Histogram[metric]);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<SurfaceDistance> MeasureSurfaceDistances(const TriangleSurface& reference, const TriangleSurface& mesh,
  const std::vector<Metric>& metrics, const SurfaceDistanceOptions& options, const Monitor& monitor)
{
  CheckSurface(reference, "reference");
  CheckSurface(mesh, "mesh");
  const MeasuredSurface measuredReference(reference, metrics, monitor.Step(0.0, 0.1));
  const MeasuredSurface measuredMesh(mesh, metrics, monitor.Step(0.1, 0.2));
  const double samples = std::max(SurfaceDistanceOptions::LeastSamples,
    options.SamplesPerPoint * double(std::max(reference.Points.size(), mesh.Points.size())));
  Direction toMesh;
  Direction toReference;
  MeasureDirection(measuredReference, measuredMesh, samples, options, toMesh, monitor.Step(0.2, 0.6));
  MeasureDirection(measuredMesh, measuredReference, samples, options, toReference, monitor.Step(0.6, 1.0));
  AddFaces(toReference, toMesh);
  std::vector<SurfaceDistance> results(metrics.size());
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    SurfaceDistance& result = results[metric];
    result.ReferenceToMesh = toMesh.Figures[metric];
    result.MeshToReference = toReference.Figures[metric];
    result.TwoSided.Largest = std::max(result.ReferenceToMesh.Largest, result.MeshToReference.Largest);
    result.TwoSided.LargestFound = std::max(result.ReferenceToMesh.LargestFound, result.MeshToReference.LargestFound);
    result.TwoSided.Outline = std::max(result.ReferenceToMesh.Outline, result.MeshToReference.Outline);
    SetFaceFigures(toMesh, metric, result.TwoSided);
    result.Reference = std::move(toMesh.Points[metric]);
    result.Mesh = std::move(toReference.Points[metric]);
  }
  return results;
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceDistance MeasureSurfaceDistance(const TriangleSurface& reference, const TriangleSurface& mesh,
  const SurfaceDistanceOptions& options, const Monitor& monitor)
{
  return std::move(MeasureSurfaceDistances(reference, mesh, { Metric() }, options, monitor).front());
}

//----------------------------------------------------------------------------------------------------------------------
Grading MeasureGrading(const TriangleSurface& surface)
{
  WeightedHistogram histogram;
  ForEachChunk(std::int64_t(surface.Triangles.size()), TrianglesPerGradingChunk, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      std::vector<WeightedHistogram::Entry> entries;
      for (std::int64_t n = first; n < last; ++n)
      {
        const Corners& t = surface.Triangles[n];
        const double sides[3] = { (surface.Point(t[1]) - surface.Point(t[0])).norm(),
          (surface.Point(t[2]) - surface.Point(t[1])).norm(), (surface.Point(t[0]) - surface.Point(t[2])).norm() };
        for (const auto [a, b] :
          { std::minmax(sides[0], sides[1]), std::minmax(sides[1], sides[2]), std::minmax(sides[2], sides[0]) })
        {
          entries.push_back(WeightedHistogram::MakeEntry(b == 0.0 ? 1.0 : b / a, 1));
        }
      }
      histogram.Add(entries);
    });
  return { histogram.Percentile(0.5), histogram.Percentile(0.95) };
}
}
