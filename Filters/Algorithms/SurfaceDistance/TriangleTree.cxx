// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleTree.h"

#include "Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Grain = 4096; // triangles that a thread takes at a time
constexpr std::int64_t GrainOfNodes = 256;

// Rounding to single precision moves a coordinate by up to 2^-24 of its size. Of a box and a point that are compared,
// both are rounded, and so is the box once more when it is widened: four times as much is enough.
constexpr double RoundingOfCoordinates = 4 * 0x1p-24;

/// The middle of a triangle's box, by twice its coordinates, for sorting triangles.
struct Middle
{
  float Doubled[3];
  std::int32_t Triangle;
};

Middle MiddleOf(const TriangleSurface& surface, std::size_t triangle)
{
  Eigen::AlignedBox3d box;
  for (const PointId corner : surface.Triangles[triangle])
  {
    box.extend(surface.Point(corner));
  }
  const Eigen::Vector3f doubled = (box.min() + box.max()).cast<float>();
  return { { doubled.x(), doubled.y(), doubled.z() }, std::int32_t(triangle) };
}

int LongestSide(const Middle* first, const Middle* last)
{
  Eigen::AlignedBox3f box;
  for (const Middle* middle = first; middle < last; ++middle)
  {
    box.extend(Eigen::Vector3f(middle->Doubled[0], middle->Doubled[1], middle->Doubled[2]));
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  return axis;
}

/// Moves the `count` triangles that are least along the longest side to the front of the range.
void Split(Middle* first, std::size_t count, Middle* last)
{
  if (count < std::size_t(last - first))
  {
    const int axis = LongestSide(first, last);
    std::nth_element(first, first + count, last,
      [axis](const Middle& a, const Middle& b)
      { return a.Doubled[axis] != b.Doubled[axis] ? a.Doubled[axis] < b.Doubled[axis] : a.Triangle < b.Triangle; });
  }
}

/// Sorts a range into children of `capacity` triangles each: first into halves, then each half.
void SplitIntoChildren(Middle* first, Middle* last, std::size_t capacity)
{
  const std::size_t children = (std::size_t(last - first) + capacity - 1) / capacity;
  Middle* const half = std::min(last, first + (children + 1) / 2 * capacity);
  Split(first, std::size_t(half - first), last);
  Split(first, capacity, half);
  Split(half, capacity, last);
}

}

//----------------------------------------------------------------------------------------------------------------------
TriangleTree::TriangleTree(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
{
  double largest = 0.0;
  for (const Eigen::Vector3d& point : surface.Points)
  {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  this->Margin = float(RoundingOfCoordinates * largest);
  this->MakeLevels();
  this->Sort(monitor);
  this->FillNodes();
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::MakeLevels()
{
  std::vector<std::size_t> sizes; // from the lowest level to the root
  std::size_t size = (this->Surface.Triangles.size() + Fan - 1) / Fan; // leaves
  do
  {
    size = (size + Fan - 1) / Fan;
    sizes.push_back(size);
  } while (size > 1);
  this->LevelStart.assign(1, 0);
  for (auto level = sizes.rbegin(); level != sizes.rend(); ++level)
  {
    this->LevelStart.push_back(this->LevelStart.back() + *level);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::Sort(const Monitor& monitor)
{
  const std::size_t size = this->Surface.Triangles.size();
  std::vector<Middle> middles(size);
  ParallelFor(std::int64_t(size), Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        middles[std::size_t(n)] = MiddleOf(this->Surface, std::size_t(n));
      }
    });
  std::size_t capacity = Fan; // triangles of a child
  for (std::size_t level = 1; level < this->Levels(); ++level)
  {
    capacity *= Fan;
  }
  for (std::size_t level = 0; level < this->Levels(); ++level, capacity /= Fan)
  {
    monitor.Progress(double(level) / double(this->Levels()));
    const auto split = [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const std::size_t begin = std::size_t(node) * Fan * capacity;
        SplitIntoChildren(middles.data() + begin, middles.data() + std::min(size, begin + Fan * capacity), capacity);
      }
    };
    ParallelFor(std::int64_t(this->NodesOf(level)), Grain / std::int64_t(capacity) + 1, split);
  }
  this->Triangles.reserve(size);
  this->Numbers.reserve(size);
  for (const Middle& middle : middles)
  {
    this->Numbers.push_back(middle.Triangle);
    this->Triangles.push_back(this->Surface.Triangles[std::size_t(middle.Triangle)]);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::SetBox(Node& node, int child, const Eigen::AlignedBox3d& box) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Low[axis][child] = float(box.min()[axis]) - this->Margin;
    node.High[axis][child] = float(box.max()[axis]) + this->Margin;
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillLowest(std::size_t node)
{
  Node& filled = this->Nodes[this->LevelStart[this->Levels() - 1] + node];
  for (std::size_t child = 0; child < Fan; ++child)
  {
    Eigen::AlignedBox3d box;
    const TriangleRange triangles = this->TrianglesOf(node * Fan + child);
    for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
    {
      for (const PointId corner : this->Triangles[triangle])
      {
        box.extend(this->Surface.Point(corner));
      }
    }
    if (!box.isEmpty())
    {
      this->SetBox(filled, int(child), box);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillFromChildren(std::size_t level, std::size_t node)
{
  Node& filled = this->Nodes[this->LevelStart[level] + node];
  for (std::size_t child = 0; child < Fan && node * Fan + child < this->NodesOf(level + 1); ++child)
  {
    const Node& below = this->Nodes[this->LevelStart[level + 1] + node * Fan + child];
    for (int axis = 0; axis < 3; ++axis)
    {
      filled.Low[axis][Eigen::Index(child)] = below.Low[axis].minCoeff();
      filled.High[axis][Eigen::Index(child)] = below.High[axis].maxCoeff();
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::FillNodes()
{
  Node empty;
  std::fill_n(empty.Low, 3, Eigen::Array4f::Constant(std::numeric_limits<float>::infinity()));
  std::fill_n(empty.High, 3, Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity()));
  this->Nodes.assign(this->LevelStart.back(), empty);
  for (std::size_t level = this->Levels(); level-- > 0;)
  {
    const bool lowest = level + 1 == this->Levels();
    ParallelFor(std::int64_t(this->NodesOf(level)), GrainOfNodes,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::size_t node = std::size_t(first); node < std::size_t(last); ++node)
        {
          lowest ? this->FillLowest(node) : this->FillFromChildren(level, node);
        }
      });
  }
}
}
