// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints sealed models (Documentation/HorizonSealedModel.md). Coordinates have all digits of double precision.

#ifndef SeismicHorizonsModelPrinters_h
#define SeismicHorizonsModelPrinters_h

#include "Filters/Sealing/ModelTopology.h"
#include "Writers/HorizonLayers/LayersPrinter.h"

#include <ostream>
#include <set>

namespace SeismicHorizons
{
/// Model3d of GOCAD, with the numbers of bodies as regions, layers and fault blocks.
void PrintModel3d(
  const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor = Monitor());

/// ASCII of Gmsh 4.1. Each body is a named physical volume, and each surface a named physical surface.
void PrintModelGmsh(
  const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor = Monitor());

/// ASCII, with a solid for each body.
void PrintModelSTL(
  const ClosedModel& model, const ModelTopology& topology, std::ostream& stream, const Monitor& monitor = Monitor());

// ---- For the printers --------------------------------------------------------------------------------------------
/// Names that differ from each other, and from those `taken`. Underscores replace quotation marks and what is `unfit`.
template <typename Item>
std::vector<std::string> NameDifferently(
  const std::vector<Item>& items, const std::string& unfit, std::set<std::string> taken = {})
{
  std::vector<std::string> names;
  for (const Item& item : items)
  {
    std::string first = item.Name.empty() ? "_" : WithoutQuotes(item.Name);
    std::replace_if(
      first.begin(), first.end(), [&](char c) { return unfit.find(c) != std::string::npos; }, '_');
    names.push_back(first);
    for (int number = 2; !taken.insert(names.back()).second; ++number)
    {
      names.back() = first + '_' + std::to_string(number);
    }
  }
  return names;
}
}

#endif
