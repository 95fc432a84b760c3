// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridOutput.h"

#include "Common/Base/Errors.h"
#include "Common/Survey/LatticeFrame.h"
#include "Common/Text/TextNumbers.h"

#include <charconv>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t PieceSize = 256 * 1024; // bytes

// Other numbers are written with an exponent.
constexpr double SmallestPlain = 1e-5;
constexpr double LargestPlain = 1e16;

bool IsPlain(double value)
{
  return value == 0.0 || (std::fabs(value) >= SmallestPlain && std::fabs(value) < LargestPlain);
}
}

//----------------------------------------------------------------------------------------------------------------------
DecimalText::DecimalText(double value)
{
  const bool isPlain = IsPlain(value);
  char* const first = this->Characters.data();
  char* last = std::to_chars(
    first, first + this->Characters.size(), value, isPlain ? std::chars_format::fixed : std::chars_format::scientific)
                 .ptr;
  this->Size = static_cast<std::size_t>(last - first);
  if (isPlain && this->View().find('.') == std::string_view::npos)
  {
    *last++ = '.';
    *last++ = '0';
    this->Size += 2;
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string ToDecimal(double value)
{
  return std::string(DecimalText(value).View());
}

//----------------------------------------------------------------------------------------------------------------------
void RequireWritable(const HorizonGrid& grid, double firstNull, const std::string& format)
{
  const SurveyLattice& lattice = grid.Lattice;
  const std::int64_t nodes = std::int64_t(lattice.Columns[0]) * lattice.Columns[1];
  if (lattice.Columns[0] < 1 || lattice.Columns[1] < 1 || static_cast<std::int64_t>(grid.Z.size()) != nodes)
  {
    throw InputError(std::to_string(grid.Z.size()) + " values, expected one for each of " +
      std::to_string(lattice.Columns[0]) + " x " + std::to_string(lattice.Columns[1]) + " nodes");
  }
  if (!lattice.Origin.allFinite() || !lattice.ColumnStep.allFinite() || !lattice.RowStep.allFinite() ||
    lattice.ColumnStep.isZero(0.0) || lattice.RowStep.isZero(0.0))
  {
    throw InputError("a lattice from " + ToText(lattice.Origin) + " with the steps " + ToText(lattice.ColumnStep) +
      " and " + ToText(lattice.RowStep) + ", expected finite numbers, and steps other than 0");
  }
  for (std::size_t n = 0; n < grid.Z.size(); ++n)
  {
    if (grid.Z[n] >= firstNull || std::isinf(grid.Z[n]))
    {
      const auto width = static_cast<std::size_t>(lattice.Columns[0]);
      throw InputError("value " + ShortestText(grid.Z[n]) + " of column (" + std::to_string(n % width) + ", " +
        std::to_string(n / width) + "), expected less than " + ToDecimal(firstNull) + ", which means no value in " +
        format);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
GridOutput::GridOutput(std::ostream& stream, const Monitor& monitor, std::int64_t numberOfValues)
  : Stream(stream)
  , Work(monitor)
  , NumberOfValues(numberOfValues)
{
}

//----------------------------------------------------------------------------------------------------------------------
void GridOutput::WriteValue(std::string_view text, std::size_t width)
{
  this->Text.append(text.size() < width ? width - text.size() : 0, ' ');
  this->Text += text;
  ++this->Written;
}

//----------------------------------------------------------------------------------------------------------------------
void GridOutput::EndLine()
{
  this->Text += '\n';
  this->HandOn();
}

//----------------------------------------------------------------------------------------------------------------------
void GridOutput::EndValues(std::int64_t number)
{
  this->Written += number;
  this->HandOn();
}

//----------------------------------------------------------------------------------------------------------------------
void GridOutput::HandOn()
{
  if (this->Text.size() >= PieceSize)
  {
    this->Stream.write(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->Text.clear();
    this->Work.Progress(static_cast<double>(this->Written) / static_cast<double>(this->NumberOfValues));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GridOutput::Finish()
{
  this->Stream.write(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
  this->Text.clear();
  this->Work.Progress(1.0);
  if (!this->Stream.flush())
  {
    throw InputError(
      "writing failed, expected disk space for a grid of " + std::to_string(this->NumberOfValues) + " values");
  }
}
}
