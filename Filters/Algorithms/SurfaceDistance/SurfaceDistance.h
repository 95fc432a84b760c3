// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures how far two meshes are apart, as Metro does (Cignoni, Rocchini and Scopigno 1998, "Metro: measuring error on
// simplified surfaces"; thesis 4.4).
//
// Distances from points, and from samples of edges and faces, to the other surface are exact; only the choice of places
// is approximate. The largest distance is bounded (LargestDistance.h).

#ifndef SeismicHorizonsSurfaceDistance_h
#define SeismicHorizonsSurfaceDistance_h

#include "Common/Base/Monitor.h"
#include "TriangleSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
struct SurfaceDistanceOptions
{
  /// Samples on faces per point of the larger surface, above 0. Each triangle with an area has one, a surface
  /// LeastSamples.
  double SamplesPerPoint = 2.0;
  std::uint64_t Seed = 1;
  /// Enables PointDistances::Vertical.
  bool Vertical = true;

  static constexpr double LeastSamples = 10000.0;
};

constexpr std::array<int, 4> Percentiles = { 50, 90, 95, 99 };

/// Bins are equal up to the 99th percentile, with one for the rest.
constexpr std::size_t DistanceBins = 31;

/// Distances are in units of the coordinates.
struct DistanceFigures
{
  // No place is farther than Largest, and one is as far as LargestFound, usually at most 1 % less.
  double Largest = 0.0;
  double LargestFound = 0.0;
  // Faces are weighted by area.
  double Mean = 0.0;
  double Rms = 0.0;
  std::array<double, Percentiles.size()> Percentile = {}; // to a thousandth
  std::array<double, DistanceBins> Share = {}; // of the area per bin
  /// This is the largest distance between outlines in plan, NaN if one is empty.
  double Outline = 0.0;
  std::int64_t Samples = 0; // on the faces
};

struct PointDistances
{
  /// Points that are no corners are included.
  std::vector<double> Distance;
  /// This is z minus z of the other surface, or NaN if it has nothing above or below.
  std::vector<double> Vertical;
};

struct SurfaceDistance
{
  DistanceFigures ReferenceToMesh;
  DistanceFigures MeshToReference;
  /// Means and percentiles are over the area of both.
  DistanceFigures TwoSided;
  PointDistances Reference;
  PointDistances Mesh;
};

/// Throws InputError as CheckSurface() does. Takes near linear time, and about 40 bytes per triangle.
SurfaceDistance MeasureSurfaceDistance(const TriangleSurface& reference, const TriangleSurface& mesh,
  const SurfaceDistanceOptions& options = SurfaceDistanceOptions(), const Monitor& monitor = Monitor());

/// Takes one or two metrics; places are spread evenly in the first. Only the first result has PointDistances::Vertical,
/// in units of z.
std::vector<SurfaceDistance> MeasureSurfaceDistances(const TriangleSurface& reference, const TriangleSurface& mesh,
  const std::vector<Metric>& metrics, const SurfaceDistanceOptions& options = SurfaceDistanceOptions(),
  const Monitor& monitor = Monitor());

/// Grading is the ratio of longer to shorter edges at corners, infinite for an edge without length, to 1/1024.
struct Grading
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

Grading MeasureGrading(const TriangleSurface& surface);
}

#endif
