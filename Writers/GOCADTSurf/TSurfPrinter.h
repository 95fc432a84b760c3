// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces in GOCAD's text format (Documentation/GOCADTSurfWriter.md). Ids start at 1. Numbers have
// the digits that restore them exactly.

#ifndef SeismicHorizonsTSurfPrinter_h
#define SeismicHorizonsTSurfPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <ostream>

namespace SeismicHorizons
{
/// Omits vertices without triangles. `withBorders` adds FindBorders instead of the surface's own borders. Throws
/// InputError for invalid coordinates, names and units, and if writing fails.
void PrintTSurf(const TSurf& surface, bool withBorders, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
