// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "GridWriters.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr double Nearness = 1e-6; // In columns; world coordinates are rounded.
// The larger of both limits on nodes applies.
constexpr double EnoughNodes = 1 << 22;
constexpr double MostNodesPerColumn = 100;

struct Position
{
  int First = 0;
  double Part = 0.0; // Fraction of a step; 0 on the last column.
  bool IsInside = false;

  Position(double place, int columns)
  {
    const double nearest = std::round(place);
    const double snapped = std::abs(place - nearest) <= Nearness ? nearest : place;
    this->IsInside = snapped >= 0.0 && snapped <= columns - 1;
    if (this->IsInside)
    {
      this->First = static_cast<int>(snapped);
      this->Part = snapped - this->First;
    }
  }
};

/// Returns nan if a column with a weight has no value.
double Interpolate(const HorizonGrid& grid, const Position& i, const Position& j)
{
  double z = 0.0;
  for (const int side : { 0, 1, 2, 3 })
  {
    const double weight = (side % 2 == 0 ? 1.0 - i.Part : i.Part) * (side < 2 ? 1.0 - j.Part : j.Part);
    if (weight > 0.0)
    {
      const auto column = static_cast<std::size_t>(i.First + side % 2);
      const auto row = static_cast<std::size_t>(j.First + side / 2);
      z += weight * grid.Z[column + row * static_cast<std::size_t>(grid.Lattice.Columns[0])];
    }
  }
  return z;
}

SurveyLattice FindUpright(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  const Eigen::Vector2d acrossI = (lattice.Columns[0] - 1) * i;
  const Eigen::Vector2d acrossJ = (lattice.Columns[1] - 1) * j;
  const Eigen::Vector2d least = acrossI.cwiseMin(0.0) + acrossJ.cwiseMin(0.0);
  const Eigen::Vector2d extent = acrossI.cwiseAbs() + acrossJ.cwiseAbs();
  const bool isSwapped = std::abs(i.x() * j.y()) < std::abs(i.y() * j.x());
  const Eigen::Vector2d steps = isSwapped ? Eigen::Vector2d(j.norm(), i.norm()) : Eigen::Vector2d(i.norm(), j.norm());
  const Eigen::Array2d nodes = (extent.array() / steps.array() + Nearness).floor() + 1.0;
  const double columns = double(lattice.Columns[0]) * lattice.Columns[1];
  const double most =
    std::min<double>(std::max(EnoughNodes, MostNodesPerColumn * columns), std::numeric_limits<std::int32_t>::max());
  if (!(nodes.prod() <= most))
  {
    throw InputError("a lattice along the axes of " + std::to_string(std::int64_t(nodes[0])) + " x " +
      std::to_string(std::int64_t(nodes[1])) + " nodes, expected at most " + std::to_string(std::int64_t(most)) +
      " in all for " + std::to_string(lattice.Columns[0]) + " x " + std::to_string(lattice.Columns[1]) +
      " columns that are turned; use IRAP");
  }
  SurveyLattice upright;
  upright.Columns = { static_cast<int>(nodes[0]), static_cast<int>(nodes[1]) };
  upright.Origin = lattice.Origin + least;
  upright.ColumnStep = { steps[0], 0.0 };
  upright.RowStep = { 0.0, steps[1] };
  return upright;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid MakeUpright(const HorizonGrid& grid, const Monitor& monitor)
{
  const SurveyLattice& lattice = grid.Lattice;
  HorizonGrid upright;
  upright.Name = grid.Name;
  upright.Survey = grid.Survey;
  upright.Lattice = FindUpright(lattice);
  const auto [columns, rows] = upright.Lattice.Columns;
  upright.Z.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const Eigen::Matrix2d toLattice = lattice.Steps().inverse();
  for (int row = 0; row < rows; ++row)
  {
    monitor.Progress(static_cast<double>(row) / rows);
    for (int column = 0; column < columns; ++column)
    {
      const Eigen::Vector2d fromOrigin =
        upright.Lattice.Origin - lattice.Origin + column * upright.Lattice.ColumnStep + row * upright.Lattice.RowStep;
      const Eigen::Vector2d place = toLattice * fromOrigin;
      const Position i(place.x(), lattice.Columns[0]);
      const Position j(place.y(), lattice.Columns[1]);
      upright.Z.push_back(
        i.IsInside && j.IsInside ? Interpolate(grid, i, j) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  if (std::all_of(upright.Z.begin(), upright.Z.end(), [](double z) { return std::isnan(z); }))
  {
    throw InputError("none of " + std::to_string(columns) + " x " + std::to_string(rows) +
      " nodes along the axes between columns with values, expected at least one; use IRAP");
  }
  return upright;
}
}
