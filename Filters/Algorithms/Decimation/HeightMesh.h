// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh over a horizon: its triangles in plan, the heights of its vertices, and how far it is from the horizon.

#ifndef SeismicHorizonsHeightMesh_h
#define SeismicHorizonsHeightMesh_h

#include "Common/BoundedHorizon.h"
#include "Common/Monitor.h"
#include "Common/Parallel.h"
#include "Common/Types.h"
#include "HeightRaster.h"
#include "PlaneMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// The heights of the vertices of a mesh that are on no loop: those that can move; or of some others.
struct InnerHeights
{
  std::vector<VertexId> Vertices; // ascending
  std::vector<double> Heights;

  /// Leaves out the vertices that are marked.
  void Drop(const std::vector<unsigned char>& marks)
  {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < this->Vertices.size(); ++n)
    {
      if (marks[std::size_t(this->Vertices[n])] == 0)
      {
        this->Vertices[kept] = this->Vertices[n];
        this->Heights[kept++] = this->Heights[n];
      }
    }
    this->Vertices.resize(kept);
    this->Heights.resize(kept);
  }
};

/// Vertices are numbered in the order in which they come, those of loops first; SortVertices() numbers them by points.
class HeightMesh
{
public:
  /// Meshes the loops. The places of the horizon are columns. Its heights may be those of others, `heights`, which must
  /// outlive the mesh.
  HeightMesh(BoundedHorizon horizon, const Monitor& monitor, const double* heights = nullptr);

  /// Lays the mesh over another horizon, too, of the same points with other heights. Vertices then have a height of
  /// each, at first that of its column, and errors are the largest ones of all, which are measured without powers. What
  /// has no number of a horizon is about the first one, and so are sums.
  /// A horizon may have some of the points alone, marked as known, which others own: the heights of others are those of
  /// vertices there, and have no errors. The heights must outlive the mesh.
  void AddHorizon(const std::vector<double>& heights, const std::vector<unsigned char>* isKnown = nullptr);
  std::size_t NumberOfHorizons() const { return 1 + this->Others.size(); }

  /// Gives the horizon back; the mesh cannot be used any more.
  BoundedHorizon TakeHorizon();

  /// How many points the horizon has: those with a patch.
  std::size_t NumberOfPoints() const { return this->Points; }
  /// And how many numbers points have.
  std::size_t NumberOfAllPoints() const { return this->Patches.size(); }
  bool HasPoint(PointId point) const { return this->Patches[point] >= 0; }
  const Loops& Boundary() const { return this->Horizon.Boundary; }
  const PlanePoint& Column(PointId point) const { return this->Places[point]; }
  const PlaneMesh& Triangles() const { return this->Mesh; }
  PlaneMesh& Triangles() { return this->Mesh; }

  /// How many points are vertices of the mesh or on loops.
  std::size_t NumberOfVertices() const { return this->Vertices.size() - this->Removed; }
  /// And how many of these are on no loop.
  std::size_t NumberOfInnerVertices() const { return this->NumberOfVertices() - this->OnLoops; }
  bool IsVertex(PointId point) const { return this->Marks[point] != 0; }
  /// Beyond all numbers of vertices; some of those below may have been removed.
  VertexId EndOfVertices() const { return VertexId(this->Vertices.size()); }
  bool IsRemoved(VertexId vertex) const { return this->Sources[vertex] == NoPoint; }
  bool IsOnLoop(VertexId vertex) const { return this->AreOnLoops[vertex] != 0; }
  /// Whether a vertex stays: it is on a loop, or was asked to.
  bool IsFixed(VertexId vertex) const { return this->AreFixed[vertex] != 0; }
  void Fix(VertexId vertex) { this->AreFixed[vertex] = 1; }
  /// The point of a vertex.
  PointId SourceOf(VertexId vertex) const { return this->Sources[vertex]; }
  /// The vertex of each point, or NoVertex.
  std::vector<VertexId> VerticesByPoint() const;
  /// The corner of a triangle that a point is, or NoVertex.
  VertexId CornerOf(TriangleId triangle, PointId point) const;

