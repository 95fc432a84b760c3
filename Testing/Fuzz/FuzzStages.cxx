// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a horizon and the options of all stages (StageInput.h), which are run one after the other. Their results
// must have the properties of StageProperties.h; options out of range must be refused, and nothing else may be.

#include "StageInput.h"
#include "StageProperties.h"

#include "Filters/Algorithms/CellSimplification/CellSimplification.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Tools/ReductionChecker.h"

#include <algorithm>
#include <cmath>

using namespace Fuzz;
using namespace SeismicHorizons;
using namespace TestHorizons;

namespace
{
bool IsLength(double value)
{
  return value >= 0.0 && std::isfinite(value);
}

bool IsValid(const BoundaryOptions& options)
{
  const bool isTooWide = options.Cuts && options.Growth == GrowthStrategy::Distance && options.Radius > 1;
  return options.Radius >= 1 && options.Radius <= LargestRadius && options.SmallestHoleSize >= 1 &&
    options.MinimumPatchSize >= 1 && !isTooWide;
}

bool IsValid(const BoundarySimplificationOptions& options)
{
  return IsLength(options.DistanceThreshold) && IsLength(options.OutlineTolerance);
}

bool IsValid(const CellOptions& options)
{
  return options.CellSize >= 1;
}

bool IsValid(const ElaborateOptions& options)
{
  return options.CellSize >= 1 && IsLength(options.FlatnessThreshold) && IsLength(options.BoundaryDensityThreshold) &&
    IsLength(options.BoundaryExtentThreshold) && IsLength(options.BoundaryCellSizeThreshold) &&
    IsLength(options.GrowthPerRing) && options.GrowthPerRing >= 1.0 && IsLength(options.SmallestCellSize) &&
    options.SmallestCellSize >= 1.0;
}

bool IsValid(const BoundaryLimits& limits)
{
  return limits.LargestAngle >= 0.0 && limits.LargestAngle <= 180.0 && IsLength(limits.LongestEdge);
}

/// The columns that were not dropped, with their heights, inside their boundary. Patches that were dropped must make no
/// difference to the others.
BoundedHorizon KeepPatches(const Patches::Columns& columns, const std::vector<double>& heights,
  const ExteriorBoundary& boundary, const BoundaryOptions& options)
{
  Patches::Columns keptColumns;
  std::vector<double> keptHeights;
  for (std::size_t point = 0; point < columns.size(); ++point)
  {
    if (boundary.Patch[point] != NoPatch)
    {
      keptColumns.push_back(columns[point]);
      keptHeights.push_back(heights[point]);
    }
  }
  const BoundedHorizon horizon = MakeHorizon(keptColumns, keptHeights, options);
  // Hops that a cut bars keep others away, so that the other side of a crack matters, be it a patch that is dropped.
  const bool canMatter = options.Cuts && options.Radius > 1;
  Require(canMatter ||
      (horizon.Boundary.Size() == boundary.Boundary.Size() &&
        horizon.Boundary.TotalLength() == boundary.Boundary.TotalLength()),
    "boundary: dropped patches matter");
  return horizon;
}

std::optional<BoundedHorizon> TakeHorizon(StageInput& input)
{
  const Patches::Columns columns = input.TakeColumns();
  const std::vector<double> heights = input.TakeHeights(columns);
  const std::shared_ptr<const LinkCuts> cuts = input.TakeCuts(columns);
  BoundaryOptions options = input.TakeBoundaryOptions();
  options.Cuts = cuts.get();
  const auto boundary = RunOn(IsValid(options), "boundary", [&]() { return FindExteriorBoundary(columns, options); });
  if (!boundary)
  {
    return {};
  }
  CheckBoundary(columns, *boundary, options);
  BoundedHorizon horizon = KeepPatches(columns, heights, *boundary, options);
  horizon.Cuts = cuts;
  return horizon;
}

/// Points that are left of a horizon.
BoundedHorizon WithCuts(BoundedHorizon left, const BoundedHorizon& horizon)
{
  left.Cuts = horizon.Cuts;
  return left;
}

BoundedHorizon SimplifyLoops(const BoundedHorizon& horizon, StageInput& input)
{
  const BoundarySimplificationOptions options = input.TakeBoundarySimplificationOptions();
  const auto result = RunOn(IsValid(options), "boundary simplification",
    [&]() { return SimplifyBoundary(TestHorizons::OnColumns(horizon), horizon.Boundary, options); });
  if (!result)
  {
    return horizon;
  }
  CheckSimplifiedBoundary(horizon, *result, options);
  const BoundedHorizon simplified = WithCuts(Drop(horizon, *result), horizon);
  if (options.OutlineTolerance == 0.0) // outlines that move in plan may move over cuts
  {
    CheckCuts(simplified, "boundary simplification");
  }
  CheckedMesh(simplified, "mesh of the simplified boundary");
  return simplified;
}

BoundedHorizon SimplifyInside(const BoundedHorizon& horizon, StageInput& input)
{
  const ElaborateOptions options = input.TakeCellOptions();
  const bool isElaborate = input.TakeBool();
  const std::string name = isElaborate ? "elaborate simplification" : "rough simplification";
  const auto simplify = [&]()
  { return isElaborate ? SimplifyElaborate(horizon, options) : SimplifyRough(horizon, options); };
  const bool isValid = isElaborate ? IsValid(options) : IsValid(static_cast<const CellOptions&>(options));
  const auto result = RunOn(isValid, name, [&]() { return OnAnyThreads(simplify, ReductionChecker::IsSame, name); });
  if (!result)
  {
    return horizon;
  }
  CheckReduction(horizon, *result);
  const BoundedHorizon reduced = WithCuts(Reduce(horizon, *result), horizon);
  CheckedMesh(reduced, "mesh of the " + name);
  return reduced;
}

/// From 0 to the highest or lowest point.
double HeightRange(const BoundedHorizon& horizon)
{
  double range = 0.0;
  for (const double height : horizon.Height)
  {
    range = std::max(range, std::abs(height));
  }
  return range;
}

/// A mesh within an error, or of so many points.
void DecimateWhole(const BoundedHorizon& horizon, StageInput& input)
{
  const DecimationOptions options = input.TakeDecimationOptions();
  const auto isSame = [](const Decimation& a, const Decimation& b)
  { return a.Triangles == b.Triangles && a.Points.Height == b.Points.Height && a.Errors == b.Errors; };
  const auto decimate = [&]() { return Decimate(TestHorizons::OnColumns(horizon), options); };
  const std::vector<unsigned char> marks = horizon.Boundary.MarkPoints(horizon.Plane.size());
  const auto least = std::size_t(std::count(marks.begin(), marks.end(), 1));
  const bool isNumber = options.MaximumNumberOfPoints > 0;
  const bool isValid = IsLength(options.MaximumError) && options.SmallestAngle >= 0.0 &&
    options.SmallestAngle <= 60.0 &&
    !(isNumber && (options.MaximumError > 0.0 || options.MaximumNumberOfPoints < least));
  const auto result = RunOn(isValid, "decimation", [&]() { return OnAnyThreads(decimate, isSame, "decimation"); });
  if (!result)
  {
    return;
  }
  const double rounding = 1e-12 * HeightRange(horizon);
  const bool isKept = result->LargestError <= options.MaximumError + rounding;
  Require(isKept || isNumber, "decimation: the error is larger than asked for");
  Require(!isNumber || result->Points.Source.size() <= options.MaximumNumberOfPoints, "decimation: too many points");
  const BoundedHorizon reduced = Reduce(horizon, result->Points);
  if (options.Effort == DecimationEffort::Fast)
  {
    CheckedMesh(reduced, "mesh of the decimation");
  }
  else
  {
    CheckAnyMesh(reduced, result->Triangles);
  }
}

bool IsValid(const SurfaceOptions& options)
{
  const int radius = options.Radius.value_or(1);
  const bool isTooWide = options.Cuts && options.Growth == GrowthStrategy::Distance && radius > 1;
  return !isTooWide && (options.MaximumNumberOfTriangles > 0 || IsLength(options.MaximumError)) && radius >= 1 &&
    radius <= LargestRadius && options.SmallestHoleSize.value_or(1) >= 1 && options.MinimumPatchSize >= 1 &&
    IsLength(options.OutlineTolerance.value_or(0.0)) && IsLength(options.DistanceThreshold.value_or(0.0));
}

/// False when outlines alone take more triangles than there may be; that no other message says.
bool IsEnough(const SurfacePoints& points, const SurfaceOptions& options)
{
  try
  {
    MakeSurface(points, options);
    return true;
  }
  catch (const InputError& error)
  {
    return std::string(error.what()).find("that the outlines require") == std::string::npos;
  }
}

/// From points to a mesh in one; with a number of triangles that may be too small for the outlines.
void MeshAtOnce(const BoundedHorizon& horizon, StageInput& input)
{
  SurfaceOptions options = input.TakeSurfaceOptions();
  options.Cuts = horizon.Cuts.get();
  if (options.Cuts && !options.Radius)
  {
    options.Growth = GrowthStrategy::Clockwise; // the other one refuses the radius that may be chosen
  }
  std::vector<PlanePoint> columns;
  for (const PlanePoint& place : horizon.Plane)
  {
    columns.push_back({ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn });
  }
  const SurfacePoints points{ columns, horizon.Height };
  const bool isByNumber = options.MaximumNumberOfTriangles > 0;
  const auto isSame = [](const Surface& a, const Surface& b)
  { return a.Mesh.Triangles == b.Mesh.Triangles && a.Mesh.Points.Height == b.Mesh.Points.Height; };
  const auto make = [&]() { return MakeSurface(points, options); };
  const auto result = RunOn(
    IsValid(options) && IsEnough(points, options), "surface", [&]() { return OnAnyThreads(make, isSame, "surface"); });
  if (result && !result->Kept.empty())
  {
    const std::size_t triangles = result->Mesh.Triangles.size() / 3;
    Require(!isByNumber || triangles <= options.MaximumNumberOfTriangles, "surface: too many triangles");
    const double most = options.MaximumError + 1e-12 * HeightRange(horizon);
    Require(isByNumber || result->Mesh.LargestError <= most, "surface: the error is larger than asked for");
    BoundedHorizon mesh = horizon; // with the vertices alone
    mesh.Plane = result->Mesh.Points.Plane;
    mesh.Height = result->Mesh.Points.Height;
    mesh.Boundary = result->Mesh.Points.Boundary;
    mesh.Patch.clear();
    for (const PointId source : result->Mesh.Points.Source)
    {
      mesh.Patch.push_back(result->Boundary.Patch[std::size_t(source)]);
    }
    CheckAnyMesh(mesh, result->Mesh.Triangles);
  }
}

/// The hull of all points, and what is left of it when triangles outside are taken off.
void PeelHull(const BoundedHorizon& horizon, StageInput& input)
{
  BoundedHorizon hull = horizon;
  hull.Patch.assign(hull.Plane.size(), 0);
  hull.Boundary = FindConvexHull(hull.Plane);
  Triangulation mesh = CheckedMesh(hull, "mesh of the hull");
  const BoundaryLimits limits = input.TakeBoundaryLimits();
  const auto triangles = RunOn(IsValid(limits), "peeling",
    [&]()
    {
      RemoveOutsideTriangles(hull, mesh, limits);
      return mesh.Triangles.size();
    });
  const Triangulation again = CheckedMesh(hull, "mesh of the peeled hull");
  Require(!triangles || again.Triangles.size() == *triangles, "peeling: the mesh is not that of its boundary");
}

TriangleSurface MakeSurface(const BoundedHorizon& horizon)
{
  TriangleSurface surface;
  for (const SpacePoint& point : TestHorizons::ToSpacePoints(horizon))
  {
    surface.Points.emplace_back(point.X, point.Y, point.Z);
  }
  const RawVector<PointId> triangles = Triangulate(horizon).Triangles;
  for (std::size_t first = 0; first < triangles.size(); first += 3)
  {
    surface.Triangles.push_back({ triangles[first], triangles[first + 1], triangles[first + 2] });
  }
  return surface;
}

void Measure(const BoundedHorizon& reference, const BoundedHorizon& horizon, StageInput& input)
{
  const TriangleSurface from = MakeSurface(reference);
  const TriangleSurface to = MakeSurface(horizon);
  const SurfaceDistanceOptions options = input.TakeSurfaceDistanceOptions();
  const bool areValid = !from.Triangles.empty() && !to.Triangles.empty();
  const auto isSame = [](const SurfaceDistance& a, const SurfaceDistance& b) { return Fuzz::IsSame(a, b); };
  const auto measure = [&]() { return MeasureSurfaceDistance(from, to, options); };
  const auto distance =
    RunOn(areValid, "surface distance", [&]() { return OnAnyThreads(measure, isSame, "surface distance"); });
  if (distance)
  {
    CheckDistance(*distance);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Detail::NumberOfThreads() = 1;
  StageInput input(data, size);
  const std::optional<BoundedHorizon> taken = TakeHorizon(input);
  if (!taken || taken->Plane.empty())
  {
    return 0;
  }
  CheckedMesh(*taken, "mesh of the boundary");
  DecimateWhole(*taken, input);
  BoundedHorizon horizon = SimplifyLoops(*taken, input);
  for (int simplifications = input.TakeBelow(3); simplifications >= 0; --simplifications)
  {
    horizon = SimplifyInside(horizon, input);
  }
  PeelHull(horizon, input);
  // At least ten thousand samples are taken, so that not every input can have them.
  if (input.TakeBelow(16) == 1)
  {
    Measure(*taken, horizon, input);
  }
  MeshAtOnce(*taken, input);
  return 0;
}
