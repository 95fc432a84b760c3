// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextPrinter.h"
#include "Tools/Check.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
std::string Text(double number)
{
  std::ostringstream stream;
  TextPrinter printer(stream);
  printer.Print(number);
  printer.Flush();
  return stream.str();
}

void NumbersAreShort()
{
  CHECK_EQUAL(Text(0.0), "0");
  CHECK_EQUAL(Text(-0.0), "-0");
  CHECK_EQUAL(Text(0.1), "0.1");
  CHECK_EQUAL(Text(1e6), "1000000");
  CHECK_EQUAL(Text(459621.05127), "459621.05127");
  CHECK_EQUAL(Text(0.1 + 0.2), "0.30000000000000004");
  CHECK_EQUAL(Text(1e-6), "0.000001");
  CHECK_EQUAL(Text(1e-7), "1e-07");
  CHECK_EQUAL(Text(-2.5e15), "-2.5e+15");
}

/// Bit by bit, over all exponents.
void NumbersAreReadBack()
{
  std::mt19937_64 random(7);
  std::vector<double> numbers;
  std::stringstream stream;
  TextPrinter printer(stream);
  while (numbers.size() < 100000)
  {
    const std::uint64_t bits = random();
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof(number));
    if (std::isfinite(number))
    {
      numbers.push_back(number);
      printer.Print(number);
      printer.Print('\n');
    }
  }
  printer.Flush();
  for (const double number : numbers)
  {
    std::string text;
    double read = 0.0;
    CHECK(std::getline(stream, text) && text.size() < 32 && ReadAnyNumber(text, read) == NumberKind::Finite);
    CHECK(std::memcmp(&number, &read, sizeof(number)) == 0);
  }
}

void LongTextGoesThrough()
{
  std::ostringstream stream;
  TextPrinter printer(stream);
  const std::string much(3000000, 'x');
  printer.Print('a');
  printer.Print(much);
  printer.Print(std::numeric_limits<std::int64_t>::min());
  CHECK(stream.str().size() < much.size() + 21);
  printer.Flush();
  CHECK(stream.str() == 'a' + much + "-9223372036854775808");
}

void FullStreamsAreNoticed()
{
  std::ostringstream stream;
  TextPrinter printer(stream);
  printer.Print("abc");
  printer.Flush();
  stream.setstate(std::ios::badbit);
  printer.Print("d");
  CHECK_THROWS_WITH(printer.Flush(), "writing failed after 3 bytes, expected disk space for the rest of the file");
}
}

int TestTextPrinter(int, char*[])
{
  NumbersAreShort();
  NumbersAreReadBack();
  LongTextGoesThrough();
  FullStreamsAreNoticed();
  return Check::Result();
}
