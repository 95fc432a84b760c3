// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far two triangle meshes are apart: the measure of Metro (Cignoni, Rocchini and Scopigno 1998, "Metro: measuring
// error on simplified surfaces"; thesis 4.4).
//
// From places on one surface (its points, and samples of its edges and faces) the distance to the nearest triangle of
// the other surface is measured exactly; then the other way round. Only the choice of the places is approximate, and
// that not for the largest distance, which is found within bounds (LargestDistance.h).

#ifndef SeismicHorizonsSurfaceDistance_h
#define SeismicHorizonsSurfaceDistance_h

#include "Common/Monitor.h"
#include "Metric.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct SurfaceDistanceOptions
{
  /// Samples on the faces of each surface for each point of the one that has more points; above 0. There is at least
  /// one on every triangle with an area, and there are at least LeastSamples on a surface. Edges are sampled at the
  /// same spacing.
  double SamplesPerPoint = 2.0;
  /// The seed of where the samples are; any number.
  std::uint64_t Seed = 1;
  /// Whether PointDistances::Vertical is made.
  bool Vertical = true;

  static constexpr double LeastSamples = 10000.0;
};

/// The percentiles that are measured.
constexpr std::array<int, 4> Percentiles = { 50, 90, 95, 99 };

/// Bins of a histogram of distances: of equal width up to the 99th percentile, and one for all above.
constexpr std::size_t DistanceBins = 31;

/// Distances from one surface to another, in the units of the coordinates.
struct DistanceFigures
{
  // Bounds of the largest distance of vertices, edges and faces, up to rounding: no place is farther than the first,
  // and one is as far as the second, which is at most 1 % less unless the effort ran out.
  double Largest = 0.0;
  double LargestFound = 0.0;
  // Of the faces, weighted by area.
  double Mean = 0.0;
  double Rms = 0.0; // the root of the mean square
  std::array<double, Percentiles.size()> Percentile = {}; // as of the constant; within a thousandth of their size
  std::array<double, DistanceBins> Share = {}; // of the area, in each bin; sums up to 1
  /// The largest distance of the outline (edges of one triangle) to the other outline, in plan; nan when one of the
  /// surfaces has none.
  double Outline = 0.0;
  std::int64_t Samples = 0; // on the faces
};

/// Distances of the points of one surface to the other one.
struct PointDistances
{
  /// Of all points, whether they are corners of triangles or not.
  std::vector<double> Distance;
  /// z of the point less that of the other surface there; nan where it has nothing above or below.
  std::vector<double> Vertical;
};

struct SurfaceDistance
{
  DistanceFigures ReferenceToMesh;
  DistanceFigures MeshToReference;
  /// Largest of both; mean, root mean square and percentiles over the area of both.
  DistanceFigures TwoSided;
  PointDistances Reference;
  PointDistances Mesh;
};

/// Throws InputError as CheckSurface does; messages call the surfaces "reference" and "mesh". The result is the same
/// for any number of threads. Near linear; about 40 bytes per triangle of both.
SurfaceDistance MeasureSurfaceDistance(const TriangleSurface& reference, const TriangleSurface& mesh,
  const SurfaceDistanceOptions& options = SurfaceDistanceOptions(), const Monitor& monitor = Monitor());

/// The same in one or two metrics at once, in their order: the places are the same ones, spread evenly in the first
/// metric, and faces are weighted by their areas in each. Only the first result has PointDistances::Vertical, in units
/// of z.
std::vector<SurfaceDistance> MeasureSurfaceDistances(const TriangleSurface& reference, const TriangleSurface& mesh,
  const std::vector<Metric>& metrics, const SurfaceDistanceOptions& options = SurfaceDistanceOptions(),
  const Monitor& monitor = Monitor());

/// How quickly the triangles of a mesh change in size: median and percentile, over the corners of all triangles, of the
/// ratio of the longer to the shorter of the two sides that meet there. 1 where they are equal, infinite where one has
/// no length. Right to 1/1024 of their value.
struct Grading
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// `surface` has at least one triangle.
Grading MeasureGrading(const TriangleSurface& surface);
}

#endif
