// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShortSteps.h"

#include "Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
using Steps = std::vector<Eigen::Vector2d>;

constexpr std::size_t MostVoters = 1024;
// Steps that are alike but for rounding and for errors of the places, as a part of their length.
constexpr double Likeness = 0.25;
// What is off a line, as a part of the step along it: rows of a lattice are at least sqrt(3)/2 of its shortest step
// apart.
constexpr double OffLine = 0.5;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// From some of the points, the step to the nearest other one that is accepted.
template <typename Accept>
Steps NearestSteps(const std::vector<Eigen::Vector2d>& points, Accept&& accept)
{
  Steps steps;
  const std::size_t stride = points.size() / MostVoters + 1;
  for (std::size_t from = 0; from < points.size(); from += stride)
  {
    Eigen::Vector2d nearest = Eigen::Vector2d::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t to = 0; to < points.size(); ++to)
    {
      const Eigen::Vector2d step = points[to] - points[from];
      const double squared = step.squaredNorm();
      if (squared < least && to != from && accept(step))
      {
        nearest = step;
        least = squared;
      }
    }
    if (std::isfinite(least))
    {
      steps.push_back(nearest);
    }
  }
  return steps;
}

/// The mean of the largest group of steps that are alike. A step and its opposite are the same. The middle one in
/// length tells how much alike they have to be, as a step over a hole is longer than most.
Eigen::Vector2d Vote(Steps steps)
{
  const auto middle = steps.begin() + std::ptrdiff_t(steps.size() / 2);
  std::nth_element(
    steps.begin(), middle, steps.end(), [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  const double squaredReach = Likeness * Likeness * middle->squaredNorm();
  Eigen::Vector2d best = *middle;
  int mostVotes = 0;
  for (const Eigen::Vector2d& candidate : steps)
  {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int votes = 0;
    for (const Eigen::Vector2d& step : steps)
    {
      const Eigen::Vector2d same = step.dot(candidate) < 0.0 ? Eigen::Vector2d(-step) : step;
      if ((same - candidate).squaredNorm() <= squaredReach)
      {
        sum += same;
        ++votes;
      }
    }
    if (votes > mostVotes)
    {
      mostVotes = votes;
      best = sum / votes;
    }
  }
  return best;
}
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Matrix2d FindShortSteps(const std::vector<Eigen::Vector2d>& points)
{
  const Steps nearest = NearestSteps(points, [](const Eigen::Vector2d&) { return true; });
  Steps offLine;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
  if (!nearest.empty())
  {
    along = Vote(nearest);
    const double distance = OffLine * along.squaredNorm();
    offLine =
      NearestSteps(points, [&](const Eigen::Vector2d& step) { return std::abs(Cross(along, step)) > distance; });
  }
  if (offLine.empty())
  {
    throw InputError(
      std::to_string(points.size()) + " different places on one line, expected points on a lattice in the plane");
  }
  for (Eigen::Vector2d& step : offLine)
  {
    step -= std::round(step.dot(along) / along.squaredNorm()) * along;
  }
  Eigen::Matrix2d steps;
  steps << along, Vote(offLine);
  return steps;
}
}
