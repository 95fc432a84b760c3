// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes vertices inside a mesh by collapsing a side each, the cheapest first.

#ifndef SeismicHorizonsVertexRemoval_h
#define SeismicHorizonsVertexRemoval_h

#include "Common/Monitor.h"
#include "HeightMesh.h"
#include "MeshCost.h"

#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
class VertexRemoval
{
public:
  /// Keeps references.
  VertexRemoval(HeightMesh& mesh, const MeshCost& cost)
    : Mesh(mesh)
    , Cost(cost)
  {
  }

  /// Removes vertices until none can go for the cost's error and angle, or so many are left.
  void Run(std::size_t leastVertices, const Monitor& monitor);

private:
  struct Candidate
  {
    PointId Point = NoPoint;
    std::size_t Side = 0; // of the ring of the point, the side that is collapsed
    double Cost = 0.0; // by how much the sum becomes larger
    bool IsPossible = false;
  };

  void FindTriangles();
  void FindCandidates(const std::vector<PointId>& points, const Monitor& monitor);
  Candidate Try(PointId point, std::vector<TriangleId>& ring) const;
  bool TrySide(const std::vector<TriangleId>& ring, const std::vector<PointId>& points, std::size_t side, double most,
    double largest, double& sum) const;
  std::vector<PointId> RemoveCheapest(std::size_t leastVertices);

  HeightMesh& Mesh;
  const MeshCost& Cost;
  std::vector<TriangleId> TriangleAt; // by point: one of its triangles
  std::vector<Candidate> Candidates; // by point
  std::vector<unsigned char> IsChanged; // by triangle, in one round
};
}

#endif
