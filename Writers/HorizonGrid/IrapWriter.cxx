// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "Common/Text/TextNumbers.h"
#include "GridOutput.h"
#include "GridWriters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr double TextNull = 9999900.0;
constexpr float BinaryNull = 1e30f;
constexpr double FirstBinaryNull = 9.9999e29; // Larger values may be rounded to the null value.
constexpr std::size_t TrailingNumbers = 7;
constexpr int ValuesInLine = 9; // Some programs accept no more.
constexpr double LargestShift = 0.01; // Fraction of a step by which nodes may move to make steps perpendicular.

struct WrittenLattice
{
  double ColumnStep = 0.0;
  double RowStep = 0.0; // Negative for left-handed lattices.
  double Degrees = 0.0; // counterclockwise
};

/// Throws InputError if the farthest node would move.
WrittenLattice FindIrapLattice(const SurveyLattice& lattice)
{
  const Eigen::Vector2d& i = lattice.ColumnStep;
  const Eigen::Vector2d& j = lattice.RowStep;
  const double cross = i.x() * j.y() - i.y() * j.x();
  const double shear = std::fabs(i.stableNormalized().dot(j.stableNormalized()));
  if (!(shear * (lattice.Columns[1] - 1) <= LargestShift))
  {
    const double degrees = std::acos(shear) * (180.0 / std::acos(-1.0));
    throw InputError(
      "steps at " + ShortestText(std::round(100.0 * degrees) / 100.0) + " degrees, expected right angles for IRAP");
  }
  WrittenLattice irap;
  irap.ColumnStep = i.stableNorm(); // Squares of steps may overflow.
  irap.RowStep = std::copysign(j.stableNorm(), cross);
  irap.Degrees = std::atan2(i.y(), i.x()) * (180.0 / std::acos(-1.0)) + 0.0; // Avoids -0.
  return irap;
}

void WriteHeader(GridOutput& output, const SurveyLattice& lattice, const WrittenLattice& irap)
{
  const std::string x = ToDecimal(lattice.Origin.x());
  const std::string y = ToDecimal(lattice.Origin.y());
  const double xLast = lattice.Origin.x() + (lattice.Columns[0] - 1) * irap.ColumnStep;
  const double yLast = lattice.Origin.y() + (lattice.Columns[1] - 1) * irap.RowStep;
  output.WriteLine(
    "-996 " + std::to_string(lattice.Columns[1]) + ' ' + ToDecimal(irap.ColumnStep) + ' ' + ToDecimal(irap.RowStep));
  output.WriteLine(x + ' ' + ToDecimal(xLast) + ' ' + y + ' ' + ToDecimal(yLast));
  output.WriteLine(std::to_string(lattice.Columns[0]) + ' ' + ToDecimal(irap.Degrees) + ' ' + x + ' ' + y);
  output.WriteLine("0 0 0 0 0 0 0");
}

constexpr std::int32_t Mark = -996;

std::uint32_t FloatBits(float number)
{
  std::uint32_t bits = 0;
  static_assert(sizeof(bits) == sizeof(number));
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

/// A Fortran record is big-endian, with its length in bytes before and after it.
void WriteRecord(GridOutput& output, const std::vector<std::uint32_t>& numbers)
{
  const auto write = [&output](std::uint32_t bits)
  {
    for (const int shift : { 24, 16, 8, 0 })
    {
      const char byte = static_cast<char>(bits >> shift & 0xff);
      output.Write(std::string_view(&byte, 1));
    }
  };
  const auto length = static_cast<std::uint32_t>(numbers.size() * sizeof(std::uint32_t));
  write(length);
  std::for_each(numbers.begin(), numbers.end(), write);
  write(length);
}

float ToSingle(double number)
{
  const auto single = static_cast<float>(number);
  if (!std::isfinite(single))
  {
    throw InputError(ShortestText(number) + ", expected a number within single precision for IRAP binary");
  }
  return single;
}

void WriteBinaryHeader(GridOutput& output, const SurveyLattice& lattice, const WrittenLattice& irap)
{
  const auto [columns, rows] = lattice.Columns;
  const auto bits = [](double number) { return FloatBits(ToSingle(number)); };
  const std::uint32_t x = bits(lattice.Origin.x());
  const std::uint32_t y = bits(lattice.Origin.y());
  const double xLast = lattice.Origin.x() + (columns - 1) * irap.ColumnStep;
  const double yLast = lattice.Origin.y() + (rows - 1) * irap.RowStep;
  WriteRecord(output,
    { static_cast<std::uint32_t>(Mark), static_cast<std::uint32_t>(rows), x, bits(xLast), y, bits(yLast),
      bits(irap.ColumnStep), bits(irap.RowStep) });
  WriteRecord(output, { static_cast<std::uint32_t>(columns), bits(irap.Degrees), x, y });
  WriteRecord(output, std::vector<std::uint32_t>(TrailingNumbers, 0));
}
}

//----------------------------------------------------------------------------------------------------------------------
double RoundingOf(const SurveyLattice& lattice)
{
  return (lattice.Origin - lattice.Origin.cast<float>().cast<double>()).cwiseAbs().maxCoeff();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteIrapBinary(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, FirstBinaryNull, "IRAP binary");
  for (const double z : grid.Z)
  {
    ToSingle(std::isnan(z) ? 0.0 : z);
  }
  const WrittenLattice lattice = FindIrapLattice(grid.Lattice);
  GridOutput output(stream, monitor, static_cast<std::int64_t>(grid.Z.size()));
  WriteBinaryHeader(output, grid.Lattice, lattice);
  std::vector<std::uint32_t> row(static_cast<std::size_t>(grid.Lattice.Columns[0]));
  for (auto z = grid.Z.begin(); z != grid.Z.end(); z += grid.Lattice.Columns[0])
  {
    std::transform(z, z + grid.Lattice.Columns[0], row.begin(),
      [](double value) { return FloatBits(std::isnan(value) ? BinaryNull : static_cast<float>(value)); });
    WriteRecord(output, row);
    output.EndValues(grid.Lattice.Columns[0]);
  }
  output.Finish();
}

//----------------------------------------------------------------------------------------------------------------------
void WriteIrapText(std::ostream& stream, const HorizonGrid& grid, const Monitor& monitor)
{
  RequireWritable(grid, TextNull, "IRAP");
  const WrittenLattice lattice = FindIrapLattice(grid.Lattice);
  GridOutput output(stream, monitor, static_cast<std::int64_t>(grid.Z.size()));
  WriteHeader(output, grid.Lattice, lattice);
  int inLine = 0;
  for (const double z : grid.Z)
  {
    output.WriteValue(DecimalText(std::isnan(z) ? TextNull : z).View(), 0);
    inLine = (inLine + 1) % ValuesInLine;
    inLine == 0 ? output.EndLine() : output.Write(" ");
  }
  output.EndLine();
  output.Finish();
}
}
