// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextFields_h
#define SeismicHorizonsTextFields_h

#include "FieldSeparator.h"
#include "TextNumbers.h"
#include "TextWords.h"

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Some programs end files with EOB, EOD, EOF, or the control character of DOS.
bool IsEndMark(std::string_view line);

/// Blank lines and comments after # or !.
bool IsSkipped(std::string_view line);

/// Accepts exponents of C and Fortran, such as 1.5D+03.
NumberKind ReadNumber(std::string_view field, double& value);

bool IsNumber(std::string_view field);

/// Spreadsheets double the quotes in quoted fields; those stay until here.
std::string WithoutDoubledQuotes(std::string_view field);

/// Quoted text is one field, without the quotes; an unmatched quote belongs to its field. The class is inline because
/// it dominates the time of reading.
class FieldCursor
{
public:
  FieldCursor(std::string_view line, FieldSeparator separator)
    : Place(line.data())
    , Last(line.data() + line.size())
    , Separator(SeparatorOf(separator))
    , SkipsColons(separator == FieldSeparator::Colons)
  {
  }

  /// Between two commas there is an empty field, but none after a trailing comma.
  bool Next(std::string_view& field)
  {
    this->SkipBlanks();
    if (this->Place == this->Last)
    {
      return false;
    }
    if (*this->Place == '"' || *this->Place == '\'')
    {
      field = this->Quoted();
    }
    else
    {
      field = this->Unquoted();
    }
    if (this->Separator != 0)
    {
      this->SkipBlanks();
      this->IsSeparated = this->Place != this->Last && this->IsSeparator(*this->Place);
      this->Place += this->IsSeparated ? 1 : 0;
    }
    return true;
  }

  /// Valid after Next() returned false.
  bool EndsInSeparator() const { return this->IsSeparated; }

private:
  /// Returns 0 for blanks.
  static char SeparatorOf(FieldSeparator separator)
  {
    switch (separator)
    {
      case FieldSeparator::Tab:
        return '\t';
      case FieldSeparator::Comma:
        return ',';
      case FieldSeparator::Semicolon:
        return ';';
      default:
        return 0;
    }
  }

  bool IsSeparator(char c) const { return this->Separator != 0 && c == this->Separator; }

  bool IsSkipped(char c) const { return (IsBlank(c) && c != this->Separator) || (this->SkipsColons && c == ':'); }

  void SkipBlanks()
  {
    while (this->Place != this->Last && this->IsSkipped(*this->Place))
    {
      ++this->Place;
    }
  }

  std::string_view Quoted()
  {
    const char quote = *this->Place++;
    const char* const first = this->Place;
    const auto isDoubled = [this] { return this->Place + 1 != this->Last && this->Place[1] == '"'; };
    while (this->Place != this->Last && (*this->Place != quote || (quote == '"' && isDoubled())))
    {
      this->Place += *this->Place == quote ? 2 : 1;
    }
    if (this->Place == this->Last)
    {
      return std::string_view(first - 1, std::size_t(this->Place - first) + 1);
    }
    const std::string_view field(first, std::size_t(this->Place - first));
    ++this->Place;
    return field;
  }

  std::string_view Unquoted()
  {
    const char* const first = this->Place;
    const char* last = first;
    while (this->Place != this->Last && !this->IsSeparator(*this->Place))
    {
      if (!this->IsSkipped(*this->Place))
      {
        last = this->Place + 1;
      }
      else if (this->Separator == 0)
      {
        break;
      }
      ++this->Place;
    }
    return std::string_view(first, std::size_t(last - first));
  }

  const char* Place;
  const char* const Last;
  const char Separator;
  const bool SkipsColons;
  bool IsSeparated = false;
};

std::vector<std::string_view> SplitFields(std::string_view line, FieldSeparator separator);
}

#endif
