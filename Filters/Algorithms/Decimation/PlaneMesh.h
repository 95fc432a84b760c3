// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A triangulation in plan that is edited step by step. Boundary edges stay until Exchange, and so do edges kept on
// request (KeptEdges); inserting a vertex on a kept edge leaves two of them.
//
// Insert makes a point the third corner of three triangles, Flip exchanges a diagonal, and Collapse moves a point to
// the other end of an edge, which removes two triangles.
//
//        c               c            c---e      c---e         e---d         e---d
//       / \             /|\           |\  |      |  /|        / \ / \       /   / \ .
//      / p \     ->    / p \          | \ |  ->  | / |       f---p---c ->  f   /   c
//     /     \         / / \ \         |  \|      |/  |        \ / \ /       \  /  / .
//    a-------b       a-------b        a---b      a---b         a---b         a---b

#ifndef SeismicHorizonsPlaneMesh_h
#define SeismicHorizonsPlaneMesh_h

#include "Common/Base/RawVector.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_set>
#include <vector>

namespace SeismicHorizons
{
using TriangleId = std::int32_t;
using VertexId = std::int32_t;

constexpr TriangleId NoTriangle = -1;
constexpr VertexId NoVertex = -1;

/// Edges have the number of the corner they start at, so the edge opposite to a corner has the next number.
constexpr int NextCorner(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}
constexpr int PreviousCorner(int corner)
{
  return corner == 0 ? 2 : corner - 1;
}

class PlaneMesh
{
public:
  PlaneMesh() = default;

  /// Triangles are counter-clockwise and share whole edges.
  PlaneMesh(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles);

  TriangleId Size() const { return TriangleId(this->Triangles.size()); }
  VertexId Corner(TriangleId triangle, int corner) const { return this->Triangles[triangle].Corners[corner]; }
  const std::array<VertexId, 3>& Corners(TriangleId triangle) const { return this->Triangles[triangle].Corners; }
  /// Returns the sine of the smallest angle.
  double SineOf(TriangleId triangle) const;
  /// Returns NoTriangle at the boundary.
  TriangleId Neighbour(TriangleId triangle, int edge) const { return this->Triangles[triangle].Neighbours[edge]; }
  int EdgeTo(TriangleId triangle, TriangleId neighbour) const;
  VertexId Beyond(TriangleId triangle, int edge) const;
  int CornerAt(TriangleId triangle, VertexId vertex) const;
  const PlanePoint& Place(VertexId vertex) const { return this->Places[vertex]; }

  /// Walks from `near` across at most 100 edges. Returns NoTriangle if the boundary is in the way.
  TriangleId Locate(const PlanePoint& place, TriangleId near) const;

  /// Numbers of a vertex to insert, and of the first of its two triangles.
  struct Room
  {
    VertexId Vertex = NoVertex;
    TriangleId First = NoTriangle;

    Room At(std::size_t n) const { return { this->Vertex + VertexId(n), this->First + TriangleId(2 * n) }; }
  };

  /// Triangles are gone until a vertex is inserted.
  Room AddRoom(std::size_t vertices);
  /// Returns the triangles around the vertex; none on the boundary or at a corner, where it cannot be inserted.
  void Insert(const PlanePoint& place, TriangleId triangle, const Room& room, std::vector<TriangleId>& around);
  /// Takes away the room that was added last where no vertex is inserted. Needs all triangles that changed since,
  /// and renumbers them; marks keep the old numbers.
  void CloseGaps(const Room& first, std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged);

  /// Turns a, b, c and b, a, d into a, d, c and d, b, c, in the same order. Their union must be strictly convex.
  void Flip(TriangleId triangle, int edge);

  /// Flips edges opposite to an inserted vertex until they are Delaunay (Lawson 1977, "Software for C1 surface
  /// interpolation"). The vertex is the third corner of all triangles in `around`, which grows.
  void Legalize(std::vector<TriangleId>& around);

  /// Flips edges of these triangles until all are Delaunay. Adds triangles that change.
  void MakeDelaunay(std::vector<TriangleId>& triangles);
  void MakeDelaunay();

  /// The ring is counter-clockwise, and empty at the boundary.
  void FindRing(VertexId vertex, TriangleId first, std::vector<TriangleId>& ring) const;

