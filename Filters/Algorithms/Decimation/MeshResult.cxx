// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshResult.h"

#include "Common/Types.h"
#include "Selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
class Collector
{
public:
  explicit Collector(const HeightMesh& mesh)
    : Surface(mesh)
    , Mesh(mesh.Triangles())
  {
  }

  Decimation Run(const Monitor& monitor)
  {
    this->WritePoints();
    this->WriteTriangles();
    this->AssignPoints(monitor);
    this->CheckAllAssigned();
    this->MeasureSides();
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
      const std::int32_t size = this->Surface.SubVoxelsPerColumn();
      points.Plane.push_back({ place.Column.X * size, place.Column.Y * size });
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
    }
  }

  /// Measures every triangle, and gives each dropped point to a vertex.
  void AssignPoints(const Monitor& monitor)
  {
    this->Result.Errors.assign(std::size_t(this->Mesh.Size()), 0.0);
    std::vector<double> sums(this->Result.Errors.size(), 0.0);
    this->Surface.ForEachTriangle(
      monitor, [&](TriangleId triangle) { sums[std::size_t(triangle)] = this->AssignPointsOf(triangle); });
    const double sum = std::accumulate(sums.begin(), sums.end(), 0.0);
    this->Result.MeanError = this->Surface.NumberOfPoints() == 0 ? 0.0 : sum / double(this->Surface.NumberOfPoints());
    const auto largest = std::max_element(this->Result.Errors.begin(), this->Result.Errors.end());
    this->Result.LargestError = this->Result.Errors.empty() ? 0.0 : *largest;
  }

  /// The sum of the errors of the points that are given to its corners.
  double AssignPointsOf(TriangleId triangle)
  {
    double sum = 0.0;
    double& largest = this->Result.Errors[std::size_t(triangle)];
    this->Surface.RasterOf(triangle).ForEachColumn(this->Surface.RaisedCorners(triangle),
      [&](PointId point, double error, const std::array<double, 3>& weights)
      {
        largest = std::max(largest, std::abs(error));
        if (this->Owns(triangle, weights))
        {
          sum += std::abs(error);
        }
        if (!this->Surface.IsVertex(point) && this->Owns(triangle, weights))
        {
          const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
          this->Result.Points.Target[std::size_t(point)] = this->Result.Triangles[std::size_t(3 * triangle + nearest)];
        }
      });
    return sum;
  }

  /// Of two triangles the first one owns the columns on their common side, which is opposite to a corner without
  /// weight.
  bool Owns(TriangleId triangle, const std::array<double, 3>& weights) const
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const TriangleId beyond = this->Mesh.Neighbour(triangle, NextCorner(corner));
      if (weights[std::size_t(corner)] == 0.0 && beyond != NoTriangle && beyond < triangle)
      {
        return false;
      }
    }
    return true;
  }

  void CheckAllAssigned() const
  {
    const std::vector<PointId>& target = this->Result.Points.Target;
    for (PointId point = 0; std::size_t(point) < target.size(); ++point)
    {
      if (target[std::size_t(point)] == NoPoint && this->Surface.HasPoint(point))
      {
        throw InputError("point " + std::to_string(point) +
          " lies outside the boundary of its patch, expected loops around all points");
      }
    }
  }

  void MeasureSides()
  {
    for (TriangleId triangle = 0; triangle < this->Mesh.Size(); ++triangle)
    {
      for (int side = 0; side < 3; ++side)
      {
        const TriangleId beyond = this->Mesh.Neighbour(triangle, side);
        if (beyond == NoTriangle || beyond > triangle) // each side once
        {
          double& largest = beyond == NoTriangle ? this->Result.LargestLoopError : this->Result.LargestSideError;
          largest = std::max(largest, this->Surface.MeasureCrossings(triangle, side).Largest);
        }
      }
    }
  }

  const HeightMesh& Surface;
  const PlaneMesh& Mesh;
  Decimation Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
Decimation MakeResult(const HeightMesh& mesh, const Monitor& monitor)
{
  return Collector(mesh).Run(monitor);
}
}
