// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDXFWriter.h"

#include "HorizonDXF.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHorizonDXFWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonDXFWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const SeismicHorizons::Monitor& monitor)
{
  SeismicHorizons::PrintDXF(ToPlain(horizons), stream, monitor);
}