  /// Inserts a point that lies in a triangle or on its sides as PlaneMesh does, at the height of its column.
  void Insert(PointId point, TriangleId triangle, std::vector<TriangleId>& around);
  /// Once no triangle has it as a corner.
  void Remove(VertexId vertex);
  /// To the height of its column.
  void PutBack(VertexId vertex);
  /// Numbers vertices by points, without those that were removed.
  void SortVertices();
  /// The same, and triangles as PlaneMesh does.
  void SortByPlace();
  void Compact();

  /// Of the mesh: at first that of the column.
  double Height(VertexId vertex) const { return this->Vertices[vertex].Height; }
  /// Of the horizon.
  double ColumnHeight(VertexId vertex) const { return this->RasterAt(vertex).HeightAt(this->Vertices[vertex].Column); }
  /// Those of the vertices that are on no loop.
  InnerHeights Heights(std::size_t horizon = 0) const;
  void SetHeights(const InnerHeights& heights, std::size_t horizon = 0);
  /// The same for each horizon.
  std::vector<InnerHeights> AllHeights() const;
  /// And of some vertices.
  std::vector<InnerHeights> HeightsOf(const std::vector<VertexId>& vertices) const;
  void SetAllHeights(const std::vector<InnerHeights>& heights);
  double Height(std::size_t horizon, VertexId vertex) const { return this->Raised(horizon, vertex).Height; }
  double ColumnHeight(std::size_t horizon, VertexId vertex) const
  {
    return horizon == 0 ? this->ColumnHeight(vertex) : this->Others[horizon - 1].Heights[this->Sources[vertex]];
  }

  const RaisedPoint& Raised(VertexId vertex) const { return this->Vertices[vertex]; }
  RaisedTriangle RaisedCorners(TriangleId triangle) const
  {
    return { this->Raised(this->Mesh.Corner(triangle, 0)), this->Raised(this->Mesh.Corner(triangle, 1)),
      this->Raised(this->Mesh.Corner(triangle, 2)) };
  }
  /// The heights of the patch that a triangle belongs to.
  const HeightRaster& RasterOf(TriangleId triangle) const { return this->RasterAt(this->Mesh.Corner(triangle, 0)); }

  const RaisedPoint& Raised(std::size_t horizon, VertexId vertex) const
  {
    return horizon == 0 ? this->Vertices[vertex] : this->Others[horizon - 1].Vertices[vertex];
  }
  RaisedTriangle RaisedCorners(std::size_t horizon, TriangleId triangle) const
  {
    return { this->Raised(horizon, this->Mesh.Corner(triangle, 0)),
      this->Raised(horizon, this->Mesh.Corner(triangle, 1)), this->Raised(horizon, this->Mesh.Corner(triangle, 2)) };
  }
  const HeightRaster& RasterOf(std::size_t horizon, TriangleId triangle) const
  {
    return this->RasterAt(horizon, this->Mesh.Corner(triangle, 0));
  }
  /// Of the patch that a vertex belongs to.
  const HeightRaster& RasterAt(std::size_t horizon, VertexId vertex) const
  {
    return horizon == 0 ? this->RasterAt(vertex)
                        : this->Others[horizon - 1].Rasters[this->Patches[this->Sources[vertex]]];
  }

  /// Of a side of a triangle, wherever it crosses lines between columns.
  HeightError MeasureCrossings(TriangleId triangle, int side, const ErrorPower& power = ErrorPower()) const
  {
    return this->RasterOf(triangle).MeasureCrossings(this->Raised(this->Mesh.Corner(triangle, side)),
      this->Raised(this->Mesh.Corner(triangle, NextCorner(side))), power);
  }

  /// Measures triangles on threads, and keeps their errors: without a power only those above a bound, else all with
  /// their sums.
  void Measure(const std::vector<TriangleId>& triangles, const ErrorPower& power, double bound, const Monitor& monitor);
  void MeasureAll(const ErrorPower& power, double bound, const Monitor& monitor);
  /// The points of errors that have none yet: those measured with a power.
  void FindPoints(const std::vector<TriangleId>& triangles, double bound);
  /// Measures their inner sides, where they cross lines between columns that are not both vertices: keeps what is above
  /// the bound and above the error so far.
  void MeasureSides(const std::vector<TriangleId>& triangles, double bound, const Monitor& monitor);
  void MeasureAllSides(double bound, const Monitor& monitor);
  /// Gives triangles with a marked point that is no vertex an error of 1 at the one that is farthest inside, others
  /// none.
  void MeasureMarked(const std::vector<TriangleId>& triangles, const std::vector<unsigned char>& marks);
  void MeasureAllMarked(const std::vector<unsigned char>& marks) { this->MeasureMarked(this->AllTriangles(), marks); }
  const HeightError& Error(TriangleId triangle) const { return this->Errors[triangle]; }
  void SetError(TriangleId triangle, const HeightError& error) { this->Errors[triangle] = error; }
  /// Of those that are kept: of all triangles, when all were measured after the last change.
  double LargestError() const;

