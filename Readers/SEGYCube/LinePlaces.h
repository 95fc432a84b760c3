// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLinePlaces_h
#define SeismicHorizonsLinePlaces_h

#include "SEGYCube.h"
#include "TraceTable.h"

namespace SeismicHorizons
{
/// Positions the traces of a single line, which may be curved, by their headers. Missing places, places of 0 and strays
/// are interpolated, with a warning. Places stay empty if no fields form a line.
void PlaceAlongLine(SEGYCube& cube, const TraceTable& table, const FieldPair& given);
}

#endif
