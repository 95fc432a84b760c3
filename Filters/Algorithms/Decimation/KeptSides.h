// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Forces lines between vertices into the mesh, which remains constrained Delaunay: crossed edges are flipped until the
// line is an edge (Sloan 1993, "A fast algorithm for generating constrained Delaunay triangulations").

#ifndef SeismicHorizonsKeptSides_h
#define SeismicHorizonsKeptSides_h

#include "Common/Horizon/Types.h"
#include "PlaneMesh.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace SeismicHorizons
{
class KeptSides
{
public:
  /// Nothing else may change the mesh meanwhile.
  KeptSides(PlaneMesh& mesh, std::size_t vertices);

  /// Splits the line at vertices on it. Returns false, and keeps the segments so far, if it crosses the boundary or a
  /// kept edge.
  bool Keep(VertexId from, VertexId to);

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
  std::vector<TriangleId> TriangleAt;
  std::deque<Line> Crossed; // edges that remain across the line
};
}

#endif
