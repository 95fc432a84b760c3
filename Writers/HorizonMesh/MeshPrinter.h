// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Documentation/Formats.md describes the formats. Coordinates have all digits of double precision. Functions
// throw InputError for coordinates that are not finite.

#ifndef SeismicHorizonsMeshPrinter_h
#define SeismicHorizonsMeshPrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <ostream>

namespace SeismicHorizons
{
/// ASCII, since binary STL has single precision, half a metre for coordinates of millions.
void PrintSTL(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());

/// Binary, in the byte order of this machine.
void PrintPLY(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());

void PrintOBJ(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
