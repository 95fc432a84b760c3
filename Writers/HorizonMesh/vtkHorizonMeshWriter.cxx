// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonMeshWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Text/InputFile.h"
#include "MeshPrinter.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"
#include "Writers/XMLPrinter.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonMeshWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonMeshWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  const std::string format = ExtensionOf(this->GetFileName());
  const NamedHorizon& horizon = horizons.front();
  if (format == "vtp")
  {
    PrintXML<vtkXMLPolyDataWriter>(horizon.Data, stream);
    return;
  }
  const auto print = format == "stl" ? PrintSTL : format == "ply" ? PrintPLY : format == "obj" ? PrintOBJ : nullptr;
  if (!print)
  {
    throw InputError("extension \"" + format + "\", expected vtp, stl, ply or obj");
  }
  PrefixErrors(horizon.Name,
    [&]() { print(MakeTSurf(horizon.Data, horizon.Name, VerticalPositive::Elevation), stream, monitor); });
}
