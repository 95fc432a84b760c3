// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "BoundarySimplification/BoundarySimplification.h"
#include "Common/BoundedHorizon.h"
#include "Common/Parameters.h"
#include "Common/PlaneGeometry.h"
#include "ErrorSearch.h"
#include "GapHistogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// The values of some points.
template <typename Value>
std::vector<Value> Select(const std::vector<Value>& values, const std::vector<PointId>& points)
{
  std::vector<Value> selected;
  selected.reserve(points.size());
  for (const PointId point : points)
  {
    selected.push_back(values[std::size_t(point)]);
  }
  return selected;
}

/// What two reductions, one after the other, make of the points of the first one.
Reduction Chain(const Reduction& first, Reduction second)
{
  std::vector<PointId> target = Select(second.Target, first.Target);
  second.Target = std::move(target);
  second.Source = Select(first.Source, second.Source);
  return second;
}

/// Runs the methods one after the other; a boundary is found again only when its holes change.
class SurfaceMaker
{
public:
  SurfaceMaker(const SurfacePoints& points, const SurfaceOptions& options)
    : Points(points)
    , Options(options)
  {
    this->Result.Parameters.Radius = options.Radius ? *options.Radius : ChooseRadius(points.Columns);
  }

  Surface Run(const Monitor& monitor)
  {
    const bool isByNumber = this->Options.MaximumNumberOfTriangles > 0;
    const double last = isByNumber ? 0.6 : 0.0; // the part of the work where the last run begins
    const double error = isByNumber ? this->FindError(monitor.Step(0.0, last)) : this->Options.MaximumError;
    this->Simplify(error, monitor.Step(last, last + 0.4 * (1.0 - last)));
    if (!this->Result.Kept.empty())
    {
      this->Plane = std::vector<PlanePoint>(); // memory that the decimation can use
      this->Height = std::vector<double>();
      this->Decimate(isByNumber, monitor.Step(last + 0.4 * (1.0 - last), 1.0));
    }
    return std::move(this->Result);
  }

private:
  /// The error that outlines are simplified for when the mesh has a number of triangles.
  double FindError(const Monitor& monitor)
  {
    if (this->Options.OutlineTolerance && this->Options.DistanceThreshold)
    {
      return 0.0;
    }
    int run = 0;
    return FindErrorForTriangles(this->Options.MaximumNumberOfTriangles, this->FindExtent(),
      [&](double error)
      {
        const Monitor step = monitor.Step(double(run) / MostSearchRuns, double(run + 1) / MostSearchRuns);
        ++run;
        this->Simplify(error, step.Step(0.0, 0.5));
        return this->CountTriangles(error, step.Step(0.5, 1.0));
      });
  }

  /// No point of the horizon is farther from another one along all axes together.
  double FindExtent() const
  {
    const PlaneBox box(this->Points.Columns);
    const auto heights = std::minmax_element(this->Points.Height.begin(), this->Points.Height.end());
    return double(box.Greatest.X) - box.Least.X + double(box.Greatest.Y) - box.Least.Y + *heights.second -
      *heights.first;
  }

  std::size_t CountTriangles(double error, const Monitor& monitor)
  {
    DecimationOptions options = this->MakeDecimationOptions();
    options.Effort = DecimationEffort::Fast;
    options.MaximumError = error;
    return this->Result.Kept.empty() ? 0
                                     : SeismicHorizons::Decimate(this->Horizon, options, monitor).Triangles.size() / 3;
  }

  /// Finds the boundary with the holes that an error leaves open, and simplifies it for that error.
  void Simplify(double error, const Monitor& monitor)
  {
    SurfaceParameters& parameters = this->Result.Parameters;
    parameters.MaximumError = error;
    parameters.OutlineTolerance = this->Options.OutlineTolerance.value_or(error);
    parameters.DistanceThreshold = this->Options.DistanceThreshold.value_or(error);
    this->FindBoundary(monitor.Step(0.0, 0.5));
    if (this->Result.Kept.empty())
    {
      return;
    }
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.OutlineTolerance = parameters.OutlineTolerance;
    options.DistanceThreshold = parameters.DistanceThreshold;
    const BoundarySimplification simplified =
      SimplifyBoundary(ToSpacePoints(this->Plane, this->Height, this->Points.SubVoxelsPerColumn),
        this->Result.Boundary.Boundary, options, monitor.Step(0.5, 1.0));
    this->Result.BoundaryDeviation = simplified.Deviation;
    this->Result.OutlineDeviation = simplified.OutlineDeviation;
    this->Simplified = ToReduction(simplified, this->Plane, this->Height);
    this->Horizon.SubVoxelsPerColumn = this->Points.SubVoxelsPerColumn;
    this->Horizon.Plane = std::move(this->Simplified.Plane);
    this->Horizon.Height = std::move(this->Simplified.Height);
    this->Horizon.Patch = Select(this->Result.Boundary.Patch, this->Simplified.Source);
    this->Horizon.Boundary = std::move(this->Simplified.Boundary);
  }

