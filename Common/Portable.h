// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What C++17 lacks and GCC and Clang have: bits of numbers, integers of 128 bits, and four numbers that are calculated
// with at a time. Each has plain C++ in its place, for other compilers and where SEISMICHORIZONS_PLAIN_CXX is defined.
// Results are the same. Nothing else uses extensions of a compiler.

#ifndef SeismicHorizonsPortable_h
#define SeismicHorizonsPortable_h

#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__) && !defined(SEISMICHORIZONS_PLAIN_CXX)
#define SEISMICHORIZONS_EXTENSIONS 1
#else
#define SEISMICHORIZONS_EXTENSIONS 0
#endif

namespace SeismicHorizons
{
// ---- Bits --------------------------------------------------------------------------------------------------------
namespace PlainCxx
{
/// Sums of 2, of 4 and of 8 bits side by side; the product adds those of 8.
constexpr int CountBits(std::uint64_t bits)
{
  bits -= bits >> 1 & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + (bits >> 2 & 0x3333333333333333U);
  bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<int>(bits * 0x0101010101010101U >> 56);
}

constexpr int LowestBit(std::uint64_t bits)
{
  return CountBits((bits & (~bits + 1)) - 1);
}
}

/// How many bits are set. Where the processor cannot be relied on to count them, compilers call a function that takes
/// longer than the sums.
inline int CountBits(std::uint64_t bits)
{
#if SEISMICHORIZONS_EXTENSIONS && (defined(__POPCNT__) || !defined(__x86_64__))
  return __builtin_popcountll(bits);
#else
  return PlainCxx::CountBits(bits);
#endif
}

/// Position of the lowest bit of a number that is not 0.
inline int LowestBit(std::uint64_t bits)
{
#if SEISMICHORIZONS_EXTENSIONS
  return __builtin_ctzll(bits);
#else
  return PlainCxx::LowestBit(bits);
#endif
}

// ---- Integers of 128 bits ----------------------------------------------------------------------------------------
namespace PlainCxx
{
/// Two words in two's complement. Compared as a signed number, and shifted by 0 to 127 as an unsigned one.
class TwoWords
{
public:
  TwoWords() = default;
  template <typename Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  constexpr TwoWords(Integer value)
    : Low(static_cast<std::uint64_t>(value))
    , High(std::is_signed_v<Integer> && !(value > 0) && value != 0 ? ~std::uint64_t(0) : 0)
  {
  }
  template <typename Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  explicit constexpr operator Integer() const
  {
    return static_cast<Integer>(this->Low);
  }

  friend constexpr TwoWords operator+(const TwoWords& a, const TwoWords& b)
  {
    const std::uint64_t low = a.Low + b.Low;
    return Make(a.High + b.High + (low < a.Low ? 1 : 0), low);
  }
  friend constexpr TwoWords operator~(const TwoWords& a) { return Make(~a.High, ~a.Low); }
  friend constexpr TwoWords operator-(const TwoWords& a) { return ~a + 1; }
  friend constexpr TwoWords operator-(const TwoWords& a, const TwoWords& b) { return a + -b; }
  friend constexpr TwoWords operator*(const TwoWords& a, const TwoWords& b)
  {
    TwoWords product = Multiply(a.Low, b.Low);
    product.High += a.High * b.Low + a.Low * b.High;
    return product;
  }
  friend constexpr TwoWords operator&(const TwoWords& a, const TwoWords& b)
  {
    return Make(a.High & b.High, a.Low & b.Low);
  }
  friend constexpr TwoWords operator|(const TwoWords& a, const TwoWords& b)
  {
    return Make(a.High | b.High, a.Low | b.Low);
  }
  friend constexpr TwoWords operator<<(const TwoWords& a, int count)
  {
    if (count >= WordBits)
    {
      return Make(a.Low << (count - WordBits), 0);
    }
    return count == 0 ? a : Make(a.High << count | a.Low >> (WordBits - count), a.Low << count);
  }
  friend constexpr TwoWords operator>>(const TwoWords& a, int count)
  {
    if (count >= WordBits)
    {
      return Make(0, a.High >> (count - WordBits));
    }
    return count == 0 ? a : Make(a.High >> count, a.Low >> count | a.High << (WordBits - count));
  }
  constexpr TwoWords& operator+=(const TwoWords& other) { return *this = *this + other; }
  constexpr TwoWords& operator-=(const TwoWords& other) { return *this = *this - other; }
  constexpr TwoWords& operator&=(const TwoWords& other) { return *this = *this & other; }
  constexpr TwoWords& operator|=(const TwoWords& other) { return *this = *this | other; }

  friend constexpr bool operator==(const TwoWords& a, const TwoWords& b) { return a.High == b.High && a.Low == b.Low; }
  friend constexpr bool operator!=(const TwoWords& a, const TwoWords& b) { return !(a == b); }
  friend constexpr bool operator<(const TwoWords& a, const TwoWords& b)
  {
    constexpr std::uint64_t sign = std::uint64_t(1) << (WordBits - 1);
    return a.High == b.High ? a.Low < b.Low : (a.High ^ sign) < (b.High ^ sign);
  }
  friend constexpr bool operator>(const TwoWords& a, const TwoWords& b) { return b < a; }
  friend constexpr bool operator<=(const TwoWords& a, const TwoWords& b) { return !(b < a); }
  friend constexpr bool operator>=(const TwoWords& a, const TwoWords& b) { return !(a < b); }

private:
  static constexpr int WordBits = 64;
  static constexpr int HalfBits = 32;

