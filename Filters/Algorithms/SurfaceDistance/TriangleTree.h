// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tree of boxes over the triangles of a surface, to find the nearest of them, and those above or below a place.
//
// A node is a box with four children, which are boxes around a quarter of its triangles each: it is halved across its
// longest side, and each half once more. The lowest boxes, the leaves, hold four triangles. So the shape of the tree
// follows from the number of triangles alone, and needs no pointers: node n of a level has nodes 4 n to 4 n + 3 of the
// next one as its children, and triangles are sorted in the same way. A node stores the boxes of its children in single
// precision, side by side, so that one instruction compares all four with a point.

#ifndef SeismicHorizonsTriangleTree_h
#define SeismicHorizonsTriangleTree_h

#include "Common/Monitor.h"
#include "Metric.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class TriangleTree
{
public:
  /// `surface` is one that CheckSurface takes, but needs no area; it must outlive the tree. Time near n log n, on
  /// several threads; about 23 bytes per triangle, and 16 more while the tree is made. The same tree for any number of
  /// threads.
  explicit TriangleTree(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  /// The number, in the surface, of a triangle in the order of the tree: those that follow each other are near each
  /// other.
  std::int32_t NumberOf(std::size_t sorted) const { return this->Numbers[sorted]; }

  /// The squared distance to the nearest triangle. `hint` is the number of the sorted triangle to begin with, and
  /// becomes that of the nearest one: a query is quick when it begins with the result for a place near by.
  double SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric = Metric()) const;

  /// The z of the surface at the x and y of a point; where there are several, the one nearest to its own z, and nan
  /// where there is none. A place that is within `tolerance` of an edge in plan counts as on the triangle. Vertical
  /// triangles do not count.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  static constexpr std::size_t Fan = 4; // children of a node, and triangles of a leaf

  /// The boxes of four children, by axis; where there is no child, low is above high.
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
  std::size_t Levels() const { return this->LevelStart.size() - 1; }

  /// The sorted triangles from `First` to before `Last`.
  struct TriangleRange
  {
    std::size_t First;
    std::size_t Last;
  };
  TriangleRange TrianglesOf(std::size_t leaf) const
  {
    return { leaf * Fan, std::min((leaf + 1) * Fan, this->Triangles.size()) };
  }
  void SearchLeaf(
    std::size_t leaf, const Eigen::Vector3d& point, const Metric& metric, std::int32_t& nearest, double& best) const;
  template <typename DistancesOf, typename LeafSearch>
  void Descend(float bound, DistancesOf&& distancesOf, LeafSearch&& searchLeaf) const;

  const TriangleSurface& Surface;
  std::vector<Corners> Triangles;
  std::vector<std::int32_t> Numbers; // of the sorted triangles
  std::vector<Node> Nodes;
  std::vector<std::size_t> LevelStart; // the first node of each level, the root first, and the end of the last one
  float Margin = 0.0F; // by how much boxes are widened: more than rounding to single precision moves any coordinate
};
}

#endif
