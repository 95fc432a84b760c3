// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonGridPrinter.h"

#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"
#include "GridWriters.h"

#include <algorithm>
#include <filesystem>

namespace SeismicHorizons
{
namespace
{
constexpr double LargestRounding = 0.01; // Fraction of a step by which nodes may move without a warning.
}

//----------------------------------------------------------------------------------------------------------------------
GridFileKind ChooseFormat(GridFileKind format, const std::string& path)
{
  if (format != GridFileKind::ByExtension)
  {
    return format;
  }
  const std::string extension = ToLower(std::filesystem::u8path(path).extension().u8string());
  if (extension == ".gri" || extension == ".irapbin")
  {
    return GridFileKind::IrapBinary;
  }
  return extension == ".zmap" || extension == ".zmp" ? GridFileKind::Zmap : GridFileKind::IrapText;
}

//----------------------------------------------------------------------------------------------------------------------
WrittenGrid MakeWrittenGrid(
  const NamedHorizon& horizon, GridFileKind format, WrittenSense sense, const Monitor& monitor)
{
  WrittenGrid written;
  HorizonGrid& grid = written.Grid;
  grid = SampleWholeLattice(horizon.Data, VerticalSign(horizon.Data, sense), monitor.Step(0.0, 0.5));
  grid.Name = horizon.Name;
  const SurveyLattice& lattice = grid.Lattice;
  if (format == GridFileKind::Zmap && !IsAlongAxes(lattice))
  {
    grid = MakeUpright(grid, monitor.Step(0.5, 0.6));
    written.Warnings.push_back(horizon.Name + ": ZMAP+ has no rotation: resampled on a lattice along the axes of " +
      std::to_string(lattice.Columns[0]) + " x " + std::to_string(lattice.Columns[1]) +
      " nodes; IRAP keeps the lattice");
  }
  const double rounding = RoundingOf(lattice);
  if (format == GridFileKind::IrapBinary &&
    rounding > LargestRounding * std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm()))
  {
    written.Warnings.push_back(horizon.Name + ": places are rounded to single precision, by up to " +
      ShortestText(rounding) + "; IRAP text keeps them");
  }
  return written;
}

//----------------------------------------------------------------------------------------------------------------------
void PrintGrid(const HorizonGrid& grid, GridFileKind format, std::ostream& stream, const Monitor& monitor)
{
  const auto write = format == GridFileKind::Zmap ? WriteZmap
    : format == GridFileKind::IrapBinary          ? WriteIrapBinary
                                                  : WriteIrapText;
  write(stream, grid, monitor);
}
}
