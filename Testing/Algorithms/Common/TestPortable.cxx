// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Extensions of the compiler beside the plain C++ that stands in for them.

#include "Common/Portable.h"
#include "Tools/Check.h"

#include <array>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace SeismicHorizons;
using PlainCxx::TwoWords;

namespace
{
std::mt19937_64 Engine;

/// Random bits, of which at most so many.
std::uint64_t RandomBits(int most)
{
  return Engine() >> (64 - most);
}

// ---- Bits --------------------------------------------------------------------------------------------------------
void BitsAreCounted()
{
  CHECK_EQUAL(PlainCxx::CountBits(0), 0);
  CHECK_EQUAL(PlainCxx::CountBits(~std::uint64_t(0)), 64);
  for (int n = 0; n < 64; ++n)
  {
    const std::uint64_t bit = std::uint64_t(1) << n;
    CHECK_EQUAL(PlainCxx::LowestBit(bit), n);
    CHECK_EQUAL(LowestBit(bit), n);
    CHECK_EQUAL(PlainCxx::CountBits(bit - 1), n);
    CHECK_EQUAL(CountBits(bit - 1), n);
    const std::uint64_t bits = RandomBits(64) | bit;
    CHECK_EQUAL(PlainCxx::CountBits(bits), CountBits(bits));
    CHECK_EQUAL(PlainCxx::LowestBit(bits), LowestBit(bits));
  }
}

// ---- Integers of 128 bits ----------------------------------------------------------------------------------------
using Words = std::pair<std::uint64_t, std::uint64_t>;

template <typename Wide>
Words WordsOf(const Wide& number)
{
  return { static_cast<std::uint64_t>(number >> 64), static_cast<std::uint64_t>(number) };
}

/// What the methods do with two numbers of 64 bits, and a shift.
template <typename Wide>
std::vector<Words> Calculate(std::int64_t a, std::int64_t b)
{
  Wide sum = Wide(a) * b;
  sum += Wide(b) * b - Wide(a);
  Wide difference = Wide(a) - b;
  difference -= sum;
  return { WordsOf(Wide(a)), WordsOf(Wide(a) * b), WordsOf(sum), WordsOf(difference), WordsOf(-sum),
    WordsOf(sum * difference), { sum<difference, sum> 0 }, { sum <= difference, sum >= difference },
    { sum == difference, sum != 0 } };
}

/// What they do with bits.
template <typename Wide>
std::vector<Words> Shift(std::uint64_t high, std::uint64_t low, int count)
{
  const Wide bits = Wide(high) << 64 | low;
  Wide left = bits & (bits - 1);
  left |= Wide(1) << count;
  left &= ~(bits >> count);
  return { WordsOf(bits), WordsOf(left), WordsOf(bits << count), WordsOf(bits >> count), { left == 0, left != 0 } };
}

void WideIntegersAreThoseOfTheCompiler()
{
  for (int n = 0; n < 20000; ++n)
  {
    const auto a = static_cast<std::int64_t>(RandomBits(1 + n % 64)) * (n % 2 == 0 ? 1 : -1);
    const auto b = static_cast<std::int64_t>(RandomBits(1 + n / 64 % 64)) * (n % 3 == 0 ? 1 : -1);
    CHECK(Calculate<TwoWords>(a, b) == Calculate<Int128>(a, b));
    const std::uint64_t high = RandomBits(1 + n % 64);
    const std::uint64_t low = RandomBits(1 + n / 64 % 64);
    CHECK(Shift<TwoWords>(high, low, n % 128) == Shift<Bits128>(high, low, n % 128));
  }
}

/// Also where the compiler has none of its own.
void WideIntegersAreExact()
{
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  CHECK(WordsOf(TwoWords(most) * most) == Words(0x3FFFFFFFFFFFFFFFU, 1));
  CHECK(WordsOf(TwoWords(least) * least) == Words(0x4000000000000000U, 0));
  CHECK(WordsOf(TwoWords(least) * most) == Words(0xC000000000000000U, 0x8000000000000000U));
  CHECK(TwoWords(least) * most < 0 && TwoWords(-1) * -1 > 0 && !(TwoWords(0) < 0) && !(TwoWords(0) > 0));
  CHECK(TwoWords(most) + 1 == TwoWords(std::uint64_t(1) << 63));
  CHECK(TwoWords(most) * most - TwoWords(most) * (most - 1) == most);
}

// ---- Four numbers at a time --------------------------------------------------------------------------------------
template <typename Floats, typename Integers>
std::array<float, 4> Evaluate(const Floats& a, const Floats& b)
{
  Floats result = 0.5f * a + b / a - (-b);
  const Integers marks = (a < b) & (a <= 2.0f * b);
  Integers count = {};
  count -= marks;
  result = result * b - 1.0f;
  return { result[0] + float(count[0]), result[1] + float(marks[1]), result[2] + float((a > b)[2]),
    result[3] + float((a >= b)[3]) };
}

void BatchesAreFourNumbers()
{
  std::uniform_real_distribution<float> random(-100.0f, 100.0f);
  for (int n = 0; n < 1000; ++n)
  {
    std::array<float, 8> v;
    for (float& value : v)
    {
      value = random(Engine);
    }
    const FloatBatch a = { v[0], v[1], v[2], v[3] };
    const FloatBatch b = { v[4], v[5], v[6], v[7] };
    using Plain = PlainCxx::FourNumbers<float>;
    const std::array<float, 4> plain = Evaluate<Plain, PlainCxx::FourNumbers<std::int32_t>>(
      Plain(v[0], v[1], v[2], v[3]), Plain(v[4], v[5], v[6], v[7]));
    CHECK((Evaluate<FloatBatch, IntegerBatch>(a, b)) == plain);
    const FloatBatch lower = Select(a < b, a, b);
    const IntegerBatch whole = ToIntegers(a);
    const FloatBatch floats = ToFloats(whole);
    for (int k = 0; k < BatchSize; ++k)
    {
      const float first = v[std::size_t(k)];
      const float second = v[std::size_t(k + 4)];
      CHECK(lower[k] == (first < second ? first : second));
      CHECK(whole[k] == std::int32_t(first) && floats[k] == float(whole[k]) && FourTimes(first)[k] == first);
      CHECK(Rotate(a)[k] == v[std::size_t((k + 1) % 4)]);
      CHECK(EvenOnes(a, b)[k] == v[std::size_t(2 * k)] && OddOnes(a, b)[k] == v[std::size_t(2 * k + 1)]);
    }
    BitBatch marks = {};
    BitBatch bit = { 1, 2, 4, 8 };
    bit <<= BatchSize;
    marks |= BitsAs<BitBatch>(a < b) & bit;
    CHECK(marks[2] == (v[2] < v[6] ? 64U : 0U));
  }
}
}

int TestPortable(int, char*[])
{
  BitsAreCounted();
  WideIntegersAreThoseOfTheCompiler();
  WideIntegersAreExact();
  BatchesAreFourNumbers();
  return Check::Result();
}
