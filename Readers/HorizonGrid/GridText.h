// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridText_h
#define SeismicHorizonsGridText_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/NullValues.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/LineBuffer.h"
#include "Common/Text/TextNumbers.h"
#include "GridLayout.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Errors start with the number of the line. Progress is by bytes, if the length of the stream is known.
class GridText
{
public:
  GridText(std::istream& stream, const Monitor& monitor, std::size_t bufferSize, const NullValues& nulls,
    bool hasDecimalCommas);

  bool IsNull(std::string_view word) const { return this->Nulls.IsNullText(word); }

  std::string Place() const { return "line " + std::to_string(this->LineNumber); }
  std::int64_t Line() const { return this->LineNumber; }
  InputError Error(const std::string& text) const { return InputError(this->Place() + ": " + text); }

  // ---- By lines ----
  /// Returns the rest of the current line, valid until the next call. A newline follows it in memory.
  std::optional<std::string_view> PeekLine();

  void NextLine();

  // ---- By words, wherever lines end ----
  std::string_view Word(const std::string& name);
  double Number(const std::string& name);
  int Count(const std::string& name);

  /// Null values become nan.
  std::vector<double> Values(std::int64_t count, const NullRule& isNull);

  FileError EndError(const std::string& expected) const;
  FileError EndError(std::int64_t found, std::int64_t expected) const;

  /// Allows blank lines and lines that begin with one of `comments`.
  void RequireEnd(std::string_view comments = {});

  /// Limits `count` values by the length of the file.
  std::size_t Room(std::int64_t count) const;

private:
  bool Fill();

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
  const NullValues& Nulls;
  const bool HasDecimalCommas;
  std::string Converted; // the text in memory, with decimal points
  const char* Text = nullptr;
  const char* Last = nullptr; // The end of the complete lines in memory.
  std::int64_t LineNumber = 1;
  bool IsFresh = true;
};

/// Returns nan for null values.
double ReadGridValue(std::string_view word, const NullRule& isNull, const GridText& text);
}

#endif
