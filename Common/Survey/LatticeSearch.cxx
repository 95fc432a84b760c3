// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeSearch.h"

#include "Common/Base/Errors.h"
#include "Common/Base/FixedChunks.h"
#include "Common/Horizon/Lattice.h"
#include "LatticeFrame.h"
#include "PointWindow.h"
#include "ShortSteps.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t WindowSize = 1 << 14; // points
constexpr double FirstReach = 2.0; // columns
// Within this reach correct steps only become more accurate, and few points cannot disprove wrong steps.
constexpr double TellingReach = 8.0;
// Fraction of a step.
constexpr double CoarseRounding = 0.05;
constexpr double LastReach = MostColumnsPerSide + 1.0; // columns
// Windows with fewer places have stacked picks, as of several horizons, or null picks at (0, 0).
constexpr std::size_t FewestPlaces = 64;
// Root mean square distance in columns. Random places have sqrt(1/6) = 0.41, and a lattice that misses half of the
// points 0.35.
constexpr double LargestSpread = 0.2;
// If a window has points on few lines its steps may be multiples of the lattice steps.
constexpr int MostPartsOfStep = 4;
constexpr double FewestUnits = 2.5; // Steps have this many rounding units, unless points follow each other.

struct Numbered
{
  PlaneFit Fit;
  double Squares = 0.0; // sum of squared distances from columns, in columns
  double Largest = 0.0; // distance, in columns
  std::int64_t Beyond = 0; // points farther away

  void Add(const Numbered& other)
  {
    this->Fit.Add(other.Fit);
    this->Squares += other.Squares;
    this->Largest = std::max(this->Largest, other.Largest);
    this->Beyond += other.Beyond;
  }

  double Spread() const { return std::sqrt(this->Squares / double(std::max<std::int64_t>(this->Fit.Size(), 1))); }
};

Numbered NumberPoints(const PlaneCloud& points, const PlaneMap& map, double reach, const Monitor& monitor)
{
  const Eigen::Matrix2d toColumns = map.Steps.inverse();
  return AddUpChunks<Numbered>(points.Size(), ChunkSize, monitor,
    [&](Numbered& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t point = first; point < last; ++point)
      {
        const Eigen::Vector2d place = points[point];
        const Eigen::Vector2d column = toColumns * (place - map.Origin);
        if (column.cwiseAbs().maxCoeff() > reach)
        {
          ++part.Beyond;
          continue;
        }
        const Eigen::Vector2d index = column.array().round();
        part.Fit.Add(index, place);
        part.Squares += (column - index).squaredNorm();
        part.Largest = std::max(part.Largest, (column - index).norm());
      }
    });
}

[[noreturn]] void RefuseSpread(std::int64_t points, const PlaneMap& map, double spread)
{
  std::ostringstream text;
  text << points << " points without a lattice: with the best steps, " << ToText(map.Steps.col(0)) << " and "
       << ToText(map.Steps.col(1)) << ", they are " << std::round(100.0 * spread)
       << " % of a step off their columns on average; expected the regular lattice of a survey, or Gridding, "
          "or NoLattice for an extraction";
  throw InputError(text.str());
}

/// Finds the longest fractions of the steps that fit all points.
PlaneMap DivideSteps(const PlaneCloud& points, const PlaneMap& map, double reach, double spread, const Monitor& monitor)
{
  for (int parts = 2; parts <= MostPartsOfStep * MostPartsOfStep; ++parts)
  {
    for (int columnParts = 1; columnParts <= MostPartsOfStep; ++columnParts)
    {
      const int rowParts = parts / columnParts;
      if (columnParts * rowParts != parts || rowParts > MostPartsOfStep)
      {
        continue;
      }
      PlaneMap divided = map;
      divided.Steps.col(0) /= columnParts;
      divided.Steps.col(1) /= rowParts;
      if (NumberPoints(points, divided, reach * std::max(columnParts, rowParts), monitor).Spread() <= LargestSpread)
      {
        return divided;
      }
    }
  }
  RefuseSpread(points.Size(), map, spread);
}

