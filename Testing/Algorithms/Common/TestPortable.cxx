// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bits and four numbers at a time, beside one after the other.

#include "Common/Base/Portable.h"
#include "Tools/Check.h"

#include <array>
#include <bitset>
#include <random>

using namespace SeismicHorizons;

namespace
{
std::mt19937_64 Engine;

// ---- Bits --------------------------------------------------------------------------------------------------------
void BitsAreCounted()
{
  CHECK_EQUAL(CountBits(0), 0);
  CHECK_EQUAL(CountBits(~std::uint64_t(0)), 64);
  for (int n = 0; n < 64; ++n)
  {
    const std::uint64_t bit = std::uint64_t(1) << n;
    CHECK_EQUAL(LowestBit(bit), n);
    CHECK_EQUAL(CountBits(bit - 1), n);
    const std::uint64_t bits = Engine() | bit;
    CHECK_EQUAL(CountBits(bits), int(std::bitset<64>(bits).count()));
    CHECK(LowestBit(bits) <= n && (bits >> LowestBit(bits) & 1) == 1 && (bits & -bits) >> LowestBit(bits) == 1);
  }
}

// ---- Four numbers at a time --------------------------------------------------------------------------------------
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
    const FloatBatch lower = Select(a < b, a, b);
    const IntegerBatch whole = ToIntegers(a);
    const FloatBatch floats = ToFloats(whole);
    for (int k = 0; k < BatchSize; ++k)
    {
      const float first = v[std::size_t(k)];
      const float second = v[std::size_t(k + 4)];
      CHECK(lower[k] == (first < second ? first : second));
      CHECK(whole[k] == std::int32_t(first) && floats[k] == float(whole[k]) && FourTimes(first)[k] == first);
      CHECK((a <= b)[k] == (first <= second ? -1 : 0) && (a - b)[k] == first - second && (b / a)[k] == second / first);
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
  BatchesAreFourNumbers();
  return Check::Result();
}