  void FindBoundary(const Monitor& monitor)
  {
    SurfaceParameters& parameters = this->Result.Parameters;
    BoundaryOptions options;
    options.Radius = parameters.Radius;
    options.Growth = this->Options.Growth;
    options.HoleBoundaries = this->Options.HoleBoundaries;
    options.MinimumPatchSize = this->Options.MinimumPatchSize;
    options.SmallestHoleSize = this->Options.SmallestHoleSize
      ? *this->Options.SmallestHoleSize
      : ChooseSmallestHoleSize(parameters.Radius, parameters.OutlineTolerance);
    if (this->HasBoundary && parameters.SmallestHoleSize == options.SmallestHoleSize)
    {
      return;
    }
    parameters.SmallestHoleSize = options.SmallestHoleSize;
    this->Result.Boundary = FindExteriorBoundary(this->Points.Columns, options, monitor);
    this->Result.Kept = DropPointsWithoutPatch(this->Result.Boundary);
    this->Plane = Select(this->Points.Plane, this->Result.Kept);
    this->Height = Select(this->Points.Height, this->Result.Kept);
    this->HasBoundary = true;
  }

  DecimationOptions MakeDecimationOptions() const
  {
    DecimationOptions options;
    options.MaximumError = 0.0;
    static_cast<DecimationQuality&>(options) = this->Options;
    return options;
  }

  void Decimate(bool isByNumber, const Monitor& monitor)
  {
    SurfaceParameters& parameters = this->Result.Parameters;
    DecimationOptions options = this->MakeDecimationOptions();
    if (isByNumber)
    {
      parameters.MaximumNumberOfPoints = this->FindNumberOfPoints(monitor.Step(0.0, 0.2));
    }
    else
    {
      options.MaximumError = parameters.MaximumError;
    }
    options.MaximumNumberOfPoints = parameters.MaximumNumberOfPoints;
    this->Result.Mesh = SeismicHorizons::Decimate(this->Horizon, options, monitor.Step(0.2, 1.0));
    this->Result.Mesh.Points = Chain(this->Simplified, std::move(this->Result.Mesh.Points));
  }

  /// So many points that the mesh has no more triangles than it may. With those of the loops alone it has a number of
  /// triangles that depends on nothing else, and two more for each point inside.
  std::size_t FindNumberOfPoints(const Monitor& monitor) const
  {
    const std::size_t onLoops = this->Horizon.Boundary.CountPoints(this->Horizon.Plane.size());
    DecimationOptions options = this->MakeDecimationOptions();
    options.Effort = DecimationEffort::Fast;
    options.FitHeights = false;
    options.MaximumNumberOfPoints = onLoops;
    const std::size_t least = SeismicHorizons::Decimate(this->Horizon, options, monitor).Triangles.size() / 3;
    const std::size_t most = this->Options.MaximumNumberOfTriangles;
    if (least > most)
    {
      throw TooFewTriangles(most, least);
    }
    return std::min(onLoops + (most - least) / 2, this->Horizon.Plane.size());
  }

  const SurfacePoints& Points;
  const SurfaceOptions& Options;
  Surface Result;
  bool HasBoundary = false;
  std::vector<PlanePoint> Plane; // of the points that have a patch, as their heights
  std::vector<double> Height;
  Reduction Simplified; // of these; its places and loops are those of the horizon
  BoundedHorizon Horizon; // the same, to be decimated
};
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ChooseSmallestHoleSize(int radius, double outlineTolerance)
{
  constexpr double Widest = 1 << 14; // no lattice has as many columns as its square
  const double narrow = std::ceil(std::min(2.0 * outlineTolerance, Widest));
  const std::int64_t side = std::max(std::int64_t(2 * radius + 1), std::int64_t(narrow));
  return side * side;
}

//----------------------------------------------------------------------------------------------------------------------
Surface MakeSurface(const SurfacePoints& points, const SurfaceOptions& options, const Monitor& monitor)
{
  if (options.MaximumNumberOfTriangles == 0)
  {
    CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  }
  CheckAtLeast("outline tolerance", options.OutlineTolerance.value_or(0.0), 0.0, " columns");
  CheckAtLeast("distance threshold", options.DistanceThreshold.value_or(0.0), 0.0, " lattice units");
  return SurfaceMaker(points, options).Run(monitor);
}
}
