// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceDistance.h"

#include "Common/FixedChunks.h"
#include "SurfaceEdges.h"
#include "SurfaceSamples.h"
#include "TriangleTree.h"
#include "WeightedHistogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// So much work that it hardly matters for the speed where a chunk's first search begins.
// The most samples on all edges of a surface: far more than it takes where triangles are no needles, about four per
// point.
constexpr double MostEdgeSamples = 1e5;
constexpr double MostEdgeSamplesPerPoint = 64.0;

constexpr std::int64_t PointsPerChunk = 4096;
constexpr std::int64_t TrianglesPerChunk = 512;
// The histogram is locked once for so many samples.
constexpr std::size_t EntriesAtOnce = 16384;

// How far outside a triangle, seen from above, a place still counts as above or below it: a millionth of the spacing of
// samples. Rounding may put places of an outline just outside, but by far less.
constexpr double HeightTolerance = 1e-6;

// The weight of all faces of both surfaces, in the integers of the histogram: small parts of it keep many digits, and
// sums stay below 2^64.
const double TotalWeight = std::ldexp(1.0, 60);

/// A surface with what it takes to measure from it and to it.
struct MeasuredSurface
{
  const TriangleSurface& Surface;
  TriangleTree Tree;
  SurfaceEdges Edges;
  double Area = 0.0;

  MeasuredSurface(const TriangleSurface& surface, const Monitor& monitor)
    : Surface(surface)
    , Tree(surface, monitor)
    , Edges(surface)
  {
    for (const Corners& triangle : surface.Triangles)
    {
      this->Area += surface.Area(triangle);
    }
  }
};

/// Measures distances to one surface. Each search begins with the triangle that the one before found, so that a probe
/// serves one chunk: with the same places in the same order it finds the same triangles.
class Probe
{
public:
  explicit Probe(const TriangleTree& tree)
    : Tree(tree)
  {
  }

  double operator()(const Eigen::Vector3d& place)
  {
    const double distance = std::sqrt(this->Tree.SquaredDistance(place, this->Nearest));
    this->Largest = std::max(this->Largest, distance);
    return distance;
  }

  double Largest = 0.0; // of all so far

private:
  const TriangleTree& Tree;
  std::int32_t Nearest = 0;
};

std::vector<unsigned char> MarkCorners(const TriangleSurface& surface)
{
  std::vector<unsigned char> marks(surface.Points.size(), 0);
  for (const Corners& triangle : surface.Triangles)
  {
    for (const PointId corner : triangle)
    {
      marks[std::size_t(corner)] = 1;
    }
  }
  return marks;
}

/// Writes the distances of all points, and gives the largest of those that are corners of triangles.
double MeasurePoints(
  const TriangleSurface& from, const TriangleTree& to, std::vector<double>& distances, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(from.Points.size());
  distances.resize(std::size_t(size));
  ForEachChunk(size, PointsPerChunk, monitor,
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      Probe probe(to);
      for (std::int64_t point = first; point < last; ++point)
      {
        distances[std::size_t(point)] = probe(from.Points[std::size_t(point)]);
      }
    });
  const std::vector<unsigned char> corners = MarkCorners(from);
  double largest = 0.0;
  for (std::size_t point = 0; point < distances.size(); ++point)
  {
    largest = corners[point] ? std::max(largest, distances[point]) : largest;
  }
  return largest;
}

/// Writes for all points how far they are above the other surface.
void MeasureHeights(const TriangleSurface& from, const TriangleTree& to, double tolerance, std::vector<double>& heights)
{
  const std::int64_t size = std::int64_t(from.Points.size());
  heights.resize(std::size_t(size));
  ForEachChunk(size, PointsPerChunk, Monitor(),
    [&](std::size_t, std::int64_t first, std::int64_t last)
    {
      for (std::size_t point = std::size_t(first); point < std::size_t(last); ++point)
      {
        heights[point] = from.Points[point].z() - to.FindHeight(from.Points[point], tolerance);
      }
    });
}

double LengthOf(const TriangleSurface& surface, PointId low, PointId high)
{
  return (surface.Point(high) - surface.Point(low)).norm();
}

