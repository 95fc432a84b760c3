// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridOutput_h
#define SeismicHorizonsGridOutput_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// Reading the text restores the number. It has a point and, unless it is very large or small, no exponent, which some
/// programs cannot read.
class DecimalText
{
public:
  explicit DecimalText(double value);

  std::string_view View() const { return { this->Characters.data(), this->Size }; }

private:
  std::array<char, 40> Characters; // 17 digits, 16 zeros, a sign and a point.
  std::size_t Size = 0;
};

std::string ToDecimal(double value);

/// Throws InputError for invalid lattices and values, including values of at least `firstNull`, which would be read as
/// null.
void RequireWritable(const HorizonGrid& grid, double firstNull, const std::string& format);

class GridOutput
{
public:
  GridOutput(std::ostream& stream, const Monitor& monitor, std::int64_t numberOfValues);

  void Write(std::string_view text) { this->Text += text; }

  /// Aligns a value to the right of a field, which long values extend.
  void WriteValue(std::string_view text, std::size_t width);

  void EndLine();

  void WriteLine(std::string_view text)
  {
    this->Write(text);
    this->EndLine();
  }

  /// Counts values that were written by other functions.
  void EndValues(std::int64_t number);

  void Finish();

private:
  void HandOn();

  std::ostream& Stream;
  const Monitor& Work;
  const std::int64_t NumberOfValues;
  std::int64_t Written = 0;
  std::string Text;
};
}

#endif
