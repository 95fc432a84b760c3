// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces as drawings of AutoCAD R12 (AC1009), which all programs that know DXF read
// (Documentation/HorizonDXFWriter.md). Coordinates have all digits that reading them back takes.

#ifndef SeismicHorizonsDXFPrinter_h
#define SeismicHorizonsDXFPrinter_h

#include "Common/Monitor.h"
#include "Common/Survey/TSurf.h"
#include "Common/TextPrinter.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// The names of layers for surfaces: at most 31 letters of the English alphabet, digits, "-" and "_", other characters
/// as "_", with "_2", "_3" and so on behind those that came before, as layers know no case.
std::vector<std::string> MakeLayerNames(const std::vector<std::string>& names);

/// Up to the first triangle: the table of layers.
void PrintDXFBegin(const std::vector<std::string>& layers, TextPrinter& out);

/// The triangles of a surface on a layer, each as a 3DFACE. Throws InputError on coordinates that are not finite.
void PrintDXFFaces(
  const TSurf& surface, const std::string& layer, TextPrinter& out, const Monitor& monitor = Monitor());

/// From behind the last triangle on.
void PrintDXFEnd(TextPrinter& out);
}

#endif
