// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextWords.h"

#include "TextNumbers.h"

#include <algorithm>
#include <cctype>

namespace SeismicHorizons
{
namespace
{
/// Returns 0 for bytes that start no character in UTF-8.
std::size_t SizeOfCharacter(unsigned char first)
{
  return first < 0x80U ? 1 : first < 0xC2U ? 0 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : first < 0xF5U ? 4 : 0;
}

bool IsUtf8(std::string_view text)
{
  for (std::size_t n = 0; n < text.size();)
  {
    const std::size_t size = SizeOfCharacter(static_cast<unsigned char>(text[n]));
    if (size == 0 || n + size > text.size())
    {
      return false;
    }
    for (std::size_t next = n + 1; next < n + size; ++next)
    {
      if ((static_cast<unsigned char>(text[next]) & 0xC0U) != 0x80U)
      {
        return false;
      }
    }
    n += size;
  }
  return true;
}

bool HasEverySecondByteZero(std::string_view text)
{
  constexpr std::size_t looked = 64;
  const std::string_view first = text.substr(0, looked);
  for (const std::size_t zero : { 0, 1 })
  {
    bool all = first.size() >= 4;
    for (std::size_t n = 0; n < first.size(); ++n)
    {
      all = all && (first[n] == '\0') == (n % 2 == zero);
    }
    if (all)
    {
      return true;
    }
  }
  return false;
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsUtf16(std::string_view text)
{
  const std::string_view mark = text.substr(0, 2);
  return mark == "\xff\xfe" || mark == "\xfe\xff" || HasEverySecondByteZero(text);
}

//----------------------------------------------------------------------------------------------------------------------
std::string ToUtf8(const std::string& text)
{
  if (IsUtf8(text))
  {
    return text;
  }
  std::string result;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U)
    {
      result += c;
    }
    else
    {
      result += static_cast<char>(0xC0U | byte >> 6U);
      result += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
std::string ToLower(std::string_view text)
{
  std::string lower(text);
  std::transform(
    lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view Trim(std::string_view text)
{
  while (!text.empty() && EndsToken(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && EndsToken(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view Unquote(std::string_view text)
{
  text = Trim(text);
  const bool isQuoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return isQuoted ? text.substr(1, text.size() - 2) : text;
}
}
