// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonDXF.h"

#include "Common/Base/Errors.h"
#include "DXFPrinter.h"
#include "Writers/FaultParts.h"
#include "Writers/GOCADTSurf/HorizonTSurf.h"

#include <cstddef>
#include <string>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void PrintDXF(const std::vector<NamedHorizon>& given, std::ostream& stream, const Monitor& monitor)
{
  const std::vector<NamedHorizon> horizons = SplitByFault(given);
  const std::vector<std::string> names = NamesOf(horizons);
  const std::vector<std::string> layers = MakeLayerNames(names);
  TextPrinter out(stream);
  PrintDXFBegin(layers, out);
  const auto size = double(horizons.size());
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    PrefixErrors(names[n],
      [&]()
      {
        const TSurf surface = MakeTSurf(horizons[n].Data, names[n], VerticalPositive::Elevation);
        PrintDXFFaces(surface, layers[n], out, monitor.Step(double(n) / size, double(n + 1) / size));
      });
  }
  PrintDXFEnd(out);
}
}
