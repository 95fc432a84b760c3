// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes lines between vertices of a mesh sides that stay: the mesh remains constrained Delaunay, with these among the
// constraints. Sides in the way of a line are flipped until it is one itself (Sloan 1993, "A fast algorithm for
// generating constrained Delaunay triangulations").

#ifndef SeismicHorizonsKeptSides_h
#define SeismicHorizonsKeptSides_h

#include "Common/Types.h"
#include "PlaneMesh.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace SeismicHorizons
{
class KeptSides
{
public:
  /// Keeps a reference to the mesh, which is changed by nobody else meanwhile, and has so many vertices.
  KeptSides(PlaneMesh& mesh, std::size_t vertices);

  /// Keeps the line between two vertices, piece by piece where it runs through others. False when the boundary or a
  /// side that is kept already crosses it: pieces before the one that is crossed are kept, the others not.
  bool Keep(VertexId from, VertexId to);

  /// Flips other sides until all are Delaunay again.
  void Legalize();

private:
  struct Line
  {
    VertexId From;
    VertexId To;
  };

  struct Side
  {
    TriangleId Triangle = NoTriangle;
    int Number = 0;
  };

  bool FindStart(VertexId from, VertexId to, Side& crossed, VertexId& next) const;
  bool FindCrossed(VertexId from, VertexId to, Side first, VertexId& end);
  void FlipCrossed(VertexId from, VertexId end);
  Side FindSide(VertexId a, VertexId b) const;
  bool IsConvex(const Side& side) const;
  void Flip(const Side& side);
  template <typename Visitor>
  bool AnyAround(VertexId vertex, Visitor&& visit) const;
  template <typename Visitor>
  bool AnyBeside(VertexId vertex, Visitor&& visit) const;

  PlaneMesh& Mesh;
  std::vector<TriangleId> TriangleAt; // by vertex: one of its triangles
  std::deque<Line> Crossed; // the sides across the line, or those that are left of them
};
}

#endif
