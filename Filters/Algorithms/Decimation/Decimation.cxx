// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: the result of a mesh; refinement to an error or to a number of points.

#include "Decimation.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/Types.h"
#include "HeightMesh.h"
#include "MeshFit.h"
#include "MeshImprover.h"
#include "MeshRefiner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{

// ---- The result ----------------------------------------------------------------------------------------------------
/// Vertices must be sorted by point.
class Collector
{
public:
  Collector(const HeightMesh& mesh, double smallestAngle)
    : Surface(mesh)
    , Mesh(mesh.Triangles())
    , SmallestSine(SineOfDegrees(smallestAngle))
  {
  }

  Decimation Run(bool isMeasured, const Monitor& monitor)
  {
    this->WritePoints();
    this->WriteTriangles();
    if (isMeasured)
    {
      this->Measure(monitor);
      this->CheckAllAssigned();
    }
    return std::move(this->Result);
  }

private:
  void WritePoints()
  {
    Reduction& points = this->Result.Points;
    points.Target = FilledVector(this->Surface.NumberOfAllPoints(), NoPoint);
    for (VertexId vertex = 0; vertex < this->Surface.EndOfVertices(); ++vertex)
    {
      const RaisedPoint& place = this->Surface.Raised(vertex);
      points.Source.push_back(this->Surface.SourceOf(vertex));
      points.Target[points.Source.back()] = PointId(vertex);
      points.Plane.push_back(place.Column);
      points.Height.push_back(place.Height);
      points.Averaged.push_back(place.Height != this->Surface.ColumnHeight(vertex) ? 1 : 0);
    }
    points.Boundary = this->Surface.Boundary().Renumbered(points.Target);
  }

  void WriteTriangles()
  {
    this->Result.Triangles.reserve(3 * std::size_t(this->Mesh.Size()));
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      const auto& corners = this->Mesh.Corners(triangle);
      this->Result.Triangles.insert(this->Result.Triangles.end(), corners.begin(), corners.end());
      this->Result.NumberOfSlivers += this->Mesh.SineOf(triangle) < this->SmallestSine ? 1 : 0;
    }
  }

  void Measure(const Monitor& monitor)
  {
    MeshFit errors(this->Mesh, this->Surface.RaisedVertices());
    errors.Measure(
      0, this->Mesh.Size(),
      [this](TriangleId triangle) -> const HeightRaster& { return this->Surface.RasterOf(triangle); },
      [this](PointId point, VertexId vertex) { this->Result.Points.Target[point] = vertex; }, monitor);
    for (VertexId vertex = 0; vertex < this->Surface.EndOfVertices(); ++vertex)
    {
      errors.Sum += std::abs(this->Surface.Height(vertex) - this->Surface.ColumnHeight(vertex));
    }
    WriteErrors(std::move(errors), std::size_t(this->Surface.EndOfVertices()), this->Result);
  }

  void CheckAllAssigned() const
  {
    const RawVector<PointId>& target = this->Result.Points.Target;
    ParallelFor(std::int64_t(target.size()), Grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (PointId point = PointId(first); point < PointId(last); ++point)
        {
          if (target[point] == NoPoint && this->Surface.HasPoint(point))
          {
            throw InputError("point " + std::to_string(point) +
              " lies outside the boundary of its patch, expected loops around all points");
          }
        }
      });
  }

  const HeightMesh& Surface;
  const PlaneMesh& Mesh;
  const double SmallestSine;
  Decimation Result;
};

// ---- From the loops to the mesh ------------------------------------------------------------------------------------
// The best effort inserts these multiples of inner vertices. Twice as many lower the mean error by only 1 to 2 %.
constexpr double Surplus = 4.0;
// The error of as many leaves few more than the number.
constexpr double SurplusForLargest = 2.0;
constexpr double FarFromInserted = 1.04;

/// Fitting heights for a number of points flips edges even with the effort Fast.
bool IsFlipped(const DecimationOptions& options)
{
  return options.FitHeights && HasNumber(options);
}

