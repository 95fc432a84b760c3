// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Decimation.h"

#include "Common/Parameters.h"
#include "HeightFit.h"
#include "MeshImprover.h"
#include "MeshRefiner.h"
#include "MeshResult.h"

#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// From places in sub-voxels to those in columns.
void PutOnColumns(BoundedHorizon& horizon)
{
  for (std::size_t point = 0; point < horizon.Plane.size(); ++point)
  {
    PlanePoint& place = horizon.Plane[point];
    const PlanePoint column = { place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn };
    if (column.X * horizon.SubVoxelsPerColumn != place.X || column.Y * horizon.SubVoxelsPerColumn != place.Y)
    {
      throw InputError("point " + std::to_string(point) +
        " stands beside its column, expected whole columns: horizons are decimated before points are merged");
    }
    place = column;
  }
}

// With fitted heights, points are inserted for an error so much larger, and then, once heights are fitted, for the
// error itself. What was not fitted again then needs some room: heights move less than the error.
constexpr double ErrorBeforeFit = 1.3;
constexpr double ReachOfFit = 0.9;

// With the best effort, so many times the inner vertices that may be left are inserted, and then removed again. Twice
// as many more make the mean error 1 to 2 % smaller.
constexpr double Surplus = 4.0;

void InsertToError(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const double error = options.MaximumError;
  MeshRefiner refiner(mesh, 0, DecimationPriority::LargestError);
  if (options.FitHeights && error > 0.0)
  {
    refiner.InsertWhereFar(ErrorBeforeFit * error, monitor.Step(0.0, 0.5));
    mesh.SetHeights(FitHeights(mesh, DecimationPriority::LargestError, ReachOfFit * error, monitor.Step(0.5, 0.6)));
  }
  refiner.InsertWhereFar(error, monitor.Step(0.6, 0.8));
  refiner.InsertAtSides(error, monitor.Step(0.8, 1.0));
}

void InsertToNumber(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  MeshRefiner refiner(mesh, options.MaximumNumberOfPoints, options.Priority);
  refiner.InsertWhereFar(0.0, monitor.Step(0.0, 0.9));
  if (options.FitHeights)
  {
    FitToNumber(mesh, options.Priority, monitor.Step(0.9, 1.0));
  }
}

/// Inserts more points than may be left, and removes as many.
void InsertAndRemove(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const std::size_t inside = options.MaximumNumberOfPoints - mesh.NumberOfVertices();
  const std::size_t most = mesh.NumberOfVertices() + std::size_t(Surplus * double(inside));
  MeshRefiner(mesh, most, options.Priority).InsertWhereFar(0.0, monitor.Step(0.0, 0.4));
  ReduceToNumber(mesh, options.MaximumNumberOfPoints, options, monitor.Step(0.4, 1.0));
}

void Refine(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const bool isBest = options.Effort == DecimationEffort::Best;
  if (options.MaximumNumberOfPoints > 0)
  {
    (isBest ? InsertAndRemove : InsertToNumber)(mesh, options, monitor);
    return;
  }
  InsertToError(mesh, options, monitor.Step(0.0, isBest ? 0.3 : 1.0));
  if (isBest && options.MaximumError > 0.0)
  {
    ImproveWithinError(mesh, options, monitor.Step(0.3, 1.0));
  }
}

void Check(const DecimationOptions& options)
{
  CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  CheckWithin("smallest angle", options.SmallestAngle, 0.0, 60.0, " degrees");
  if (options.MaximumError > 0.0 && options.MaximumNumberOfPoints > 0)
  {
    std::ostringstream message;
    message << "maximum error " << options.MaximumError << " and maximum number of points "
            << options.MaximumNumberOfPoints << ", expected one of them as the target, and 0 for the other one";
    throw InputError(message.str());
  }
}

void CheckNumberOfPoints(const HeightMesh& mesh, std::size_t most)
{
  if (most > 0 && most < mesh.NumberOfVertices())
  {
    throw InputError("maximum number of points " + std::to_string(most) + ", expected at least the " +
      std::to_string(mesh.NumberOfVertices()) + " of the loops, which are kept");
  }
}

/// Of a horizon on columns.
Decimation Run(BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor)
{
  HeightMesh mesh(std::move(horizon), monitor.Step(0.0, 0.1));
  const std::size_t most = options.MaximumNumberOfPoints;
  CheckNumberOfPoints(mesh, most);
  Refine(mesh, options, monitor.Step(0.1, 0.9));
  if (most > 0 && most < mesh.NumberOfVertices())
  {
    // No vertex can go to a neighbour any more, as none of these sees all of what is around it. That is rare.
    DecimationOptions fast = options;
    fast.Effort = DecimationEffort::Fast;
    return Run(mesh.TakeHorizon(), fast, monitor.Step(0.9, 1.0));
  }
  return MakeResult(mesh, monitor.Step(0.9, 1.0));
}
}

//----------------------------------------------------------------------------------------------------------------------
Decimation Decimate(BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor)
{
  Check(options);
  PutOnColumns(horizon);
  return Run(std::move(horizon), options, monitor);
}
}
