// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeightMesh.h"

#include "Common/CountingSort.h"
#include "Common/Parallel.h"
#include "Selection.h"
#include "Triangulation/Triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
// Heights of a triangle are right to some units in the last place of those of its corners.
constexpr double UnitsOfRounding = 32.0 * std::numeric_limits<double>::epsilon();

// How many triangles a thread measures at a time.
constexpr std::int64_t Grain = 64;

/// The mesh of the loops alone, over the points of the whole horizon.
RawVector<PointId> MeshLoops(const BoundedHorizon& horizon, const std::vector<std::int32_t>& patches,
  const std::vector<unsigned char>& isOnLoop, const Monitor& monitor)
{
  const Selection loops(isOnLoop);
  BoundedHorizon outline;
  outline.SubVoxelsPerColumn = horizon.SubVoxelsPerColumn;
  for (const PointId point : loops.Points)
  {
    outline.Plane.push_back(horizon.Plane[std::size_t(point)]);
    outline.Patch.push_back(patches[std::size_t(point)]);
  }
  outline.Boundary = horizon.Boundary.Renumbered(loops.Numbers);
  RawVector<PointId> triangles = Triangulate(outline, TriangulationOptions(), monitor).Triangles;
  for (PointId& point : triangles)
  {
    point = loops.Points[std::size_t(point)];
  }
  return triangles;
}

/// Patches numbered from 0 on without gaps, by point.
std::vector<std::int32_t> Renumber(std::vector<std::int32_t> patches)
{
  // Numbers come in long runs.
  std::map<std::int32_t, std::int32_t> numbers;
  std::int32_t last = 0;
  std::int32_t* number = nullptr;
  for (std::int32_t& patch : patches)
  {
    if (!number || patch != last)
    {
      last = patch;
      number = &numbers.emplace(patch, std::int32_t(numbers.size())).first->second;
    }
    patch = *number;
  }
  return patches;
}

double FindRounding(const std::vector<double>& heights)
{
  const auto ends = std::minmax_element(heights.begin(), heights.end());
  return heights.empty() ? 0.0 : UnitsOfRounding * std::max(std::abs(*ends.first), std::abs(*ends.second));
}
}

//----------------------------------------------------------------------------------------------------------------------
HeightMesh::HeightMesh(const BoundedHorizon& horizon, const std::vector<PlanePoint>& columns, const Monitor& monitor)
  : Horizon(horizon)
  , Columns(columns)
  , Patches(Renumber(horizon.Patch))
  , LoopMarks(horizon.Boundary.MarkPoints(horizon.Plane.size()))
  , Marks(this->LoopMarks)
  , Vertices(std::size_t(std::count(this->Marks.begin(), this->Marks.end(), 1)))
  , Mesh(columns, MeshLoops(horizon, this->Patches, this->LoopMarks, monitor))
  , VertexHeights(horizon.Height)
  , RoundingError(FindRounding(horizon.Height))
{
  this->MakeRasters();
}

//----------------------------------------------------------------------------------------------------------------------
// One for each patch: they can be far apart, and one can lie in a hole of another one.
void HeightMesh::MakeRasters()
{
  const std::vector<std::int32_t>& patch = this->Patches;
  const std::int32_t patches = patch.empty() ? 0 : *std::max_element(patch.begin(), patch.end()) + 1;
  const ItemLists<PointId> points(patches,
    [&patch](auto&& add)
    {
      for (std::size_t point = 0; point < patch.size(); ++point)
      {
        add(patch[point], PointId(point));
      }
    });
  this->Rasters.reserve(std::size_t(patches));
  for (std::int32_t number = 0; number < patches; ++number)
  {
    this->Rasters.emplace_back(
      std::vector<PointId>(points.begin(number), points.end(number)), this->Columns, this->Horizon.Height);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MarkVertex(PointId point, bool isVertex)
{
  this->Marks[std::size_t(point)] = isVertex ? 1 : 0;
  this->Vertices += isVertex ? 1 : -1;
  this->VertexHeights[std::size_t(point)] = this->Horizon.Height[std::size_t(point)];
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Compact()
{
  const std::vector<TriangleId> left = this->Mesh.Compact();
  for (std::size_t n = 0; n < left.size(); ++n)
  {
    this->Errors[n] = this->Errors[std::size_t(left[n])];
  }
  this->Errors.resize(left.size());
}

//----------------------------------------------------------------------------------------------------------------------
template <typename Measuring>
void HeightMesh::MeasureEach(const std::vector<TriangleId>& triangles, const Monitor& monitor, Measuring&& measure)
{
  this->Errors.resize(std::size_t(this->Mesh.Size()));
  ParallelFor(std::int64_t(triangles.size()), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const TriangleId triangle = triangles[std::size_t(n)];
        this->Errors[std::size_t(triangle)] = measure(triangle);
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::Measure(const std::vector<TriangleId>& triangles, const ErrorPower& power, const Monitor& monitor)
{
  this->MeasureEach(triangles, monitor, [&](TriangleId triangle) { return this->Measure(triangle, power); });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MeasureAll(const ErrorPower& power, const Monitor& monitor)
{
  this->Measure(this->AllTriangles(), power, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MeasureWithSides(const std::vector<TriangleId>& triangles, const Monitor& monitor)
{
  this->MeasureEach(triangles, monitor, [this](TriangleId triangle) { return this->MeasureWithSides(triangle); });
}

//----------------------------------------------------------------------------------------------------------------------
void HeightMesh::MeasureAllWithSides(const Monitor& monitor)
{
  this->MeasureWithSides(this->AllTriangles(), monitor);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TriangleId> HeightMesh::AllTriangles() const
{
  std::vector<TriangleId> all(std::size_t(this->Mesh.Size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

//----------------------------------------------------------------------------------------------------------------------
HeightError HeightMesh::MeasureWithSides(TriangleId triangle) const
{
  HeightError error = this->Measure(triangle);
  for (int side = 0; side < 3; ++side)
  {
    if (this->Mesh.Neighbour(triangle, side) != NoTriangle)
    {
      const HeightError ofSide = this->MeasureSide(triangle, side);
      error = ofSide.Largest > error.Largest ? ofSide : error;
    }
  }
  return error;
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::LargestWithSides(TriangleId triangle) const
{
  double largest = this->Measure(triangle).Largest;
  for (int side = 0; side < 3; ++side)
  {
    if (this->Mesh.Neighbour(triangle, side) != NoTriangle)
    {
      largest = std::max(largest, this->MeasureCrossings(triangle, side).Largest);
    }
  }
  return largest;
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::LargestError() const
{
  double largest = 0.0;
  for (const HeightError& error : this->Errors)
  {
    largest = std::max(largest, error.Largest);
  }
  return largest;
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::HeightRange() const
{
  const std::vector<double>& heights = this->Horizon.Height;
  const auto ends = std::minmax_element(heights.begin(), heights.end());
  const double range = heights.empty() ? 0.0 : *ends.second - *ends.first;
  return range > 0.0 ? range : 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
double HeightMesh::SumOfErrors() const
{
  std::vector<double> sums(std::size_t(this->Mesh.Size()), 0.0);
  this->ForEachTriangle(Monitor(),
    [&](TriangleId triangle)
    {
      this->RasterOf(triangle).ForEachColumn(this->RaisedCorners(triangle),
        [&](PointId, double error, const std::array<double, 3>&) { sums[std::size_t(triangle)] += std::abs(error); });
    });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}
}
