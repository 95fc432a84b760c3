// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshFit.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
// A zero weight means the opposite edge, two mean the third corner.
bool OwnsColumn(const PlaneMesh& mesh, TriangleId triangle, const std::array<double, 3>& weights)
{
  if (std::count(weights.begin(), weights.end(), 0.0) > 1)
  {
    return false;
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    const TriangleId beyond = mesh.Neighbour(triangle, NextCorner(corner));
    if (weights[corner] == 0.0 && beyond != NoTriangle && beyond < triangle)
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
MeshFit::MeshFit(const PlaneMesh& mesh, const std::vector<RaisedPoint>& vertices)
  : Errors(std::size_t(mesh.Size()), 0.0)
  , Mesh(mesh)
  , Vertices(vertices)
{
}

//----------------------------------------------------------------------------------------------------------------------
void MeshFit::Measure(
  TriangleId first, TriangleId last, const RasterOf& rasterOf, const Assign& assign, const Monitor& monitor)
{
  constexpr std::int64_t trianglesPerTask = 128;
  std::vector<Part> parts(std::size_t(last - first));
  ParallelFor(std::int64_t(parts.size()), trianglesPerTask, monitor,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        const TriangleId triangle = first + TriangleId(n);
        const HeightRaster& raster = rasterOf(triangle);
        this->AddColumns(triangle, raster, assign, parts[std::size_t(n)]);
        this->AddDropped(triangle, raster, parts[std::size_t(n)]);
        this->AddEdges(triangle, raster, parts[std::size_t(n)]);
      }
    });
  for (std::size_t n = 0; n < parts.size(); ++n)
  {
    const Part& part = parts[n];
    this->Errors[std::size_t(first) + n] = std::max(part.Largest, part.Crossings.BesideLoops);
    this->Largest = std::max(this->Largest, part.Largest);
    this->LargestOfEdges = std::max(this->LargestOfEdges, part.Crossings.Inside);
    this->LargestOfLoops = std::max(this->LargestOfLoops, part.Crossings.BesideLoops);
    this->Sum += part.Sum;
    this->Columns += part.Columns;
  }
}

//----------------------------------------------------------------------------------------------------------------------
RaisedTriangle MeshFit::Corners(TriangleId triangle) const
{
  const auto& [a, b, c] = this->Mesh.Corners(triangle);
  return { this->Vertices[a], this->Vertices[b], this->Vertices[c] };
}

//----------------------------------------------------------------------------------------------------------------------
void MeshFit::AddColumns(TriangleId triangle, const HeightRaster& raster, const Assign& assign, Part& part) const
{
  raster.ForEachColumn(this->Corners(triangle),
    [&](PointId point, double error, const std::array<double, 3>& weights)
    {
      part.Largest = std::max(part.Largest, std::abs(error));
      if (OwnsColumn(this->Mesh, triangle, weights))
      {
        part.Sum += std::abs(error);
        ++part.Columns;
        const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
        assign(point, this->Mesh.Corner(triangle, int(nearest)));
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
// Dropped points on edges of loops are covered, too.
void MeshFit::AddDropped(TriangleId triangle, const HeightRaster& raster, Part& part) const
{
  for (int edge = 0; edge < 3; ++edge)
  {
    if (this->Mesh.Neighbour(triangle, edge) != NoTriangle)
    {
      continue;
    }
    const RaisedPoint& from = this->Vertices[this->Mesh.Corner(triangle, edge)];
    const RaisedPoint& to = this->Vertices[this->Mesh.Corner(triangle, NextCorner(edge))];
    ForEachColumnBetween(from.Column, to.Column,
      [&](const PlanePoint& column, double fraction)
      {
        const double own = raster.DroppedHeight(column);
        if (!std::isnan(own))
        {
          const double error = std::abs(from.Height + fraction * (to.Height - from.Height) - own);
          part.Largest = std::max(part.Largest, error);
          part.Sum += error;
          ++part.Columns;
        }
      });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void MeshFit::AddEdges(TriangleId triangle, const HeightRaster& raster, Part& part) const
{
  for (int edge = 0; edge < 3; ++edge)
  {
    const bool isOnLoop = this->Mesh.Neighbour(triangle, edge) == NoTriangle;
    const CrossingErrors own = raster.MeasureCrossings(
      this->Vertices[this->Mesh.Corner(triangle, edge)], this->Vertices[this->Mesh.Corner(triangle, NextCorner(edge))]);
    CrossingErrors& all = part.Crossings;
    all.Inside = isOnLoop ? all.Inside : std::max(all.Inside, own.Inside);
    all.BesideLoops = std::max({ all.BesideLoops, own.BesideLoops, isOnLoop ? own.Inside : 0.0 });
  }
}
}
