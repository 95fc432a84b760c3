// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshImprover.h"

#include "MeshRefiner.h"

#include <algorithm>
#include <optional>

namespace SeismicHorizons
{
namespace
{
// Heights are fitted at a larger error, and move less than the error, to leave room for points that are not fitted.
constexpr double ErrorBeforeFit = 1.3;
constexpr double ReachOfFit = 0.9;

// For larger angles (degrees), the best effort would insert more vertices than it removes.
constexpr double LargestInserted = 2.0;
}

//----------------------------------------------------------------------------------------------------------------------
void InsertToError(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const HeightRule& rule)
{
  const double error = options.MaximumError;
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  std::optional<EdgeSizes> sizes;
  if (options.EdgeLength > 0.0)
  {
    sizes.emplace(mesh, options.EdgeLength, options.EdgeGrowth);
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
  refiner.InsertWhereFar(error, monitor.Step(0.6, 0.8));
  refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.8, 0.9));
  const bool isForAll = options.Effort == DecimationEffort::Fast || sizes;
  const double smallestAngle = isForAll ? SmallestAngleOf(options) : std::min(options.SmallestAngle, LargestInserted);
  for (std::size_t before = 0; smallestAngle > 0.0;)
  {
    before = mesh.NumberOfVertices();
    refiner.InsertAtSlivers(smallestAngle, sizes ? &*sizes : nullptr);
    if (mesh.NumberOfVertices() == before)
    {
      break;
    }
    refiner.InsertWhereFar(error, monitor.Step(0.9, 0.95));
    refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.95, 1.0));
  }
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
  refiner.InsertAtEdges(options.MaximumCrossingError(), monitor.Step(0.95, 1.0));
}
}