std::vector<PointId> FindInTheWay(
  const HeightMesh& mesh, const std::vector<TriangleId>& triangles, const DecimationOptions& options)
{
  constexpr std::int64_t trianglesPerChunk = 1024;
  const double bound = options.MaximumCrossingError() + mesh.Rounding();
  if (bound == std::numeric_limits<double>::infinity())
  {
    return {};
  }
  const PlaneMesh& plane = mesh.Triangles();
  const bool areAll = triangles.size() == std::size_t(plane.Size());
  return CollectChunks<PointId>(std::int64_t(triangles.size()), trianglesPerChunk, Monitor(),
    [&](std::vector<PointId>& found, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = triangles[n];
        for (int edge = 0; edge < 3; ++edge)
        {
          if (!areAll || plane.Neighbour(triangle, edge) < triangle) // each edge once
          {
            mesh.RasterOf(triangle).FindDropped(mesh.Raised(plane.Corner(triangle, edge)),
              mesh.Raised(plane.Corner(triangle, NextCorner(edge))), bound, found);
          }
        }
      }
    });
}

/// Each inner vertex adds two triangles.
std::size_t TrianglesOfLoops(const HeightMesh& mesh)
{
  return std::size_t(mesh.Triangles().Size()) - 2 * mesh.NumberOfInnerVertices();
}

LoopTriangles ViewLoops(
  const HeightMesh& mesh, const std::vector<TriangleId>& triangles, const DecimationOptions& options, int reviews)
{
  LoopTriangles view{ {}, FindInTheWay(mesh, triangles, options), mesh.HeightsOfPoints(), TrianglesOfLoops(mesh),
    options.MaximumError, reviews };
  for (const TriangleId triangle : triangles)
  {
    const auto& [a, b, c] = mesh.Triangles().Corners(triangle);
    if (mesh.IsOnLoop(a) || mesh.IsOnLoop(b) || mesh.IsOnLoop(c))
    {
      view.Corners.push_back({ mesh.SourceOf(a), mesh.SourceOf(b), mesh.SourceOf(c) });
    }
  }
  return view;
}

std::vector<TriangleId> FindSlivers(const HeightMesh& mesh, double smallestAngle)
{
  const double sine = SineOfDegrees(smallestAngle);
  std::vector<TriangleId> slivers = mesh.AllTriangles();
  slivers.erase(std::remove_if(slivers.begin(), slivers.end(),
                  [&](TriangleId triangle) { return mesh.Triangles().SineOf(triangle) >= sine; }),
    slivers.end());
  return slivers;
}

/// The best effort improves this mesh. Unless it is even, loops move before points are inserted at slivers, which they may
/// mend.
void InsertUntilGood(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  constexpr double inserted = 0.8; // the rest is short
  DecimationOptions now = options;
  now.SmallestAngle = review ? 0.0 : options.SmallestAngle;
  std::optional<std::vector<TriangleId>> triangles; // nothing while the mesh has the loops alone
  for (int reviews = 0;; ++reviews)
  {
    const Monitor step = monitor.Step(reviews == 0 ? 0.0 : inserted, inserted);
    if (triangles)
    {
      triangles = InsertWhereChanged(mesh, now, std::move(*triangles), step);
    }
    else
    {
      InsertToError(mesh, now, step);
      triangles = mesh.AllTriangles();
    }
    monitor.Progress(inserted);
    std::optional<MovedLoops> moved = review ? review(ViewLoops(mesh, *triangles, options, reviews)) : std::nullopt;
    if (moved)
    {
      triangles = mesh.ChangeLoops(std::move(moved->Boundary), std::move(moved->Dropped), moved->ShownAgain);
    }
    else if (now.SmallestAngle < options.SmallestAngle)
    {
      now = options;
      triangles = FindSlivers(mesh, options.SmallestAngle);
    }
    else
    {
      return;
    }
  }
}

// ---- For a number ----------------------------------------------------------------------------------------------------
/// The best effort searches the least bound, from a mesh within a bound.
bool IsSearched(const DecimationOptions& options)
{
  return options.Effort == DecimationEffort::Best && options.Priority == DecimationPriority::LargestError;
}

