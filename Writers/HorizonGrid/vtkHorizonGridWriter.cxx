// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonGridWriter.h"

#include "Common/Monitor.h"
#include "Common/TextWords.h"
#include "GridWriters.h"
#include "HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <array>
#include <filesystem>
#include <string>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonGridWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const NamedHorizon& horizon = horizons.front();
  HorizonGrid grid = SampleWholeLattice(horizon.Data, this->VerticalSign(horizon.Data), monitor.Step(0.0, 0.5));
  grid.Name = horizon.Name;
  (this->WritesZmap() ? WriteZmap : WriteIrapText)(stream, grid, monitor.Step(0.5, 1.0));
}

//----------------------------------------------------------------------------------------------------------------------
bool vtkHorizonGridWriter::WritesZmap()
{
  if (this->Format != ByExtension)
  {
    return this->Format == Zmap;
  }
  const std::string file = this->GetFileName() ? this->GetFileName() : "";
  const std::string extension = ToLower(std::filesystem::u8path(file).extension().u8string());
  return extension == ".zmap" || extension == ".zmp";
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  constexpr std::array<const char*, 3> formats = { "ByExtension", "IrapText", "Zmap" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Format: " << formats[static_cast<std::size_t>(this->Format)] << '\n';
}
