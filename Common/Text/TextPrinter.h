// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextPrinter_h
#define SeismicHorizonsTextPrinter_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>
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

  /// Must be called at the end. Flushing throws InputError if writing fails.
  void Flush();

private:
  char* Reserve(std::size_t length);

  std::ostream& Stream;
  std::vector<char> Buffer;
  std::size_t Filled = 0;
  std::int64_t Written = 0;
};
}

#endif
