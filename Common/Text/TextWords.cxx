// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextWords.h"

#include "TextNumbers.h"

#include <algorithm>
#include <cctype>

namespace SeismicHorizons
{
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
