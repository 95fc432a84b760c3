// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Numbers as text: which there are, and their values.

#include "Common/Text/TextNumbers.h"
#include "Tools/Check.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

using namespace SeismicHorizons;

namespace
{
/// The kind, and the value where it is finite.
void CheckNumber(const std::string& text, NumberKind kind, double expected = 0.0)
{
  double value = -77.0;
  CHECK(ReadAnyNumber(text, value) == kind);
  if (kind == NumberKind::Finite && !CHECK_EQUAL(value, expected))
  {
    std::cerr << "  " << text << '\n';
  }
  double plain = -77.0;
  const std::string line = text + '\n';
  if (const char* const last = ReadPlainNumber(line.data(), plain))
  {
    CHECK(last == line.data() + text.size() && kind == NumberKind::Finite && plain == expected);
    CHECK(std::signbit(plain) == std::signbit(value));
  }
}

void NumbersAreNearest()
{
  CheckNumber("0", NumberKind::Finite, 0.0);
  CheckNumber("-0", NumberKind::Finite, -0.0);
  CheckNumber("+1", NumberKind::Finite, 1.0);
  CheckNumber("1.", NumberKind::Finite, 1.0);
  CheckNumber(".5", NumberKind::Finite, 0.5);
  CheckNumber("-.5", NumberKind::Finite, -0.5);
  CheckNumber("1e5", NumberKind::Finite, 1e5);
  CheckNumber("1E+05", NumberKind::Finite, 1e5);
  CheckNumber("1.e-5", NumberKind::Finite, 1e-5);
  CheckNumber("0.1", NumberKind::Finite, 0.1);
  CheckNumber("9007199254740993", NumberKind::Finite, 9007199254740992.0); // half way: to even
  CheckNumber("9007199254740993.0000000000000000000000001", NumberKind::Finite, 9007199254740994.0);
  CheckNumber("1.7976931348623157e308", NumberKind::Finite, 1.7976931348623157e308);
  CheckNumber("4.9e-324", NumberKind::Finite, 4.9e-324);
  CheckNumber("2.5e-324", NumberKind::Finite, 4.9e-324);
}

void TooSmallIsZero()
{
  for (const char* const text : { "1e-400", "-1e-400", "2e-324", "1e-99999999999999999999", "0e99999999999999999999" })
  {
    CheckNumber(text, NumberKind::Finite, 0.0);
  }
}

void TooLargeIsNotFinite()
{
  for (const char* const text :
    { "1e400", "-1e400", "1e309", "1e99999999999999999999", "inf", "-inf", "+Infinity", "nan", "-NaN", "nan(1)" })
  {
    CheckNumber(text, NumberKind::NotFinite);
  }
}

/// The exponent makes up for the digits, or does not.
void LongNumbersAreRead()
{
  for (const int zeros : { 10, 100, 300, 340, 400, 1000 })
  {
    const std::string digits(static_cast<std::size_t>(zeros), '0');
    const std::string power = std::to_string(zeros);
    CheckNumber('1' + digits + "e-" + power, NumberKind::Finite, 1.0);
    CheckNumber("0." + digits + "1e" + power, NumberKind::Finite, 0.1);
    // Not std::pow, which MinGW does not round to nearest.
    const double expected = std::strtod(("1e" + power).c_str(), nullptr);
    CheckNumber('1' + digits, zeros <= 308 ? NumberKind::Finite : NumberKind::NotFinite, expected);
  }
  CheckNumber('1' + std::string(400, '0') + "e-5", NumberKind::NotFinite);
  CheckNumber("0." + std::string(400, '0') + "1e5", NumberKind::Finite, 0.0);
  CheckNumber("-0." + std::string(400, '0') + "1e5", NumberKind::Finite, 0.0);
  CheckNumber("0." + std::string(310, '0') + "1e5", NumberKind::Finite, 1e-306);
}

void OtherTokensAreNone()
{
  for (const char* const text : { "", "+", "-", ".", "-.", "e5", "1e", "1e+", "0x10", "1,5", " 1", "1.5.2", "--1",
         "+-1", "++1", "1d5", "in", "infin", "1f", "1_000", "\xD9\xA1" })
  {
    CheckNumber(text, NumberKind::NotANumber);
  }
}

/// Of all numbers that the short way takes, the value is that of the long one.
void PlainNumbersAreTheSame()
{
  std::mt19937_64 random;
  int plainOnes = 0;
  for (int n = 0; n < 100000; ++n)
  {
    std::string text = std::to_string(random() >> (random() % 64));
    text.insert(random() % (text.size() + 1), random() % 4 == 0 ? "" : ".");
    text.insert(0, random() % 2 == 0 ? "-" : "");
    double value = 0.0;
    double plain = 0.0;
    const std::string line = text + '\n';
    CHECK(ReadAnyNumber(text, value) == NumberKind::Finite);
    if (ReadPlainNumber(line.data(), plain))
    {
      CHECK_EQUAL(plain, value);
      ++plainOnes;
    }
  }
  CHECK(plainOnes > 50000);
}

void ShortIntegersEndTheirTokens()
{
  const auto read = [](const char* text)
  {
    int value = 0;
    return ReadShortInteger(text, value) ? value : 77;
  };
  CHECK_EQUAL(read("12 \n"), 12);
  CHECK_EQUAL(read("-999999999\n"), -999999999);
  for (const char* const text : { "1234567890\n", "1.0\n", "+1\n", "-\n", "\n", "1x\n" })
  {
    CHECK_EQUAL(read(text), 77);
  }
}
}

int TestTextNumbers(int, char*[])
{
  NumbersAreNearest();
  TooSmallIsZero();
  TooLargeIsNotFinite();
  LongNumbersAreRead();
  OtherTokensAreNone();
  PlainNumbersAreTheSame();
  ShortIntegersEndTheirTokens();
  return Check::Result();
}
