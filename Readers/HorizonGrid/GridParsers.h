// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each function reads a file of one format from its start, and throws InputError if it violates the format.

#ifndef SeismicHorizonsGridParsers_h
#define SeismicHorizonsGridParsers_h

#include "Common/Survey/HorizonGrid.h"

namespace SeismicHorizons
{
class GridBytes;
class GridText;

HorizonGrid ReadIrapText(GridText& text);
HorizonGrid ReadZmap(GridText& text);
HorizonGrid ReadCps3(GridText& text);
HorizonGrid ReadEarthVision(GridText& text);
HorizonGrid ReadSurferText(GridText& text);
HorizonGrid ReadGxf(GridText& text);
HorizonGrid ReadEsriGrid(GridText& text);

/// Big-endian.
HorizonGrid ReadIrapBinary(GridBytes& bytes);
HorizonGrid ReadStorm(GridBytes& bytes);

/// Little-endian.
HorizonGrid ReadSurferBinary(GridBytes& bytes);
HorizonGrid ReadSurfer7(GridBytes& bytes);
}

#endif
