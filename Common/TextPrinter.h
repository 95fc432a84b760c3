// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prints text and numbers into a stream, independent of the locale. Text is collected in a buffer, so that printing a
// number takes little more than finding its digits.

#ifndef SeismicHorizonsTextPrinter_h
#define SeismicHorizonsTextPrinter_h

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
class TextPrinter
{
public:
  /// The stream must outlive the printer.
  explicit TextPrinter(std::ostream& stream);

  void Print(char c);
  void Print(std::string_view text);
  void Print(std::int64_t number);

  /// The shortest digits that give the same number when they are read, 17 at most. With an exponent only where there
  /// would be many zeros without.
  void Print(double number);

  /// To be called at the end. Here, and now and then before, InputError is thrown when the stream takes no more.
  void Flush();

private:
  /// Makes room for that many characters.
  char* Reserve(std::size_t length);

  std::ostream& Stream;
  std::vector<char> Buffer;
  std::size_t Filled = 0;
  std::int64_t Written = 0; // bytes that went into the stream
};
}

#endif
