// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the writers write is read as the same grid again, byte for byte where it matters, and what a format cannot hold
// is refused.

#include "GridSamples.h"
#include "Tools/MonitorChecker.h"
#include "Writers/HorizonGrid/GridWriters.h"

#include <algorithm>

using namespace GridSamples;
using namespace SeismicHorizons;

namespace
{
using Writer = void (*)(std::ostream&, const HorizonGrid&, const Monitor&);

std::string Write(Writer write, const HorizonGrid& grid)
{
  std::ostringstream stream;
  write(stream, grid, Monitor());
  return stream.str();
}

std::string IrapOf(const HorizonGrid& grid)
{
  return Write(WriteIrapText, grid);
}

std::string ZmapOf(const HorizonGrid& grid)
{
  return Write(WriteZmap, grid);
}

HorizonGrid Sample()
{
  return Read(IrapText());
}

/// Values with all digits, of many sizes.
HorizonGrid Awkward()
{
  HorizonGrid grid;
  grid.Lattice.Columns = { 13, 7 };
  grid.Lattice.Origin = { 459218.90625371, 6627263.509993 };
  grid.Lattice.ColumnStep = { 12.5, 0.0 };
  grid.Lattice.RowStep = { 0.0, 25.0 };
  for (int n = 0; n < 13 * 7; ++n)
  {
    grid.Z.push_back(n % 5 == 0 ? None : std::sin(n) * std::pow(10.0, n % 14 - 8));
  }
  grid.Z[1] = 0.0;
  grid.Z[2] = -1e-300;
  grid.Z[3] = 1500.0;
  return grid;
}

void IrapHasTheFormOfOthers()
{
  CHECK_EQUAL(IrapOf(Sample()),
    "-996 2 50.0 25.0\n1000.0 1100.0 5000.0 5025.0\n3 0.0 1000.0 5000.0\n0 0 0 0 0 0 0\n"
    "1.0 2.0 3.0 4.0 9999900.0 6.0 \n");
}

void IrapBinaryHasTheFormOfOthers()
{
  const std::int32_t rows = 2;
  const std::int32_t columns = 3;
  CHECK_EQUAL(Write(WriteIrapBinary, Sample()),
    Record(BigEndian(std::vector<std::int32_t>{ -996, rows }) +
      BigEndian(std::vector<float>{ 1000, 1100, 5000, 5025, 50, 25 })) +
      Record(BigEndian(columns) + BigEndian(std::vector<float>{ 0, 1000, 5000 })) + Record(std::string(28, '\0')) +
      Record(BigEndian(std::vector<float>{ 1, 2, 3 })) + Record(BigEndian(std::vector<float>{ 4, 1e30f, 6 })));
}

/// Places and values come back as single precision has them.
void IrapBinaryRounds()
{
  HorizonGrid grid = Awkward();
  const double turn = 0.6;
  grid.Lattice.ColumnStep = 12.5 * Eigen::Vector2d(std::cos(turn), std::sin(turn));
  grid.Lattice.RowStep = -18.75 * Eigen::Vector2d(-std::sin(turn), std::cos(turn));
  const HorizonGrid again = Read(Write(WriteIrapBinary, grid));
  const Eigen::Vector2d moved = again.Lattice.Origin - grid.Lattice.Origin;
  CHECK_EQUAL(moved.cwiseAbs().maxCoeff(), RoundingOf(grid.Lattice));
  CHECK(RoundingOf(grid.Lattice) > 1e-3 && RoundingOf(grid.Lattice) <= 0.25);
  CHECK((again.Lattice.Steps() - grid.Lattice.Steps()).cwiseAbs().maxCoeff() < 1e-5);
  std::vector<double> rounded;
  for (const double z : grid.Z)
  {
    rounded.push_back(static_cast<float>(z));
  }
  CHECK(HasValues(again, rounded));
  CHECK_EQUAL(RoundingOf(Sample().Lattice), 0.0);
}

void ZmapHasTheFormOfOthers()
{
  HorizonGrid grid = Sample();
  grid.Name = "top, \n@reek";
  CHECK_EQUAL(ZmapOf(grid),
    "@top    reek HEADER, GRID, 5\n15, -99999.0, , 1, 1\n2, 3, 1000.0, 1100.0, 5000.0, 5025.0\n0.0, 0.0, 0.0\n@\n"
    "            4.0            1.0\n       -99999.0            2.0\n            6.0            3.0\n");
  CHECK_EQUAL(Read(ZmapOf(grid)).Name, "top    reek");
}

/// No value is one that no value is near, in single precision, too.
void ZmapNullsAreBelowAllValues()
{
  const std::pair<double, std::string> lowest[] = { { -98000.0, "-99999.0" }, { -99998.9999, "-999999.0" },
    { -1e6, "-9999999.0" }, { -9.9999999e6, "1.0E+30" } };
  for (const auto& [z, null] : lowest)
  {
    HorizonGrid grid = Sample();
    grid.Z[0] = z;
    CHECK(ZmapOf(grid).find(", " + null + ", ,") != std::string::npos);
    CHECK(HasValues(Read(ZmapOf(grid)), grid.Z));
  }
}

/// Old readers take lines of 100 characters, whose values have one width, and begin each column in a new one.
void ZmapLinesAreRegular()
{
  std::istringstream lines(ZmapOf(Awkward()));
  std::string line;
  for (int n = 0; n < 5; ++n)
  {
    std::getline(lines, line);
    CHECK(line.size() <= 100);
  }
  for (int column = 0; column < 13; ++column)
  {
    std::getline(lines, line);
    const std::size_t width = line.size() / 5;
    std::getline(lines, line);
    CHECK_EQUAL(line.size(), 2 * width);
  }
}

void WrittenGridsAreReadAgain()
{
  for (const HorizonGrid& grid : { Sample(), Awkward() })
  {
    for (const Writer write : { WriteIrapText, WriteZmap, WriteCps3, WriteSurfer, WriteEsri })
    {
      const HorizonGrid again = Read(Write(write, grid));
      CHECK(again.Lattice.Columns == grid.Lattice.Columns);
      CHECK(again.Lattice.Origin == grid.Lattice.Origin);
      CHECK(HasLattice(again, grid.Lattice.Origin, grid.Lattice.ColumnStep, grid.Lattice.RowStep));
      CHECK(HasValues(again, grid.Z));
    }
  }
}

void IrapTurnsAndMirrors()
{
  for (const double degrees : { 0.0, 30.0, 90.0, 140.000015, -10.0, 180.0, -90.0 })
  {
    for (const double side : { 1.0, -1.0 })
    {
      HorizonGrid grid = Awkward();
      const double angle = degrees * std::acos(-1.0) / 180.0;
      grid.Lattice.ColumnStep = 12.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      grid.Lattice.RowStep = side * 18.75 * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
      const HorizonGrid again = Read(IrapOf(grid));
      CHECK(HasLattice(again, grid.Lattice.Origin, grid.Lattice.ColumnStep, grid.Lattice.RowStep));
      CHECK(HasValues(again, grid.Z));
    }
  }
}

/// A lattice that runs from another corner, or the other way, is the same grid; nulls are below all values.
void AllWaysAlongTheAxes()
{
  const HorizonGrid expected = Sample();
  HorizonGrid mirrored = expected;
  mirrored.Lattice.Origin = { 1100, 5025 };
  mirrored.Lattice.ColumnStep = { -50, 0 };
  mirrored.Lattice.RowStep = { 0, -25 };
  std::reverse(mirrored.Z.begin(), mirrored.Z.end());
  HorizonGrid turned = expected;
  turned.Lattice.Columns = { 2, 3 };
  turned.Lattice.Origin = { 1100, 5000 };
  turned.Lattice.ColumnStep = { 0, 25 };
  turned.Lattice.RowStep = { -50, 0 };
  turned.Z = { 3, 6, 2, None, 1, 4 };
  HorizonGrid low = expected;
  low.Z[0] = -9999.0;
  for (const Writer write : { WriteZmap, WriteCps3, WriteSurfer, WriteEsri })
  {
    CHECK(IsTheSample(Read(Write(write, mirrored))));
    CHECK(IsTheSample(Read(Write(write, turned))));
    CHECK(HasValues(Read(Write(write, low)), low.Z));
  }
}

void LatticesThatDoNotFitAreRefused()
{
  HorizonGrid grid = Sample();
  grid.Lattice.RowStep = { 25, 25 };
  CHECK_THROWS_WITH(IrapOf(grid), "steps at 45 degrees, expected right angles for IRAP");
  CHECK_THROWS_WITH(Write(WriteIrapBinary, grid), "steps at 45 degrees, expected right angles for IRAP");
  const std::string message = "a rotated or sheared lattice, expected a lattice along the axes for ZMAP+; use IRAP";
  CHECK_THROWS_WITH(ZmapOf(grid), message);
  grid.Lattice.ColumnStep = { 49.9, 2 };
  grid.Lattice.RowStep = { -1, 24.95 };
  CHECK_THROWS_WITH(ZmapOf(grid), message);
  grid.Lattice.ColumnStep = { 0, 0 };
  for (const Writer write : { WriteIrapText, WriteIrapBinary, WriteZmap, WriteCps3, WriteSurfer, WriteEsri })
  {
    CHECK_THROWS_WITH(
      Write(write, grid), " with the steps (0, 0) and (-1, 24.95), expected finite numbers, and steps other than 0");
  }
}

void ValuesThatDoNotFitAreRefused()
{
  HorizonGrid grid = Sample();
  grid.Z[5] = 9999900.0;
  CHECK_THROWS_WITH(
    IrapOf(grid), "value 9999900 of column (2, 1), expected less than 9999900.0, which means no value in IRAP");
  CHECK_EQUAL(Read(ZmapOf(grid)).Z[5], 9999900.0);
  grid.Z[5] = 1e30;
  CHECK_THROWS_WITH(
    ZmapOf(grid), "value 1e+30 of column (2, 1), expected less than 9.9e+29, which means no value in ZMAP+");
  grid.Z[5] = -std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(IrapOf(grid), "value -inf of column (2, 1)");
  grid.Z[5] = 9.99999999e29;
  CHECK_THROWS_WITH(
    Write(WriteIrapBinary, grid), "of column (2, 1), expected less than 9.9999e+29, which means no value");
  grid.Z[5] = -1e300;
  CHECK_THROWS_WITH(Write(WriteIrapBinary, grid), "-1e+300, expected a number within single precision for IRAP binary");
  grid.Z.pop_back();
  CHECK_THROWS_WITH(ZmapOf(grid), "5 values, expected one for each of 3 x 2 nodes");
}

void WriteErrorsAreTold()
{
  for (const Writer write : { WriteIrapText, WriteIrapBinary, WriteZmap, WriteCps3, WriteSurfer, WriteEsri })
  {
    std::ostringstream stream;
    stream.setstate(std::ios::badbit);
    CHECK_THROWS_WITH(write(stream, Sample(), Monitor()), "writing failed, expected disk space for a grid of 6 values");
  }
}

void WritingStopsOnRequest()
{
  HorizonGrid grid;
  grid.Lattice.Columns = { 400, 900 };
  grid.Z.assign(400 * 900, 1234.5678);
  for (const Writer write : { WriteIrapText, WriteIrapBinary, WriteZmap, WriteCps3, WriteSurfer, WriteEsri })
  {
    const auto work = [&](const Monitor& monitor)
    {
      std::ostringstream stream;
      write(stream, grid, monitor);
    };
    CHECK_EQUAL(MonitorChecker::Check(4, work), std::string());
  }
}
}

int TestGridWriters(int, char*[])
{
  IrapHasTheFormOfOthers();
  IrapBinaryHasTheFormOfOthers();
  IrapBinaryRounds();
  ZmapHasTheFormOfOthers();
  ZmapNullsAreBelowAllValues();
  ZmapLinesAreRegular();
  WrittenGridsAreReadAgain();
  IrapTurnsAndMirrors();
  AllWaysAlongTheAxes();
  LatticesThatDoNotFitAreRefused();
  ValuesThatDoNotFitAreRefused();
  WriteErrorsAreTold();
  WritingStopsOnRequest();
  return Check::Result();
}
