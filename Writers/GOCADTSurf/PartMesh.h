// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPartMesh_h
#define SeismicHorizonsPartMesh_h

#include "Common/Survey/TSurf.h"

#include <array>
#include <cstddef>
#include <vector>

namespace SeismicHorizons
{
/// The vertices and triangles of a TSurf as a file lists them, part after part. Vertices are those of triangles only,
/// by ascending number within a part. One that several parts have in common is listed in each of them: from the second
/// time on it stands at the place of the first.
struct PartMesh
{
  struct Part
  {
    std::size_t LastVertex, LastTriangle; // one behind its last; it begins where the part before it ends
  };

  std::vector<PointId> Sources; // of each vertex the vertex of the TSurf
  std::vector<PointId> Places; // of each vertex the one before it at whose place it stands, or NoPoint
  std::vector<TSurf::Triangle> Triangles;
  std::vector<Part> Parts;
};

/// Linear but for the sorting of the numbers of the parts.
PartMesh MakePartMesh(const TSurf& surface);

/// The sections of the border: one for each loop of the sides that belong to one triangle alone, as its first two
/// vertices. It runs against the triangles beside it, as it does in files of others: seen from where they are
/// counter-clockwise, the surface lies to its right. Linear but for the sorting of the neighbours of each vertex.
std::vector<std::array<PointId, 2>> FindBorders(
  const std::vector<TSurf::Triangle>& triangles, std::size_t numberOfVertices);
}

#endif
