// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNullValue_h
#define SeismicHorizonsNullValue_h

#include <cmath>

namespace SeismicHorizons
{
/// Relative rounding of single precision.
constexpr double SinglePrecision = 1.0 / (1 << 24);

/// Programs store null values in single precision. A null of nan matches nothing.
inline bool IsNullValue(double value, double null)
{
  return std::abs(value - null) <= SinglePrecision * std::abs(null);
}
}

#endif
