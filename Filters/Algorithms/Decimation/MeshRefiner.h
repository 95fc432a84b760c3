// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inserts points into a mesh where it is far from the horizon, in rounds (see Decimation.h).

#ifndef SeismicHorizonsMeshRefiner_h
#define SeismicHorizonsMeshRefiner_h

#include "Common/Monitor.h"
#include "Common/Types.h"
#include "Decimation.h"
#include "HeightMesh.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
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
  /// Inserts points until no triangle has a smaller angle, in degrees, but where sides of the boundary, or those that
  /// stay, leave no other or no column is in the right place. Errors may grow by that.
  void InsertAtSlivers(double smallestAngle);
  /// Inserts all points that are marked, whatever their error, and however many.
  void InsertMarked(const std::vector<unsigned char>& marks);

private:
  bool IsFull() const { return this->MostVertices > 0 && this->Mesh.NumberOfVertices() >= this->MostVertices; }
  void StartWith(double bound);
  void KeepFar(double bound);
  bool FindUrgent(double& limit, std::vector<TriangleId>& urgent) const;
  double UrgencyOf(TriangleId triangle) const;
  bool InsertRound(const std::vector<TriangleId>& triangles);
  void Insert(PointId point, TriangleId triangle);
  void PutBack(VertexId vertex, TriangleId triangle);
  bool IsSliver(TriangleId triangle, double sine) const;
  PlanePoint PlaceBeside(TriangleId sliver, double smallestAngle) const;
  bool CanInsert(const PlanePoint& place, TriangleId triangle) const;
  void AddNew(TriangleId triangle);
  void SortNew();

  HeightMesh& Mesh;
  const std::size_t MostVertices;
  const DecimationPriority Priority;
  ErrorPower Power;
  std::vector<TriangleId> Far; // triangles with an error above the bound
  std::vector<TriangleId> New; // triangles that are still to be measured
  std::vector<unsigned char> IsNew; // by triangle
  std::vector<TriangleId> Around; // the point that was inserted last
};
}

#endif
