// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextPrinter.h"

#include "Common/Base/Errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t TextBufferSize = 1 << 20;
constexpr std::size_t LongestNumber = 32;

// Other numbers have an exponent.
constexpr double LeastPlain = 1e-6;
constexpr double GreatestPlain = 1e15;
}

//----------------------------------------------------------------------------------------------------------------------
void RequireFinitePoint(const std::array<double, 3>& place, std::int64_t point)
{
  for (const double coordinate : place)
  {
    if (!std::isfinite(coordinate))
    {
      throw InputError("coordinate " + std::to_string(coordinate) + " of point " + std::to_string(point) +
        ", expected a finite number");
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
TextPrinter::TextPrinter(std::ostream& stream)
  : Stream(stream)
  , Buffer(TextBufferSize)
{
}

//----------------------------------------------------------------------------------------------------------------------
void TextPrinter::Print(char c)
{
  *this->Reserve(1) = c;
  ++this->Filled;
}

//----------------------------------------------------------------------------------------------------------------------
void TextPrinter::Print(std::string_view text)
{
  std::copy(text.begin(), text.end(), this->Reserve(text.size()));
  this->Filled += text.size();
}

//----------------------------------------------------------------------------------------------------------------------
void TextPrinter::Print(std::int64_t number)
{
  char* const first = this->Reserve(LongestNumber);
  this->Filled += std::size_t(std::to_chars(first, first + LongestNumber, number).ptr - first);
}

//----------------------------------------------------------------------------------------------------------------------
void TextPrinter::Print(double number)
{
  const double size = std::abs(number);
  const bool isPlain = number == 0.0 || (size >= LeastPlain && size < GreatestPlain);
  const auto format = isPlain ? std::chars_format::fixed : std::chars_format::scientific;
  char* const first = this->Reserve(LongestNumber);
  this->Filled += std::size_t(std::to_chars(first, first + LongestNumber, number, format).ptr - first);
}

//----------------------------------------------------------------------------------------------------------------------
void TextPrinter::Flush()
{
  this->Stream.write(this->Buffer.data(), std::streamsize(this->Filled));
  this->Stream.flush();
  if (!this->Stream)
  {
    throw InputError(
      "writing failed after " + std::to_string(this->Written) + " bytes, expected disk space for the rest of the file");
  }
  this->Written += std::int64_t(this->Filled);
  this->Filled = 0;
}

//----------------------------------------------------------------------------------------------------------------------
char* TextPrinter::Reserve(std::size_t length)
{
  if (this->Filled + length > this->Buffer.size())
  {
    this->Flush();
    this->Buffer.resize(std::max(length, this->Buffer.size()));
  }
  return this->Buffer.data() + this->Filled;
}
}
