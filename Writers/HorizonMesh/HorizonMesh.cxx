// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonMesh.h"

#include "Common/Base/Errors.h"
#include "MeshPrinter.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void PrintMesh(const NamedHorizon& horizon, const std::string& format, std::ostream& stream, const Monitor& monitor)
{
  const auto print = format == "stl" ? PrintSTL : format == "ply" ? PrintPLY : format == "obj" ? PrintOBJ : nullptr;
  if (!print)
  {
    throw InputError("extension \"" + format + "\", expected vtp, stl, ply or obj");
  }
  PrefixErrors(horizon.Name,
    [&]() { print(MakeTSurf(horizon.Data, horizon.Name, VerticalPositive::Elevation), stream, monitor); });
}
}