/// The spacing of samples on edges: that which was asked for, unless it gives too many. Along needles and surfaces that
/// stand on end edges are long beside the area, from which spacings are made.
double SpacingOnEdges(const TriangleSurface& surface, const SurfaceEdges& edges, double spacing)
{
  const std::int64_t size = std::int64_t(surface.Points.size());
  std::vector<double> lengths(CountChunks(size, PointsPerChunk), 0.0);
  ForEachChunk(size, PointsPerChunk, Monitor(),
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      edges.ForEach(
        first, last, [&](PointId low, PointId high, std::uint32_t) { lengths[chunk] += LengthOf(surface, low, high); });
    });
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  return std::max(spacing, total / (MostEdgeSamples + MostEdgeSamplesPerPoint * double(size)));
}

/// The largest distance of samples on edges, one for each `spacing` of their length. Shorter edges have no samples:
/// their ends are measured as points.
double MeasureEdges(const TriangleSurface& from, const SurfaceEdges& edges, const TriangleTree& to, double spacing,
  std::uint64_t seed, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(from.Points.size());
  const double wide = SpacingOnEdges(from, edges, spacing);
  std::vector<double> largest(CountChunks(size, PointsPerChunk), 0.0);
  ForEachChunk(size, PointsPerChunk, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      Probe probe(to);
      edges.ForEach(first, last,
        [&](PointId low, PointId high, std::uint32_t)
        {
          const double length = LengthOf(from, low, high);
          const std::uint64_t edge = (std::uint64_t(low) << 32U) | std::uint64_t(high);
          SampleEdge(
            from.Point(low), from.Point(high), std::int64_t(length / wide), Scramble(seed ^ Scramble(edge)), probe);
        });
      largest[chunk] = probe.Largest;
    });
  return largest.empty() ? 0.0 : *std::max_element(largest.begin(), largest.end());
}

/// What the samples on the faces of a surface, or of a chunk of it, add up to.
struct FaceSums
{
  double Area = 0.0;
  double Distance = 0.0; // weighted by area
  double Square = 0.0; // of the distance, weighted by area
  double Largest = 0.0;
  std::int64_t Samples = 0;

  void Add(const FaceSums& other)
  {
    this->Area += other.Area;
    this->Distance += other.Distance;
    this->Square += other.Square;
    this->Largest = std::max(this->Largest, other.Largest);
    this->Samples += other.Samples;
  }
};

/// Measures samples on the triangles of one chunk.
class FaceMeter
{
public:
  FaceMeter(const TriangleTree& to, double density, double weightPerArea, std::uint64_t seed)
    : Measure(to)
    , Density(density)
    , WeightPerArea(weightPerArea)
    , Seed(seed)
  {
  }

  /// From the triangles `first` to before `last`, in the order of the tree.
  FaceSums Run(const MeasuredSurface& from, std::int64_t first, std::int64_t last, WeightedHistogram& histogram)
  {
    for (std::int64_t n = first; n < last; ++n)
    {
      const Corners& t = from.Tree.SortedTriangles()[std::size_t(n)];
      const double area = from.Surface.Area(t);
      if (area > 0.0)
      {
        this->Sample(from.Surface, t, area, Scramble(this->Seed ^ Scramble(std::uint64_t(n))), histogram);
      }
    }
    histogram.Add(this->Entries);
    this->Sums.Largest = this->Measure.Largest;
    return this->Sums;
  }

private:
  void Sample(
    const TriangleSurface& surface, const Corners& t, double area, std::uint64_t random, WeightedHistogram& histogram)
  {
    const std::int64_t count = std::max<std::int64_t>(1, std::llround(area * this->Density));
    const double share = area / double(count);
    const std::uint64_t weight = std::uint64_t(share * this->WeightPerArea);
    SampleTriangle(surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]), count, random,
      [&](const Eigen::Vector3d& place)
      {
        const double distance = this->Measure(place);
        this->Sums.Distance += share * distance;
        this->Sums.Square += share * distance * distance;
        this->Entries.push_back(WeightedHistogram::MakeEntry(distance, weight));
        if (this->Entries.size() == EntriesAtOnce)
        {
          histogram.Add(this->Entries);
        }
      });
    this->Sums.Area += area;
    this->Sums.Samples += count;
  }

  Probe Measure;
  double Density;
  double WeightPerArea;
  std::uint64_t Seed;
  FaceSums Sums;
  std::vector<WeightedHistogram::Entry> Entries;
};

FaceSums MeasureFaces(const MeasuredSurface& from, const MeasuredSurface& to, double density, std::uint64_t seed,
  WeightedHistogram& histogram, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(from.Surface.Triangles.size());
  const double weightPerArea = TotalWeight / (from.Area + to.Area);
  return AddUpChunks<FaceSums>(size, TrianglesPerChunk, monitor,
    [&](FaceSums& sums, std::int64_t first, std::int64_t last)
    { sums = FaceMeter(to.Tree, density, weightPerArea, seed).Run(from, first, last, histogram); });
}

