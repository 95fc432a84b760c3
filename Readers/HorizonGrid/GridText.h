// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid as text: header lines, or words wherever lines end, and then values.

#ifndef SeismicHorizonsGridText_h
#define SeismicHorizonsGridText_h

#include "Common/FileErrors.h"
#include "Common/LineBuffer.h"
#include "Common/Monitor.h"
#include "Common/TextNumbers.h"
#include "GridLayout.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Errors begin with the number of the line. Progress is by bytes, where the stream can tell its length.
class GridText
{
public:
  /// Begins where the stream is. `bufferSize` is how many bytes are held at a time.
  GridText(std::istream& stream, const Monitor& monitor, std::size_t bufferSize);

  /// The line at hand, as "line 3".
  std::string Place() const { return "line " + std::to_string(this->LineNumber); }
  std::int64_t Line() const { return this->LineNumber; }
  InputError Error(const std::string& text) const { return InputError(this->Place() + ": " + text); }

  // ---- By lines ----
  /// What is left of the line at hand, without its end; nothing at the end of the file. A newline follows it in memory.
  /// It is there until the next call of any function.
  std::optional<std::string_view> PeekLine();

  /// Goes on to the next line.
  void NextLine();

  // ---- By words, wherever lines end ----
  /// The next word. Throws InputError with `name` at the end of the file.
  std::string_view Word(const std::string& name);
  double Number(const std::string& name);
  int Count(const std::string& name);

  /// Reads `count` values, nan where there is none.
  std::vector<double> Values(std::int64_t count, const NullRule& isNull);

  /// The errors for a file that ends too early, in its header or after some values.
  FileError EndError(const std::string& expected) const;
  FileError EndError(std::int64_t found, std::int64_t expected) const;

  /// Throws InputError when anything follows but blank lines, and lines that begin with one of `comments`.
  void RequireEnd(std::string_view comments = {});

  /// How many values to make room for when a file claims `count`: never more than its length allows.
  std::size_t Room(std::int64_t count) const;

private:
  bool Fill();

  /// Goes on to the next word; false at the end of the file.
  bool FindWord()
  {
    for (;;)
    {
      if (this->Text == this->Last && !this->Fill())
      {
        return false;
      }
      this->Text = SkipBlanks(this->Text);
      if (*this->Text != '\n')
      {
        return true;
      }
      ++this->Text;
      ++this->LineNumber;
    }
  }

  const double BytesInStream;
  LineBuffer Lines;
  const Monitor& Work;
  const char* Text = nullptr; // what comes next
  const char* Last = nullptr; // the end of the complete lines in memory
  std::int64_t LineNumber = 1;
  bool IsFresh = true; // nothing was read yet
};

/// The value a word stands for, nan when there is none. Throws InputError when it is no number.
double ReadGridValue(std::string_view word, const NullRule& isNull, const GridText& text);
}

#endif
