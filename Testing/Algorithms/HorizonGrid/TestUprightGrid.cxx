// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids on turned and sheared lattices become grids along the axes: planes stay planes, and what is empty stays empty.

#include "GridSamples.h"
#include "Tools/MonitorChecker.h"
#include "Writers/HorizonGrid/GridWriters.h"

#include <Eigen/LU>

using namespace GridSamples;
using namespace SeismicHorizons;

namespace
{
double Plane(const Eigen::Vector2d& place)
{
  return 1500.0 + 0.25 * (place.x() - 604321.25) - 0.125 * (place.y() - 6079543.5);
}

Eigen::Vector2d PlaceOf(const SurveyLattice& lattice, int i, int j)
{
  return lattice.Origin + i * lattice.ColumnStep + j * lattice.RowStep;
}

/// A plane over a lattice of steps of 12.5 and 25, with a hole and a corner that is missing.
HorizonGrid MakePlane(double degrees, double shear, double side)
{
  const double angle = degrees * std::acos(-1.0) / 180.0;
  HorizonGrid grid;
  grid.Name = "top";
  grid.Lattice.Columns = { 40, 30 };
  grid.Lattice.Origin = { 604321.25, 6079543.5 };
  grid.Lattice.ColumnStep = 12.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  grid.Lattice.RowStep =
    side * 25.0 * Eigen::Vector2d(-std::sin(angle), std::cos(angle)) + shear * grid.Lattice.ColumnStep;
  for (int j = 0; j < 30; ++j)
  {
    for (int i = 0; i < 40; ++i)
    {
      const bool isEmpty = (i > 10 && i < 16 && j > 8 && j < 12) || i + j < 9;
      grid.Z.push_back(isEmpty ? None : Plane(PlaceOf(grid.Lattice, i, j)));
    }
  }
  return grid;
}

/// By another way than the code: whether the columns of the cell around a place all have values.
bool IsWithinValues(const HorizonGrid& grid, const Eigen::Vector2d& place)
{
  const Eigen::Vector2d at = grid.Lattice.Steps().fullPivLu().solve(place - grid.Lattice.Origin);
  constexpr double nearness = 1e-6;
  for (int j = int(std::floor(at.y() + nearness)); j <= int(std::ceil(at.y() - nearness)); ++j)
  {
    for (int i = int(std::floor(at.x() + nearness)); i <= int(std::ceil(at.x() - nearness)); ++i)
    {
      const bool isColumn = i >= 0 && j >= 0 && i < grid.Lattice.Columns[0] && j < grid.Lattice.Columns[1];
      if (!isColumn || std::isnan(grid.Z[std::size_t(i + j * grid.Lattice.Columns[0])]))
      {
        return false;
      }
    }
  }
  return true;
}

void PlanesStayPlanesAndHolesHoles()
{
  for (const double degrees : { 0.0, 30.0, 45.0, 90.0, 117.0, 180.0, -63.0 })
  {
    for (const double shear : { 0.0, 0.4 })
    {
      for (const double side : { 1.0, -1.0 })
      {
        const HorizonGrid grid = MakePlane(degrees, shear, side);
        const HorizonGrid upright = MakeUpright(grid);
        CHECK(IsAlongAxes(upright.Lattice));
        CHECK_EQUAL(upright.Name, "top");
        std::size_t values = 0;
        double off = 0.0;
        for (int j = 0; j < upright.Lattice.Columns[1]; ++j)
        {
          for (int i = 0; i < upright.Lattice.Columns[0]; ++i)
          {
            const Eigen::Vector2d place = PlaceOf(upright.Lattice, i, j);
            const double z = upright.Z[std::size_t(i + j * upright.Lattice.Columns[0])];
            CHECK_EQUAL(!std::isnan(z), IsWithinValues(grid, place));
            values += std::isnan(z) ? 0 : 1;
            off = std::max(off, std::isnan(z) ? 0.0 : std::abs(z - Plane(place)));
          }
        }
        CHECK(off < 1e-6);
        CHECK(values > 900 && values <= 1200); // 1140 columns have values
      }
    }
  }
}

/// Nodes that are columns have their values, and nothing is lost.
void TurnsByRightAnglesKeepAll()
{
  for (const double degrees : { 0.0, 90.0, 180.0, 270.0 })
  {
    const HorizonGrid grid = MakePlane(degrees, 0.0, 1.0);
    const HorizonGrid upright = MakeUpright(grid);
    const auto count = [](const HorizonGrid& of)
    { return std::count_if(of.Z.begin(), of.Z.end(), [](double z) { return std::isnan(z); }); };
    CHECK_EQUAL(upright.Z.size(), grid.Z.size());
    CHECK_EQUAL(count(upright), count(grid));
  }
}

void GridsWithoutNodesAreRefused()
{
  HorizonGrid line = MakePlane(30.0, 0.0, 1.0);
  line.Lattice.Columns = { 40, 1 };
  line.Z.assign(40, None);
  CHECK_THROWS_WITH(
    MakeUpright(line), "nodes along the axes between columns with values, expected at least one; use IRAP");
  line.Lattice.Columns = { 1000000, 1 };
  line.Z.assign(1000000, 1.0);
  CHECK_THROWS_WITH(MakeUpright(line), " x 250000 nodes, expected at most 100000000 in all for 1000000 x 1 columns");
}

void WorkIsMonitored()
{
  const HorizonGrid grid = MakePlane(30.0, 0.0, 1.0);
  CHECK_EQUAL(MonitorChecker::Check(10, [&](const Monitor& monitor) { MakeUpright(grid, monitor); }), std::string());
}
}

int TestUprightGrid(int, char*[])
{
  PlanesStayPlanesAndHolesHoles();
  TurnsByRightAnglesKeepAll();
  GridsWithoutNodesAreRefused();
  WorkIsMonitored();
  return Check::Result();
}
