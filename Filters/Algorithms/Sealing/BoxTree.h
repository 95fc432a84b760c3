// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Boxes of any sizes in a loose octree, so that they can be found, added and removed: each is in the cell of its centre
// that is just as large, and reaches beyond it by up to half of the cell. Only cells that are there are searched, as
// triangles are flat, and large ones have many cells of small ones around.

#ifndef SeismicHorizonsBoxTree_h
#define SeismicHorizonsBoxTree_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class BoxTree
{
public:
  struct Entry
  {
    std::int32_t Triangle;
    Eigen::AlignedBox3d Box;
  };

  explicit BoxTree(const std::vector<Entry>& entries = {})
  {
    for (const Entry& entry : entries)
    {
      this->Around.extend(entry.Box);
    }
    this->Root = { 0, this->Around.center(), 0.5 * this->Around.sizes().maxCoeff() };
    for (const Entry& entry : entries)
    {
      this->Add(entry.Triangle, entry.Box);
    }
  }

  void Add(std::int32_t triangle, const Eigen::AlignedBox3d& box)
  {
    this->Around.extend(box);
    this->EntriesAt(box, 1).push_back({ triangle, box });
  }

  void Remove(std::int32_t triangle, const Eigen::AlignedBox3d& box)
  {
    std::vector<Entry>& entries = this->EntriesAt(box, -1);
    *std::find_if(entries.begin(), entries.end(),
      [triangle](const Entry& entry) { return entry.Triangle == triangle; }) = entries.back();
    entries.pop_back();
  }

  /// Whether test(triangle) is true for one whose box meets the box.
  template <typename Test>
  bool Any(const Eigen::AlignedBox3d& box, Test&& test) const
  {
    return this->Around.intersects(box) && this->AnyAt(this->Root, box, test);
  }

private:
  struct Node
  {
    std::array<std::int32_t, 8> Children = {}; // 0 if not there
    std::int32_t Count = 0; // of boxes, those of children included
    std::vector<Entry> Entries;
  };

  struct Cell
  {
    std::int32_t Node;
    Eigen::Vector3d Middle;
    double Half; // of its size

    /// `child` has a bit for each axis.
    Cell Child(std::int32_t node, std::size_t child) const
    {
      const double half = 0.5 * this->Half;
      const Eigen::Vector3d side(
        (child & 1U) != 0 ? half : -half, (child & 2U) != 0 ? half : -half, (child & 4U) != 0 ? half : -half);
      return { node, this->Middle + side, half };
    }
  };

  /// Of the cell of a box, from or to which it will be moved.
  std::vector<Entry>& EntriesAt(const Eigen::AlignedBox3d& box, std::int32_t added)
  {
    constexpr double smallest = 1e-6, rounding = 1.001; // of all, and of the box
    const double size = rounding * std::max(box.sizes().maxCoeff(), smallest * this->Root.Half);
    const Eigen::Vector3d centre = box.center();
    Cell cell = this->Root;
    const bool isIn = (centre - cell.Middle).cwiseAbs().maxCoeff() <= cell.Half; // Others are in the root.
    while (isIn && cell.Half >= size)
    {
      this->Nodes[std::size_t(cell.Node)].Count += added;
      const std::size_t child = (centre.x() > cell.Middle.x() ? 1U : 0U) | (centre.y() > cell.Middle.y() ? 2U : 0U) |
        (centre.z() > cell.Middle.z() ? 4U : 0U);
      std::int32_t& node = this->Nodes[std::size_t(cell.Node)].Children[child];
      const bool isNew = node == 0;
      node = isNew ? std::int32_t(this->Nodes.size()) : node;
      cell = cell.Child(node, child);
      this->Nodes.resize(this->Nodes.size() + (isNew ? 1 : 0));
    }
    this->Nodes[std::size_t(cell.Node)].Count += added;
    return this->Nodes[std::size_t(cell.Node)].Entries;
  }

  template <typename Test>
  bool AnyAt(const Cell& cell, const Eigen::AlignedBox3d& box, Test& test) const
  {
    const Node& node = this->Nodes[std::size_t(cell.Node)];
    for (const Entry& entry : node.Entries)
    {
      if (entry.Box.intersects(box) && test(entry.Triangle))
      {
        return true;
      }
    }
    for (std::size_t child = 0; child < node.Children.size() && node.Count > 0; ++child)
    {
      if (node.Children[child] != 0)
      {
        const Cell next = cell.Child(node.Children[child], child);
        const Eigen::Array3d most = Eigen::Array3d::Constant(2.0 * next.Half);
        if ((box.min().array() <= next.Middle.array() + most).all() &&
          (box.max().array() >= next.Middle.array() - most).all() && this->AnyAt(next, box, test))
        {
          return true;
        }
      }
    }
    return false;
  }

  Eigen::AlignedBox3d Around; // all boxes that were there
  Cell Root;
  std::vector<Node> Nodes = std::vector<Node>(1);
};
}

#endif
