// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "NullValues.h"

#include "Common/Text/TextFields.h"
#include "Common/Text/TextNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
// OpendTect, IRAP and CPS-3 write 1e30, other programs 1e20, IESX the largest float; no horizon is that deep.
constexpr double LeastHuge = 0.999999e20;
constexpr double FloatPrecision = 1e-6; // relative
constexpr std::array<std::string_view, 7> NullWords = { "nan", "null", "none", "undef", "n/a", "na", "-" };
}

//----------------------------------------------------------------------------------------------------------------------
NullValues::NullValues(const std::string& list)
{
  std::string text = list;
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == ',' || c == ';' || c == '\n'; }, ' ');
  FieldCursor fields(text, FieldSeparator::Blanks);
  std::string_view field;
  while (fields.Next(field))
  {
    double number = 0.0;
    if (ReadAnyNumber(field, number) == NumberKind::Finite)
    {
      this->Numbers.push_back(number);
    }
    else
    {
      this->Words.push_back(ToLower(field));
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void NullValues::Add(const NullValues& other)
{
  this->Numbers.insert(this->Numbers.end(), other.Numbers.begin(), other.Numbers.end());
  this->Words.insert(this->Words.end(), other.Words.begin(), other.Words.end());
}

//----------------------------------------------------------------------------------------------------------------------
bool NullValues::IsNullText(std::string_view field) const
{
  if (field.find_first_not_of('*') == std::string_view::npos)
  {
    return true;
  }
  const std::string word = ToLower(field);
  return std::find(NullWords.begin(), NullWords.end(), word) != NullWords.end() ||
    std::find(this->Words.begin(), this->Words.end(), word) != this->Words.end();
}

//----------------------------------------------------------------------------------------------------------------------
bool NullValues::IsNullNumber(double value) const
{
  return std::abs(value) >= LeastHuge ||
    std::any_of(this->Numbers.begin(), this->Numbers.end(),
      [value](double null) { return std::abs(value - null) <= FloatPrecision * std::abs(null); });
}
}
