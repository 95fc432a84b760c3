// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextEncoding_h
#define SeismicHorizonsTextEncoding_h

#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Requires a byte order mark, or ASCII characters of two bytes.
bool IsUtf16(std::string_view text);

/// Text that is not UTF-8 is converted from Latin-1, since files do not state their encoding.
std::string ToUtf8(const std::string& text);
}

#endif
