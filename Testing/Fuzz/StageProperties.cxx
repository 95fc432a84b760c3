// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StageProperties.h"

#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/CutChecker.h"
#include "Tools/ReductionChecker.h"
#include "Tools/TriangleSets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace Fuzz
{
using namespace SeismicHorizons;

namespace
{
// Checkers look at all pairs of points, which takes too long with more of them.
constexpr std::size_t MostPointsInPairs = 200;
// Figures are sums of rounded numbers; this is far above what that takes away, and far below any fault.
constexpr double Rounding = 1e-9;

bool IsSameBoundary(const Loops& a, const Loops& b)
{
  bool same = a.Size() == b.Size();
  for (std::size_t loop = 0; same && loop < a.Size(); ++loop)
  {
    same = std::equal(a.begin(loop), a.end(loop), b.begin(loop), b.end(loop));
  }
  return same;
}

std::vector<PlanePoint> Moved(std::vector<PlanePoint> places, const PlanePoint& way)
{
  for (PlanePoint& place : places)
  {
    place = { place.X + way.X, place.Y + way.Y };
  }
  return places;
}

/// The cuts of columns that are moved, too; nothing where there are none.
std::optional<LinkCuts> MovedCuts(const LinkCuts* cuts, const Patches::Columns& columns, const PlanePoint& way)
{
  if (!cuts)
  {
    return std::nullopt;
  }
  const PlaneBox box(columns);
  LinkCuts moved{ PlaneBox(Moved(columns, way)) };
  for (std::int32_t y = box.Least.Y; y <= box.Greatest.Y; ++y)
  {
    for (std::int32_t x = box.Least.X; x <= box.Greatest.X; ++x)
    {
      cuts->IsCutEast({ x, y }) ? moved.CutEast({ x + way.X, y + way.Y }) : void();
      cuts->IsCutNorth({ x, y }) ? moved.CutNorth({ x + way.X, y + way.Y }) : void();
    }
  }
  return moved;
}

/// Twice the area inside the loops.
std::int64_t DoubledArea(const BoundedHorizon& horizon)
{
  std::int64_t area = 0;
  horizon.Boundary.ForEachEdge([&](PointId from, PointId to)
    { area -= SignedArea(horizon.Plane.front(), horizon.Plane[std::size_t(from)], horizon.Plane[std::size_t(to)]); });
  return area;
}

std::int64_t DoubledArea(const BoundedHorizon& horizon, const RawVector<PointId>& triangles)
{
  std::int64_t area = 0;
  for (std::size_t first = 0; first < triangles.size(); first += 3)
  {
    const auto place = [&](std::size_t corner) { return horizon.Plane[std::size_t(triangles[first + corner])]; };
    const std::int64_t own = SignedArea(place(0), place(1), place(2));
    Require(own > 0, "a triangle that does not turn counter-clockwise");
    area += own;
  }
  return area;
}

/// All numbers that are not one per point.
std::vector<double> Figures(const SurfaceDistance& distance)
{
  std::vector<double> figures;
  for (const DistanceFigures* f : { &distance.ReferenceToMesh, &distance.MeshToReference, &distance.TwoSided })
  {
    figures.insert(figures.end(), { f->Largest, f->LargestFound, f->Mean, f->Rms, f->Outline, double(f->Samples) });
    figures.insert(figures.end(), f->Percentile.begin(), f->Percentile.end());
  }
  return figures;
}

/// Numbers that are the same to the bit; nan is the same as nan.
bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

void CheckFigures(const DistanceFigures& figures)
{
  const double most = figures.LargestFound * (1.0 + Rounding);
  Require(
    std::isfinite(figures.Largest) && figures.Largest >= 0.0, "largest distance " + std::to_string(figures.Largest));
  Require(figures.LargestFound >= 0.0 && figures.LargestFound <= figures.Largest, "bounds of the largest distance");
  Require(figures.Rms >= 0.0 && figures.Rms <= most, "root mean square above the largest distance");
  Require(figures.Mean >= 0.0 && figures.Mean <= figures.Rms * (1.0 + Rounding), "mean above the root mean square");
  Require(std::is_sorted(figures.Percentile.begin(), figures.Percentile.end()), "percentiles not in order");
  // Percentiles are right within a thousandth.
  Require(figures.Percentile.front() >= 0.0 && figures.Percentile.back() <= most * 1.001,
    "percentile above the largest distance");
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckBoundary(const Patches::Columns& columns, const ExteriorBoundary& boundary, const BoundaryOptions& options)
{
  if (columns.size() <= MostPointsInPairs)
  {
    RequireNothing(BoundaryChecker::CheckBoundary(columns, boundary, options), "boundary");
    if (options.Cuts && options.MinimumPatchSize == 1)
    {
      RequireNothing(CutChecker::CheckBoundary({ columns, *options.Cuts }, boundary, options), "boundary");
    }
  }
  for (const PlanePoint& way : { PlanePoint{ 1, -1 }, { -1000, 777 }, { (1 << 28) - 2000, -(1 << 28) } })
  {
    BoundaryOptions movedOptions = options;
    const std::optional<LinkCuts> cuts = MovedCuts(options.Cuts, columns, way);
    movedOptions.Cuts = cuts ? &*cuts : nullptr;
    const ExteriorBoundary moved = FindExteriorBoundary(Moved(columns, way), movedOptions);
    Require(moved.Patch == boundary.Patch && IsSameBoundary(moved.Boundary, boundary.Boundary),
      "boundary: the place of the origin matters");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CheckCuts(const BoundedHorizon& horizon, const std::string& name)
{
  if (horizon.Cuts && horizon.Plane.size() <= MostPointsInPairs)
  {
    Patches::Columns columns;
    for (const PlanePoint& place : horizon.Plane)
    {
      columns.push_back({ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn });
    }
    RequireNothing(
      CutChecker::CheckCuts({ columns, *horizon.Cuts }, horizon.Plane, horizon.Boundary, horizon.SubVoxelsPerColumn),
      name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
Triangulation CheckedMesh(const BoundedHorizon& horizon, const std::string& name)
{
  const Triangulation mesh = Triangulate(horizon);
  const TriangleSets::Triangles triangles = TriangleSets::Canonical(mesh.Triangles);
  Require(triangles.size() == mesh.Triangles.size() / 3, name + ": a triangle twice");
  TriangulationOptions options;
  options.Strategy = SearchStrategy::Compactness;
  Require(
    TriangleSets::Canonical(Triangulate(horizon, options).Triangles) == triangles, name + ": the strategy matters");
  BoundedHorizon moved = horizon;
  moved.Plane = Moved(horizon.Plane, { 12345, -(1 << 28) });
  Require(
    TriangleSets::Canonical(Triangulate(moved).Triangles) == triangles, name + ": the place of the origin matters");
  Require(DoubledArea(horizon) == DoubledArea(horizon, mesh.Triangles), name + ": area");
  if (horizon.Plane.size() <= MostPointsInPairs)
  {
    RequireNothing(BoundaryChecker::CheckCrossings(horizon), name);
    RequireNothing(MeshChecker::CheckMesh(horizon, mesh.Triangles), name);
  }
  return mesh;
}

//----------------------------------------------------------------------------------------------------------------------
void CheckAnyMesh(const BoundedHorizon& horizon, const RawVector<PointId>& triangles)
{
  if (horizon.Plane.size() <= MostPointsInPairs)
  {
    RequireNothing(MeshChecker::CheckMesh(horizon, triangles, MeshChecker::Kind::Any), "mesh");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CheckSimplifiedBoundary(
  const BoundedHorizon& horizon, const BoundarySimplification& result, const BoundarySimplificationOptions& options)
{
  const double tolerance = options.OutlineTolerance;
  Require(result.OutlineDeviation <= tolerance, "boundary simplification: outline deviation above the tolerance");
  const double most = std::hypot(options.DistanceThreshold, tolerance) * (1.0 + Rounding);
  const bool isBound = options.BoundDeviation || options.Method == OutlineMethod::FewestPoints;
  Require(std::isfinite(result.Deviation) && (!isBound || result.Deviation <= most),
    "boundary simplification: deviation " + std::to_string(result.Deviation));
  const std::vector<PointId> targets = TestHorizons::FindTargets(result, horizon.Plane.size());
  for (const PointId target : targets)
  {
    Require(targets[std::size_t(target)] == target, "boundary simplification: a dropped point is a target");
  }
  const BoundedHorizon dropped = TestHorizons::Drop(horizon, result);
  Require(tolerance > 0.0 || DoubledArea(dropped) == DoubledArea(horizon), "boundary simplification: area");
}

//----------------------------------------------------------------------------------------------------------------------
void CheckReduction(const BoundedHorizon& horizon, const Reduction& result)
{
  RequireNothing(ReductionChecker::CheckPoints(horizon, result), "reduction");
  const auto [low, high] = std::minmax_element(horizon.Height.begin(), horizon.Height.end());
  const double slack = Rounding * std::max(std::abs(*low), std::abs(*high));
  for (const double height : result.Height)
  {
    Require(height >= *low - slack && height <= *high + slack, "reduction: height " + std::to_string(height));
  }
  for (const double flatness : result.Flatness)
  {
    Require(flatness >= 0.0 && 3.0 * flatness <= 1.0 + Rounding, "reduction: flatness " + std::to_string(flatness));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void CheckDistance(const SurfaceDistance& distance)
{
  for (const DistanceFigures* figures : { &distance.ReferenceToMesh, &distance.MeshToReference, &distance.TwoSided })
  {
    CheckFigures(*figures);
  }
  for (const PointDistances* points : { &distance.Reference, &distance.Mesh })
  {
    const bool fine = std::all_of(points->Distance.begin(), points->Distance.end(),
      [](double value) { return std::isfinite(value) && value >= 0.0; });
    Require(fine, "distance of a point");
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSame(const SurfaceDistance& a, const SurfaceDistance& b)
{
  return IsSame(Figures(a), Figures(b)) && IsSame(a.Reference.Distance, b.Reference.Distance) &&
    IsSame(a.Reference.Vertical, b.Reference.Vertical) && IsSame(a.Mesh.Distance, b.Mesh.Distance) &&
    IsSame(a.Mesh.Vertical, b.Mesh.Vertical);
}
}