  static constexpr TwoWords Make(std::uint64_t high, std::uint64_t low)
  {
    TwoWords made = low;
    made.High = high;
    return made;
  }

  /// By halves of the words: four products of 64 bits.
  static constexpr TwoWords Multiply(std::uint64_t a, std::uint64_t b)
  {
    constexpr std::uint64_t half = 0xFFFFFFFFU;
    const std::uint64_t first = (a >> HalfBits) * (b & half);
    const std::uint64_t second = (a & half) * (b >> HalfBits);
    const std::uint64_t lowest = (a & half) * (b & half);
    const std::uint64_t middle = (first & half) + (second & half) + (lowest >> HalfBits);
    return Make((a >> HalfBits) * (b >> HalfBits) + (first >> HalfBits) + (second >> HalfBits) + (middle >> HalfBits),
      middle << HalfBits | (lowest & half));
  }

  std::uint64_t Low;
  std::uint64_t High;
};
}

#if SEISMICHORIZONS_EXTENSIONS && defined(__SIZEOF_INT128__)
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Bits128;
#else
using Int128 = PlainCxx::TwoWords;
using Bits128 = PlainCxx::TwoWords;
#endif

// ---- Four numbers at a time --------------------------------------------------------------------------------------
namespace PlainCxx
{
/// Has what code uses of the vector extensions. A number stands for four of it.
template <typename Number>
struct FourNumbers
{
  using Marks = FourNumbers<std::int32_t>; // of comparisons: -1 where they are true, else 0

  FourNumbers() = default;
  FourNumbers(Number value)
    : Numbers{ value, value, value, value }
  {
  }
  FourNumbers(Number first, Number second, Number third, Number fourth)
    : Numbers{ first, second, third, fourth }
  {
  }
  Number& operator[](int n) { return this->Numbers[n]; }
  const Number& operator[](int n) const { return this->Numbers[n]; }

  template <typename Result, typename Operation>
  static FourNumbers<Result> Make(Operation&& operation)
  {
    return { operation(0), operation(1), operation(2), operation(3) };
  }

  friend FourNumbers operator+(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] + b[n]; });
  }
  friend FourNumbers operator-(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] - b[n]; });
  }
  friend FourNumbers operator*(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] * b[n]; });
  }
  friend FourNumbers operator/(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] / b[n]; });
  }
  friend FourNumbers operator-(const FourNumbers& a)
  {
    return Make<Number>([&](int n) { return -a[n]; });
  }
  friend FourNumbers operator&(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] & b[n]; });
  }
  friend FourNumbers operator|(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<Number>([&](int n) { return a[n] | b[n]; });
  }
  friend FourNumbers operator<<(const FourNumbers& a, int count)
  {
    return Make<Number>([&](int n) { return a[n] << count; });
  }
  friend Marks operator<(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<std::int32_t>([&](int n) { return a[n] < b[n] ? -1 : 0; });
  }
  friend Marks operator<=(const FourNumbers& a, const FourNumbers& b)
  {
    return Make<std::int32_t>([&](int n) { return a[n] <= b[n] ? -1 : 0; });
  }
  friend Marks operator>(const FourNumbers& a, const FourNumbers& b) { return b < a; }
  friend Marks operator>=(const FourNumbers& a, const FourNumbers& b) { return b <= a; }
  FourNumbers& operator-=(const FourNumbers& other) { return *this = *this - other; }
  FourNumbers& operator|=(const FourNumbers& other) { return *this = *this | other; }
  FourNumbers& operator<<=(int count) { return *this = *this << count; }

  Number Numbers[4];
};
}

/// Comparisons give an IntegerBatch: -1 where they are true, else 0.
#if SEISMICHORIZONS_EXTENSIONS
typedef float FloatBatch __attribute__((vector_size(16)));
typedef std::int32_t IntegerBatch __attribute__((vector_size(16)));
typedef std::uint32_t BitBatch __attribute__((vector_size(16)));
#else
using FloatBatch = PlainCxx::FourNumbers<float>;
using IntegerBatch = PlainCxx::FourNumbers<std::int32_t>;
using BitBatch = PlainCxx::FourNumbers<std::uint32_t>;
#endif

constexpr int BatchSize = 4;

inline FloatBatch FourTimes(float value)
{
  return FloatBatch{ value, value, value, value };
}

inline FloatBatch ToFloats(const IntegerBatch& values)
{
#if SEISMICHORIZONS_EXTENSIONS
  return __builtin_convertvector(values, FloatBatch);
#else
  return { float(values[0]), float(values[1]), float(values[2]), float(values[3]) };
#endif
}

/// Rounded towards 0.
inline IntegerBatch ToIntegers(const FloatBatch& values)
{
#if SEISMICHORIZONS_EXTENSIONS
  return __builtin_convertvector(values, IntegerBatch);
#else
  return { std::int32_t(values[0]), std::int32_t(values[1]), std::int32_t(values[2]), std::int32_t(values[3]) };
#endif
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
#if SEISMICHORIZONS_EXTENSIONS
  return marks ? a : b;
#else
  return PlainCxx::FourNumbers<float>::Make<float>([&](int n) { return marks[n] != 0 ? a[n] : b[n]; });
#endif
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
