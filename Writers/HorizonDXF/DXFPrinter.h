// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces as drawings of AutoCAD R12 (AC1009), which all DXF programs read
// (Documentation/Formats.md). Coordinates have the digits that restore them exactly.

#ifndef SeismicHorizonsDXFPrinter_h
#define SeismicHorizonsDXFPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"
#include "Common/Text/TextPrinter.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Names have at most 31 ASCII letters, digits, "-" and "_"; "_" replaces other characters. Layers ignore case, so that
/// repeated names get "_2", "_3" and so on.
std::vector<std::string> MakeLayerNames(const std::vector<std::string>& names);

void PrintDXFBegin(const std::vector<std::string>& layers, TextPrinter& out);

/// Each triangle is a 3DFACE. Throws InputError for coordinates that are not finite.
void PrintDXFFaces(
  const TSurf& surface, const std::string& layer, TextPrinter& out, const Monitor& monitor = Monitor());

void PrintDXFEnd(TextPrinter& out);
}

#endif
