// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLinePlaces_h
#define SeismicHorizonsLinePlaces_h

#include "SEGYCube.h"
#include "TraceTable.h"

namespace SeismicHorizons
{
/// Puts the traces of a cube of one line where their own headers say, which need not be on a straight line. Columns
/// without a trace, those whose place is 0, and those that are far from both neighbours are put between these; what was
/// moved is a warning. Looks at the given fields, where there are some, else at those where the cube has its places,
/// else at the usual ones. Leaves the places empty where no fields have a line.
void PlaceAlongLine(SEGYCube& cube, const TraceTable& table, const FieldPair& given);
}

#endif
