// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextNumbers.h"

#include <fast_float/fast_float.h>

#include <cmath>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
// fast_float replaces std::from_chars for double, which libc++ lacks before 20, and distinguishes overflow from
// underflow.
NumberKind ReadAnyNumber(std::string_view token, double& value)
{
  const std::string_view number = WithoutPlus(token);
  const char* const last = number.data() + number.size();
  const auto [end, error] = fast_float::from_chars(number.data(), last, value);
  if (error == std::errc::invalid_argument || end != last)
  {
    return NumberKind::NotANumber;
  }
  return std::isfinite(value) ? NumberKind::Finite : NumberKind::NotFinite;
}
}
