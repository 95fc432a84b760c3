// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stands before the picks of a file: comments and headers of the usual programs.

#ifndef SeismicHorizonsTextHeader_h
#define SeismicHorizonsTextHeader_h

#include "NameLine.h"
#include "TextLayout.h"

#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Reads the header: the layout with all that it says. Columns are those it names, in their order; none where it names
/// none. HeaderLines is the number of the first line behind it.
TextLayout ReadTextHeader(const TextLines& lines);
}

#endif