/// Fills in the figures that follow from the faces.
void SetFaceFigures(const FaceSums& sums, const WeightedHistogram& histogram, DistanceFigures& figures)
{
  figures.Largest = std::max(figures.Largest, sums.Largest);
  figures.Mean = sums.Distance / sums.Area;
  figures.Rms = std::sqrt(sums.Square / sums.Area);
  figures.Samples = sums.Samples;
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    // A bin of the histogram may end beyond the largest distance in it.
    figures.Percentile[n] = std::min(histogram.Percentile(0.01 * Percentiles[n]), sums.Largest);
  }
}

/// The largest distance of one outline to the other; nan when one of them is empty.
double MeasureOutline(const TriangleSurface& from, const TriangleSurface& to, double spacing, std::uint64_t seed)
{
  if (from.Triangles.empty() || to.Triangles.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const TriangleTree tree(to);
  std::vector<double> distances;
  const double corners = MeasurePoints(from, tree, distances, Monitor());
  return std::max(corners, MeasureEdges(from, SurfaceEdges(from), tree, spacing, seed, Monitor()));
}

/// Measures from one surface to the other.
struct Direction
{
  const MeasuredSurface& From;
  const MeasuredSurface& To;
  double Samples; // on the faces
  const SurfaceDistanceOptions& Options;
  // What Run finds on the faces.
  FaceSums Sums;
  WeightedHistogram Histogram;

  DistanceFigures Run(PointDistances& points, const Monitor& monitor)
  {
    const double density = this->Samples / this->From.Area;
    const double spacing = 1.0 / std::sqrt(density);
    DistanceFigures figures;
    figures.Largest = MeasurePoints(this->From.Surface, this->To.Tree, points.Distance, monitor.Step(0.0, 0.2));
    figures.Largest = std::max(figures.Largest,
      MeasureEdges(
        this->From.Surface, this->From.Edges, this->To.Tree, spacing, this->Options.Seed, monitor.Step(0.2, 0.5)));
    this->Sums =
      MeasureFaces(this->From, this->To, density, this->Options.Seed, this->Histogram, monitor.Step(0.5, 0.9));
    SetFaceFigures(this->Sums, this->Histogram, figures);
    monitor.Progress(0.9);
    figures.Outline = MeasureOutline(FindOutline(this->From.Surface, this->From.Edges),
      FindOutline(this->To.Surface, this->To.Edges), spacing, this->Options.Seed);
    if (this->Options.Vertical)
    {
      MeasureHeights(this->From.Surface, this->To.Tree, HeightTolerance * spacing, points.Vertical);
    }
    return figures;
  }
};

/// The figures of both directions together. Adds what the second one found on the faces to the first one.
DistanceFigures Combine(
  const DistanceFigures& a, const DistanceFigures& b, Direction& firstDirection, const Direction& secondDirection)
{
  DistanceFigures both;
  both.Largest = std::max(a.Largest, b.Largest);
  both.Outline = std::max(a.Outline, b.Outline);
  firstDirection.Sums.Add(secondDirection.Sums);
  firstDirection.Histogram.Add(secondDirection.Histogram);
  SetFaceFigures(firstDirection.Sums, firstDirection.Histogram, both);
  return both;
}
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceDistance MeasureSurfaceDistance(const TriangleSurface& reference, const TriangleSurface& mesh,
  const SurfaceDistanceOptions& options, const Monitor& monitor)
{
  CheckSurface(reference, "reference");
  CheckSurface(mesh, "mesh");
  const MeasuredSurface measuredReference(reference, monitor.Step(0.0, 0.1));
  const MeasuredSurface measuredMesh(mesh, monitor.Step(0.1, 0.2));
  const double samples = std::max(SurfaceDistanceOptions::LeastSamples,
    options.SamplesPerPoint * double(std::max(reference.Points.size(), mesh.Points.size())));
  Direction toMesh{ measuredReference, measuredMesh, samples, options, {}, {} };
  Direction toReference{ measuredMesh, measuredReference, samples, options, {}, {} };
  SurfaceDistance result;
  result.ReferenceToMesh = toMesh.Run(result.Reference, monitor.Step(0.2, 0.6));
  result.MeshToReference = toReference.Run(result.Mesh, monitor.Step(0.6, 1.0));
  result.TwoSided = Combine(result.ReferenceToMesh, result.MeshToReference, toMesh, toReference);
  return result;
}
}
