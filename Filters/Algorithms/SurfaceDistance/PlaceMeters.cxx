// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaceMeters.h"

#include "Common/FixedChunks.h"
#include "SurfaceSamples.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// So much work that it hardly matters for the speed where a chunk's first search begins.
constexpr std::int64_t PointsPerChunk = 4096;

// The most samples on all edges of a surface: far more than it takes where triangles are no needles, about four per
// point.
constexpr double MostEdgeSamples = 1e5;
constexpr double MostEdgeSamplesPerPoint = 64.0;

void KeepLarger(const MetricValues& other, MetricValues& largest)
{
  std::transform(
    other.begin(), other.end(), largest.begin(), largest.begin(), [](double a, double b) { return std::max(a, b); });
}

/// Of all chunks.
MetricValues LargestOf(const std::vector<MetricValues>& chunks)
{
  MetricValues largest = {};
  for (const MetricValues& chunk : chunks)
  {
    KeepLarger(chunk, largest);
  }
  return largest;
}

/// The corners of triangles that count.
std::vector<unsigned char> MarkCorners(const TriangleSurface& surface)
{
  std::vector<unsigned char> marks(surface.Points.size(), 0);
  for (const Corners& triangle : surface.Triangles)
  {
    for (const PointId corner : triangle)
    {
      marks[std::size_t(corner)] = surface.Counts(corner) ? 1 : 0;
    }
  }
  return marks;
}

double LengthOf(const TriangleSurface& surface, PointId low, PointId high, const Metric& metric)
{
  return metric.Length(surface.Point(high) - surface.Point(low));
}

/// Whether a place on an edge may be farther away than `largest`. Distances of two places differ by no more than how
/// far these are apart, so that none is farther than half of the edge and of what its ends have together.
bool MayExceed(const TriangleSurface& surface, PointId low, PointId high, const std::vector<Metric>& metrics,
  const std::vector<PointDistances>& points, const MetricValues& largest)
{
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    const std::vector<double>& distance = points[metric].Distance;
    const double most =
      0.5 * (LengthOf(surface, low, high, metrics[metric]) + distance[std::size_t(low)] + distance[std::size_t(high)]);
    if (!(most <= largest[metric]))
    {
      return true;
    }
  }
  return false;
}

/// The spacing of samples on edges: that which was asked for, unless it gives too many. Along needles and surfaces that
/// stand on end edges are long beside the area, from which spacings are made.
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
}

//----------------------------------------------------------------------------------------------------------------------
MetricValues MeasurePoints(const TriangleSurface& from, const TriangleSearch& to, const std::vector<Metric>& metrics,
  double tolerance, std::vector<PointDistances>& points, const Monitor& monitor)
{
  const std::size_t size = from.Points.size();
  points.resize(metrics.size());
  for (PointDistances& distances : points)
  {
    distances.Distance.resize(size);
  }
  points[0].Vertical.resize(tolerance > 0.0 ? size : 0);
  const std::vector<unsigned char> corners = MarkCorners(from);
  std::vector<MetricValues> largest(CountChunks(std::int64_t(size), PointsPerChunk), MetricValues());
  ForEachChunk(std::int64_t(size), PointsPerChunk, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      DistanceProbe probe(to, metrics);
      for (std::size_t point = std::size_t(first); point < std::size_t(last); ++point)
      {
        const Eigen::Vector3d& place = from.Points[point];
        const MetricValues& found = probe(place);
        for (std::size_t metric = 0; metric < metrics.size(); ++metric)
        {
          points[metric].Distance[point] = found[metric];
        }
        if (tolerance > 0.0)
        {
          points[0].Vertical[point] = place.z() - probe.FindHeight(place, tolerance);
        }
        if (corners[point] != 0)
        {
          KeepLarger(found, largest[chunk]);
        }
      }
    });
  return LargestOf(largest);
}

//----------------------------------------------------------------------------------------------------------------------
MetricValues MeasureEdges(const TriangleSurface& from, const SurfaceEdges& edges, const TriangleSearch& to,
  const std::vector<Metric>& metrics, const std::vector<PointDistances>& points, const MetricValues& ofPoints,
  double spacing, std::uint64_t seed, const Monitor& monitor)
{
  const std::int64_t size = std::int64_t(from.Points.size());
  const double wide = SpacingOnEdges(from, edges, metrics[0], spacing);
  std::vector<MetricValues> largest(CountChunks(size, PointsPerChunk), MetricValues());
  ForEachChunk(size, PointsPerChunk, monitor,
    [&](std::size_t chunk, std::int64_t first, std::int64_t last)
    {
      DistanceProbe probe(to, metrics);
      probe.SetLargest(ofPoints);
      edges.ForEach(first, last,
        [&](PointId low, PointId high, std::uint32_t)
        {
          const std::int64_t count = std::int64_t(LengthOf(from, low, high, metrics[0]) / wide);
          if (count > 0 && from.Counts(low) && from.Counts(high) &&
            MayExceed(from, low, high, metrics, points, probe.Largest()))
          {
            const std::uint64_t edge = (std::uint64_t(low) << 32U) | std::uint64_t(high);
            SampleEdge(from.Point(low), from.Point(high), count, Scramble(seed ^ Scramble(edge)),
              [&probe](const Eigen::Vector3d& place) { probe.RaiseLargest(place); });
          }
        });
      largest[chunk] = probe.Largest();
    });
  MetricValues result = LargestOf(largest);
  KeepLarger(ofPoints, result);
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
MetricValues MeasureOutline(const MeasuredSurface& from, const MeasuredSurface& to, double spacing, std::uint64_t seed)
{
  MetricValues largest;
  largest.fill(std::numeric_limits<double>::quiet_NaN());
  if (!from.Outline.Triangles.empty() && !to.Outline.Triangles.empty())
  {
    const TriangleSearch search(to.Outline);
    std::vector<PointDistances> points;
    largest = MeasurePoints(from.Outline, search, from.Metrics, 0.0, points, Monitor());
    largest = MeasureEdges(
      from.Outline, SurfaceEdges(from.Outline), search, from.Metrics, points, largest, spacing, seed, Monitor());
  }
  return largest;
}
}
