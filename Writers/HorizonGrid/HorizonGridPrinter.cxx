// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonGridPrinter.h"

#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"
#include "GridWriters.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<std::pair<std::string_view, GridFileKind>, 8> Extensions = {
  { { ".gri", GridFileKind::IrapBinary }, { ".irapbin", GridFileKind::IrapBinary }, { ".zmap", GridFileKind::Zmap },
    { ".zmp", GridFileKind::Zmap }, { ".cps3", GridFileKind::Cps3 }, { ".cps", GridFileKind::Cps3 },
    { ".grd", GridFileKind::Surfer }, { ".asc", GridFileKind::Esri } }
};
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
  const auto found = std::find_if(
    Extensions.begin(), Extensions.end(), [&extension](const auto& known) { return extension == known.first; });
  return found == Extensions.end() ? GridFileKind::IrapText : found->second;
}

//----------------------------------------------------------------------------------------------------------------------
WrittenGrid MakeWrittenGrid(
  const NamedHorizon& horizon, GridFileKind format, WrittenSense sense, const Monitor& monitor)
{
  WrittenGrid written;
  HorizonGrid& grid = written.Grid;
  const bool isUpright = format == GridFileKind::Esri && sense == WrittenSense::AsRead;
  grid = SampleWholeLattice(horizon.Data, isUpright ? 1 : VerticalSign(horizon.Data, sense), monitor.Step(0.0, 0.5));
  grid.Name = horizon.Name;
  const SurveyLattice& lattice = grid.Lattice;
  const bool canTurn = format == GridFileKind::IrapText || format == GridFileKind::IrapBinary;
  if (!canTurn && !IsAlongAxes(lattice))
  {
    grid = MakeUpright(grid, monitor.Step(0.5, 0.6));
    written.Warnings.push_back(horizon.Name +
      ": the format has no rotation: resampled on a lattice along the axes of " + std::to_string(lattice.Columns[0]) +
      " x " + std::to_string(lattice.Columns[1]) + " nodes; IRAP keeps the lattice");
  }
  const double rounding = RoundingOf(lattice);
  if (format == GridFileKind::IrapBinary &&
    rounding > LargestRounding * std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm()))
  {
    written.Warnings.push_back(horizon.Name + ": coordinates are rounded to single precision, by up to " +
      ShortestText(rounding) + "; IRAP text keeps them");
  }
  return written;
}

//----------------------------------------------------------------------------------------------------------------------
void PrintGrid(const HorizonGrid& grid, GridFileKind format, std::ostream& stream, const Monitor& monitor)
{
  const auto write = format == GridFileKind::Zmap ? WriteZmap
    : format == GridFileKind::IrapBinary          ? WriteIrapBinary
    : format == GridFileKind::Cps3                ? WriteCps3
    : format == GridFileKind::Surfer              ? WriteSurfer
    : format == GridFileKind::Esri                ? WriteEsri
                                                  : WriteIrapText;
  write(stream, grid, monitor);
}
}