  /// Calls call(triangle) for all triangles, on threads.
  template <typename Call>
  void ForEachTriangle(const Monitor& monitor, Call&& call) const;

  /// The columns that count for a triangle in sums over all columns: see below.
  SideColumns OwnedColumns(TriangleId triangle) const;
  /// Whether a column in a triangle or on its sides, with these weights of the corners, counts for it in sums over all
  /// columns. Those of vertices count for no triangle, and those on a common side for the first of the two.
  bool Owns(TriangleId triangle, const std::array<double, 3>& weights) const;
  /// Of all columns: the sum of their errors, and that of squares, for which errors are divided by the unit first.
  struct ErrorSums
  {
    double Errors = 0.0;
    double Squares = 0.0;
  };
  ErrorSums SumErrors(double unit) const;
  /// How far rounding may put a triangle from a point.
  double Rounding() const { return this->RoundingError; }
  /// From the lowest point to the highest one, or 1 where all are equally high.
  double HeightRange() const { return this->Range > 0.0 ? this->Range : 1.0; }

private:
  /// The same points in other heights.
  struct OtherHorizon
  {
    std::vector<HeightRaster> Rasters;
    std::vector<RaisedPoint> Vertices;
    const double* Heights; // by point
  };

  const HeightRaster& RasterAt(VertexId vertex) const
  {
    return this->OnlyRaster ? *this->OnlyRaster : this->Rasters[this->Patches[this->Sources[vertex]]];
  }
  void MeshLoops(const Monitor& monitor);
  std::vector<HeightRaster> MakeRasters() const;
  void AddRounding(double lowest, double highest);
  void FindRange();
  std::vector<TriangleId> AllTriangles() const;
  HeightError MeasureOthers(TriangleId triangle, double bound, HeightError error) const;
  HeightError MeasureSides(std::size_t horizon, TriangleId triangle, double bound, bool isEachOnce) const;
  HeightError MeasureSides(TriangleId triangle, double bound, bool isEachOnce) const;
  template <typename Measuring>
  void MeasureEach(const std::vector<TriangleId>& triangles, const Monitor& monitor, Measuring&& measure);

  BoundedHorizon Horizon; // without what is in the members below
  const double* const OwnHeights; // of the first horizon, by point
  const PlanePoints Places; // its columns
  std::vector<std::int32_t> Patches; // by point, without gaps; negative for those that the horizon does not have
  std::size_t Points;
  std::vector<unsigned char> Marks; // by point, 1 for vertices and points of loops
  std::vector<PointId> Sources; // by vertex: its point; NoPoint for those that were removed
  std::vector<unsigned char> AreOnLoops; // by vertex
  std::vector<unsigned char> AreFixed; // by vertex
  std::vector<RaisedPoint> Vertices; // columns with the heights of the mesh
  std::vector<OtherHorizon> Others; // all but the first one
  std::size_t OnLoops = 0; // vertices
  std::size_t Removed = 0; // vertices
  PlaneMesh Mesh;
  std::vector<HeightRaster> Rasters; // by patch
  const HeightRaster* OnlyRaster; // of a single patch, else null
  double Range = 0.0;
  double RoundingError = 0.0;
  std::vector<HeightError> Errors; // by triangle
};

//----------------------------------------------------------------------------------------------------------------------
template <typename Call>
void HeightMesh::ForEachTriangle(const Monitor& monitor, Call&& call) const
{
  constexpr std::int64_t Grain = 128; // triangles a thread looks at at a time
  ParallelFor(this->Mesh.Size(), Grain, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      for (TriangleId triangle = TriangleId(first); triangle < TriangleId(last); ++triangle)
      {
        call(triangle);
      }
    });
}
}

#endif
