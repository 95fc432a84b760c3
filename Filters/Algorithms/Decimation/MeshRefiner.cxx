// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshRefiner.h"

#include "Common/CountingSort.h"
#include "Common/Parallel.h"
#include "Selection.h"
#include "Triangulation/Triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace SeismicHorizons
{
namespace
{
// To what part of the largest error the limit falls.
constexpr double LimitPart = 0.6;

// Heights of a triangle are right to some units in the last place of those of its corners.
constexpr double UnitsOfRounding = 32.0 * std::numeric_limits<double>::epsilon();

// How many triangles a thread measures at a time.
constexpr std::int64_t Grain = 64;

/// The mesh of the loops alone, over the points of the whole horizon.
RawVector<PointId> MeshLoops(
  const BoundedHorizon& horizon, const std::vector<unsigned char>& isOnLoop, const Monitor& monitor)
{
  const Selection loops(isOnLoop);
  BoundedHorizon outline;
  outline.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  for (const PointId point : loops.Points)
  {
    outline.Plane.push_back(horizon.Plane[std::size_t(point)]);
    outline.Patch.push_back(horizon.Patch[std::size_t(point)]);
  }
  outline.Boundary = horizon.Boundary.Renumbered(loops.Numbers);
  RawVector<PointId> triangles = Triangulate(outline, TriangulationOptions(), monitor).Triangles;
  for (PointId& point : triangles)
  {
    point = loops.Points[std::size_t(point)];
  }
  return triangles;
}

double FindRounding(const std::vector<double>& heights)
{
  const auto ends = std::minmax_element(heights.begin(), heights.end());
  return heights.empty() ? 0.0 : UnitsOfRounding * std::max(std::abs(*ends.first), std::abs(*ends.second));
}
}

//----------------------------------------------------------------------------------------------------------------------
MeshRefiner::MeshRefiner(const BoundedHorizon& horizon, const std::vector<PlanePoint>& columns,
  const DecimationOptions& options, const Monitor& monitor)
  : Horizon(horizon)
  , Columns(columns)
  , Options(options)
  , IsVertex(horizon.Boundary.MarkPoints(horizon.Plane.size()))
  , Vertices(std::size_t(std::count(this->IsVertex.begin(), this->IsVertex.end(), 1)))
  , Triangles(columns, MeshLoops(horizon, this->IsVertex, monitor))
  , VertexHeights(horizon.Height)
  , Rounding(FindRounding(horizon.Height))
{
  this->CheckNumberOfPoints();
  this->MakeRasters();
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::CheckNumberOfPoints() const
{
  const std::size_t most = this->Options.MaximumNumberOfPoints;
  if (most > 0 && most < this->Vertices)
  {
    throw InputError("maximum number of points " + std::to_string(most) + ", expected at least the " +
      std::to_string(this->Vertices) + " of the loops, which are kept");
  }
}

//----------------------------------------------------------------------------------------------------------------------
// One for each patch: they can be far apart, and one can lie in a hole of another one.
void MeshRefiner::MakeRasters()
{
  const std::vector<std::int32_t>& patch = this->Horizon.Patch;
  const std::int32_t patches = patch.empty() ? 0 : *std::max_element(patch.begin(), patch.end()) + 1;
  const ItemLists<PointId> points(patches,
    [&patch](auto&& add)
    {
      for (std::size_t point = 0; point < patch.size(); ++point)
      {
        add(patch[point], PointId(point));
      }
    });
  this->Rasters.resize(std::size_t(patches));
  for (std::int32_t number = 0; number < patches; ++number)
  {
    if (!points.IsEmpty(number))
    {
      this->Rasters[std::size_t(number)] = std::make_unique<HeightRaster>(
        std::vector<PointId>(points.begin(number), points.end(number)), this->Columns, this->Horizon.Height);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertWhereFar(double error, const Monitor& monitor)
{
  if (this->IsFull())
  {
    return;
  }
  const double bound = error + this->Rounding;
  const auto measure = [this](TriangleId triangle) { return this->RasterOf(triangle).Measure(this->Raised(triangle)); };
  this->AddAllAsNew();
  this->MeasureNew(monitor.Step(0.0, 0.1), measure);
  const double first = this->FindLargest();
  for (double largest = first; largest > bound && !this->IsFull(); largest = this->FindLargest())
  {
    const double limit = std::max(bound, LimitPart * largest);
    while (!this->IsFull() && this->InsertRound(this->FindAbove(limit)))
    {
      this->MeasureNew(Monitor(), measure);
      // From one limit to the next the number of triangles grows by a factor: by the last rounds most is still to come.
      monitor.Progress(1.0 - 0.9 * limit / first);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::InsertAtSides(double error, const Monitor& monitor)
{
  if (this->IsFull())
  {
    return;
  }
  const auto measure = [this](TriangleId triangle) { return this->MeasureAll(triangle); };
  this->AddAllAsNew();
  this->MeasureNew(monitor, measure);
  while (!this->IsFull() && this->InsertRound(this->FindAbove(error + this->Rounding)))
  {
    this->MeasureNew(Monitor(), measure);
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Inserts the worst points of triangles, but for those that an insertion before has changed. False when there is none.
bool MeshRefiner::InsertRound(const std::vector<TriangleId>& triangles)
{
  this->New.clear();
  this->IsNew.assign(std::size_t(this->Triangles.Size()) + 2 * triangles.size(), 0);
  for (const TriangleId triangle : triangles)
  {
    const PointId point = this->Errors[std::size_t(triangle)].Point;
    if (this->IsVertex[std::size_t(point)] != 0)
    {
      this->AddNew(triangle); // the point, beside a side, was inserted from another triangle
    }
    else if (this->IsNew[std::size_t(triangle)] == 0 && !this->IsFull())
    {
      this->Insert(point, this->Triangles.Locate(point, triangle));
    }
  }
  return !this->New.empty();
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::Insert(PointId point, TriangleId triangle)
{
  if (triangle == NoTriangle || this->IsNew[std::size_t(triangle)] != 0)
  {
    return;
  }
  const std::vector<TriangleId>& changed = this->Triangles.Insert(point, triangle);
  if (changed.empty())
  {
    throw InputError(
      "point " + std::to_string(point) + " lies on the boundary, expected it inside or on a loop's line");
  }
  this->IsVertex[std::size_t(point)] = 1;
  ++this->Vertices;
  std::for_each(changed.begin(), changed.end(), [this](TriangleId changedOne) { this->AddNew(changedOne); });
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddNew(TriangleId triangle)
{
  if (this->IsNew[std::size_t(triangle)] == 0)
  {
    this->IsNew[std::size_t(triangle)] = 1;
    this->New.push_back(triangle);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshRefiner::AddAllAsNew()
{
  this->New.resize(std::size_t(this->Triangles.Size()));
  std::iota(this->New.begin(), this->New.end(), 0);
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Measure>
void MeshRefiner::MeasureNew(const Monitor& monitor, Measure&& measure)
{
  this->Errors.resize(std::size_t(this->Triangles.Size()));
  ParallelFor(std::int64_t(this->New.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = this->New[std::size_t(n)];
        this->Errors[std::size_t(triangle)] = measure(triangle);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// At columns, and of inner sides.
HeightError MeshRefiner::MeasureAll(TriangleId triangle) const
{
  HeightError error = this->RasterOf(triangle).Measure(this->Raised(triangle));
  for (int side = 0; side < 3; ++side)
  {
    if (this->Triangles.Neighbour(triangle, side) != NoTriangle)
    {
      const HeightError ofSide = this->MeasureSide(triangle, side);
      error = ofSide.Largest > error.Largest ? ofSide : error;
    }
  }
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
// The triangles with an error above a limit, from the largest down.
std::vector<TriangleId> MeshRefiner::FindAbove(double limit) const
{
  std::vector<TriangleId> above;
  for (std::size_t triangle = 0; triangle < this->Errors.size(); ++triangle)
  {
    if (this->Errors[triangle].Largest > limit)
    {
      above.push_back(TriangleId(triangle));
    }
  }
  const auto error = [this](TriangleId triangle) { return this->Errors[std::size_t(triangle)].Largest; };
  std::sort(above.begin(), above.end(),
    [&error](TriangleId a, TriangleId b) { return error(a) != error(b) ? error(a) > error(b) : a < b; });
  return above;
}

//----------------------------------------------------------------------------------------------------------------------
double MeshRefiner::FindLargest() const
{
  double largest = 0.0;
  for (const HeightError& error : this->Errors)
  {
    largest = std::max(largest, error.Largest);
  }
  return largest;
}
//----------------------------------------------------------------------------------------------------------------------
double MeshRefiner::SumOfErrors() const
{
  std::vector<double> sums(std::size_t(this->Triangles.Size()), 0.0);
  ParallelFor(this->Triangles.Size(), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (TriangleId triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
      {
        this->RasterOf(triangle).ForEachColumn(this->Raised(triangle),
          [&](PointId, double error, const std::array<double, 3>&) { sums[std::size_t(triangle)] += std::abs(error); });
      }
    });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}
}
