// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh of the loops, into which points are inserted where it is farthest from the horizon (Decimation.h says how).

#ifndef SeismicHorizonsMeshRefiner_h
#define SeismicHorizonsMeshRefiner_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Decimation.h"
#include "DelaunayMesh.h"
#include "HeightRaster.h"

#include <memory>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
class MeshRefiner
{
public:
  /// Meshes the loops. `columns` are those of all points. Keeps references.
  MeshRefiner(const BoundedHorizon& horizon, const std::vector<PlanePoint>& columns, const DecimationOptions& options,
    const Monitor& monitor);

  /// Inserts points until no column is farther from the mesh than `error`, or there are as many as there may be.
  void InsertWhereFar(double error, const Monitor& monitor);
  /// Then the same where inner sides of the mesh cross lines between columns.
  void InsertAtSides(double error, const Monitor& monitor);
  /// The largest error of a triangle when it was made.
  double FindLargest() const;
  /// The sum of the errors of all points with the heights as they are; points on sides count twice.
  double SumOfErrors() const;

  const DelaunayMesh& Mesh() const { return this->Triangles; }
  /// By point, for vertices of the mesh those of the mesh: at first those of their columns.
  const std::vector<double>& Heights() const { return this->VertexHeights; }
  void SetHeights(std::vector<double> heights) { this->VertexHeights = std::move(heights); }
  /// By point, 1 for the vertices of the mesh and all points of loops.
  const std::vector<unsigned char>& VertexMarks() const { return this->IsVertex; }
  /// The heights of the patch that a triangle belongs to.
  const HeightRaster& RasterOf(TriangleId triangle) const
  {
    return *this->Rasters[std::size_t(this->Horizon.Patch[std::size_t(this->Triangles.Corner(triangle, 0))])];
  }
  RaisedTriangle Raised(TriangleId triangle) const
  {
    return { this->Raised(triangle, 0), this->Raised(triangle, 1), this->Raised(triangle, 2) };
  }
  /// Of a side of a triangle, where it crosses lines between columns that are not both vertices.
  HeightError MeasureSide(TriangleId triangle, int side) const
  {
    return this->RasterOf(triangle).MeasureSide(
      this->Raised(triangle, side), this->Raised(triangle, NextCorner(side)), this->IsVertex);
  }

private:
  RaisedPoint Raised(TriangleId triangle, int corner) const
  {
    const std::size_t point = std::size_t(this->Triangles.Corner(triangle, corner));
    return { this->Columns[point], this->VertexHeights[point] };
  }
  bool IsFull() const
  {
    return this->Options.MaximumNumberOfPoints > 0 && this->Vertices >= this->Options.MaximumNumberOfPoints;
  }

  void CheckNumberOfPoints() const;
  void MakeRasters();
  bool InsertRound(const std::vector<TriangleId>& triangles);
  void Insert(PointId point, TriangleId triangle);
  void AddNew(TriangleId triangle);
  void AddAllAsNew();
  template <typename Measure>
  void MeasureNew(const Monitor& monitor, Measure&& measure);
  HeightError MeasureAll(TriangleId triangle) const;
  std::vector<TriangleId> FindAbove(double limit) const;

  const BoundedHorizon& Horizon;
  const std::vector<PlanePoint>& Columns;
  const DecimationOptions& Options;
  std::vector<unsigned char> IsVertex; // by point
  std::size_t Vertices;
  DelaunayMesh Triangles;
  std::vector<std::unique_ptr<HeightRaster>> Rasters; // by patch; null for numbers without points
  std::vector<double> VertexHeights; // by point
  double Rounding; // how far rounding may put a triangle from a point
  std::vector<HeightError> Errors; // by triangle
  std::vector<TriangleId> New; // triangles that are still to be measured
  std::vector<unsigned char> IsNew; // by triangle
};
}

#endif
