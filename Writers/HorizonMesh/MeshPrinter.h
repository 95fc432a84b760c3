// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints triangulated surfaces in formats of meshes without names (Documentation/HorizonMeshWriter.md). Coordinates
// have all digits of double precision. All throw InputError on coordinates that are not finite.

#ifndef SeismicHorizonsMeshPrinter_h
#define SeismicHorizonsMeshPrinter_h

#include "Common/Monitor.h"
#include "Common/Survey/TSurf.h"

#include <ostream>

namespace SeismicHorizons
{
/// Stereo lithography, as text: as bytes it has single precision, which is half a metre in coordinates of millions.
void PrintSTL(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());

/// The polygon file format, bytes in the order of this machine.
void PrintPLY(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());

/// The format of Wavefront.
void PrintOBJ(const TSurf& surface, std::ostream& stream, const Monitor& monitor = Monitor());
}

#endif
