// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Measures a finished mesh against the points of a horizon, triangle by triangle, and finds the vertex that represents
// each point.

#ifndef SeismicHorizonsMeshFit_h
#define SeismicHorizonsMeshFit_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "HeightRaster.h"
#include "PlaneMesh.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
/// A column counts in sums for one triangle: on an edge for the lower number, at a vertex for none.
bool OwnsColumn(const PlaneMesh& mesh, TriangleId triangle, const std::array<double, 3>& weights);

class MeshFit
{
public:
  /// Returns the raster of the points around a triangle.
  using RasterOf = std::function<const HeightRaster&(TriangleId)>;
  /// Takes each point in a triangle, but for vertices, once, from several threads.
  using Assign = std::function<void(PointId, VertexId)>;

  /// Both must outlive this.
  MeshFit(const PlaneMesh& mesh, const std::vector<RaisedPoint>& vertices);

  /// Triangles from the first to before the last, each once.
  void Measure(
    TriangleId first, TriangleId last, const RasterOf& rasterOf, const Assign& assign, const Monitor& monitor);

  /// By triangle: of columns, and of edges where they count for LargestOfLoops.
  std::vector<double> Errors;
  double Largest = 0.0; // of columns
  double LargestOfEdges = 0.0; // inner ones, where they cross links between points
  double LargestOfLoops = 0.0; // and of inner edges where they cross links to dropped points
  /// Of columns in triangles, but for vertices, and of dropped ones on loops.
  double Sum = 0.0;
  std::size_t Columns = 0;

private:
  struct Part
  {
    double Largest = 0.0;
    double Sum = 0.0;
    std::size_t Columns = 0;
    CrossingErrors Crossings;
  };

  RaisedTriangle Corners(TriangleId triangle) const;
  void AddColumns(TriangleId triangle, const HeightRaster& raster, const Assign& assign, Part& part) const;
  void AddDropped(TriangleId triangle, const HeightRaster& raster, Part& part) const;
  void AddEdges(TriangleId triangle, const HeightRaster& raster, Part& part) const;

  const PlaneMesh& Mesh;
  const std::vector<RaisedPoint>& Vertices;
};
}

#endif
