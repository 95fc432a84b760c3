// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTextWriter.h"

#include "HorizonText.h"
#include "Writers/FaultLines/FaultLinesFile.h"

#include "vtkObjectFactory.h"

#include <algorithm>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonTextWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonTextWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  PrintHorizonText(ToPlain(horizons), { this->Sense(), this->WriteAttributes }, stream, monitor);
}

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonTextWriter::WriteFiles(
  const std::string& path, const std::vector<WrittenHorizon>& horizons, const Monitor& monitor, std::string& subject)
{
  const std::vector<NamedHorizon> plain = ToPlain(horizons);
  if (!plain.empty() &&
    std::all_of(plain.begin(), plain.end(), [](const NamedHorizon& one) { return AreFaultLines(one.Data); }))
  {
    WriteFaultLines(path, plain, this->Sense(), monitor, subject);
    return;
  }
  this->Superclass::WriteFiles(path, horizons, monitor, subject);
}
