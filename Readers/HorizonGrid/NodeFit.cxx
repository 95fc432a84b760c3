// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NodeFit.h"

#include "Common/Survey/PlaneFit.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextNumbers.h"

#include <algorithm>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double SmallestSine = 0.01; // Sine of the smallest angle between the steps; surveys are nearly rectangular.
constexpr double LargestShift = 0.1; // Fraction of a step, since coordinates are written with few digits.

void RequireArea(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  if (!(std::fabs(i.x() * j.y() - i.y() * j.x()) > SmallestSine * i.norm() * j.norm()))
  {
    throw InputError("columns and rows of nodes along the same line of x and y, expected a lattice in the plane");
  }
}

void RequireOnNodes(const std::vector<GridPoint>& points, const SurveyLattice& lattice)
{
  const double step = std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm());
  for (const GridPoint& point : points)
  {
    const Eigen::Vector2d node = lattice.Origin + point.I * lattice.ColumnStep + point.J * lattice.RowStep;
    const double shift = (point.Place - node).norm();
    if (!(shift <= LargestShift * step))
    {
      throw ErrorAt(point.Line,
        "a point " + ShortestText(shift) + " from its node, expected a regular lattice with points within " +
          ShortestText(LargestShift * step));
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
/// Distances from the first point are summed, so that large coordinates lose no digits.
SurveyLattice FitLattice(const std::vector<GridPoint>& points, const std::array<int, 2>& columns)
{
  PlaneFit fit;
  for (const GridPoint& point : points)
  {
    fit.Add({ point.I - points[0].I, point.J - points[0].J }, point.Place - points[0].Place);
  }
  const std::optional<PlaneMap> map = fit.Solve();
  if (!map)
  {
    throw InputError(
      std::to_string(points.size()) + " points in one line of nodes, expected at least three that are not");
  }
  SurveyLattice lattice;
  lattice.Columns = columns;
  lattice.ColumnStep = map->Steps.col(0);
  lattice.RowStep = map->Steps.col(1);
  lattice.Origin = points[0].Place + map->Origin - points[0].I * lattice.ColumnStep - points[0].J * lattice.RowStep;
  RequireArea(lattice);
  RequireOnNodes(points, lattice);
  return lattice;
}
}
