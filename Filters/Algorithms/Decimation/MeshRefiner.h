// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts points into a mesh where its error is large, in rounds (see Decimation.h).

#ifndef SeismicHorizonsMeshRefiner_h
#define SeismicHorizonsMeshRefiner_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Decimation.h"
#include "EdgeSizes.h"
#include "HeightMesh.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
class MeshRefiner
{
public:
  /// The mesh must be constrained Delaunay and remains so. A limit of 0 vertices means none.
  MeshRefiner(HeightMesh& mesh, std::size_t mostVertices, DecimationPriority priority);
  /// Without a limit. Only these triangles and those that change are examined; the others must be within the errors.
  MeshRefiner(HeightMesh& mesh, std::vector<TriangleId> examined);

  void InsertWhereFar(double error, const Monitor& monitor);
  /// Continues, in a mesh within the error, where inner edges cross grid lines farther away than the second one, unless
  /// it is infinite.
  void InsertAtEdges(double error, double crossingError, const Monitor& monitor);
  /// Angles, in degrees, remain smaller where fixed edges force them or no column is suitable. Errors may grow.
  /// With sizes, edges may not be longer either.
  void InsertAtSlivers(double smallestAngle, const EdgeSizes* sizes = nullptr);
  /// Ignores errors; the refiner must have no limit of vertices.
  void InsertMarked(const std::vector<unsigned char>& marks);

  /// The triangles given, and all that have changed since.
  const std::vector<TriangleId>& Examined();

  /// With a limit: of triangles where points were inserted, as they were before.
  const std::vector<double>& ErrorsBefore() const { return this->Before; }

private:
  bool IsFull() const { return this->MostVertices > 0 && this->Mesh.NumberOfVertices() >= this->MostVertices; }
  void StartWith(double bound);
  void KeepFar(double bound);
  bool FindUrgent(double& limit, std::vector<TriangleId>& urgent) const;
  double UrgencyOf(TriangleId triangle) const;
  bool InsertRound(const std::vector<TriangleId>& triangles, bool arePointsInside);
  void Insert(PointId point, TriangleId triangle, const PlaneMesh::Room& room);
  void PutBack(VertexId vertex, TriangleId triangle);
  PlanePoint PlaceBeside(TriangleId sliver, double smallestAngle, double part) const;
  bool IsTooLong(TriangleId triangle, const EdgeSizes& sizes) const;
  bool CanInsert(const PlanePoint& place, TriangleId triangle, double leastCosine) const;
  void AddNew(TriangleId triangle);
  void SeeNew();
  void SortNew();

  HeightMesh& Mesh;
  const std::size_t MostVertices;
  const DecimationPriority Priority;
  ErrorSquares Squares;
  bool AreAllExamined = true;
  std::vector<TriangleId> Seen; // examined, several times if changed again
  std::vector<TriangleId> Far; // triangles above the bound
  std::vector<TriangleId> New;
  std::vector<unsigned char> IsNew;
  std::vector<TriangleId> Around;
  std::vector<double> Before;
};
}

#endif
