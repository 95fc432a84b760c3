// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNullValues_h
#define SeismicHorizonsNullValues_h

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// What stands for "no value" in text files: nothing, stars, words as "nan", "null" and "UNDEF", numbers of 1e20 and
/// more, and the numbers and words that users name.
class NullValues
{
public:
  NullValues() = default;

  /// Adds the numbers and words of a list that is separated by blanks, commas or semicolons.
  explicit NullValues(const std::string& list);

  /// Adds those of another list.
  void Add(const NullValues& other);

  /// Whether a field that is no number says that there is none.
  bool IsNullText(std::string_view field) const;

  /// Whether a number says so: up to the precision of a float, in which many programs hold it.
  bool IsNullNumber(double value) const;

private:
  std::vector<double> Numbers;
  std::vector<std::string> Words; // in small letters
};
}

#endif
