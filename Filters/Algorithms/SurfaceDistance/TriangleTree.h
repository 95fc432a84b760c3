// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tree of boxes over the triangles of a surface, to find the nearest of them, and those above or below a place.
//
// Every box has four children, of which each holds a quarter of its triangles along its longest sides; the lowest boxes
// hold four triangles. So the shape of the tree follows from the number of triangles alone, and needs no pointers: node
// n of a level has nodes 4 n to 4 n + 3 of the next one as its children, and triangles are sorted the same way. A node
// holds the boxes of its children, in single precision, which four at a time are compared with a point.

#ifndef SeismicHorizonsTriangleTree_h
#define SeismicHorizonsTriangleTree_h

#include "Common/Monitor.h"
#include "TriangleSurface.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class TriangleTree
{
public:
  /// `surface` has passed CheckSurface or would, an area apart, and outlives the tree. Time near
  /// n log n on several threads; about 19 bytes per triangle, and 16 more while it is made. The same tree for any
  /// number of threads.
  explicit TriangleTree(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  /// The triangles, those side by side that are near each other.
  const std::vector<Corners>& SortedTriangles() const { return this->Triangles; }

  /// The squared distance to the nearest triangle. `hint` is where to begin, the number of a sorted triangle, and
  /// becomes the nearest one: queries are quick when each begins with the result for a place near by.
  double SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint) const;

  /// The z of the surface at the x and y of a point; where there are several, the one nearest to its own z, and nan
  /// where there is none. A place within `tolerance` of an edge counts as on the triangle. Vertical triangles have no
  /// inside in plan and do not count.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  /// The boxes of four children; low is above high where there is none.
  struct Node
  {
    Eigen::Array4f Low[3];
    Eigen::Array4f High[3];
  };

  void MakeLevels();
  void Sort(const Monitor& monitor);
  void FillNodes();
  void FillLowest(std::size_t node);
  void FillFromChildren(std::size_t level, std::size_t node);
  void SetBox(Node& node, int child, const Eigen::AlignedBox3d& box) const;
  std::size_t NodesOf(std::size_t level) const { return this->LevelStart[level + 1] - this->LevelStart[level]; }

  const TriangleSurface& Surface;
  std::vector<Corners> Triangles;
  std::vector<Node> Nodes;
  std::vector<std::size_t> LevelStart; // the first node of each level, the root first, and the end of the last one
  float Margin = 0.0F; // more than single precision can be off at the coordinates of the surface
};
}

#endif