/// The map holds near its origin.
PlaneMap Grow(const PlaneCloud& points, PlaneMap map, const Monitor& monitor)
{
  for (double reach = FirstReach;; reach *= 2.0)
  {
    Numbered near = NumberPoints(points, map, reach, monitor);
    if (near.Spread() > LargestSpread && reach < TellingReach)
    {
      continue;
    }
    if (near.Spread() > LargestSpread)
    {
      map = DivideSteps(points, map, reach, near.Spread(), monitor);
      near = NumberPoints(points, map, reach, monitor);
    }
    if (const std::optional<PlaneMap> fitted = near.Fit.Solve())
    {
      map = *fitted;
    }
    if (near.Beyond == 0 || reach > LastReach)
    {
      return map;
    }
  }
}

/// The step along i is nearer to x; the step along j turns left of it.
PlaneMap TurnSteps(const PlaneMap& map)
{
  Eigen::Vector2d along = map.Steps.col(0);
  Eigen::Vector2d across = map.Steps.col(1);
  if (std::abs(across.x()) * along.norm() > std::abs(along.x()) * across.norm())
  {
    std::swap(along, across);
  }
  along = along.x() < 0.0 ? Eigen::Vector2d(-along) : along;
  const double turn = along.x() * across.y() - along.y() * across.x();
  PlaneMap turned = map;
  turned.Steps << along, turn < 0.0 ? Eigen::Vector2d(-across) : across;
  return turned;
}

class DistinctPlaces
{
public:
  explicit DistinctPlaces(const PlaneCloud& points)
    : Middle(points.Middle)
  {
    std::vector<std::pair<double, double>> places;
    places.reserve(points.X.size());
    std::transform(points.X.begin(), points.X.end(), points.Y.begin(), std::back_inserter(places),
      [](double x, double y) { return std::make_pair(x, y); });
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const auto& [x, y] : places)
    {
      this->X.push_back(x);
      this->Y.push_back(y);
    }
  }

  PlaneCloud Cloud() const { return { this->X, this->Y, this->Middle }; }

private:
  std::vector<double> X, Y;
  const Eigen::Vector2d Middle;
};

Eigen::Vector2d Mean(const std::vector<Eigen::Vector2d>& points)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points)
  {
    sum += point;
  }
  return sum / double(points.size());
}

double ShortestStep(const Eigen::Matrix2d& steps)
{
  return steps.colwise().norm().minCoeff();
}

/// Returns the fraction of points that have another one a step further.
double PartFollowed(const PlaneCloud& points, const Eigen::Vector2d& step, double unit)
{
  const auto cell = [unit](const Eigen::Vector2d& place)
  { return std::make_pair(std::llround(place.x() / unit), std::llround(place.y() / unit)); };
  std::set<std::pair<long long, long long>> cells;
  for (std::int64_t point = 0; point < std::min(points.Size(), WindowSize); ++point)
  {
    cells.insert(cell(points[point]));
  }
  std::size_t followed = 0;
  for (std::int64_t point = 0; point < std::min(points.Size(), WindowSize); ++point)
  {
    followed += cells.count(cell(points[point] + step));
  }
  return double(followed) / double(std::min(points.Size(), WindowSize));
}

/// Requires an exact lattice. Otherwise the places may be rounded, and are on a rather full lattice of the rounding
/// unit.
template <typename Find>
std::optional<PlaneMap> FindExactly(const PlaneCloud& points, double unit, double exact, Find&& find)
{
  constexpr double rather = 0.5;
  try
  {
    const PlaneMap map = find();
    const double spread = NumberPoints(points, map, LastReach, Monitor()).Spread();
    const bool isFull = ShortestStep(map.Steps) >= FewestUnits * unit ||
      std::max(PartFollowed(points, map.Steps.col(0), unit), PartFollowed(points, map.Steps.col(1), unit)) >= rather;
    return spread <= exact && isFull ? std::optional<PlaneMap>(map) : std::nullopt;
  }
  catch (const InputError&)
  {
    return std::nullopt;
  }
}

