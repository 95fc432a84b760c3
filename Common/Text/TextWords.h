// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextWords_h
#define SeismicHorizonsTextWords_h

#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Requires a byte order mark, or ASCII characters of two bytes.
bool IsUtf16(std::string_view text);

/// Text that is not UTF-8 is converted from Latin-1, since files do not state their encoding.
std::string ToUtf8(const std::string& text);

std::string ToLower(std::string_view text);

inline bool StartsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

/// Some programs put this mark before UTF-8.
constexpr std::string_view ByteOrderMark = "\xEF\xBB\xBF";

inline std::string_view WithoutByteOrderMark(std::string_view text)
{
  return text.substr(StartsWith(text, ByteOrderMark) ? ByteOrderMark.size() : 0);
}

std::string_view Trim(std::string_view text);

/// Removes a pair of quotes after trimming; blanks inside remain.
std::string_view Unquote(std::string_view text);
}

#endif
