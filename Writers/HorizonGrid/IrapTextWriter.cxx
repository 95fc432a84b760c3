// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Errors.h"
#include "Common/TextNumbers.h"
#include "GridOutput.h"
#include "GridWriters.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr double Null = 9999900.0;
constexpr int ValuesInLine = 9; // more are too many for some programs
constexpr double LargestShift = 0.01; // of a step, that a node may be off for steps not quite at right angles

struct IrapLattice
{
  double ColumnStep = 0.0;
  double RowStep = 0.0; // negative when the lattice is seen in a mirror
  double Degrees = 0.0; // of the rotation, counterclockwise
};

/// Throws InputError when the steps are so far from right angles that the farthest node would move.
IrapLattice FindLattice(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  const double cross = i.x() * j.y() - i.y() * j.x();
  const double shear = std::fabs(i.stableNormalized().dot(j.stableNormalized()));
  if (!(shear * (lattice.Columns[1] - 1) <= LargestShift))
  {
    const double degrees = std::acos(shear) * (180.0 / std::acos(-1.0));
    throw InputError(
      "steps at " + ShortestText(std::round(100.0 * degrees) / 100.0) + " degrees, expected right angles for IRAP");
  }
  IrapLattice irap;
  irap.ColumnStep = i.stableNorm(); // squares of steps may be too large
  irap.RowStep = std::copysign(j.stableNorm(), cross);
  irap.Degrees = std::atan2(i.y(), i.x()) * (180.0 / std::acos(-1.0)) + 0.0; // not -0
  return irap;
}

void WriteHeader(GridOutput& output, const SurveyLattice& lattice, const IrapLattice& irap)
{
  const std::string x = ToDecimal(lattice.Origin.x());
  const std::string y = ToDecimal(lattice.Origin.y());
  const double xLast = lattice.Origin.x() + (lattice.Columns[0] - 1) * irap.ColumnStep;
  const double yLast = lattice.Origin.y() + (lattice.Columns[1] - 1) * irap.RowStep;
  output.Write(
    "-996 " + std::to_string(lattice.Columns[1]) + ' ' + ToDecimal(irap.ColumnStep) + ' ' + ToDecimal(irap.RowStep));
  output.EndLine();
  output.Write(x + ' ' + ToDecimal(xLast) + ' ' + y + ' ' + ToDecimal(yLast));
  output.EndLine();
  output.Write(std::to_string(lattice.Columns[0]) + ' ' + ToDecimal(irap.Degrees) + ' ' + x + ' ' + y);
  output.EndLine();
  output.Write("0 0 0 0 0 0 0");
  output.EndLine();
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteIrapText(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, Null, "IRAP");
  const IrapLattice lattice = FindLattice(grid.Lattice);
  GridOutput output(stream, monitor, static_cast<std::int64_t>(grid.Z.size()));
  WriteHeader(output, grid.Lattice, lattice);
  int inLine = 0;
  for (const double z : grid.Z)
  {
    output.WriteValue(DecimalText(std::isnan(z) ? Null : z).View(), 0);
    inLine = (inLine + 1) % ValuesInLine;
    inLine == 0 ? output.EndLine() : output.Write(" ");
  }
  output.EndLine();
  output.Finish();
}
}
