// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonDXFWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "DXFPrinter.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace SeismicHorizons;

vtkStandardNewMacro(vtkHorizonDXFWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkHorizonDXFWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  std::vector<std::string> names(horizons.size());
  std::transform(
    horizons.begin(), horizons.end(), names.begin(), [](const NamedHorizon& horizon) { return horizon.Name; });
  const std::vector<std::string> layers = MakeLayerNames(names);
  TextPrinter out(stream);
  PrintDXFBegin(layers, out);
  const auto size = static_cast<double>(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    PrefixErrors(names[n],
      [&]()
      {
        const TSurf surface = MakeTSurf(horizons[n].Data, names[n], VerticalPositive::Elevation);
        const Monitor step = monitor.Step(static_cast<double>(n) / size, static_cast<double>(n + 1) / size);
        PrintDXFFaces(surface, layers[n], out, step);
      });
  }
  PrintDXFEnd(out);
}
