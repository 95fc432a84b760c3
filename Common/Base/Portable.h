// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Extensions of GCC and Clang beyond C++17: bit operations, 128-bit integers, vectors of four and eight numbers, and
// functions for processors with AVX2. No other file uses extensions.

#ifndef SeismicHorizonsPortable_h
#define SeismicHorizonsPortable_h

#include <cstdint>
#include <cstring>

namespace SeismicHorizons
{
// ---- Bits --------------------------------------------------------------------------------------------------------
/// Without a guaranteed POPCNT, compilers call a function slower than parallel sums of 2, 4 and 8 bits; the product
/// adds the bytes.
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

/// The number must not be 0.
inline int LowestBit(std::uint64_t bits)
{
  return __builtin_ctzll(bits);
}

// ---- Integers of 128 bits ----------------------------------------------------------------------------------------
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Bits128;

// ---- Four numbers at a time --------------------------------------------------------------------------------------
/// Comparisons give -1 where true, else 0.
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

/// Rounds towards 0.
inline IntegerBatch ToIntegers(const FloatBatch& values)
{
  return __builtin_convertvector(values, IntegerBatch);
}

template <typename To, typename From>
To BitsAs(const From& values)
{
  static_assert(sizeof(To) == sizeof(From), "four numbers each");
  To bits;
  std::memcpy(&bits, &values, sizeof(bits));
  return bits;
}

inline FloatBatch Select(const IntegerBatch& marks, const FloatBatch& a, const FloatBatch& b)
{
  return marks ? a : b;
}

inline FloatBatch Rotate(const FloatBatch& a)
{
  return FloatBatch{ a[1], a[2], a[3], a[0] };
}

inline FloatBatch EvenOnes(const FloatBatch& a, const FloatBatch& b)
{
  return FloatBatch{ a[0], a[2], b[0], b[2] };
}

inline FloatBatch OddOnes(const FloatBatch& a, const FloatBatch& b)
{
  return FloatBatch{ a[1], a[3], b[1], b[3] };
}

// ---- Eight numbers at a time -------------------------------------------------------------------------------------
// They are one or several registers of the processor, so results do not depend on it.
template <typename Real>
struct Eight
{
  typedef Real Numbers __attribute__((vector_size(8 * sizeof(Real))));
  typedef Real Unaligned __attribute__((vector_size(8 * sizeof(Real)), aligned(sizeof(Real)), may_alias));
};

template <>
struct Eight<std::int32_t>
{
  typedef std::int32_t Numbers __attribute__((vector_size(32)));
};

template <>
struct Eight<std::int64_t>
{
  typedef std::int64_t Numbers __attribute__((vector_size(64)));
};

/// Functions with the first mark may use AVX2 if HasAvx2(). What they call has the second mark, and is compiled for
/// each of its callers.
#if defined(__x86_64__)
#define SEISMICHORIZONS_WITH_AVX2 __attribute__((target("avx2")))
inline bool HasAvx2()
{
  return __builtin_cpu_supports("avx2") != 0;
}
#else
#define SEISMICHORIZONS_WITH_AVX2
inline bool HasAvx2()
{
  return false;
}
#endif
#define SEISMICHORIZONS_PART_OF_CALLER __attribute__((always_inline)) inline
}

#endif
