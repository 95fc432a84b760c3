// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextEncoding_h
#define SeismicHorizonsTextEncoding_h

#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Whether text begins as in UTF-16: with its mark, or with characters of ASCII that are two bytes each.
bool IsUtf16(std::string_view text);

/// Text that is not in UTF-8 is taken for Latin-1: which encoding of single bytes it is in, files do not say.
std::string ToUtf8(const std::string& text);
}

#endif
