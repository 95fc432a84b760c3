// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "GridOutput.h"
#include "GridWriters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace SeismicHorizons
{
namespace
{
constexpr double FirstZmapNull = 9.9e29; // Readers compare in single precision.
// The first one well below all values is used. Single precision holds all but the last, which some readers take for a
// value.
constexpr std::array<double, 3> Nulls = { -99999.0, -999999.0, -9999999.0 };
constexpr std::string_view LastNull = "1.0E+30";
constexpr int ZmapValuesInLine = 5;
constexpr std::size_t SmallestWidth = 15; // characters, as other programs write
constexpr double LargestTilt = 0.01; // Fraction of a step by which nodes may move to be along the axes.

struct Axis
{
  int Count = 0;
  double First = 0.0;
  double Last = 0.0;
  std::int64_t FirstIndex = 0; // Index in HorizonGrid::Z.
  std::int64_t IndexStep = 0;
};

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

struct Axes
{
  Axis X;
  Axis Y;
};

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

struct Layout
{
  std::size_t Width = SmallestWidth;
  std::size_t Decimals = 1;
  std::string Null;
};

std::string ChooseZmapNull(const std::vector<double>& values)
{
  const auto isAbove = [&values](double null)
  { return std::all_of(values.begin(), values.end(), [null](double z) { return !(z <= 0.99 * null); }); };
  const auto* const null = std::find_if(Nulls.begin(), Nulls.end(), isAbove);
  return null == Nulls.end() ? std::string(LastNull) : ToDecimal(*null);
}

Layout FindLayout(const std::vector<double>& values)
{
  Layout layout;
  layout.Null = ChooseZmapNull(values);
  for (const double z : values)
  {
    const DecimalText text(std::isnan(z) ? 0.0 : z);
    const std::size_t decimals = text.View().size() - std::min(text.View().find('.') + 1, text.View().size());
    layout.Width = std::max(layout.Width, text.View().size() + 1);
    layout.Decimals = std::max(layout.Decimals, decimals);
  }
  return layout;
}

void WriteHeader(GridOutput& output, std::string name, const Axes& axes, const Layout& layout)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == ',' || c == '@' || static_cast<unsigned char>(c) < ' '; }, ' ');
  output.WriteLine('@' + name + " HEADER, GRID, " + std::to_string(ZmapValuesInLine));
  output.WriteLine(
    std::to_string(layout.Width) + ", " + layout.Null + ", , " + std::to_string(layout.Decimals) + ", 1");
  output.WriteLine(std::to_string(axes.Y.Count) + ", " + std::to_string(axes.X.Count) + ", " + ToDecimal(axes.X.First) +
    ", " + ToDecimal(axes.X.Last) + ", " + ToDecimal(axes.Y.First) + ", " + ToDecimal(axes.Y.Last));
  output.WriteLine("0.0, 0.0, 0.0");
  output.WriteLine("@");
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsAlongAxes(const SurveyLattice& lattice)
{
  return FindAxes(lattice).has_value();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteZmap(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, FirstZmapNull, "ZMAP+");
  const std::optional<Axes> found = FindAxes(grid.Lattice);
  if (!found)
  {
    throw InputError("a rotated or sheared lattice, expected a lattice along the axes for ZMAP+; use IRAP");
  }
  const Axes& axes = *found;
  const Layout layout = FindLayout(grid.Z);
  GridOutput output(stream, monitor, static_cast<std::int64_t>(grid.Z.size()));
  WriteHeader(output, grid.Name, axes, layout);
  for (int column = 0; column < axes.X.Count; ++column)
  {
    const std::int64_t first = axes.X.FirstIndex + column * axes.X.IndexStep + axes.Y.FirstIndex;
    for (int row = axes.Y.Count - 1; row >= 0; --row)
    {
      const double z = grid.Z[static_cast<std::size_t>(first + row * axes.Y.IndexStep)];
      output.WriteValue(std::isnan(z) ? std::string_view(layout.Null) : DecimalText(z).View(), layout.Width);
      const bool isLast = row == 0 || (axes.Y.Count - row) % ZmapValuesInLine == 0;
      if (isLast)
      {
        output.EndLine();
      }
    }
  }
  output.Finish();
}
}
