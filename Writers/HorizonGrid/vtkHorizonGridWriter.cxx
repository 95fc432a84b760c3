// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonGridWriter.h"

#include "Common/Base/Monitor.h"
#include "HorizonGridPrinter.h"

#include "vtkObjectFactory.h"

#include <string>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonGridWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonGridWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const std::string file = this->GetFileName();
  const GridFileKind format = ChooseFormat(static_cast<GridFileKind>(this->Format), file);
  const WrittenGrid written = MakeWrittenGrid(ToPlain(horizons).front(), format, this->Sense(), monitor);
  for (const std::string& warning : written.Warnings)
  {
    vtkWarningMacro(<< file << ": " << warning);
  }
  PrintGrid(written.Grid, format, stream, monitor.Step(0.6, 1.0));
}
