// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Both searches go down from the root, with a stack of boxes that are still to be searched.

#include "TriangleTree.h"

#include "SearchStack.h"
#include "TriangleHeight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
// On each level a box is taken off the stack and four are put there; numbers of 32 bits fit 16 levels.
constexpr std::size_t MostWaiting = 64;

// A squared distance in single precision is wrong by a few roundings, less than 1e-6 of it. Boxes that are farther than
// the best triangle by this factor have nothing nearer.
constexpr double SlackOfDistances = 1.0 + 1e-5;

/// A box that is still to be searched: a node, or on the level below the last one a leaf.
struct Waiting
{
  float SquaredDistance;
  std::uint32_t Node;
  std::uint32_t Level;
};
}

//----------------------------------------------------------------------------------------------------------------------
void TriangleTree::SearchLeaf(
  std::size_t leaf, const Eigen::Vector3d& point, const Metric& metric, std::int32_t& nearest, double& best) const
{
  const TriangleRange triangles = this->TrianglesOf(leaf);
  for (std::size_t triangle = triangles.First; triangle < triangles.Last; ++triangle)
  {
    // The boxes of most triangles are too far away already, which takes less time to find out.
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
double TriangleTree::SquaredDistance(const Eigen::Vector3d& point, std::int32_t& hint, const Metric& metric) const
{
  const Eigen::Vector3f place = point.cast<float>();
  const Eigen::Array3f weights = metric.Weights().cast<float>();
  const std::uint32_t levels = std::uint32_t(this->Levels());
  double best = metric.SquaredDistance(this->Surface, this->Triangles[std::size_t(hint)], point);
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
      this->SearchLeaf(box.Node, point, metric, hint, best);
      bound = float(SlackOfDistances * best);
      continue;
    }
    const Node& node = this->Nodes[this->LevelStart[box.Level] + box.Node];
    Eigen::Array4f distances = Eigen::Array4f::Zero();
    for (int axis = 0; axis < 3; ++axis)
    {
      distances +=
        (weights[axis] * (node.Low[axis] - place[axis]).max(place[axis] - node.High[axis]).max(0.0F)).square();
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
    best = NearerHeight(this->Surface, this->Triangles[triangle], point, tolerance, best);
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
