// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tokens and numbers of text files, independent of the locale. All text ends in a newline, which also
// ends a token. So functions stop there, and do not take the end of the text.

#ifndef SeismicHorizonsTextNumbers_h
#define SeismicHorizonsTextNumbers_h

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace SeismicHorizons
{
/// Carriage returns are blanks, so that lines may end in \r\n.
inline bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

inline bool EndsToken(char c)
{
  return IsBlank(c) || c == '\n';
}

inline bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

inline const char* SkipBlanks(const char* text)
{
  while (IsBlank(*text))
  {
    ++text;
  }
  return text;
}

/// The token that starts at `text`; empty at a blank or a newline.
inline std::string_view TokenAt(const char* text)
{
  const char* last = text;
  while (!EndsToken(*last))
  {
    ++last;
  }
  return std::string_view(text, static_cast<std::size_t>(last - text));
}

/// Appends the digits at `text` to `number`, and returns where they end.
inline const char* ReadDigits(const char* text, std::uint64_t& number)
{
  for (; IsDigit(*text); ++text)
  {
    number = 10 * number + static_cast<std::uint64_t>(*text - '0');
  }
  return text;
}

/// Reads a number without exponent whose digits, taken as an integer, are at most 2^53. A double holds that integer
/// exactly, and the power of ten to divide it by as well, so that one division gives the nearest double. Returns the
/// end of the token, or null when it is anything else. Nearly all numbers are of this kind. With fast_float for these,
/// too, reading of a file takes a quarter longer.
inline const char* ReadPlainNumber(const char* text, double& value)
{
  constexpr std::array<double, 20> powersOfTen = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12,
    1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19 };
  constexpr std::uint64_t largestExact = std::uint64_t(1) << std::numeric_limits<double>::digits;
  constexpr std::ptrdiff_t mostDigits = std::numeric_limits<std::uint64_t>::digits10;

  const bool negative = *text == '-';
  const char* const first = text + (negative || *text == '+' ? 1 : 0);
  std::uint64_t digits = 0;
  const char* last = ReadDigits(first, digits);
  std::ptrdiff_t numberOfDigits = last - first;
  std::ptrdiff_t decimals = 0;
  if (*last == '.')
  {
    const char* const point = last;
    last = ReadDigits(point + 1, digits);
    decimals = last - point - 1;
    numberOfDigits += decimals;
  }
  if (numberOfDigits == 0 || numberOfDigits > mostDigits || digits > largestExact || !EndsToken(*last))
  {
    return nullptr;
  }
  value = static_cast<double>(digits);
  if (decimals > 0)
  {
    value /= powersOfTen[static_cast<std::size_t>(decimals)];
  }
  value = negative ? -value : value;
  return last;
}

/// Reads a token of at most nine digits and perhaps a minus sign. Returns its end, or null when it is anything else.
inline const char* ReadShortInteger(const char* text, int& value)
{
  constexpr std::ptrdiff_t mostDigits = std::numeric_limits<int>::digits10;
  const bool negative = *text == '-';
  const char* const first = text + (negative ? 1 : 0);
  int digits = 0;
  const char* last = first;
  for (; IsDigit(*last) && last - first < mostDigits; ++last)
  {
    digits = 10 * digits + (*last - '0');
  }
  value = negative ? -digits : digits;
  return last != first && EndsToken(*last) ? last : nullptr;
}

/// The token without a leading plus sign, which the standard library does not take.
inline std::string_view WithoutPlus(std::string_view token)
{
  return token.size() > 1 && token[0] == '+' && token[1] != '-' ? token.substr(1) : token;
}

/// What a token is. Numbers too large for a double, infinity and nan are not finite.
enum class NumberKind
{
  Finite,
  NotFinite,
  NotANumber
};

/// Reads a number of any length, with or without exponent. One too small for a double is 0.
NumberKind ReadAnyNumber(std::string_view token, double& value);

/// The shortest text that is read as the same number again.
inline std::string ShortestText(double value)
{
  std::array<char, 32> text; // the longest number takes 24 characters
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

/// A positive integer of 32 bits, or 0 when the token is anything else.
inline int ReadPositiveInteger(std::string_view token)
{
  int value = 0;
  const std::string_view number = WithoutPlus(token);
  const char* const last = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), last, value);
  return error == std::errc() && end == last ? std::max(value, 0) : 0;
}
}

#endif
