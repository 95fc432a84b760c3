// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonMeshWriter.h"

#include "Common/Text/InputFile.h"
#include "HorizonMesh.h"
#include "Writers/XMLPrinter.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonMeshWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonMeshWriter::PrintHorizons(
  const std::vector<WrittenHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const std::string format = ExtensionOf(this->GetFileName());
  if (format == "vtp")
  {
    PrintXML<vtkXMLPolyDataWriter>(horizons.front().Data, stream);
    return;
  }
  PrintMesh(ToPlain(horizons).front(), format, stream, monitor);
}
