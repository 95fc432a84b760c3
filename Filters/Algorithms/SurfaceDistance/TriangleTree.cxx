// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TriangleTree.h"

#include "ClosestPoint.h"
#include "Common/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t Fan = 4; // children of a node, and triangles of a leaf
// On each level a box is taken off the stack and four are put there; numbers of 32 bits fit 16 levels.
constexpr std::size_t MostWaiting = 64;
constexpr std::int64_t Grain = 4096; // triangles that a thread takes at a time
constexpr std::int64_t GrainOfNodes = 256;

// Rounding to single precision moves a coordinate by up to 2^-24 of its size. Of a box and a point that are compared,
// both are rounded, and so is the box once more when it is widened: four times as much is enough.
constexpr double RoundingOfCoordinates = 4 * 0x1p-24;

// A squared distance in single precision is wrong by a few roundings, less than 1e-6 of it. Boxes that are farther than
// the best triangle by this factor have nothing nearer.
constexpr double SlackOfDistances = 1.0 + 1e-5;

/// The middle of a triangle's box, by twice its coordinates, for sorting triangles.
struct Middle
{
  float Doubled[3];
  std::int32_t Triangle;
};

/// A box that is still to be searched: a node, or on the level below the last one a leaf.
struct Waiting
{
  float SquaredDistance;
  std::uint32_t Node;
  std::uint32_t Level;
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

/// Sorts boxes so that the nearest is last. There are four at most, for which this takes less time than std::sort.
void SortByDistance(Waiting* first, Waiting* last)
{
  for (Waiting* next = first + 1; next < last; ++next)
  {
    const Waiting moved = *next;
    Waiting* place = next;
    for (; place > first && (place - 1)->SquaredDistance < moved.SquaredDistance; --place)
    {
      *place = *(place - 1);
    }
    *place = moved;
  }
}

double SquaredDistanceTo(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& point)
{
  return SquaredDistanceToTriangle(point, surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]));
}

/// The same to the box of a triangle, which is never farther away.
double SquaredDistanceToBox(const TriangleSurface& surface, const Corners& t, const Eigen::Vector3d& point)
{
  const auto& a = surface.Point(t[0]).array();
  const auto& b = surface.Point(t[1]).array();
  const auto& c = surface.Point(t[2]).array();
  return (a.min(b).min(c) - point.array()).max(point.array() - a.max(b).max(c)).max(0.0).square().sum();
}

/// The z of a triangle at a place in plan; nan when the place is more than `tolerance` outside it, or when it is no
/// wider than that in plan.
double HeightAt(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners, double tolerance)
{
  std::array<double, 3> part;
  double sum = 0.0;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const Eigen::Vector2d from = corners[(n + 1) % 3].head<2>() - p.head<2>();
    const Eigen::Vector2d to = corners[(n + 2) % 3].head<2>() - p.head<2>();
    part[n] = from.x() * to.y() - from.y() * to.x();
    sum += part[n];
  }
  const double turn = sum < 0.0 ? -1.0 : 1.0;
  double height = 0.0;
  double inside = 0.0;
  for (std::size_t n = 0; n < 3; ++n)
  {
    const double edge = (corners[(n + 2) % 3] - corners[(n + 1) % 3]).head<2>().norm();
    if (!(std::abs(sum) > tolerance * edge) || turn * part[n] < -tolerance * edge)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    // Just outside an edge the height is that on it.
    part[n] = std::max(0.0, turn * part[n]);
    inside += part[n];
    height += part[n] * corners[n].z();
  }
  return height / inside;
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
  for (const Middle& middle : middles)
  {
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

//----------------------------------------------------------------------------------------------------------------------
TriangleTree::TriangleRange TriangleTree::TrianglesOf(std::size_t leaf) const
{
  return { leaf * Fan, std::min((leaf + 1) * Fan, this->Triangles.size()) };
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::SearchLeaf(std::size_t leaf, const Eigen::Vector3d& point, std::int32_t& nearest, double& best) const
{
  const TriangleRange triangles = this->TrianglesOf(leaf);
  for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
  {
    // The boxes of most triangles are too far away already, which takes less time to find out.
    const Corners& corners = this->Triangles[triangle];
    if (std::int32_t(triangle) != nearest && SquaredDistanceToBox(this->Surface, corners, point) < best)
    {
      const double distance = SquaredDistanceTo(this->Surface, corners, point);
      nearest = distance < best ? std::int32_t(triangle) : nearest;
      best = std::min(best, distance);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint) const
{
  const Eigen::Vector3f place = point.cast<float>();
  const std::uint32_t levels = std::uint32_t(this->Levels());
  double best = SquaredDistanceTo(this->Surface, this->Triangles[std::size_t(hint)], point);
  float bound = float(SlackOfDistances * best);
  Waiting stack[MostWaiting];
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
      this->SearchLeaf(box.Node, point, hint, best);
      bound = float(SlackOfDistances * best);
      continue;
    }
    const Node& node = this->Nodes[this->LevelStart[box.Level] + box.Node];
    Eigen::Array4f distances = Eigen::Array4f::Zero();
    for (int axis = 0; axis < 3; ++axis)
    {
      distances += (node.Low[axis] - place[axis]).max(place[axis] - node.High[axis]).max(0.0F).square();
    }
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
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
/// The height of a leaf's triangle that is nearer to the point than `best`, or else that; nan for none at all.
double TriangleTree::HeightInLeaf(std::size_t leaf, const Eigen::Vector3d& point, double tolerance, double best) const
{
  const TriangleRange triangles = this->TrianglesOf(leaf);
  for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
  {
    const Corners& t = this->Triangles[triangle];
    const double height =
      HeightAt(point, { this->Surface.Point(t[0]), this->Surface.Point(t[1]), this->Surface.Point(t[2]) }, tolerance);
    // The first comparison is false for nan.
    best = std::abs(height - point.z()) >= std::abs(best - point.z()) || std::isnan(height) ? best : height;
  }
  return best;
}

//----------------------------------------------------------------------------------------------------------------------
double TriangleTree::FindHeight(const Eigen::Vector3d& point, double tolerance) const
{
  const Eigen::Vector3f place = point.cast<float>();
  const float reach = std::max(this->Margin, float(2.0 * tolerance)); // twice: the tolerance is rounded as well
  const std::uint32_t levels = std::uint32_t(this->Levels());
  double best = std::numeric_limits<double>::quiet_NaN();
  Waiting stack[MostWaiting];
  std::size_t size = 1;
  stack[0] = { 0.0F, 0, 0 };
  while (size > 0)
  {
    const Waiting box = stack[--size];
    if (box.Level == levels)
    {
      best = this->HeightInLeaf(box.Node, point, tolerance, best);
      continue;
    }
    const Node& node = this->Nodes[this->LevelStart[box.Level] + box.Node];
    const Eigen::Array<bool, 4, 1> above = node.Low[0] <= place.x() + reach && node.High[0] >= place.x() - reach &&
      node.Low[1] <= place.y() + reach && node.High[1] >= place.y() - reach;
    for (std::uint32_t child = 0; child < Fan; ++child)
    {
      if (above[child])
      {
        stack[size++] = { 0.0F, box.Node * std::uint32_t(Fan) + child, box.Level + 1 };
      }
    }
  }
  return best;
}
}
