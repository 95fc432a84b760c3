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

/// Whether a text begins with another.
inline bool StartsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

/// The mark that some programs put before text in UTF-8.
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

/// The text behind a byte order mark, if there is one.
inline std::string_view WithoutByteOrderMark(std::string_view text)
{
  return text.substr(StartsWith(text, ByteOrderMark) ? ByteOrderMark.size() : 0);
}

/// The text without blanks and line ends at both ends.
std::string_view Trim(std::string_view text);

/// The same without a pair of quotes around it; blanks within these stay.
std::string_view Unquote(std::string_view text);
}

#endif
