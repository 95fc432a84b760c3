// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshImprover.h"

#include "EdgeSizes.h"
#include "MeshRefiner.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Heights are fitted at a larger error, and move less than the error, to leave room for points that are not fitted.
constexpr double ErrorBeforeFit = 1.3;
constexpr double ReachOfFit = 0.9;

// For larger angles (degrees), the best effort would insert more vertices than it removes.
constexpr double LargestInserted = 2.0;

std::optional<EdgeSizes> SizesOf(const HeightMesh& mesh, const DecimationOptions& options)
{
  return options.EdgeLength > 0.0 ? std::make_optional<EdgeSizes>(mesh, options.EdgeLength, options.EdgeGrowth)
                                  : std::nullopt;
}

void InsertRest(HeightMesh& mesh, MeshRefiner& refiner, const DecimationOptions& options, const EdgeSizes* sizes,
  const Monitor& monitor)
{
  const bool isForAll = options.Effort == DecimationEffort::Fast || sizes;
  const double smallestAngle = isForAll ? SmallestAngleOf(options) : std::min(options.SmallestAngle, LargestInserted);
  std::size_t before = 0;
  double done = 0.0; // later rounds are short
  do
  {
    const Monitor step = monitor.Step(done, 0.2 * done + 0.8);
    done = 0.2 * done + 0.8;
    refiner.InsertWhereFar(options.MaximumError, step.Step(0.0, 0.6));
    refiner.InsertAtEdges(options.MaximumError, options.MaximumCrossingError(), step.Step(0.6, 1.0));
    before = mesh.NumberOfVertices();
    if (smallestAngle > 0.0)
    {
      refiner.InsertAtSlivers(smallestAngle, sizes);
    }
  } while (mesh.NumberOfVertices() > before);
}
}

//----------------------------------------------------------------------------------------------------------------------
void InsertToError(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule)
{
  const double error = options.MaximumError;
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  const std::optional<EdgeSizes> sizes = SizesOf(mesh, options);
  if (sizes)
  {
    refiner.InsertMarked(sizes->MarkPoints());
    refiner.InsertAtSlivers(SmallestAngleOf(options), &*sizes);
  }
  if (options.FitHeights && error > 0.0)
  {
    refiner.InsertWhereFar(ErrorBeforeFit * error, monitor.Step(0.0, 0.5));
    mesh.SortByPlace();
    mesh.SetAllHeights(FitAllHeights(
      mesh, ReachOfFit * error, options.Crossings != CrossingTolerance::Unbounded, rule, monitor.Step(0.5, 0.6)));
  }
  InsertRest(mesh, refiner, options, sizes ? &*sizes : nullptr, monitor.Step(0.6, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TriangleId> InsertWhereChanged(
  HeightMesh& mesh, const DecimationOptions& options, std::vector<TriangleId> changed, const Monitor& monitor)
{
  const std::optional<EdgeSizes> sizes = SizesOf(mesh, options);
  if (sizes) // of other loops
  {
    changed = mesh.AllTriangles();
  }
  MeshRefiner refiner(mesh, std::move(changed));
  InsertRest(mesh, refiner, options, sizes ? &*sizes : nullptr, monitor);
  return refiner.Examined();
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveWithinError(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const ColumnRule& rule)
{
  mesh.SortByPlace();
  ImproveInGroups(mesh, options, rule, monitor.Step(0.0, 0.9));
  // Groups leave room for rounding, so this changes nothing; but the bound is measured before it is promised.
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  refiner.InsertWhereFar(options.MaximumError, monitor.Step(0.9, 0.95));
  refiner.InsertAtEdges(options.MaximumError, options.MaximumCrossingError(), monitor.Step(0.95, 1.0));
}
}
