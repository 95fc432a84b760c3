// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShortSteps.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Median.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using Steps = std::vector<Eigen::Vector2d>;

constexpr std::size_t MostVoters = 1024;
// Relative difference of equal steps with rounded or wrong places.
constexpr double Likeness = 0.25;
// Relative to the step along the line; rows of a lattice are at least sqrt(3)/2 of its shortest step apart.
constexpr double OffLine = 0.5;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

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

/// Signs are ignored. Similarity is relative to the median length, since steps over holes are longer.
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

struct CountedStep
{
  Eigen::Vector2d Step;
  std::int64_t Count = 0;
};

/// Units are the rounding; signs are ignored.
class StepCounts
{
public:
  StepCounts(const std::vector<Eigen::Vector2d>& points, double unit)
    : Unit(unit)
  {
    const Steps nearest = NearestSteps(points, [](const Eigen::Vector2d&) { return true; });
    std::vector<double> lengths;
    for (const Eigen::Vector2d& step : nearest)
    {
      lengths.push_back(step.norm());
    }
    const double reach = FarthestNeighbour * (UpperMedian(lengths) + unit);
    const std::size_t stride = points.size() / MostVoters + 1;
    for (std::size_t from = 0; from < points.size(); from += stride)
    {
      for (std::size_t to = 0; to < points.size(); ++to)
      {
        const Eigen::Vector2d step = points[to] - points[from];
        if (to != from && step.squaredNorm() <= reach * reach)
        {
          const auto x = std::int64_t(std::llround(step.x() / unit));
          const auto y = std::int64_t(std::llround(step.y() / unit));
          ++this->Counts[x < 0 || (x == 0 && y < 0) ? Cell{ -x, -y } : Cell{ x, y }];
        }
      }
    }
  }

  /// A peak has more steps than its surroundings, and nearly the most of all.
  std::vector<CountedStep> FindPeaks() const
  {
    std::vector<CountedStep> peaks;
    std::int64_t most = 0;
    for (const auto& [cell, count] : this->Counts)
    {
      const CountedStep here = this->Around(cell);
      bool isPeak = true;
      for (std::int64_t x = -1; x <= 1; ++x)
      {
        for (std::int64_t y = -1; y <= 1; ++y)
        {
          const Cell other = { cell.first + x, cell.second + y };
          const std::int64_t there = other == cell ? 0 : this->Around(other).Count;
          isPeak = isPeak && (there < here.Count || (there == here.Count && cell < other));
        }
      }
      if (isPeak)
      {
        peaks.push_back(here);
        most = std::max(most, here.Count);
      }
    }
    peaks.erase(
      std::remove_if(peaks.begin(), peaks.end(), [most](const CountedStep& peak) { return 2 * peak.Count < most; }),
      peaks.end());
    return peaks;
  }

private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  // In nearest distances; includes the shortest two independent steps of any lattice.
  static constexpr double FarthestNeighbour = 2.5;

  std::int64_t At(const Cell& cell) const
  {
    const auto found = this->Counts.find(
      cell.first < 0 || (cell.first == 0 && cell.second < 0) ? Cell{ -cell.first, -cell.second } : cell);
    return found == this->Counts.end() ? 0 : found->second;
  }

  /// Rounding of both ends moves a step by up to a unit.
  CountedStep Around(const Cell& cell) const
  {
    CountedStep sum{ Eigen::Vector2d::Zero(), 0 };
    for (std::int64_t x = cell.first - 1; x <= cell.first + 1; ++x)
    {
      for (std::int64_t y = cell.second - 1; y <= cell.second + 1; ++y)
      {
        const std::int64_t count = this->At({ x, y });
        sum.Step += double(count) * Eigen::Vector2d(double(x), double(y));
        sum.Count += count;
      }
    }
    sum.Step *= this->Unit / double(std::max<std::int64_t>(sum.Count, 1));
    return sum;
  }

  const double Unit;
  std::map<Cell, std::int64_t> Counts;
};
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
      std::to_string(points.size()) + " positions, all on one line, expected points on a lattice in the plane");
  }
  for (Eigen::Vector2d& step : offLine)
  {
    step -= std::round(step.dot(along) / along.squaredNorm()) * along;
  }
  Eigen::Matrix2d steps;
  steps << along, Vote(offLine);
  return steps;
}

//----------------------------------------------------------------------------------------------------------------------
double FindRounding(const std::vector<double>& x, const std::vector<double>& y)
{
  const auto areMultiples = [](const std::vector<double>& values, double unit)
  {
    constexpr double tolerance = 1e-5;
    const std::size_t stride = values.size() / MostVoters + 1;
    for (std::size_t n = 0; n < values.size(); n += stride)
    {
      const double multiple = values[n] / unit;
      if (!(std::abs(multiple - std::round(multiple)) <= tolerance))
      {
        return false;
      }
    }
    return true;
  };
  for (const double unit : { 10.0, 1.0, 0.1, 0.01, 0.001 })
  {
    if (areMultiples(x, unit) && areMultiples(y, unit))
    {
      return unit;
    }
  }
  return 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
Eigen::Matrix2d FindRoundedSteps(const std::vector<Eigen::Vector2d>& points, double unit)
{
  const StepCounts counts(points, unit);
  const std::vector<CountedStep> peaks = counts.FindPeaks();
  const auto shortest = [&](auto&& accept)
  {
    const CountedStep* best = nullptr;
    for (const CountedStep& peak : peaks)
    {
      best = accept(peak.Step) && (!best || peak.Step.squaredNorm() < best->Step.squaredNorm()) ? &peak : best;
    }
    return best;
  };
  const CountedStep* const along = shortest([](const Eigen::Vector2d&) { return true; });
  const CountedStep* const across = along
    ? shortest([along](const Eigen::Vector2d& step)
        { return std::abs(Cross(along->Step, step)) > OffLine * along->Step.norm() * step.norm(); })
    : nullptr;
  if (!across)
  {
    throw InputError(
      std::to_string(points.size()) + " positions, all on one line, expected points on a lattice in the plane");
  }
  Eigen::Matrix2d steps;
  steps << along->Step, across->Step;
  return steps;
}
}
