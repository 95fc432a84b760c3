// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNullValue_h
#define SeismicHorizonsNullValue_h

#include <cmath>

namespace SeismicHorizons
{
/// How far a number may move, in parts of its own size, when it is stored in single precision.
constexpr double SinglePrecision = 1.0 / (1 << 24);

/// Whether a number stands for "no value": it is `null` up to the rounding of single precision, in which programs
/// keep such numbers. Never where `null` is nan.
inline bool IsNullValue(double value, double null)
{
  return std::abs(value - null) <= SinglePrecision * std::abs(null);
}
}

#endif