std::size_t MostVertices(const HeightMesh& mesh, const DecimationOptions& options)
{
  if (options.MaximumNumberOfTriangles == 0)
  {
    const std::size_t least = mesh.NumberOfVertices() - mesh.NumberOfInnerVertices();
    if (options.MaximumNumberOfPoints < least)
    {
      throw InputError("maximum number of points " + std::to_string(options.MaximumNumberOfPoints) +
        ", expected at least the " + std::to_string(least) + " of the loops, which are kept");
    }
    return options.MaximumNumberOfPoints;
  }
  const std::size_t least = TrianglesOfLoops(mesh);
  if (options.MaximumNumberOfTriangles < least)
  {
    throw TooFewTriangles(options.MaximumNumberOfTriangles, least);
  }
  return std::min(
    mesh.NumberOfVertices() - mesh.NumberOfInnerVertices() + (options.MaximumNumberOfTriangles - least) / 2,
    mesh.NumberOfPoints());
}

void InsertAndRemove(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const std::size_t most = MostVertices(mesh, options);
  const std::size_t onLoops = mesh.NumberOfVertices();
  const auto insert = [&](double times, const Monitor& step)
  {
    MeshRefiner(mesh, onLoops + std::size_t(times * double(most - onLoops)), options.Priority)
      .InsertWhereFar(0.0, step);
  };
  insert(1.0, monitor.Step(0.0, 0.2));
  const double error = mesh.LargestError();
  insert(Surplus, monitor.Step(0.2, 0.4));
  mesh.SortByPlace();
  ReduceToNumber(mesh, most, error, options, monitor.Step(0.4, 1.0));
}

void InsertAndSearch(
  HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  DecimationOptions first = options;
  first.MaximumNumberOfPoints = 0;
  first.MaximumNumberOfTriangles = 0;
  if (first.MaximumError == 0.0)
  {
    const std::size_t most = MostVertices(mesh, options);
    const std::size_t onLoops = mesh.NumberOfVertices();
    MeshRefiner(mesh, onLoops + std::size_t(SurplusForLargest * double(most - onLoops)), options.Priority)
      .InsertWhereFar(0.0, monitor.Step(0.0, 0.2));
    first.MaximumError = std::max(mesh.LargestError(), LeastOfSearch);
  }
  double last = std::numeric_limits<double>::infinity();
  const auto insert = [&](double error, const Monitor& step)
  {
    DecimationOptions now = first;
    now.MaximumError = error;
    if (error > FarFromInserted * last)
    {
      mesh = HeightMesh(mesh.TakeHorizon(), Monitor());
      last = std::numeric_limits<double>::infinity();
    }
    if (error < last)
    {
      InsertUntilGood(mesh, now, step, review);
      last = error;
    }
    mesh.SortByPlace();
    return MostVertices(mesh, options);
  };
  ReduceLargestError(mesh, first, insert, monitor.Step(0.2, 1.0));
}

void InsertToNumber(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  MeshRefiner refiner(mesh, MostVertices(mesh, options), options.Priority);
  refiner.InsertWhereFar(0.0, monitor.Step(0.0, 0.7));
  if (options.FitHeights)
  {
    SmoothInGroups(mesh, options, monitor.Step(0.7, 1.0));
  }
}

void Check(const DecimationOptions& options)
{
  CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  CheckQuality(options, HasNumber(options));
  if (options.MaximumError > 0.0 && options.MaximumNumberOfPoints > 0)
  {
    std::ostringstream message;
    message << "maximum error " << options.MaximumError << " and maximum number of points "
            << options.MaximumNumberOfPoints << ", expected one of them as the target, and 0 for the other one";
    throw InputError(message.str());
  }
}

void Insert(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  if (!HasNumber(options))
  {
    InsertUntilGood(mesh, options, monitor, review);
    return;
  }
  if (IsSearched(options))
  {
    InsertAndSearch(mesh, options, monitor, review);
    return;
  }
  (options.Effort == DecimationEffort::Best ? InsertAndRemove : InsertToNumber)(mesh, options, monitor);
}

/// What fits loops as they were would stay: small triangles in an even mesh, points in one by number.
bool IsMadeAnew(const DecimationOptions& options)
{
  return options.EdgeLength > 0.0 || (HasNumber(options) && !IsSearched(options));
}

BoundedHorizon MoveLoops(
  BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  HeightMesh mesh(std::move(horizon), monitor.Step(0.0, 0.2));
  DecimationOptions fast = options;
  fast.Effort = DecimationEffort::Fast;
  fast.SmallestAngle = 0.0; // the best effort leaves other slivers
  fast.Crossings = HasNumber(options) ? CrossingTolerance::Unbounded : options.Crossings;
  fast.MaximumNumberOfTriangles = 0;
  InsertUntilGood(mesh, fast, monitor.Step(0.2, 1.0), review);
  return mesh.TakeHorizon();
}

