// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh in plan that is changed step by step. Its sides without a triangle beyond, the boundary, stay, and so do sides
// that are kept on request (KeptSides.h); a vertex that is inserted on one cuts it in two that are kept.
//
// Insert: a point makes three triangles out of the one it lies in, and is the third corner of each. Flip: of two
// triangles the side between them becomes the one between the corners opposite to it. Collapse: a point goes to the
// other end of a side, which takes two triangles away.
//
//        c               c            c---e      c---e         e---d         e---d
//       / \             /|\           |\  |      |  /|        / \ / \       /   / \ .
//      / p \     ->    / p \          | \ |  ->  | / |       f---p---c ->  f   /   c
//     /     \         / / \ \         |  \|      |/  |        \ / \ /       \  /  / .
//    a-------b       a-------b        a---b      a---b         a---b         a---b

#ifndef SeismicHorizonsPlaneMesh_h
#define SeismicHorizonsPlaneMesh_h

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace SeismicHorizons
{
using TriangleId = std::int32_t;
using VertexId = std::int32_t;

constexpr TriangleId NoTriangle = -1;
constexpr VertexId NoVertex = -1;

/// Around a triangle, counter-clockwise. Sides have the numbers of the corners they begin at, so that the side opposite
/// to a corner is its next one.
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
  /// Without triangles.
  PlaneMesh() = default;

  /// The places of vertices, and three of these per triangle, counter-clockwise; sides fit together.
  PlaneMesh(std::vector<PlanePoint> places, const RawVector<VertexId>& triangles);

  TriangleId Size() const { return TriangleId(this->Triangles.size()); }
  VertexId Corner(TriangleId triangle, int corner) const { return this->Triangles[triangle].Corners[corner]; }
  /// Across the side from a corner to the next one; NoTriangle at the boundary.
  TriangleId Neighbour(TriangleId triangle, int side) const { return this->Triangles[triangle].Neighbours[side]; }
  /// The side of a triangle to a neighbour.
  int SideTo(TriangleId triangle, TriangleId neighbour) const;
  /// The corner beyond a side that is not at the boundary.
  VertexId Beyond(TriangleId triangle, int side) const;
  int CornerAt(TriangleId triangle, VertexId vertex) const;
  const PlanePoint& Place(VertexId vertex) const { return this->Places[vertex]; }

  /// The triangle that a place is in or on, looked for from one near by, across at most a hundred sides; NoTriangle
  /// when it is not found or the boundary is in the way.
  TriangleId Locate(const PlanePoint& place, TriangleId near) const;

  /// Inserts a vertex, with the next number, at a place in a triangle or on its sides, and gives the three or four
  /// triangles around it; none when it lies on the boundary or in the place of a corner, where none can be inserted.
  void Insert(const PlanePoint& place, TriangleId triangle, std::vector<TriangleId>& around);

  /// Of two triangles a, b, c and b, a, d, the first with its side a b, makes a, d, c in place of the first and d, b, c
  /// in place of the other one. The four are the corners of a convex quadrilateral.
  void Flip(TriangleId triangle, int side);

  /// Flips sides opposite to a vertex that was inserted, and then those of the new triangles, until all triangles
  /// around it are Delaunay: none has the corner of a neighbour in its circle (Lawson 1977, "Software for C1 surface
  /// interpolation"). `around` are the triangles around the vertex, which is their third corner; new ones are added.
  void Legalize(std::vector<TriangleId>& around);

  /// The triangles around a vertex inside, counter-clockwise, from one of them; nothing when the boundary is met.
  void FindRing(VertexId vertex, TriangleId first, std::vector<TriangleId>& ring) const;

  /// Moves a vertex inside to the far end of a side of its ring: the second corner after it of ring[n]. The triangles
  /// on both sides of the side, ring[n] and the next one, go: they lose their corners.
  void Collapse(VertexId vertex, const std::vector<TriangleId>& ring, std::size_t n);
  bool IsGone(TriangleId triangle) const { return this->Corner(triangle, 0) == NoVertex; }

  /// Whether the side between two corners stays: no flip of Legalize takes it away.
  bool IsKept(VertexId a, VertexId b) const { return !this->Kept.empty() && this->Kept.count(SideKey(a, b)) > 0; }
  bool IsKeptSide(TriangleId triangle, int side) const
  {
    return this->IsKept(this->Corner(triangle, side), this->Corner(triangle, NextCorner(side)));
  }
  void Keep(VertexId a, VertexId b) { this->Kept.insert(SideKey(a, b)); }
  void LetGo(VertexId a, VertexId b) { this->Kept.erase(SideKey(a, b)); }
  /// Whether the circle of a triangle does not hold the corner beyond a side, or that stays.
  bool IsDelaunay(TriangleId triangle, int side) const;

  /// Numbers the triangles that are left anew, in their order.
  void Compact();
  /// Numbers vertices anew: in this order; all that triangles have are in it.
  void ReorderVertices(const std::vector<VertexId>& order);
  /// Numbers triangles by place, band by band: those of successive numbers are near each other, and so is what is read
  /// for them.
  void SortByPlace();

private:
  struct Triangle
  {
    std::array<VertexId, 3> Corners;
    std::array<TriangleId, 3> Neighbours;
  };

  static std::uint64_t SideKey(VertexId a, VertexId b)
  {
    return std::uint64_t(std::uint32_t(std::min(a, b))) << 32U | std::uint32_t(std::max(a, b));
  }

  void Connect();
  void CutKept(VertexId a, VertexId b, VertexId between);
  void Reorder(const std::vector<TriangleId>& order);
  void Replace(TriangleId triangle, TriangleId neighbour, TriangleId by);
  void Split(VertexId vertex, TriangleId triangle, std::vector<TriangleId>& parts);
  std::int64_t AreaAt(const PlanePoint& place, TriangleId triangle, int side) const;

  std::vector<PlanePoint> Places; // by vertex
  std::vector<Triangle> Triangles;
  std::unordered_set<std::uint64_t> Kept; // sides
};
}

#endif
