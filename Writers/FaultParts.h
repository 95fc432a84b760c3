// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultParts_h
#define SeismicHorizonsFaultParts_h

#include "Common/Horizon/NamedHorizon.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Text of a line, or else of a polygon; empty without such cell data.
std::string TextOfCell(const Horizon& lines, const char* array, std::int64_t cell);

/// The cell data with names: those of faults, or the labels of contours.
const char* NamesOfLines(const Horizon& lines);

/// Lines and triangles with such names become one part for each fault or level, which has its name, in the order of
/// their first cells; those without a name keep that of the whole. Others stay whole. Parts have the points of the whole.
std::vector<NamedHorizon> SplitByFault(const std::vector<NamedHorizon>& all);
}

#endif
