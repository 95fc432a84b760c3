// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of other programs that are often given in place of horizons.

#ifndef SeismicHorizonsOtherFormats_h
#define SeismicHorizonsOtherFormats_h

#include <string_view>

namespace SeismicHorizons
{
/// Throws InputError where a file that begins with these bytes has a well-known format that no reader reads: what it
/// is, what was expected, and what to do. A few kilobytes are enough.
void RefuseOtherFormats(std::string_view beginning, std::string_view expected);
}

#endif
