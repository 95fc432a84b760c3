// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tree is made top-down, and filled bottom-up:
//
// MakeLevels: the number of nodes per level
// Sort: halves of triangles by the middles of their boxes
// FillNodes: boxes, from triangles or children
//
//
// Boxes in single precision are widened, and searches exceed the best distance slightly, so that rounding hides no
// triangle.

#include "TriangleTree.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TrianglesPerSplit = 4096;
constexpr std::int64_t GrainOfNodes = 256;

// Box and point are rounded by up to 2^-24, and the box again when widened: four times is enough.
constexpr double RoundingOfCoordinates = 4 * 0x1p-24;

// A box adds three to the stack per level; numbers of 32 bits fit 16 levels.
constexpr std::size_t MostWaitingNodes = 64;

// Squared distances in single precision are wrong by less than 1e-6. Boxes beyond the best by this factor have nothing
// nearer.
constexpr double SlackOfDistances = 1.0 + 1e-5;

struct Middle
{
  float Doubled[3];
  std::int32_t Triangle;
};

Middle MiddleOf(const TriangleSurface& surface, std::int64_t triangle)
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

/// The first `count` triangles are least along the longest side.
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

void SplitIntoChildren(Middle* first, Middle* last, std::size_t capacity)
{
  const std::size_t children = (std::size_t(last - first) + capacity - 1) / capacity;
  Middle* const half = std::min(last, first + (children + 1) / 2 * capacity);
  Split(first, half - first, last);
  Split(first, capacity, half);
  Split(half, capacity, last);
}

/// On the level below the last, nodes are leaves.
struct Waiting
{
  float SquaredDistance;
  std::uint32_t Node;
  std::uint32_t Level;
};
}

//----------------------------------------------------------------------------------------------------------------------
TriangleTree::TriangleTree(const TriangleSurface& surface, const Monitor& monitor)
  : Surface(surface)
{
  assert(
    !surface.Triangles.empty() && surface.Triangles.size() <= std::size_t(std::numeric_limits<std::int32_t>::max()));
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
  ParallelFor(std::int64_t(size), TrianglesPerSplit,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        middles[n] = MiddleOf(this->Surface, n);
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
    ParallelFor(std::int64_t(this->NodesOf(level)), TrianglesPerSplit / std::int64_t(capacity) + 1, split);
  }
  this->Triangles.reserve(size);
  this->Numbers.reserve(size);
  for (const Middle& middle : middles)
  {
    this->Numbers.push_back(middle.Triangle);
    this->Triangles.push_back(this->Surface.Triangles[middle.Triangle]);
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
        for (std::int64_t node = first; node < last; ++node)
        {
          lowest ? this->FillLowest(node) : this->FillFromChildren(level, node);
        }
      });
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::SearchLeaf(
  std::size_t leaf, const Eigen::Vector3d& point, const Metric& metric, std::int32_t& nearest, double& best) const
{
  const TriangleRange triangles = this->TrianglesOf(leaf);
  for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
  {
    // Boxes rule out most triangles faster.
    const Corners& corners = this->Triangles[triangle];
    if (std::int32_t(triangle) != nearest && metric.SquaredDistanceToBox(this->Surface, corners, point) < best)
    {
      const double distance = metric.SquaredDistance(this->Surface, corners, point);
      nearest = distance < best ? std::int32_t(triangle) : nearest;
      best = std::min(best, distance);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Calls searchLeaf(leaf), which returns a new bound, for leaves within the bound, nearest first.
template <typename DistancesOf, typename LeafSearch>
void TriangleTree::Descend(float bound, DistancesOf&& distancesOf, LeafSearch&& searchLeaf) const
{
  const std::uint32_t levels = std::uint32_t(this->Levels());
  Waiting stack[MostWaitingNodes];
  std::size_t size = 1;
  stack[0] = { 0.0F, 0, 0 };
  while (size > 0)
  {
    const Waiting box = stack[--size];
    if (box.SquaredDistance >= bound)
    {
      continue;
    }
    if (box.Level == levels)
    {
      bound = searchLeaf(box.Node);
      continue;
    }
    const Eigen::Array4f distances = distancesOf(this->Nodes[this->LevelStart[box.Level] + box.Node]);
    assert(size + Fan <= MostWaitingNodes);
    const std::size_t oldSize = size;
    for (std::uint32_t child = 0; child < Fan; ++child)
    {
      if (distances[child] < bound)
      {
        stack[size++] = { distances[child], box.Node * std::uint32_t(Fan) + child, box.Level + 1 };
      }
    }
    SortByDistance(stack + oldSize, stack + size);
  }
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric) const
{
  assert(hint >= 0 && std::size_t(hint) < this->Triangles.size());
  const Eigen::Vector3f place = point.cast<float>();
  const Eigen::Array3f weights = metric.Weights().cast<float>();
  double best = metric.SquaredDistance(this->Surface, this->Triangles[hint], point);
  this->Descend(
    float(SlackOfDistances * best),
    [&](const Node& node)
    {
      Eigen::Array4f distances = Eigen::Array4f::Zero();
      for (int axis = 0; axis < 3; ++axis)
      {
        distances +=
          (weights[axis] * (node.Low[axis] - place[axis]).max(place[axis] - node.High[axis]).max(0.0F)).square();
      }
      return distances;
    },
    [&](std::size_t leaf)
    {
      this->SearchLeaf(leaf, point, metric, hint, best);
      return float(SlackOfDistances * best);
    });
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::FindHeight(const Eigen::Vector3d& point, double tolerance) const
{
  const Eigen::Vector3f place = point.cast<float>();
  const float reach = std::max(this->Margin, float(2.0 * tolerance)); // twice, as the tolerance is rounded, too
  double best = std::numeric_limits<double>::quiet_NaN();
  // Boxes on the vertical through the point have distance 0, all other boxes are out of bounds.
  constexpr float Bound = 1.0F;
  this->Descend(
    Bound,
    [&](const Node& node) -> Eigen::Array4f
    {
      return (node.Low[0] <= place.x() + reach && node.High[0] >= place.x() - reach &&
        node.Low[1] <= place.y() + reach && node.High[1] >= place.y() - reach)
        .select(Eigen::Array4f::Zero(), Eigen::Array4f::Constant(Bound));
    },
    [&](std::size_t leaf)
    {
      const TriangleRange triangles = this->TrianglesOf(leaf);
      for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
      {
        best = NearerHeight(this->Surface, this->Triangles[triangle], point, tolerance, best);
      }
      return Bound;
    });
  return best;
}
}