  /// Moves an inner vertex to its second next corner in ring[n]. ring[n] and the next triangle are removed.
  void Collapse(VertexId vertex, const std::vector<TriangleId>& ring, std::size_t n);
  /// All triangles around an inner vertex must remain counter-clockwise.
  void MoveTo(VertexId vertex, const PlanePoint& place) { this->Places[vertex] = place; }
  bool IsGone(TriangleId triangle) const { return this->Corner(triangle, 0) == NoVertex; }

  bool HasKept() const { return !this->Kept.empty(); }
  bool IsKept(VertexId a, VertexId b) const { return !this->Kept.empty() && this->Kept.count(EdgeKey(a, b)) > 0; }
  bool IsKeptEdge(TriangleId triangle, int edge) const
  {
    return this->IsKept(this->Corner(triangle, edge), this->Corner(triangle, NextCorner(edge)));
  }
  void Keep(VertexId a, VertexId b) { this->Kept.insert(EdgeKey(a, b)); }
  void LetGo(VertexId a, VertexId b) { this->Kept.erase(EdgeKey(a, b)); }
  /// Kept and boundary edges count as Delaunay.
  bool IsDelaunay(TriangleId triangle, int edge) const;

  VertexId Add(const PlanePoint& place);
  /// Replaces triangles, ascending, by others that fill their place or extend the mesh, and returns these. The last
  /// triangles may get other numbers.
  std::vector<TriangleId> Exchange(const std::vector<TriangleId>& gone, const RawVector<VertexId>& added);
  /// Kept edges remain.
  void Replace(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles);
  void Compact();
  void ReorderVertices(const std::vector<VertexId>& order);
  /// Successive triangles become neighbours, which suits the cache.
  void SortByPlace();

private:
  struct Triangle
  {
    std::array<VertexId, 3> Corners;
    std::array<TriangleId, 3> Neighbours;
  };

  struct OpenEdge
  {
    std::uint64_t Key;
    TriangleId Triangle;
    int Number;
  };

  static std::uint64_t EdgeKey(VertexId a, VertexId b)
  {
    return std::uint64_t(std::uint32_t(std::min(a, b))) << 32U | std::uint32_t(std::max(a, b));
  }

  template <typename Renumber>
  void RenumberBeside(
    const std::vector<TriangleId>& changed, const std::vector<unsigned char>& isChanged, const Renumber& renumbered);
  VertexId HigherEnd(TriangleId triangle, int edge) const;
  void Connect();
  OpenEdge OpenEdgeOf(TriangleId triangle, int edge) const;
  std::vector<OpenEdge> OpenAround(const std::vector<TriangleId>& gone);
  void MoveLastTo(TriangleId triangle);
  void CutKept(VertexId a, VertexId b, VertexId between);
  void Reorder(const std::vector<TriangleId>& order);
  void Replace(TriangleId triangle, TriangleId neighbour, TriangleId by);
  void Split(const Room& room, TriangleId triangle, std::vector<TriangleId>& parts);
  std::int64_t AreaAt(const PlanePoint& place, TriangleId triangle, int edge) const;

  std::vector<PlanePoint> Places;
  std::vector<Triangle> Triangles;
  std::unordered_set<std::uint64_t> Kept; // edges
};

// Forces lines between vertices into the mesh, which is to be made Delaunay afterwards: crossed edges are flipped until
// the line is an edge (Sloan 1993, "A fast algorithm for generating constrained Delaunay triangulations").
class KeptEdges
{
public:
  /// Nothing else may change the mesh meanwhile.
  KeptEdges(PlaneMesh& mesh, std::size_t vertices);

  /// Splits the line at vertices on it. Returns false, and keeps the segments so far, if it crosses the boundary or a
  /// kept edge.
  bool Keep(VertexId from, VertexId to);

private:
  struct Edge
  {
    TriangleId Triangle = NoTriangle;
    int Number = 0;
  };

  bool FindStart(VertexId from, VertexId to, Edge& crossed, VertexId& next) const;
  bool FindCrossed(VertexId from, VertexId to, Edge first, VertexId& end);
  void FlipCrossed(VertexId from, VertexId end);
  Edge FindEdge(VertexId a, VertexId b) const;
  bool IsConvex(const Edge& edge) const;
  void Flip(const Edge& edge);
  template <typename Visitor>
  bool AnyAround(VertexId vertex, Visitor&& visit) const;

  PlaneMesh& Mesh;
  std::vector<TriangleId> TriangleAt;
  std::deque<std::array<VertexId, 2>> Crossed; // edges that remain across the line
};
}

#endif
