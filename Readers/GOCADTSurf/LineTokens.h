// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLineTokens_h
#define SeismicHorizonsLineTokens_h

#include "Common/TextNumbers.h"
#include "Common/TextWords.h"

#include <string_view>

namespace SeismicHorizons
{
/// The words of a line, one after the other.
class LineTokens
{
public:
  /// Begins at `text`, which a newline ends.
  explicit LineTokens(const char* text)
    : Text(SkipBlanks(text))
  {
  }

  bool AtEnd() const { return *this->Text == '\n'; }

  /// Where the next word begins.
  const char* Here() const { return this->Text; }

  /// Goes on behind a word, which ends at `text`.
  void MoveTo(const char* text) { this->Text = SkipBlanks(text); }

  /// The next word; empty at the end of the line.
  std::string_view Next()
  {
    const std::string_view token = TokenAt(this->Text);
    this->MoveTo(this->Text + token.size());
    return token;
  }

  /// The next word, or what stands between quotes, which may have blanks in it.
  std::string_view NextQuoted()
  {
    if (*this->Text != '"')
    {
      return this->Next();
    }
    const char* const first = this->Text + 1;
    const char* last = first;
    while (*last != '"' && *last != '\n')
    {
      ++last;
    }
    this->MoveTo(*last == '"' ? last + 1 : last);
    return std::string_view(first, static_cast<std::size_t>(last - first));
  }

  /// The rest of the line without blanks at its ends.
  std::string_view Rest() const
  {
    const char* last = this->Text;
    while (*last != '\n')
    {
      ++last;
    }
    return Trim(std::string_view(this->Text, static_cast<std::size_t>(last - this->Text)));
  }

private:
  const char* Text;
};
}

#endif
