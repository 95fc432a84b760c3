// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words of header lines, and the numbers they are read as.

#ifndef SeismicHorizonsHeaderFields_h
#define SeismicHorizonsHeaderFields_h

#include "Common/TextNumbers.h"
#include "Common/TextWords.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Whether two words are the same but for capital letters.
bool IsSameWord(std::string_view a, std::string_view b);

/// The words of a line, without the quotes around them: parted by blanks, or by blanks and commas. A part in quotes is
/// one word. An empty line has one empty word.
std::vector<std::string> SplitAtBlanks(std::string_view line);
std::vector<std::string> SplitAtBlanksAndCommas(std::string_view line);

/// What is between the commas of a line, without blanks around it.
std::vector<std::string> SplitAtCommas(std::string_view line);

/// Reads a number as text grids have them: with an exponent after E or, by Fortran, D, and with commas behind it.
NumberKind ReadGridNumber(std::string_view token, double& value);

/// The number a word of a header stands for. Throws InputError when it is none, with the place and the name of it.
double ReadHeaderNumber(std::string_view word, const std::string& name, const std::string& place);

/// The same for a count, which is a positive integer.
int ReadHeaderCount(std::string_view word, const std::string& name, const std::string& place);

/// The words of a header line by their index.
class HeaderFields
{
public:
  /// `place` says where the line is, as "line 3".
  HeaderFields(std::string place, std::vector<std::string> fields)
    : LinePlace(std::move(place))
    , Fields(std::move(fields))
  {
  }

  const std::string& Place() const { return this->LinePlace; }
  std::size_t Size() const { return this->Fields.size(); }

  // These throw InputError, with the name, when there is no such word or it is something else.
  const std::string& Text(std::size_t index, const std::string& name) const;
  double Number(std::size_t index, const std::string& name) const;
  int Count(std::size_t index, const std::string& name) const;

private:
  std::string LinePlace;
  std::vector<std::string> Fields;
};
}

#endif
