// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLineTokens_h
#define SeismicHorizonsLineTokens_h

#include "Common/Text/TextNumbers.h"
#include "Common/Text/TextWords.h"

#include <string_view>

namespace SeismicHorizons
{
class LineTokens
{
public:
  /// A newline ends the text.
  explicit LineTokens(const char* text)
    : Text(SkipBlanks(text))
  {
  }

  bool AtEnd() const { return *this->Text == '\n'; }

  const char* Here() const { return this->Text; }

  void MoveTo(const char* text) { this->Text = SkipBlanks(text); }

  /// Empty at the end of the line.
  std::string_view Next()
  {
    const std::string_view token = TokenAt(this->Text);
    this->MoveTo(this->Text + token.size());
    return token;
  }

  /// A quoted word may contain blanks.
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
