// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridAxes.h"
#include "GridOutput.h"
#include "GridWriters.h"

#include <algorithm>
#include <array>
#include <cmath>

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
void WriteZmap(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, FirstZmapNull, "ZMAP+");
  const Axes axes = RequireAxes(grid.Lattice, "ZMAP+");
  const Layout layout = FindLayout(grid.Z);
  GridOutput output(stream, monitor, static_cast<std::int64_t>(grid.Z.size()));
  WriteHeader(output, grid.Name, axes, layout);
  PrintColumns(grid, axes, ZmapValuesInLine, layout.Width, layout.Null, output);
  output.Finish();
}
}
