// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Combines a mesh in plan with heights of its vertices, and measures its distance from the horizon.

#ifndef SeismicHorizonsHeightMesh_h
#define SeismicHorizonsHeightMesh_h

#include "Common/Base/Monitor.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Types.h"
#include "HeightRaster.h"
#include "LoopChange.h"
#include "PlaneMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Usually these are all vertices on no loop.
struct InnerHeights
{
  std::vector<VertexId> Vertices; // ascending
  std::vector<double> Heights;

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

/// Vertices are numbered by insertion, loops first unless they changed, until SortVertices() orders them by point.
class HeightMesh
{
public:
  /// Triangulates the loops. `heights`, if given, replace the horizon's and must outlive the mesh.
  HeightMesh(BoundedHorizon horizon, const Monitor& monitor, const double* heights = nullptr);

  /// Adds other heights of the same points, which must outlive the mesh. Errors become maxima over all horizons; sums,
  /// and functions without a horizon number, use the first. Points not marked in isKnown have no errors.
  void AddHorizon(const std::vector<double>& heights, const std::vector<unsigned char>* isKnown = nullptr);
  std::size_t NumberOfHorizons() const { return this->Horizons.size(); }

  /// Invalidates the mesh.
  BoundedHorizon TakeHorizon();

  /// Moves the loops, and drops or puts back points beside them. Triangles away from the changes stay, errors of all are
  /// forgotten. Returns the triangles to examine again: new ones, and those within a column of moved points or of
  /// `others`; nothing if the mesh could not be changed, which then has the loops alone. There must be one horizon, and
  /// no kept edges or fixed vertices inside.
  std::optional<std::vector<TriangleId>> ChangeLoops(
    Loops boundary, DroppedPoints dropped, const std::vector<PointId>& others = {});
  const std::vector<double>& HeightsOfPoints() const { return this->Horizon.Height; }

  std::size_t NumberOfPoints() const { return this->Points; }
  /// Includes points without a patch.
  std::size_t NumberOfAllPoints() const { return this->Patches.size(); }
  bool HasPoint(PointId point) const { return this->Patches[point] >= 0; }
  const Loops& Boundary() const { return this->Horizon.Boundary; }
  const LinkCuts* Cuts() const { return this->Horizon.Cuts.get(); }
  const PlanePoint& Column(PointId point) const { return this->Places[point]; }
  const PlaneMesh& Triangles() const { return this->Mesh; }
  PlaneMesh& Triangles() { return this->Mesh; }

  std::size_t NumberOfVertices() const { return this->Sources.size() - this->Removed; }
  std::size_t NumberOfInnerVertices() const { return this->NumberOfVertices() - this->OnLoops; }
  bool IsVertex(PointId point) const { return this->Marks[point] != 0; }
  /// All vertices are below, including removed vertices.
  VertexId EndOfVertices() const { return VertexId(this->Sources.size()); }
  bool IsRemoved(VertexId vertex) const { return this->Sources[vertex] == NoPoint; }
  bool IsOnLoop(VertexId vertex) const { return this->AreOnLoops[vertex] != 0; }
  /// Vertices on loops, and vertices passed to Fix(), are never removed.
  bool IsFixed(VertexId vertex) const { return this->AreFixed[vertex] != 0; }
  void Fix(VertexId vertex) { this->AreFixed[vertex] = 1; }
  std::size_t NumberOfPatches() const { return this->Horizons.front().Rasters.size(); }
  std::int32_t PatchOf(VertexId vertex) const { return this->Patches[this->Sources[vertex]]; }
  PointId SourceOf(VertexId vertex) const { return this->Sources[vertex]; }
  std::vector<VertexId> VerticesByPoint() const;
  /// Returns vertices on no loop, ascending.
  std::vector<VertexId> InnerVertices() const;
  /// Returns NoVertex if the point is no corner.
  VertexId CornerOf(TriangleId triangle, PointId point) const;

  /// A Delaunay mesh remains one. The point must lie in the triangle or on its edges. Room must be added before, and
  /// closed afterwards unless all is used (PlaneMesh). Points that change other triangles can be inserted at the same
  /// time, unless there are kept edges.
  void Insert(PointId point, TriangleId triangle, const PlaneMesh::Room& room, std::vector<TriangleId>& around);
  PlaneMesh::Room AddRoom(std::size_t vertices);
  void CloseGaps(
    const PlaneMesh::Room& first, std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged);
  /// Resets a vertex to the height of its column, or to its locked height.
  void PutBack(VertexId vertex);
  /// Gives vertices other points, NoPoint to remove them, other heights by horizon, and other triangles. Kept edges
  /// remain.
  void Replace(std::vector<PointId> sources, const std::vector<std::vector<double>>& heights,
    const RawVector<VertexId>& triangles);
  /// Drops removed vertices.
  void SortVertices();
  void SortByPlace();

  std::vector<InnerHeights> HeightsOf(const std::vector<VertexId>& vertices) const;
  void SetAllHeights(const std::vector<InnerHeights>& heights);
  /// Height() is on the mesh, ColumnHeight() on the horizon.
  double Height(std::size_t horizon, VertexId vertex) const { return this->Raised(horizon, vertex).Height; }
  double Height(VertexId vertex) const { return this->Height(0, vertex); }
  double ColumnHeight(std::size_t horizon, VertexId vertex) const
  {
    return this->Horizons[horizon].Heights[this->Sources[vertex]];
  }
  double ColumnHeight(VertexId vertex) const { return this->ColumnHeight(0, vertex); }

