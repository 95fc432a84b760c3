// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A mesh in plan into which points are inserted one by one. It stays constrained Delaunay: of two triangles that share
// a side neither has the corner of the other in its circle, and sides without a triangle beyond, the boundary, stay.
//
// A point makes three triangles out of the one it lies in. Then sides that are no longer Delaunay are flipped, which
// are only such as are opposite to the point (Lawson 1977, "Software for C1 surface interpolation"):
//
//          c                     c                          c-----e
//         / \                   /|\                         |\   /|
//        / p \       ->        / p \     and c-b to p-e:    | p   |
//       /     \              / /   \ \                      |/   \|
//      a-------b            a--------b                      a-----b

#ifndef SeismicHorizonsDelaunayMesh_h
#define SeismicHorizonsDelaunayMesh_h

#include "Common/RawVector.h"
#include "Common/Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
using TriangleId = std::int32_t;

constexpr TriangleId NoTriangle = -1;

/// Around a triangle, counter-clockwise. Sides have the numbers of the corners they begin at, so that the side opposite
/// to a corner is its next one.
constexpr int NextCorner(int corner)
{
  return corner == 2 ? 0 : corner + 1;
}

class DelaunayMesh
{
public:
  /// Three points per triangle, counter-clockwise; sides fit together. Keeps a reference to the places.
  DelaunayMesh(const std::vector<PlanePoint>& plane, const RawVector<PointId>& triangles);

  TriangleId Size() const { return TriangleId(this->Triangles.size()); }
  PointId Corner(TriangleId triangle, int corner) const
  {
    return this->Triangles[std::size_t(triangle)].Corners[corner];
  }
  /// Across the side from a corner to the next one; NoTriangle at the boundary.
  TriangleId Neighbour(TriangleId triangle, int side) const
  {
    return this->Triangles[std::size_t(triangle)].Neighbours[side];
  }
  const PlanePoint& Place(PointId point) const { return this->Plane[std::size_t(point)]; }

  /// The triangle that a point is in or on, looked for from one near by, across at most a hundred sides; NoTriangle
  /// when it is not found or the boundary is in the way.
  TriangleId Locate(PointId point, TriangleId near) const;

  /// Inserts a point that lies in a triangle or on its sides, and gives the triangles around the point, which are all
  /// that are new; none when it lies on the boundary or in the place of a corner, where it can not be inserted.
  const std::vector<TriangleId>& Insert(PointId point, TriangleId triangle);

private:
  struct Triangle
  {
    std::array<PointId, 3> Corners;
    std::array<TriangleId, 3> Neighbours;
  };

  void Connect();
  int SideTo(TriangleId triangle, TriangleId neighbour) const;
  void Replace(TriangleId triangle, TriangleId neighbour, TriangleId by);
  void Split(PointId point, TriangleId triangle);
  void Flip(TriangleId triangle, int side);
  bool MustFlip(TriangleId triangle, int side) const;
  void Legalize();
  std::int64_t AreaAt(const PlanePoint& place, TriangleId triangle, int side) const;

  const std::vector<PlanePoint>& Plane;
  std::vector<Triangle> Triangles;
  std::vector<TriangleId> Changed; // by the last insertion
};
}

#endif
