// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextNumbers.h"

#ifdef SEISMICHORIZONS_FAST_FLOAT
#include <fast_float/fast_float.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
//----------------------------------------------------------------------------------------------------------------------
#ifdef SEISMICHORIZONS_FAST_FLOAT
using fast_float::from_chars;
#else
using std::from_chars;
#endif

/// Of a number that is not zero and not in the range of double: true if it is too large, false if it is too small.
bool IsTooLarge(std::string_view number)
{
  const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, mark);
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  std::int64_t exponent = 0;
  if (mark < number.size())
  {
    const std::string_view text = WithoutPlus(number.substr(mark + 1));
    if (std::from_chars(text.data(), text.data() + text.size(), exponent).ec != std::errc())
    {
      return text.front() != '-';
    }
  }
  return exponent > static_cast<std::int64_t>(digits.find_first_of("123456789")) - point;
}
}

//----------------------------------------------------------------------------------------------------------------------
NumberKind ReadAnyNumber(std::string_view token, double& value)
{
  const std::string_view number = WithoutPlus(token);
  const char* const last = number.data() + number.size();
  const auto [end, error] = from_chars(number.data(), last, value);
  if (error == std::errc::invalid_argument || end != last)
  {
    return NumberKind::NotANumber;
  }
  if (error == std::errc::result_out_of_range)
  {
    value = std::copysign(
      IsTooLarge(number) ? std::numeric_limits<double>::infinity() : 0.0, number.front() == '-' ? -1.0 : 1.0);
  }
  return std::isfinite(value) ? NumberKind::Finite : NumberKind::NotFinite;
}
}