Decimation Run(
  BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  HeightMesh mesh(std::move(horizon), monitor.Step(0.0, 0.1));
  const bool isImproved = IsImproved(options);
  Insert(mesh, options, monitor.Step(0.1, isImproved ? 0.35 : 0.9), review);
  if (isImproved)
  {
    ImproveWithinError(mesh, options, monitor.Step(0.35, 0.9));
  }
  const std::size_t most = HasNumber(options) ? MostVertices(mesh, options) : 0;
  if (HasNumber(options) && most < mesh.NumberOfVertices())
  {
    // Rarely, no vertex can be collapsed, as no neighbour sees all of its ring.
    DecimationOptions fast = options;
    fast.Effort = DecimationEffort::Fast;
    return Run(mesh.TakeHorizon(), fast, monitor.Step(0.9, 1.0), review);
  }
  mesh.SortVertices();
  Decimation result = Collector(mesh, options.SmallestAngle).Run(options.IsMeasured, monitor.Step(0.9, 1.0));
  result.MaximumNumberOfPoints = most;
  return result;
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckQuality(const MeshQuality& quality, bool isByNumber)
{
  constexpr double LeastLength = 4.0; // of triangles whose corners are columns
  CheckWithin("smallest angle", quality.SmallestAngle, 0.0, 60.0, " degrees");
  CheckWithin("edge growth", quality.EdgeGrowth, 0.0, 1.0, "");
  if (quality.EdgeLength != 0.0)
  {
    CheckAtLeast("edge length", quality.EdgeLength, LeastLength, " columns, or 0 for any");
  }
  if (quality.EdgeLength > 0.0 && isByNumber)
  {
    throw InputError(
      "an edge length and a number of points or triangles, expected an error as the target of even meshes");
  }
}

//----------------------------------------------------------------------------------------------------------------------
Decimation Decimate(
  BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor, const LoopReview& review)
{
  assert(horizon.SubVoxelsPerColumn == 1);
  Check(options);
  if (review && options.MaximumError > 0.0 && IsMadeAnew(options))
  {
    horizon = MoveLoops(std::move(horizon), options, monitor.Step(0.0, 0.2), review);
  }
  Decimation result = Run(std::move(horizon), options, monitor.Step(0.2, 1.0), review);
  if (MeshChecker::IsOn)
  {
    const bool isDelaunay = options.Effort == DecimationEffort::Fast && !IsFlipped(options);
    MeshChecker::Require("Decimate", result.Points.Plane, result.Points.Boundary, result.Triangles,
      isDelaunay ? MeshChecker::Kind::Delaunay : MeshChecker::Kind::Any);
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> FindErrors(BoundedHorizon horizon, std::size_t triangles, double leastError, const Monitor& monitor)
{
  HeightMesh mesh(std::move(horizon), monitor.Step(0.0, 0.1));
  const std::size_t least = TrianglesOfLoops(mesh);
  MeshRefiner refiner(
    mesh, mesh.NumberOfVertices() + (triangles - std::min(least, triangles)) / 2 + 1, DecimationPriority::LargestError);
  refiner.InsertWhereFar(leastError, monitor.Step(0.1, 1.0));
  std::vector<double> errors = refiner.ErrorsBefore();
  const double last = std::max(leastError, mesh.LargestError());
  errors.push_back(last);
  std::sort(errors.begin(), errors.end(), std::greater<>());
  errors.erase(std::upper_bound(errors.begin(), errors.end(), last, std::greater<>()), errors.end());
  return errors;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteErrors(MeshFit errors, std::size_t vertices, Decimation& result)
{
  const std::size_t points = errors.Columns + vertices;
  result.Errors = std::move(errors.Errors);
  result.LargestError = errors.Largest;
  result.MeanError = points == 0 ? 0.0 : errors.Sum / double(points);
  result.LargestEdgeError = errors.LargestOfEdges;
  result.LargestLoopError = errors.LargestOfLoops;
}

//----------------------------------------------------------------------------------------------------------------------
InputError TooFewTriangles(std::size_t most, std::size_t least)
{
  return InputError("maximum number of triangles " + std::to_string(most) + ", expected at least the " +
    std::to_string(least) + " that the outlines require");
}
}