  const RaisedPoint& Raised(std::size_t horizon, VertexId vertex) const
  {
    return this->Horizons[horizon].Vertices[vertex];
  }
  const RaisedPoint& Raised(VertexId vertex) const { return this->Raised(0, vertex); }
  const std::vector<RaisedPoint>& RaisedVertices() const { return this->Horizons.front().Vertices; }
  RaisedTriangle RaisedCorners(std::size_t horizon, TriangleId triangle) const
  {
    return { this->Raised(horizon, this->Mesh.Corner(triangle, 0)),
      this->Raised(horizon, this->Mesh.Corner(triangle, 1)), this->Raised(horizon, this->Mesh.Corner(triangle, 2)) };
  }
  RaisedTriangle RaisedCorners(TriangleId triangle) const { return this->RaisedCorners(0, triangle); }
  const HeightRaster& RasterOfPatch(std::size_t patch) const { return this->Horizons.front().Rasters[patch]; }
  const HeightRaster& RasterAt(std::size_t horizon, VertexId vertex) const
  {
    const std::vector<HeightRaster>& rasters = this->Horizons[horizon].Rasters;
    return rasters[rasters.size() == 1 ? 0 : this->Patches[this->Sources[vertex]]];
  }
  const HeightRaster& RasterOf(std::size_t horizon, TriangleId triangle) const
  {
    return this->RasterAt(horizon, this->Mesh.Corner(triangle, 0));
  }
  const HeightRaster& RasterOf(TriangleId triangle) const { return this->RasterOf(0, triangle); }

  /// Stores errors: only above the bound, unless squares are summed.
  void Measure(
    const std::vector<TriangleId>& triangles, const ErrorSquares& squares, double bound, const Monitor& monitor);
  /// Finds points of errors that were measured with sums.
  void FindPoints(const std::vector<TriangleId>& triangles, double bound);
  /// Raises stored errors to the errors of inner edges at grid lines, unless both columns there are vertices. With
  /// isEachOnce, an edge counts for one of its triangles.
  void MeasureEdges(const std::vector<TriangleId>& triangles, double bound, bool isEachOnce, const Monitor& monitor);
  /// Sets an error of 1 where a marked point is no vertex, at the point farthest inside, else 0.
  void MeasureMarked(const std::vector<TriangleId>& triangles, const std::vector<unsigned char>& marks);
  std::vector<TriangleId> AllTriangles() const;
  const HeightError& Error(TriangleId triangle) const { return this->Errors[triangle]; }
  void SetError(TriangleId triangle, const HeightError& error) { this->Errors[triangle] = error; }
  /// All triangles must have been measured after the last change.
  double LargestError() const;

  template <typename Call>
  void ForEachTriangle(const Monitor& monitor, Call&& call) const;

  EdgeColumns OwnedColumns(TriangleId triangle) const;
  /// Bounds the rounding of heights in a triangle.
  double Rounding() const { return this->RoundingError; }
  /// Returns 1 for a level horizon.
  double HeightRange() const;

private:
  struct RaisedHorizon
  {
    std::vector<HeightRaster> Rasters; // by patch
    std::vector<RaisedPoint> Vertices;
    const double* Heights; // by point
  };

  enum class State : unsigned char
  {
    OnLoop,
    Dropped
  };
  using PointState = std::pair<PointId, State>;

  void SetLoops(const Monitor& monitor);
  std::vector<PointState> PointStates() const;
  std::vector<TriangleId> Exchange(const LoopChange& change);
  void AddVertices(std::size_t vertices);
  void SetVertex(VertexId vertex, PointId point);
  std::vector<TriangleId> FindBeside(const std::vector<PointId>& points) const;
  double HeightOfVertex(const double* heights, PointId point) const;
  std::vector<RaisedPoint> RaisedSources(const double* heights) const;
  std::vector<HeightRaster> MakeRasters(const double* heights) const;
  std::vector<std::vector<PointId>> DroppedByPatch(std::size_t patches) const;
  void AllowRounding(const std::vector<HeightRaster>& rasters);
  void Add(std::vector<HeightRaster> rasters, const double* heights);
  HeightError EdgesError(TriangleId triangle, double bound, bool isEachOnce) const;
  template <typename Measuring>
  void MeasureEach(const std::vector<TriangleId>& triangles, const Monitor& monitor, Measuring&& measure);

  BoundedHorizon Horizon; // Patch has moved into Patches
  PlanePoints Places;
  std::int32_t PatchCount = 0;
  std::vector<std::int32_t> Patches; // per point, contiguous from 0; negative outside the horizon
  std::size_t Points;
  std::vector<unsigned char> Marks; // per point: 1 for vertices, points on loops and points of other parts
  std::vector<PointId> Sources; // per vertex; NoPoint if removed
  std::vector<unsigned char> AreOnLoops;
  std::vector<unsigned char> AreFixed;
  std::vector<RaisedHorizon> Horizons;
  std::size_t OnLoops = 0;
  std::size_t Removed = 0;
  PlaneMesh Mesh;
  double RoundingError = 0.0;
  std::vector<HeightError> Errors; // per triangle
};

//----------------------------------------------------------------------------------------------------------------------
template <typename Call>
void HeightMesh::ForEachTriangle(const Monitor& monitor, Call&& call) const
{
  constexpr std::int64_t trianglesPerTask = 128;
  ParallelFor(this->Mesh.Size(), trianglesPerTask, monitor,
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
