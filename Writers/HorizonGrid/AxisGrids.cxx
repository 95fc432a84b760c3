// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "GridAxes.h"
#include "GridOutput.h"
#include "GridWriters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Values from here on mean none in each format; a little less for single precision.
constexpr double FirstCps3Null = 9.9e29;
constexpr std::string_view Cps3Null = "1.0E+30";
constexpr double FirstSurferNull = 1.7014e38;
constexpr double EsriNull = -9999.0;
constexpr int CpsValuesInLine = 5;

double StepOf(const Axis& axis)
{
  return axis.Count > 1 ? (axis.Last - axis.First) / (axis.Count - 1) : 1.0;
}

std::pair<double, double> RangeOf(const HorizonGrid& grid)
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const double z : grid.Z)
  {
    least = z < least ? z : least;
    most = z > most ? z : most;
  }
  return { least, most };
}

std::string PairOf(double first, double second)
{
  return ToDecimal(first) + ' ' + ToDecimal(second);
}

/// A line for each row, from the south or from the north.
void PrintRows(const HorizonGrid& grid, const Axes& axes, bool isFromNorth, const std::string& null, GridOutput& output)
{
  for (int n = 0; n < axes.Y.Count; ++n)
  {
    const int row = isFromNorth ? axes.Y.Count - 1 - n : n;
    for (int column = 0; column < axes.X.Count; ++column)
    {
      const double z = grid.Z[std::size_t(axes.At(column, row))];
      output.Write(column > 0 ? " " : "");
      output.WriteValue(std::isnan(z) ? std::string_view(null) : DecimalText(z).View(), 0);
    }
    output.EndLine();
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void WriteCps3(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, FirstCps3Null, "CPS-3");
  const Axes axes = RequireAxes(grid.Lattice, "CPS-3");
  const auto [least, most] = RangeOf(grid);
  GridOutput output(stream, monitor, std::int64_t(grid.Z.size()));
  output.WriteLine("FSASCI 0 1 \"Computed\" 0 1.0E+30 0\nFSATTR 0 0");
  output.WriteLine("FSLIMI " + PairOf(axes.X.First, axes.X.Last) + ' ' + PairOf(axes.Y.First, axes.Y.Last) + ' ' +
    PairOf(least, most));
  output.WriteLine("FSNROW " + std::to_string(axes.Y.Count) + ' ' + std::to_string(axes.X.Count));
  output.WriteLine("FSXINC " + PairOf(StepOf(axes.X), StepOf(axes.Y)));
  std::string name = grid.Name;
  std::replace_if(
    name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  output.WriteLine("->" + name);
  std::size_t width = Cps3Null.size();
  for (const double z : grid.Z)
  {
    width = std::isnan(z) ? width : std::max(width, DecimalText(z).View().size());
  }
  PrintColumns(grid, axes, CpsValuesInLine, width + 1, std::string(Cps3Null), output);
  output.Finish();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteSurfer(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, FirstSurferNull, "Surfer");
  const Axes axes = RequireAxes(grid.Lattice, "Surfer");
  const auto [least, most] = RangeOf(grid);
  GridOutput output(stream, monitor, std::int64_t(grid.Z.size()));
  output.WriteLine("DSAA\n" + std::to_string(axes.X.Count) + ' ' + std::to_string(axes.Y.Count));
  output.WriteLine(
    PairOf(axes.X.First, axes.X.Last) + '\n' + PairOf(axes.Y.First, axes.Y.Last) + '\n' + PairOf(least, most));
  PrintRows(grid, axes, false, "1.70141E+38", output);
  output.Finish();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteEsri(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, std::numeric_limits<double>::max(), "Esri ASCII");
  const Axes axes = RequireAxes(grid.Lattice, "Esri ASCII");
  const std::array<double, 2> steps = { StepOf(axes.X), StepOf(axes.Y) };
  double null = EsriNull;
  while (std::any_of(grid.Z.begin(), grid.Z.end(), [null](double z) { return z <= 0.99 * null; }))
  {
    null = 10.0 * null - 9.0;
  }
  GridOutput output(stream, monitor, std::int64_t(grid.Z.size()));
  output.WriteLine("ncols " + std::to_string(axes.X.Count) + "\nnrows " + std::to_string(axes.Y.Count));
  output.WriteLine("xllcenter " + ToDecimal(axes.X.First) + "\nyllcenter " + ToDecimal(axes.Y.First));
  output.WriteLine(std::abs(steps[0] - steps[1]) <= 1e-9 * steps[0]
      ? "cellsize " + ToDecimal(steps[0])
      : "dx " + ToDecimal(steps[0]) + "\ndy " + ToDecimal(steps[1]));
  output.WriteLine("NODATA_value " + ToDecimal(null));
  PrintRows(grid, axes, true, ToDecimal(null), output);
  output.Finish();
}
}
