// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four numbers that are calculated with at a time, by the vector extensions of GCC and Clang.

#ifndef SeismicHorizonsFloatBatch_h
#define SeismicHorizonsFloatBatch_h

#include <cstdint>

namespace SeismicHorizons
{
/// Comparisons give an IntegerBatch: -1 where they are true, else 0.
typedef float FloatBatch __attribute__((vector_size(16)));
typedef std::int32_t IntegerBatch __attribute__((vector_size(16)));
typedef std::uint32_t BitBatch __attribute__((vector_size(16)));

constexpr int BatchSize = 4;

inline FloatBatch FourTimes(float value)
{
  return FloatBatch{ value, value, value, value };
}

inline FloatBatch ToFloats(const IntegerBatch& values)
{
  return __builtin_convertvector(values, FloatBatch);
}

/// Rounded towards 0.
inline IntegerBatch ToIntegers(const FloatBatch& values)
{
  return __builtin_convertvector(values, IntegerBatch);
}
}

#endif