/// Lines of points at unequal distances, such as 350 and 375, fit their mean roughly, and a common divisor exactly.
template <typename Grow>
std::optional<PlaneMap> FindDivisor(const PlaneCloud& points, const std::vector<Eigen::Vector2d>& window,
  const Eigen::Vector2d& middle, const PlaneMap& rough, const Eigen::Vector2d& along, double unit, Grow&& grow)
{
  constexpr int mostParts = 256;
  constexpr double exact = 0.002; // columns
  constexpr double better = 0.1; // The distances are a tenth of the rough ones, in the smaller columns.
  constexpr double fewestOff = 0.25; // The largest distance is not of a few points.
  const Numbered found = NumberPoints(points, rough, LastReach, Monitor());
  const double longest = rough.Steps.colwise().norm().maxCoeff();
  if (found.Spread() <= exact || found.Spread() * longest <= std::min(unit, 1.0) ||
    found.Spread() < fewestOff * found.Largest)
  {
    return std::nullopt;
  }
  Eigen::Vector2d line = Eigen::Vector2d::Constant(longest); // to the next line
  for (const Eigen::Vector2d& place : window)
  {
    const Eigen::Vector2d step = place - middle;
    const double across = std::abs(step.x() * along.y() - step.y() * along.x());
    line = 2.0 * across > along.squaredNorm() && step.norm() < line.norm() ? step : line;
  }
  line -= std::round(line.dot(along) / along.squaredNorm()) * along;
  const double shortest = std::max(along.norm() / MostPartsOfStep, FewestUnits * std::min(unit, 1.0));
  for (int parts = 2; parts <= mostParts && line.norm() / parts >= shortest; ++parts)
  {
    PlaneMap map;
    map.Steps << along, line / parts;
    const bool isNear = NumberPoints(points, map, 2.0 * parts, Monitor()).Spread() < found.Spread();
    const auto fit =
      isNear ? FindExactly(points, unit, better * found.Spread(), [&]() { return grow(map.Steps); }) : std::nullopt;
    if (fit)
    {
      return fit;
    }
  }
  return std::nullopt;
}

Eigen::Vector2d MiddlePoint(const std::vector<Eigen::Vector2d>& window)
{
  const Eigen::Vector2d mean = Mean(window);
  return *std::min_element(window.begin(), window.end(),
    [&](const auto& a, const auto& b) { return (a - mean).squaredNorm() < (b - mean).squaredNorm(); });
}
}

//----------------------------------------------------------------------------------------------------------------------
PlaneMap FindLattice(const std::vector<double>& x, const std::vector<double>& y, const Monitor& monitor)
{
  if (x.size() < 3)
  {
    throw InputError(std::to_string(x.size()) + " points, expected at least three to find a lattice through them");
  }
  PlaneCloud points = { x, y, Eigen::Vector2d(x.front(), y.front()) };
  std::vector<Eigen::Vector2d> window = CrowdedWindow(points, WindowSize, monitor.Step(0.0, 0.2));
  if (window.size() < FewestPlaces && points.Size() > WindowSize)
  {
    window = CrowdedWindow(DistinctPlaces(points).Cloud(), WindowSize, monitor.Step(0.2, 0.3));
  }
  const Eigen::Matrix2d shortSteps = FindShortSteps(window);
  const double unit = FindRounding(x, y);
  // Sums are relative to a point of the window.
  const Eigen::Vector2d middle = MiddlePoint(window);
  points.Middle += middle;
  const auto grow = [&](const Eigen::Matrix2d& steps)
  {
    PlaneMap first;
    first.Steps = steps;
    return TurnSteps(Grow(points, first, monitor.Step(0.3, 1.0)));
  };
  std::optional<PlaneMap> found;
  if (window.size() < FewestPlaces || unit <= CoarseRounding * ShortestStep(shortSteps))
  {
    found = grow(shortSteps);
  }
  else
  {
    constexpr double exact = 0.02; // columns
    found = FindExactly(points, unit, exact, [&]() { return grow(shortSteps); });
    found = found ? found : grow(FindRoundedSteps(window, unit));
  }
  PlaneMap map = FindDivisor(points, window, middle, *found, shortSteps.col(0), unit, grow).value_or(*found);
  map.Origin += points.Middle;
  return map;
}
}
