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
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void CheckColumns(const SurfacePoints& points)
{
  for (std::size_t n = 0; n < points.Plane.size(); ++n)
  {
    const PlanePoint column = points.Columns[n];
    const PlanePoint exact = { column.X * points.SubVoxelsPerColumn, column.Y * points.SubVoxelsPerColumn };
    if (points.Plane[n] != exact)
    {
      throw InputError("point " + std::to_string(n) + " stands beside its column, expected whole columns");
    }
  }
}

/// Runs the methods one after the other; a boundary is found again only when its holes change.
class SurfaceMaker
{
public:
  SurfaceMaker(SurfacePoints points, const SurfaceOptions& options)
    : Points(std::move(points))
    , Options(options)
  {
    this->Points.Plane = std::vector<PlanePoint>();
    this->Result.Parameters.Radius = options.Radius ? *options.Radius : ChooseRadius(this->Points.Columns);
  }

  Surface Run(const Monitor& monitor)
  {
    const bool isByNumber = this->Options.MaximumNumberOfTriangles > 0;
    const double last = isByNumber ? 0.6 : 0.0; // the part of the work where the last run begins
    const double error = isByNumber ? this->FindError(monitor.Step(0.0, last)) : this->Options.MaximumError;
    this->Simplify(error, monitor.Step(last, last + 0.4 * (1.0 - last)));
    if (!this->Result.Kept.empty())
    {
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
    return this->Result.Kept.empty()
      ? 0
      : SeismicHorizons::Decimate(this->CopyHorizon(), options, monitor).Triangles.size() / 3;
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
    BoundarySimplification simplified = this->SimplifyLoops(monitor.Step(0.5, 1.0));
    this->Result.BoundaryDeviation = simplified.Deviation;
    this->Result.OutlineDeviation = simplified.OutlineDeviation;
    this->Dropped = std::move(simplified.Dropped);
    this->Outlines = std::move(simplified.Boundary);
  }

  /// Of the points that have a patch.
  std::vector<PlanePoint>& Columns() { return this->Result.Kept.AreAll() ? this->Points.Columns : this->KeptColumns; }
  std::vector<double>& Height() { return this->Result.Kept.AreAll() ? this->Points.Height : this->KeptHeight; }

  /// The horizon within its simplified outlines, to be decimated. Points that were dropped from these are without
  /// patch.
  BoundedHorizon MakeHorizon(std::vector<PlanePoint> columns, std::vector<double> height) const
  {
    BoundedHorizon horizon;
    horizon.SubVoxelsPerColumn = this->Points.SubVoxelsPerColumn;
    horizon.Plane = std::move(columns);
    for (PlanePoint& place : horizon.Plane)
    {
      place = { place.X * horizon.SubVoxelsPerColumn, place.Y * horizon.SubVoxelsPerColumn };
    }
    horizon.Height = std::move(height);
    horizon.Patch = this->Result.Boundary.Patch;
    for (const DroppedPoint& dropped : this->Dropped)
    {
      horizon.Patch[std::size_t(dropped.Point)] = NoPatch;
    }
    horizon.Boundary = this->Outlines;
    return horizon;
  }

  BoundedHorizon CopyHorizon() { return this->MakeHorizon(this->Columns(), this->Height()); }
  BoundedHorizon MoveHorizon() { return this->MakeHorizon(std::move(this->Columns()), std::move(this->Height())); }

  /// Seams first, then what is left of the loops.
  BoundarySimplification SimplifyLoops(const Monitor& monitor)
  {
    const SurfaceParameters& parameters = this->Result.Parameters;
    BoundarySimplificationOptions options;
    options.Method = OutlineMethod::FewestPoints;
    options.OutlineTolerance = parameters.OutlineTolerance;
    options.DistanceThreshold = parameters.DistanceThreshold;
    const auto simplify = [&](const Loops& loops)
    { return SimplifyBoundary(SpacePoints(this->Columns(), this->Height(), 1), loops, options, monitor); };
    options.Fixed = this->Result.Boundary.OpenCracks.EndsOfMouths();
    if (!HasSeams(this->Options.Seams))
    {
      return simplify(this->Result.Boundary.Boundary);
    }
    SeamChains seams = SimplifySeams(this->Columns(), this->Height(), this->Result.Boundary.Boundary,
      this->BoundaryParameters, parameters.DistanceThreshold);
    for (const SeamPin& pin : seams.Pins)
    {
      this->Height()[std::size_t(pin.Point)] = pin.Height;
    }
    options.Fixed = std::move(seams.Kept);
    BoundarySimplification simplified = simplify(seams.Boundary);
    simplified.Dropped.insert(simplified.Dropped.end(), seams.Dropped.begin(), seams.Dropped.end());
    std::sort(simplified.Dropped.begin(), simplified.Dropped.end(),
      [](const DroppedPoint& a, const DroppedPoint& b) { return a.Point < b.Point; });
    simplified.Deviation = std::max(simplified.Deviation, seams.Deviation);
    this->Result.Pins = std::move(seams.Pins);
    this->Result.OpenGaps = std::move(seams.OpenGaps);
    return simplified;
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
    options.Cuts = this->Options.Cuts;
    options.Seams = this->Options.Seams;
    options.Seams.LongestEdge = ChooseLongestSeamEdge(options.SmallestHoleSize);
    this->BoundaryParameters = options;
    this->Result.Boundary = FindExteriorBoundary(this->Points.Columns, options, monitor);
    this->Result.Kept = DropPointsWithoutPatch(this->Result.Boundary);
    if (!this->Result.Kept.AreAll())
    {
      this->KeptColumns = this->Result.Kept.Select(this->Points.Columns);
      this->KeptHeight = this->Result.Kept.Select(this->Points.Height);
    }
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
    this->Result.Mesh = SeismicHorizons::Decimate(this->MoveHorizon(), options, monitor.Step(0.2, 1.0));
    std::vector<PointId>& target = this->Result.Mesh.Points.Target;
    for (const DroppedPoint& dropped : this->Dropped)
    {
      target[std::size_t(dropped.Point)] = target[std::size_t(dropped.Target)];
    }
  }

  /// So many points that the mesh has no more triangles than it may. With those of the loops alone it has a number of
  /// triangles that depends on nothing else, and two more for each point inside.
  std::size_t FindNumberOfPoints(const Monitor& monitor)
  {
    const std::size_t onLoops = this->Outlines.CountPoints(this->Result.Kept.size());
    DecimationOptions options = this->MakeDecimationOptions();
    options.Effort = DecimationEffort::Fast;
    options.FitHeights = false;
    options.MaximumNumberOfPoints = onLoops;
    const std::size_t least = SeismicHorizons::Decimate(this->CopyHorizon(), options, monitor).Triangles.size() / 3;
    const std::size_t most = this->Options.MaximumNumberOfTriangles;
    if (least > most)
    {
      throw TooFewTriangles(most, least);
    }
    return std::min(onLoops + (most - least) / 2, this->Result.Kept.size() - this->Dropped.size());
  }

  SurfacePoints Points; // moved away by the last run
  const SurfaceOptions& Options;
  Surface Result;
  bool HasBoundary = false;
  BoundaryOptions BoundaryParameters; // with which it was found
  std::vector<PlanePoint> KeptColumns; // of the points that have a patch, where some have none
  std::vector<double> KeptHeight;
  DroppedPoints Dropped; // from the outlines of these
  Loops Outlines; // without them
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
int ChooseLongestSeamEdge(std::int64_t smallestHoleSize)
{
  constexpr double Longest = 64.0;
  return int(std::min(std::ceil(std::sqrt(double(std::max<std::int64_t>(smallestHoleSize, 1)))), Longest));
}

//----------------------------------------------------------------------------------------------------------------------
Surface MakeSurface(SurfacePoints points, const SurfaceOptions& options, const Monitor& monitor)
{
  if (options.MaximumNumberOfTriangles == 0)
  {
    CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  }
  else if (HasSeams(options.Seams))
  {
    throw InputError("a seam and a number of triangles, expected an error as the target of a part of a horizon");
  }
  CheckAtLeast("outline tolerance", options.OutlineTolerance.value_or(0.0), 0.0, " columns");
  CheckAtLeast("distance threshold", options.DistanceThreshold.value_or(0.0), 0.0, " lattice units");
  CheckColumns(points);
  return SurfaceMaker(std::move(points), options).Run(monitor);
}
}
