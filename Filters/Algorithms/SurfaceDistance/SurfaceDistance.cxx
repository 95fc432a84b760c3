// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceDistance.h"

#include "FaceMeter.h"
#include "MeasuredSurface.h"
#include "PlaceMeters.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// How far outside a triangle, seen from above, a place still counts as above or below it: a millionth of the spacing of
// samples. Rounding may put places of an outline just outside, but by far less.
constexpr double HeightTolerance = 1e-6;

/// Fills in the figures that follow from the faces.
void SetFaceFigures(
  const FaceSums& sums, std::size_t metric, const WeightedHistogram& histogram, DistanceFigures& figures)
{
  const FaceSums::Sums& in = sums.In[metric];
  figures.Largest = std::max(figures.Largest, in.Largest);
  figures.Mean = in.Distance / in.Area;
  figures.Rms = std::sqrt(in.Square / in.Area);
  figures.Samples = sums.Samples;
  for (std::size_t n = 0; n < Percentiles.size(); ++n)
  {
    // A bin of the histogram may end beyond the largest distance in it.
    figures.Percentile[n] = std::min(histogram.Percentile(0.01 * Percentiles[n]), in.Largest);
  }
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
  Histograms Histogram;

  /// Figures by metric.
  std::vector<DistanceFigures> Run(std::vector<PointDistances>& points, const Monitor& monitor)
  {
    const std::vector<Metric>& metrics = this->From.Metrics;
    const double density = this->Samples / this->From.Area[0];
    const double spacing = 1.0 / std::sqrt(density);
    const double tolerance = this->Options.Vertical ? HeightTolerance * spacing : 0.0;
    const MetricValues ofPoints =
      MeasurePoints(this->From.Surface, this->To.Search, metrics, tolerance, points, monitor.Step(0.0, 0.2));
    const MetricValues ofEdges = MeasureEdges(this->From.Surface, this->From.Edges, this->To.Search, metrics, points,
      ofPoints, spacing, this->Options.Seed, monitor.Step(0.2, 0.5));
    this->Sums =
      MeasureFaces(this->From, this->To, density, this->Options.Seed, this->Histogram, monitor.Step(0.5, 0.95));
    monitor.Progress(0.95);
    const MetricValues ofOutline = MeasureOutline(this->From, this->To, spacing, this->Options.Seed);
    std::vector<DistanceFigures> figures(metrics.size());
    for (std::size_t metric = 0; metric < metrics.size(); ++metric)
    {
      figures[metric].Largest = ofEdges[metric]; // and of points
      figures[metric].Outline = ofOutline[metric];
      SetFaceFigures(this->Sums, metric, this->Histogram[metric], figures[metric]);
    }
    return figures;
  }
};

/// Adds what a direction found on the faces to another one.
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
  Direction toMesh{ measuredReference, measuredMesh, samples, options, {}, {} };
  Direction toReference{ measuredMesh, measuredReference, samples, options, {}, {} };
  std::vector<PointDistances> ofReference;
  std::vector<PointDistances> ofMesh;
  const std::vector<DistanceFigures> figuresToMesh = toMesh.Run(ofReference, monitor.Step(0.2, 0.6));
  const std::vector<DistanceFigures> figuresToReference = toReference.Run(ofMesh, monitor.Step(0.6, 1.0));
  AddFaces(toReference, toMesh);
  std::vector<SurfaceDistance> results(metrics.size());
  for (std::size_t metric = 0; metric < metrics.size(); ++metric)
  {
    SurfaceDistance& result = results[metric];
    result.ReferenceToMesh = figuresToMesh[metric];
    result.MeshToReference = figuresToReference[metric];
    result.TwoSided.Largest = std::max(result.ReferenceToMesh.Largest, result.MeshToReference.Largest);
    result.TwoSided.Outline = std::max(result.ReferenceToMesh.Outline, result.MeshToReference.Outline);
    SetFaceFigures(toMesh.Sums, metric, toMesh.Histogram[metric], result.TwoSided);
    result.Reference = std::move(ofReference[metric]);
    result.Mesh = std::move(ofMesh[metric]);
  }
  return results;
}

//----------------------------------------------------------------------------------------------------------------------
SurfaceDistance MeasureSurfaceDistance(const TriangleSurface& reference, const TriangleSurface& mesh,
  const SurfaceDistanceOptions& options, const Monitor& monitor)
{
  return std::move(MeasureSurfaceDistances(reference, mesh, { Metric() }, options, monitor).front());
}
}
