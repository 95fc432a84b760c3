// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What C++17 lacks and GCC and Clang have: bits of numbers, integers of 128 bits, and four numbers that are calculated
// with at a time. Nothing else uses extensions of a compiler.

#ifndef SeismicHorizonsPortable_h
#define SeismicHorizonsPortable_h

#include <cstdint>
#include <cstring>

namespace SeismicHorizons
{
// ---- Bits --------------------------------------------------------------------------------------------------------
/// How many bits are set. Where the processor cannot be relied on to count them, compilers call a function that takes
/// longer than sums of 2, of 4 and of 8 bits side by side; the product adds those of 8.
inline int CountBits(std::uint64_t bits)
{
#if defined(__POPCNT__) || !defined(__x86_64__)
  return __builtin_popcountll(bits);
#else
  bits -= bits >> 1 & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + (bits >> 2 & 0x3333333333333333U);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<int>(bits * 0x0101010101010101U >> 56);
#endif
}

/// Position of the lowest bit of a number that is not 0.
inline int LowestBit(std::uint64_t bits)
{
  return __builtin_ctzll(bits);
}

// ---- Integers of 128 bits ----------------------------------------------------------------------------------------
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Bits128;

// ---- Four numbers at a time --------------------------------------------------------------------------------------
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

/// The same bits as another type of number.
template <typename To, typename From>
To BitsAs(const From& values)
{
  static_assert(sizeof(To) == sizeof(From), "four numbers each");
  To bits;
  std::memcpy(&bits, &values, sizeof(bits));
  return bits;
}

/// The first of two numbers where they are marked, else the second.
inline FloatBatch Select(const IntegerBatch& marks, const FloatBatch& a, const FloatBatch& b)
{
  return marks ? a : b;
}

/// With the first number behind the last one.
inline FloatBatch Rotate(const FloatBatch& a)
{
  return FloatBatch{ a[1], a[2], a[3], a[0] };
}

/// The first and the third number of each.
inline FloatBatch EvenOnes(const FloatBatch& a, const FloatBatch& b)
{
  return FloatBatch{ a[0], a[2], b[0], b[2] };
}

/// The second and the fourth number of each.
inline FloatBatch OddOnes(const FloatBatch& a, const FloatBatch& b)
{
  return FloatBatch{ a[1], a[3], b[1], b[3] };
}
}

#endif
