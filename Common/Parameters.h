// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks of parameters that are numbers. No parameter is silently brought into its range.

#ifndef SeismicHorizonsParameters_h
#define SeismicHorizonsParameters_h

#include "Errors.h"

#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
/// Throws InputError unless a number is finite and at least `least`. `unit` follows that in the message.
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

/// The same for a number from `least` to `most`.
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
}

#endif
