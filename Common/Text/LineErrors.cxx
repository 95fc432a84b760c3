// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineErrors.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MaximumQuote = 32;
}

//----------------------------------------------------------------------------------------------------------------------
std::string Excerpt(std::string_view text)
{
  std::string excerpt(text.substr(0, MaximumQuote));
  std::replace_if(
    excerpt.begin(), excerpt.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return excerpt + (text.size() > MaximumQuote ? "..." : "");
}

//----------------------------------------------------------------------------------------------------------------------
std::string Quote(std::string_view text)
{
  return '"' + Excerpt(text) + '"';
}

//----------------------------------------------------------------------------------------------------------------------
InputError ErrorAt(std::int64_t line, const std::string& text)
{
  return InputError("line " + std::to_string(line) + ": " + text);
}

//----------------------------------------------------------------------------------------------------------------------
FileError CutOffAt(std::int64_t line, const std::string& text)
{
  return FileError(FileProblem::CutOff, ErrorAt(line, text).what());
}
}
