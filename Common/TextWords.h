// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextWords_h
#define SeismicHorizonsTextWords_h

#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// The same text with capital letters made small.
std::string ToLower(std::string_view text);

/// The text without blanks and line ends at both ends.
std::string_view Trim(std::string_view text);
}

#endif
