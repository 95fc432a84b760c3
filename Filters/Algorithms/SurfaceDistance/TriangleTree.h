// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the nearest triangle of a surface, and heights, by a tree of boxes.
//
// A node is halved across its longest side, and each half again, to four children; leaves hold four triangles. The
// shape follows from the number of triangles without pointers: node n of a level has children 4 n to 4 n + 3. Boxes of
// children are stored side by side in single precision, so that one instruction compares all.

#ifndef SeismicHorizonsTriangleTree_h
#define SeismicHorizonsTriangleTree_h

#include "Common/Base/Monitor.h"
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
  /// The surface must pass CheckSurface(), but needs no area, and outlive the tree. Takes n log n time and 23 bytes per
  /// triangle.
  explicit TriangleTree(const TriangleSurface& surface, const Monitor& monitor = Monitor());

  /// Returns the number in the surface; neighbours in the tree are close.
  std::int32_t NumberOf(std::size_t sorted) const { return this->Numbers[sorted]; }

  /// `hint` is the sorted triangle to begin with, and becomes the nearest. A result for a place near by makes a query
  /// fast.
  double SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric = Metric()) const;

  /// Returns the z nearest to the point's, or NaN. Places within `tolerance` of an edge in plan count; vertical
  /// triangles do not.
  double FindHeight(const Eigen::Vector3d& point, double tolerance) const;

private:
  static constexpr std::size_t Fan = 4; // children of a node, and triangles of a leaf

  /// Low is above High without a child.
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
  std::vector<std::int32_t> Numbers; // in the surface, by sorted triangle
  std::vector<Node> Nodes;
  std::vector<std::size_t> LevelStart; // first node per level, the root first, and the end
  float Margin = 0.0F; // exceeds rounding to single precision
};
}

#endif
