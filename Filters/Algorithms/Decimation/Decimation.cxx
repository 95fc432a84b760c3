// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: the rounds of insertion; what a mesh is as a result; and from the mesh of the loops alone to an error
// or to a number of points.

#include "Decimation.h"

#include "Common/MeshChecker.h"
#include "Common/Monitor.h"
#include "Common/Parameters.h"
#include "Common/Predicates.h"
#include "Common/Types.h"
#include "HeightFit.h"
#include "HeightMesh.h"
#include "MeshImprover.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// Of the largest error, what part is still inserted in the same rounds; and of sums of squares.
constexpr double PartOfLargest = 0.6;
constexpr double PartOfSum = PartOfLargest * PartOfLargest;

class MeshRefiner
{
public:
  /// Keeps a reference to the mesh, which is constrained Delaunay and remains so. Inserts until it has so many vertices
  /// (0 for no limit): first those of the triangles with the largest error, or with the largest sum.
  MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, DecimationPriority priority);

  /// Inserts points until no column is farther from the mesh than `error`, or there are as many as there may be.
  void InsertWhereFar(double error, const Monitor& monitor);
  /// Then the same where inner sides of the mesh cross lines between columns.
  void InsertAtSides(double error, const Monitor& monitor);

private:
  bool IsFull() const { return this->MostVertices > 0 && this->Mesh.NumberOfVertices() >= this->MostVertices; }
  bool FindUrgent(double bound, double& limit, std::vector<TriangleId>& urgent) const;
  double UrgencyOf(TriangleId triangle) const;
  void InsertRound(const std::vector<TriangleId>& triangles);
  void Insert(PointId point, TriangleId triangle);
  void AddNew(TriangleId triangle);
  void SortNew();

  HeightMesh& Mesh;
  const std::size_t MostVertices;
  const DecimationPriority Priority;
  ErrorPower Power;
  std::vector<TriangleId> New; // triangles that are still to be measured
  std::vector<unsigned char> IsNew; // by triangle
  std::vector<TriangleId> Around; // the point that was inserted last
};

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, DecimationPriority priority)
  : Mesh(mesh)
  , MostVertices(mostVertices)
  , Priority(priority)
{
  if (priority == DecimationPriority::SumOfSquares)
  {
    this->Power = { 2, mesh.HeightRange() };
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertWhereFar(double error, const Monitor& monitor)
{
  const double bound = error + this->Mesh.Rounding();
  this->Mesh.MeasureAll(this->Power, bound, monitor.Step(0.0, 0.1));
  const double first = this->Mesh.LargestError();
  double part = 0.1;
  double limit = std::numeric_limits<double>::infinity();
  for (std::vector<TriangleId> urgent; !this->IsFull() && this->FindUrgent(bound, limit, urgent);)
  {
    // While the error falls, the number of triangles grows by factors: by the last rounds most is still to come.
    part = std::max(part, 1.0 - 0.9 * this->Mesh.Error(urgent.front()).Largest / first);
    monitor.Progress(part);
    const std::size_t before = this->Mesh.NumberOfVertices();
    this->InsertRound(urgent);
    if (this->Mesh.NumberOfVertices() == before)
    {
      throw InputError("point " + std::to_string(this->Mesh.Error(urgent.front()).Point) +
        " in several triangles, expected loops that enclose it once");
    }
    this->SortNew();
    this->Mesh.Measure(this->New, this->Power, bound, Monitor());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtSides(double error, const Monitor& monitor)
{
  const double bound = error + this->Mesh.Rounding();
  this->Mesh.MeasureAllSides(bound, monitor.Step(0.0, 0.8));
  double limit = 0.0;
  for (std::vector<TriangleId> far; !this->IsFull() && this->FindUrgent(bound, limit, far);)
  {
    monitor.Progress(0.8);
    this->InsertRound(far);
    if (this->New.empty()) // all points lie beyond the boundary, where nothing can be inserted
    {
      std::for_each(
        far.begin(), far.end(), [this](TriangleId triangle) { this->Mesh.SetError(triangle, HeightError()); });
    }
    this->Mesh.Measure(this->New, ErrorPower(), bound, Monitor());
    this->Mesh.MeasureSides(this->New, bound, Monitor());
  }
}

//----------------------------------------------------------------------------------------------------------------------
// By the points that made them, which come row by row: what is measured next is near then, for large horizons a fifth
// of the time.
void MeshRefiner::SortNew()
{
  const auto point = [this](TriangleId triangle) { return this->Mesh.Triangles().Corner(triangle, 2); };
  std::sort(this->New.begin(), this->New.end(), [&point](TriangleId a, TriangleId b) { return point(a) < point(b); });
}

//----------------------------------------------------------------------------------------------------------------------
// The triangles with an error above a bound whose urgency is not below a limit, the most urgent ones first. When there
// is none, the limit falls; false when no error is above the bound.
bool MeshRefiner::FindUrgent(double bound, double& limit, std::vector<TriangleId>& urgent) const
{
  urgent.clear();
  double most = -1.0;
  const auto add = [&]()
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Triangles().Size(); ++triangle)
    {
      if (this->Mesh.Error(triangle).Largest > bound)
      {
        most = std::max(most, this->UrgencyOf(triangle));
        if (this->UrgencyOf(triangle) >= limit)
        {
          urgent.push_back(triangle);
        }
      }
    }
  };
  add();
  if (urgent.empty() && most >= 0.0)
  {
    limit = most * (this->Priority == DecimationPriority::LargestError ? PartOfLargest : PartOfSum);
    add();
  }
  std::sort(urgent.begin(), urgent.end(),
    [this](TriangleId a, TriangleId b)
    {
      const double one = this->UrgencyOf(a);
      const double other = this->UrgencyOf(b);
      return one != other ? one > other : a < b;
    });
  return !urgent.empty();
}

//----------------------------------------------------------------------------------------------------------------------
double MeshRefiner::UrgencyOf(TriangleId triangle) const
{
  const HeightError& error = this->Mesh.Error(triangle);
  return this->Priority == DecimationPriority::LargestError ? error.Largest : error.Sum;
}

//----------------------------------------------------------------------------------------------------------------------
// Inserts the worst points of triangles, but for those that an insertion before has changed. Of as many as there may
// still be half at most: what an insertion brings about can be more urgent than the last ones of a round.
void MeshRefiner::InsertRound(const std::vector<TriangleId>& triangles)
{
  const std::size_t room =
    this->MostVertices > 0 ? this->MostVertices - this->Mesh.NumberOfVertices() : triangles.size();
  const std::size_t most = this->Mesh.NumberOfVertices() + (this->MostVertices > 0 ? (room + 1) / 2 : room);
  this->New.clear();
  this->IsNew.assign(std::size_t(this->Mesh.Triangles().Size()) + 2 * triangles.size(), 0);
  for (const TriangleId triangle : triangles)
  {
    const PointId point = this->Mesh.Error(triangle).Point;
    if (this->Mesh.IsVertex(point))
    {
      this->AddNew(triangle); // the point, beside a side, was inserted from another triangle
    }
    else if (this->IsNew[triangle] == 0 && this->Mesh.NumberOfVertices() < most)
    {
      this->Insert(point, this->Mesh.Triangles().Locate(point, triangle));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::Insert(PointId point, TriangleId triangle)
{
  if (triangle == NoTriangle || this->IsNew[triangle] != 0)
  {
    return;
  }
  PlaneMesh& triangles = this->Mesh.Triangles();
  triangles.Insert(point, triangle, this->Around);
  if (this->Around.empty())
  {
    throw InputError(
      "point " + std::to_string(point) + " lies on the boundary, expected it inside or on a loop's line");
  }
  this->Mesh.MarkVertex(point, true);
  triangles.Legalize(this->Around);
  std::for_each(this->Around.begin(), this->Around.end(), [this](TriangleId changedOne) { this->AddNew(changedOne); });
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddNew(TriangleId triangle)
{
  if (this->IsNew[triangle] == 0)
  {
    this->IsNew[triangle] = 1;
    this->New.push_back(triangle);
  }
}

// ---- The result ----------------------------------------------------------------------------------------------------
class Collector
{
public:
  Collector(const HeightMesh& mesh, double smallestAngle)
    : Surface(mesh)
    , Mesh(mesh.Triangles())
    , SmallestSine(SineOfDegrees(smallestAngle))
  {
  }

  Decimation Run(const Monitor& monitor)
  {
    this->WritePoints();
    this->WriteTriangles();
    this->AssignPoints(monitor.Step(0.0, 0.8));
    this->CheckAllAssigned();
    this->MeasureSides(monitor.Step(0.8, 1.0));
    return std::move(this->Result);
  }

private:
  void WritePoints()
  {
    Selection kept(this->Surface.VertexMarks());
    Reduction& points = this->Result.Points;
    for (const PointId point : kept.Points)
    {
      const RaisedPoint place = this->Surface.Raised(point);
      points.Plane.push_back(place.Column);
      points.Height.push_back(place.Height);
      points.Averaged.push_back(place.Height != this->Surface.ColumnHeight(point) ? 1 : 0);
    }
    points.Boundary = this->Surface.Boundary().Renumbered(kept.Numbers);
    points.Source = std::move(kept.Points);
    points.Target = std::move(kept.Numbers);
  }

  void WriteTriangles()
  {
    this->Result.Triangles.reserve(3 * std::size_t(this->Mesh.Size()));
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const std::size_t point = std::size_t(this->Mesh.Corner(triangle, corner));
        this->Result.Triangles.push_back(this->Result.Points.Target[point]);
      }
      const auto place = [&](int corner) { return this->Mesh.Place(this->Mesh.Corner(triangle, corner)); };
      this->Result.NumberOfSlivers += SineOfSmallestAngle(place(0), place(1), place(2)) < this->SmallestSine ? 1 : 0;
    }
  }

  /// Measures every triangle, and gives each dropped point to a vertex.
  void AssignPoints(const Monitor& monitor)
  {
    this->Result.Errors.assign(std::size_t(this->Mesh.Size()), 0.0);
    std::vector<double> sums(this->Result.Errors.size(), 0.0);
    this->Surface.ForEachTriangle(
      monitor, [&](TriangleId triangle) { sums[triangle] = this->AssignPointsOf(triangle); });
    double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    for (const PointId vertex : this->Result.Points.Source)
    {
      sum += std::abs(this->Surface.Height(vertex) - this->Surface.ColumnHeight(vertex));
    }
    this->Result.MeanError = this->Surface.NumberOfPoints() == 0 ? 0.0 : sum / double(this->Surface.NumberOfPoints());
    const auto largest = std::max_element(this->Result.Errors.begin(), this->Result.Errors.end());
    this->Result.LargestError = this->Result.Errors.empty() ? 0.0 : *largest;
  }

  /// The sum of the errors of the columns that count for it.
  double AssignPointsOf(TriangleId triangle)
  {
    double sum = 0.0;
    double& largest = this->Result.Errors[triangle];
    this->Surface.RasterOf(triangle).ForEachColumn(this->Surface.RaisedCorners(triangle),
      [&](PointId point, double error, const std::array<double, 3>& weights)
      {
        largest = std::max(largest, std::abs(error));
        if (this->Surface.Owns(triangle, weights))
        {
          sum += std::abs(error);
          const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
          this->Result.Points.Target[point] = this->Result.Triangles[3 * triangle + nearest];
        }
      });
    return sum;
  }

  void CheckAllAssigned() const
  {
    const std::vector<PointId>& target = this->Result.Points.Target;
    for (PointId point = 0; std::size_t(point) < target.size(); ++point)
    {
      if (target[point] == NoPoint && this->Surface.HasPoint(point))
      {
        throw InputError("point " + std::to_string(point) +
          " lies outside the boundary of its patch, expected loops around all points");
      }
    }
  }

  /// Each side once.
  void MeasureSides(const Monitor& monitor)
  {
    std::vector<std::array<double, 2>> errors(std::size_t(this->Mesh.Size()), { 0.0, 0.0 }); // of inner sides, of loops
    this->Surface.ForEachTriangle(monitor,
      [&](TriangleId triangle)
      {
        for (int side = 0; side < 3; ++side)
        {
          const TriangleId beyond = this->Mesh.Neighbour(triangle, side);
          if (beyond == NoTriangle || beyond > triangle)
          {
            double& largest = errors[triangle][beyond == NoTriangle ? 1 : 0];
            largest = std::max(largest, this->Surface.MeasureCrossings(triangle, side).Largest);
          }
        }
      });
    for (const auto& [ofInner, ofLoop] : errors)
    {
      this->Result.LargestSideError = std::max(this->Result.LargestSideError, ofInner);
      this->Result.LargestLoopError = std::max(this->Result.LargestLoopError, ofLoop);
    }
  }

  const HeightMesh& Surface;
  const PlaneMesh& Mesh;
  const double SmallestSine;
  Decimation Result;
};

//----------------------------------------------------------------------------------------------------------------------
Decimation MakeResult(const HeightMesh& mesh, double smallestAngle, const Monitor& monitor)
{
  return Collector(mesh, smallestAngle).Run(monitor);
}

// ---- From the loops to the mesh ------------------------------------------------------------------------------------
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
    mesh.Triangles().SortByPlace(); // what is read next is near then
    mesh.SetHeights(FitHeights(mesh, FitAim::LargestError, ReachOfFit * error, monitor.Step(0.5, 0.6)));
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
  return MakeResult(mesh, options.SmallestAngle, monitor.Step(0.9, 1.0));
}
}

//----------------------------------------------------------------------------------------------------------------------
Decimation Decimate(BoundedHorizon horizon, const DecimationOptions& options, const Monitor& monitor)
{
  assert(horizon.SubVoxelsPerColumn == 1);
  Check(options);
  Decimation result = Run(std::move(horizon), options, monitor);
  if (MeshChecker::IsOn)
  {
    const bool isDelaunay = options.Effort == DecimationEffort::Fast;
    MeshChecker::Require("Decimate", result.Points.Plane, result.Points.Boundary, result.Triangles,
      isDelaunay ? MeshChecker::Kind::Delaunay : MeshChecker::Kind::Any);
  }
  return result;
}
}
