// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridAxes.h"

#include "Common/Base/Errors.h"
#include "GridWriters.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestTilt = 0.01; // Fraction of a step by which nodes may move to be along the axes.

/// `along` is the component of the step on the axis.
Axis MakeAxis(int count, double origin, double along, std::int64_t indexStep)
{
  const double end = origin + (count - 1) * along;
  const bool isBackwards = along < 0.0;
  Axis axis;
  axis.Count = count;
  axis.First = isBackwards ? end : origin;
  axis.Last = isBackwards ? origin : end;
  axis.FirstIndex = isBackwards ? (count - 1) * indexStep : 0;
  axis.IndexStep = isBackwards ? -indexStep : indexStep;
  return axis;
}

/// Tests the farthest node of a step with components `along` and `beside` the axis.
bool IsAlong(double along, double beside, int count, double otherStep)
{
  return std::fabs(beside) * (count - 1) <= LargestTilt * std::min(std::fabs(along), otherStep);
}

/// Either step may be along x.
std::optional<Axes> FindAxes(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  const std::int64_t rowIndex = lattice.Columns[0];
  if (IsAlong(i.x(), i.y(), lattice.Columns[0], j.norm()) && IsAlong(j.y(), j.x(), lattice.Columns[1], i.norm()))
  {
    return Axes{ MakeAxis(lattice.Columns[0], lattice.Origin.x(), i.x(), 1),
      MakeAxis(lattice.Columns[1], lattice.Origin.y(), j.y(), rowIndex) };
  }
  if (IsAlong(i.y(), i.x(), lattice.Columns[0], j.norm()) && IsAlong(j.x(), j.y(), lattice.Columns[1], i.norm()))
  {
    return Axes{ MakeAxis(lattice.Columns[1], lattice.Origin.x(), j.x(), rowIndex),
      MakeAxis(lattice.Columns[0], lattice.Origin.y(), i.y(), 1) };
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsAlongAxes(const SurveyLattice& lattice)
{
  return FindAxes(lattice).has_value();
}

//----------------------------------------------------------------------------------------------------------------------
Axes RequireAxes(const SurveyLattice& lattice, const std::string& format)
{
  const std::optional<Axes> found = FindAxes(lattice);
  if (!found)
  {
    throw InputError("a rotated or sheared lattice, expected a lattice along the axes for " + format + "; use IRAP");
  }
  return *found;
}

//----------------------------------------------------------------------------------------------------------------------
void PrintColumns(const HorizonGrid& grid, const Axes& axes, int valuesInLine, std::size_t width,
  const std::string& null, GridOutput& output)
{
  for (int column = 0; column < axes.X.Count; ++column)
  {
    for (int row = axes.Y.Count - 1; row >= 0; --row)
    {
      const double z = grid.Z[std::size_t(axes.At(column, row))];
      output.WriteValue(std::isnan(z) ? std::string_view(null) : DecimalText(z).View(), width);
      if (row == 0 || (axes.Y.Count - row) % valuesInLine == 0)
      {
        output.EndLine();
      }
    }
  }
}
}
