// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces in GOCAD's text format (Documentation/GOCADTSurfWriter.md). Ids count up from 1.
// Coordinates and values have all digits that reading them back takes.

#ifndef SeismicHorizonsTSurfPrinter_h
#define SeismicHorizonsTSurfPrinter_h

#include "Common/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <ostream>

namespace SeismicHorizons
{
/// Prints the object of a surface: vertices that no triangle has are left out, values that are not finite become a
/// number that no vertex has as a value. `withBorders` adds the border, as FindBorders makes it out of the triangles;
/// what the surface itself says of borders is not looked at. Throws InputError on coordinates that are not finite, on
/// names and units that the format cannot hold, and when the stream takes no more.
void PrintTSurf(const TSurf& surface, bool withBorders, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
