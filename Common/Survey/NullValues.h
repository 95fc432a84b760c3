// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNullValues_h
#define SeismicHorizonsNullValues_h

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Null values are empty fields, asterisks, words such as "nan", "null" and "UNDEF", numbers from 1e20, and values that
/// users add.
class NullValues
{
public:
  NullValues() = default;

  /// The list is separated by blanks, commas or semicolons.
  explicit NullValues(const std::string& list);

  bool IsEmpty() const { return this->Numbers.empty() && this->Words.empty(); }

  void Add(const NullValues& other);

  bool IsNullText(std::string_view field) const;

  /// Compares in single precision, which many programs use.
  bool IsNullNumber(double value) const;

private:
  std::vector<double> Numbers;
  std::vector<std::string> Words;
};
}

#endif
