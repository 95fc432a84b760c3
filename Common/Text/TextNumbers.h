// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All text ends in a newline, which ends tokens, so that functions need no end pointer.

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
/// Lines may end in \r\n.
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

inline std::string_view TokenAt(const char* text)
{
  const char* last = text;
  while (!EndsToken(*last))
  {
    ++last;
  }
  return std::string_view(text, static_cast<std::size_t>(last - text));
}

inline const char* ReadDigits(const char* text, std::uint64_t& number)
{
  for (; IsDigit(*text); ++text)
  {
    number = 10 * number + static_cast<std::uint64_t>(*text - '0');
  }
  return text;
}

/// The digits form an integer of at most 2^53, so that one division gives the nearest double. Returns the end of the
/// token, or null. Nearly all numbers are such; without it reading takes a quarter longer.
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

/// Accepts nine digits and a minus sign. Returns the end, or null.
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

inline std::string_view WithoutPlus(std::string_view token)
{
  return token.size() > 1 && token[0] == '+' && token[1] != '-' ? token.substr(1) : token;
}

/// Overflow, infinity and nan are not finite.
enum class NumberKind
{
  Finite,
  NotFinite,
  NotANumber
};

/// Underflow gives 0.
NumberKind ReadAnyNumber(std::string_view token, double& value);

/// Reading the text restores the number.
inline std::string ShortestText(double value)
{
  std::array<char, 32> text;
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

/// Returns 0 for any other token.
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
