// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextPrinter_h
#define SeismicHorizonsTextPrinter_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>
#include <type_traits>
#include <vector>

namespace SeismicHorizons
{
/// Throws InputError unless all coordinates of a point are finite.
void RequireFinitePoint(const std::array<double, 3>& place, std::int64_t point);

class TextPrinter
{
public:
  explicit TextPrinter(std::ostream& stream);

  void Print(char c);
  void Print(std::string_view text);
  void Print(std::int64_t number);

  /// The shortest digits that restore the number, with an exponent instead of many zeros.
  void Print(double number);

  /// Prints values one after the other; integers may have any type.
  template <typename First, typename Second, typename... Others>
  void Print(const First& first, const Second& second, const Others&... others)
  {
    this->PrintOne(first);
    this->PrintOne(second);
    (this->PrintOne(others), ...);
  }

  template <typename First, typename... Others>
  void PrintLine([[maybe_unused]] std::string_view between, const First& first, const Others&... others)
  {
    this->PrintOne(first);
    (this->Print(between, others), ...);
    this->Print('\n');
  }

  /// Must be called at the end. Flushing throws InputError if writing fails.
  void Flush();

private:
  template <typename Value>
  void PrintOne(const Value& value)
  {
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, char>)
    {
      this->Print(value);
    }
    else if constexpr (std::is_integral_v<Value>)
    {
      this->Print(std::int64_t(value));
    }
    else
    {
      this->Print(std::string_view(value));
    }
  }

  char* Reserve(std::size_t length);

  std::ostream& Stream;
  std::vector<char> Buffer;
  std::size_t Filled = 0;
  std::int64_t Written = 0;
};
}

#endif
