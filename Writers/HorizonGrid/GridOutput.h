// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the writers share.

#ifndef SeismicHorizonsGridOutput_h
#define SeismicHorizonsGridOutput_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
/// The text of a number that is read as the same one again, with a point and, unless it is very large or small, without
/// an exponent: not all programs read one.
class DecimalText
{
public:
  explicit DecimalText(double value);

  std::string_view View() const { return { this->Characters.data(), this->Size }; }

private:
  std::array<char, 40> Characters; // a number takes 17 digits, 16 zeros, a sign and a point
  std::size_t Size = 0;
};

std::string ToDecimal(double value);

/// Throws InputError when the grid has not as many values as nodes, a lattice that is not finite, or a value that is
/// not finite or, from `firstNull` on, would be read as none.
void RequireWritable(const HorizonGrid& grid, double firstNull, const std::string& format);

/// Gathers text and hands it on in large pieces.
class GridOutput
{
public:
  GridOutput(std::ostream& stream, const Monitor& monitor, std::int64_t numberOfValues);

  void Write(std::string_view text) { this->Text += text; }

  /// Writes a value at the end of a field, which is as wide as it has to be.
  void WriteValue(std::string_view text, std::size_t width);

  void EndLine();

  /// For values that were not written one by one: so many more are there.
  void EndValues(std::int64_t number);

  /// Throws InputError when writing failed.
  void Finish();

private:
  void HandOn();

  std::ostream& Stream;
  const Monitor& Work;
  const std::int64_t NumberOfValues;
  std::int64_t Written = 0; // values
  std::string Text;
};
}

#endif
