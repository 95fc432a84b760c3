// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonTextWriter.h"

#include "HorizonText.h"

#include "vtkObjectFactory.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonTextWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonTextWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  PrintHorizonText(ToPlain(horizons), { this->Sense(), this->WriteAttributes }, stream, monitor);
}
