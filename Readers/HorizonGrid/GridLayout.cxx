// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridLayout.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextNumbers.h"

#include <cstddef>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t NodesFreeOfPoints = 1000000; // Their values take 8 MB.
constexpr std::int64_t MostNodesPerPoint = 1000;

double AxisStep(int count, const std::array<double, 2>& range, const std::string& axis)
{
  if (count == 1)
  {
    return 1.0;
  }
  if (!(range[0] < range[1]))
  {
    throw InputError(axis + " from " + ShortestText(range[0]) + " to " + ShortestText(range[1]) + " for " +
      std::to_string(count) + " nodes, expected increasing values");
  }
  return (range[1] - range[0]) / (count - 1);
}

/// std::cos is not exact at multiples of 90 degrees.
Eigen::Vector2d DirectionAt(double degrees)
{
  const double quarters = degrees / 90.0;
  if (quarters == std::floor(quarters))
  {
    const std::array<Eigen::Vector2d, 4> axes = { Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 1.0),
      Eigen::Vector2d(-1.0, 0.0), Eigen::Vector2d(0.0, -1.0) };
    const double turned = std::fmod(quarters, 4.0);
    return axes[static_cast<std::size_t>(turned < 0.0 ? turned + 4.0 : turned)];
  }
  const double radians = degrees * (std::acos(-1.0) / 180.0);
  return { std::cos(radians), std::sin(radians) };
}
}

//----------------------------------------------------------------------------------------------------------------------
NullRule NullAt(double value)
{
  constexpr double floatPrecision = std::numeric_limits<float>::epsilon();
  NullRule rule;
  rule.Value = value;
  rule.Tolerance = floatPrecision * std::fabs(value);
  return rule;
}

//----------------------------------------------------------------------------------------------------------------------
NullRule NullFrom(double least)
{
  return OrFrom({}, least);
}

//----------------------------------------------------------------------------------------------------------------------
NullRule OrFrom(NullRule rule, double least)
{
  rule.Least = least;
  return rule;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t CountNodes(const std::array<int, 2>& columns)
{
  return std::int64_t(columns[0]) * columns[1];
}

//----------------------------------------------------------------------------------------------------------------------
SurveyLattice AxisLattice(
  const std::array<int, 2>& columns, const std::array<double, 2>& xRange, const std::array<double, 2>& yRange)
{
  return TurnedLattice(
    columns, { xRange[0], yRange[0] }, { AxisStep(columns[0], xRange, "x"), AxisStep(columns[1], yRange, "y") }, 0.0);
}

//----------------------------------------------------------------------------------------------------------------------
SurveyLattice TurnedLattice(
  const std::array<int, 2>& columns, const Eigen::Vector2d& origin, const std::array<double, 2>& steps, double degrees)
{
  SurveyLattice lattice;
  const Eigen::Vector2d direction = DirectionAt(degrees);
  lattice.Columns = columns;
  lattice.Origin = origin;
  lattice.ColumnStep = steps[0] * direction;
  lattice.RowStep = steps[1] * Eigen::Vector2d(0.0 - direction.y(), direction.x()); // The subtraction avoids -0.
  const Eigen::Vector2d last = origin + columns[0] * lattice.ColumnStep + columns[1] * lattice.RowStep;
  if (steps[0] == 0.0 || steps[1] == 0.0 || !last.allFinite())
  {
    throw InputError("steps of " + ShortestText(steps[0]) + " and " + ShortestText(steps[1]) +
      ", expected steps other than 0, and finite coordinates");
  }
  return lattice;
}

//----------------------------------------------------------------------------------------------------------------------
void RequirePoints(std::int64_t nodes, std::int64_t points)
{
  if (nodes > NodesFreeOfPoints && (nodes - NodesFreeOfPoints) / MostNodesPerPoint > points)
  {
    throw InputError(std::to_string(nodes) + " nodes for " + std::to_string(points) + " points, expected at most " +
      std::to_string(MostNodesPerPoint) + " nodes for each");
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> Arrange(std::vector<double> values, const std::array<int, 2>& columns, const StorageOrder& order)
{
  if (!order.AlongY && !order.FromRight && !order.FromTop)
  {
    return values;
  }
  const std::int64_t width = columns[0];
  const std::int64_t height = columns[1];
  const std::int64_t xStep = order.FromRight ? -1 : 1;
  const std::int64_t yStep = order.FromTop ? -width : width;
  const std::int64_t first = (order.FromRight ? width - 1 : 0) + (order.FromTop ? width * (height - 1) : 0);
  const std::int64_t fastCount = order.AlongY ? height : width;
  const std::int64_t fastStep = order.AlongY ? yStep : xStep;
  const std::int64_t slowCount = order.AlongY ? width : height;
  const std::int64_t slowStep = order.AlongY ? xStep : yStep;
  std::vector<double> arranged(values.size());
  auto value = values.begin();
  for (std::int64_t slow = 0; slow < slowCount; ++slow)
  {
    for (std::int64_t fast = 0; fast < fastCount; ++fast)
    {
      arranged[static_cast<std::size_t>(first + slow * slowStep + fast * fastStep)] = *value++;
    }
  }
  return arranged;
}
}
