// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HeaderFields.h"

#include "Common/Text/LineErrors.h"
#include "Common/Text/TextFields.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
std::vector<std::string> SplitWords(std::string_view line, std::string_view separators)
{
  std::vector<std::string> words;
  std::size_t first = line.find_first_not_of(separators);
  while (first != std::string_view::npos)
  {
    const bool isQuoted = line[first] == '"';
    std::size_t last = isQuoted ? line.find('"', first + 1) : line.find_first_of(separators, first);
    last = std::min(last, line.size());
    words.emplace_back(Trim(line.substr(first + isQuoted, last - first - isQuoted)));
    first = line.find_first_not_of(separators, std::min(last + isQuoted, line.size()));
  }
  return words.empty() ? std::vector<std::string>(1) : words;
}

InputError WrongWord(
  std::string_view word, const std::string& name, const std::string& place, const std::string& expected)
{
  return InputError(place + ": " + name + ' ' + Quote(word) + ", expected " + expected);
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSameWord(std::string_view a, std::string_view b)
{
  return ToLower(a) == ToLower(b);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> SplitAtBlanks(std::string_view line)
{
  return SplitWords(line, " \t\r\n");
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> SplitAtBlanksAndCommas(std::string_view line)
{
  return SplitWords(line, " \t\r\n,");
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> SplitAtCommas(std::string_view line)
{
  std::vector<std::string> fields;
  for (std::size_t first = 0; first <= line.size();)
  {
    const std::size_t last = std::min(line.find(',', first), line.size());
    fields.emplace_back(Trim(Unquote(line.substr(first, last - first))));
    first = last + 1;
  }
  return fields;
}

//----------------------------------------------------------------------------------------------------------------------
NumberKind ReadGridNumber(std::string_view token, double& value)
{
  return ReadNumber(token.substr(0, token.find_last_not_of(',') + 1), value);
}

//----------------------------------------------------------------------------------------------------------------------
double ReadHeaderNumber(std::string_view word, const std::string& name, const std::string& place)
{
  double value = 0.0;
  if (ReadGridNumber(word, value) != NumberKind::Finite)
  {
    throw WrongWord(word, name, place, "a finite number");
  }
  return value;
}

//----------------------------------------------------------------------------------------------------------------------
int ReadHeaderCount(std::string_view word, const std::string& name, const std::string& place)
{
  const int count = ReadPositiveInteger(word.substr(0, word.find_last_not_of(',') + 1));
  if (count == 0)
  {
    throw WrongWord(word, name, place, "a positive integer");
  }
  return count;
}

//----------------------------------------------------------------------------------------------------------------------
const std::string& HeaderFields::Text(std::size_t index, const std::string& name) const
{
  if (index >= this->Fields.size())
  {
    throw InputError(this->LinePlace + ": end of the line, expected " + name);
  }
  return this->Fields[index];
}

//----------------------------------------------------------------------------------------------------------------------
double HeaderFields::Number(std::size_t index, const std::string& name) const
{
  return ReadHeaderNumber(this->Text(index, name), name, this->LinePlace);
}

//----------------------------------------------------------------------------------------------------------------------
int HeaderFields::Count(std::size_t index, const std::string& name) const
{
  return ReadHeaderCount(this->Text(index, name), name, this->LinePlace);
}

//----------------------------------------------------------------------------------------------------------------------
const HeaderFields& RequireKeyword(const KeywordLines& lines, const std::string& keyword, const std::string& place)
{
  const auto line = lines.find(keyword);
  if (line == lines.end())
  {
    throw InputError(place + ": no line " + keyword + ", expected one before the values");
  }
  return line->second;
}
}
