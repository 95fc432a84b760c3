// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHeaderFields_h
#define SeismicHorizonsHeaderFields_h

#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
constexpr double LargestNodeShift = 0.1; // Fraction of a step, since coordinates are written with few digits.

bool IsSameWord(std::string_view a, std::string_view b);

/// A quoted text is one word. An empty line has one empty word.
std::vector<std::string> SplitAtBlanks(std::string_view line);
std::vector<std::string> SplitAtBlanksAndCommas(std::string_view line);

std::vector<std::string> SplitAtCommas(std::string_view line);

/// Accepts D as an exponent (Fortran) and commas at the end.
NumberKind ReadGridNumber(std::string_view token, double& value);

double ReadHeaderNumber(std::string_view word, const std::string& name, const std::string& place);

int ReadHeaderCount(std::string_view word, const std::string& name, const std::string& place);

class HeaderFields
{
public:
  HeaderFields(std::string place, std::vector<std::string> fields)
    : LinePlace(std::move(place))
    , Fields(std::move(fields))
  {
  }

  const std::string& Place() const { return this->LinePlace; }
  std::size_t Size() const { return this->Fields.size(); }

  const std::string& Text(std::size_t index, const std::string& name) const;
  double Number(std::size_t index, const std::string& name) const;
  int Count(std::size_t index, const std::string& name) const;

private:
  std::string LinePlace;
  std::vector<std::string> Fields;
};

/// Lines by their keywords.
using KeywordLines = std::map<std::string, HeaderFields>;

/// Throws InputError without such a line before the values, which are at `place`.
const HeaderFields& RequireKeyword(const KeywordLines& lines, const std::string& keyword, const std::string& place);
}

#endif
