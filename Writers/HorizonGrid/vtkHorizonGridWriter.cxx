// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonGridWriter.h"

#include "Common/Base/Monitor.h"
#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"
#include "GridWriters.h"
#include "Writers/HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <filesystem>
#include <string>

using namespace SeismicHorizons;

namespace
{
constexpr double LargestRounding = 0.01; // Fraction of a step by which nodes may move without a warning.
}

vtkStandardNewMacro(vtkHorizonGridWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const NamedHorizon& horizon = horizons.front();
  HorizonGrid grid = SampleWholeLattice(horizon.Data, this->VerticalSign(horizon.Data), monitor.Step(0.0, 0.5));
  grid.Name = horizon.Name;
  const GridKind kind = this->ChooseFormat();
  const Monitor writing = monitor.Step(0.6, 1.0);
  if (kind == Zmap)
  {
    if (!IsAlongAxes(grid.Lattice))
    {
      grid = MakeUpright(grid, monitor.Step(0.5, 0.6));
      vtkWarningMacro(<< this->GetFileName() << ": " << horizon.Name
                      << ": ZMAP+ has no rotation: resampled on a lattice along the axes of " << grid.Lattice.Columns[0]
                      << " x " << grid.Lattice.Columns[1] << " nodes; IRAP keeps the lattice");
    }
    WriteZmap(stream, grid, writing);
  }
  else if (kind == IrapBinary)
  {
    const SurveyLattice& lattice = grid.Lattice;
    const double rounding = RoundingOf(lattice);
    if (rounding > LargestRounding * std::min(lattice.ColumnStep.norm(), lattice.RowStep.norm()))
    {
      vtkWarningMacro(<< this->GetFileName() << ": " << horizon.Name
                      << ": places are rounded to single precision, by up to " << ShortestText(rounding)
                      << "; IRAP text keeps them");
    }
    WriteIrapBinary(stream, grid, writing);
  }
  else
  {
    WriteIrapText(stream, grid, writing);
  }
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonGridWriter::GridKind vtkHorizonGridWriter::ChooseFormat()
{
  if (this->Format != ByExtension)
  {
    return static_cast<GridKind>(this->Format);
  }
  const std::string file = this->GetFileName() ? this->GetFileName() : "";
  const std::string extension = ToLower(std::filesystem::u8path(file).extension().u8string());
  if (extension == ".gri" || extension == ".irapbin")
  {
    return IrapBinary;
  }
  return extension == ".zmap" || extension == ".zmp" ? Zmap : IrapText;
}
