// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// No parameter is silently clamped.

#ifndef SeismicHorizonsParameters_h
#define SeismicHorizonsParameters_h

#include "Errors.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace SeismicHorizons
{
/// Throws InputError; `unit` follows `least` in its text.
template <typename Number>
void CheckAtLeast(const char* name, Number value, Number least, const char* unit)
{
  const bool isFinite = std::isfinite(double(value));
  if (!isFinite || value < least)
  {
    std::ostringstream text;
    text << name << ' ' << value << ", expected " << (isFinite ? "" : "a finite number, ") << "at least " << least
         << unit;
    throw InputError(text.str());
  }
}

template <typename Number>
void CheckWithin(const char* name, Number value, Number least, Number most, const char* unit)
{
  if (!(value >= least && value <= most))
  {
    std::ostringstream text;
    text << name << ' ' << value << ", expected " << least << " to " << most << unit;
    throw InputError(text.str());
  }
}

/// -1 means the last column or row. Throws InputError for an invalid range.
inline std::array<int, 2> MakeRange(const char* name, const int (&range)[2])
{
  if (range[0] < 0 || range[1] < -1 || (range[1] >= 0 && range[1] < range[0]))
  {
    throw InputError(name + std::string(" ") + std::to_string(range[0]) + " to " + std::to_string(range[1]) +
      ", expected a first number of at least 0, and a last one that is not less, or -1 for the end");
  }
  return { range[0], range[1] < 0 ? std::numeric_limits<int>::max() : range[1] };
}
}

#endif
