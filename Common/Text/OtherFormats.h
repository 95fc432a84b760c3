// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsOtherFormats_h
#define SeismicHorizonsOtherFormats_h

#include <string_view>

namespace SeismicHorizons
{
/// Throws InputError if the first kilobytes are of a well-known format that is not supported; its text gives the
/// remedy.
void RefuseOtherFormats(std::string_view beginning, std::string_view expected);
}

#endif
