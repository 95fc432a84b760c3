// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids as bytes: what is read, and what is refused in which words.

#include "GridSamples.h"

using namespace GridSamples;

namespace
{
void IrapBinaryIsRead()
{
  CHECK(IsTheSample(Read(IrapBinary())));
  const double cosine = std::cos(std::acos(-1.0) / 6.0);
  const std::string values = Record(BigEndian<float>({ 1, 2, 3, 4, 1e30f, 6 })); // records need not be rows
  CHECK(HasLattice(
    Read(IrapBinaryHeader(50, -25, 30) + values), { 1000, 5000 }, { 50 * cosine, 25 }, { 12.5, -25 * cosine }));
  CHECK(IsTheSample(Read(IrapBinaryHeader(50, 25, 0) + values + "notes behind the grid")));
  std::string single;
  for (const float z : { 1.0f, 2.0f, 3.0f, 4.0f, 2e30f, 6.0f })
  {
    single += Record(BigEndian(z));
  }
  CHECK(IsTheSample(Read(IrapBinaryHeader(50, 25, 0) + single)));
}

void IrapBinaryIsChecked()
{
  const std::string header = IrapBinaryHeader(50, 25, 0);
  CHECK_THROWS_WITH(Read(header), "byte 100: end of file, expected a record of values");
  CHECK_THROWS_WITH(Read(header + BigEndian<std::int32_t>(13)),
    "byte 100: a record of 13 bytes, expected one of 1 to 6 values of 4 bytes");
  CHECK_THROWS_WITH(Read(header + BigEndian<std::int32_t>(28)), "byte 100: a record of 28 bytes");
  CHECK_THROWS_WITH(Read(header + BigEndian<std::int32_t>(-4)), "byte 100: a record of -4 bytes");
  CHECK_THROWS_WITH(Read(header + BigEndian<std::int32_t>(8) + BigEndian<float>({ 1, 2 }) + BigEndian<std::int32_t>(9)),
    "byte 112: a record of 9 bytes, expected 8");
  CHECK_THROWS_WITH(Read(header + Record(BigEndian<float>({ 1, -std::numeric_limits<float>::infinity() }))),
    "byte 108: an infinite value, expected a finite number");
  CHECK_THROWS_WITH(Read(IrapBinaryHeader(0, 25, 0)), "byte 100: steps of 0 and 25, expected steps other than 0");
  CHECK_THROWS_WITH(Read(IrapBinaryHeader(50, NAN, 0)), "byte 32: dy is not finite, expected a finite number");
  CHECK_THROWS_WITH(Read(IrapBinaryHeader(50, 25, 1, 0, 0)), "byte 100: a rotation around (0, 0), expected the origin");
  std::string negative = header;
  negative[8] = '\xFF';
  CHECK_THROWS_WITH(Read(negative), "byte 8: ny -16777214, expected a positive integer");
}

/// Memory is taken for what the file can hold.
void HugeCountsCostNothing()
{
  std::string huge = IrapBinary();
  huge.replace(8, 4, BigEndian<std::int32_t>(2000000000));
  huge.replace(48, 4, BigEndian<std::int32_t>(2000000000));
  CHECK_THROWS_WITH(Read(huge), "byte 140: end of file, expected a record of values");
}

void StormIsRead()
{
  CHECK(IsTheSample(Read(Storm())));
  CHECK(IsTheSample(Read(Replace(Storm(), "5025.0\n", "5025.0 \r\n"))));
  CHECK_THROWS_WITH(Read(Replace(Storm(), "3 2 50.0", "3 0 50.0")), "ny \"0\", expected a positive integer");
  CHECK_THROWS_WITH(Read(Replace(Storm(), "3 2 50.0", "3 2 5O.0")), "dx \"5O.0\", expected a finite number");
  CHECK_THROWS_WITH(Read(Replace(Storm(), "5025.0", "5025.0 x")), "\"x\" after ymax, expected the end of the line");
  CHECK_THROWS_WITH(Read(Replace(Storm(), "50.0 25.0", "50.0 0")), "steps of 50 and 0, expected steps other than 0");
  CHECK_THROWS_WITH(Read(Storm() + "x"), "byte 108: more bytes after the last value, expected the end of the file");
  CHECK_THROWS_WITH(Read(Replace(Storm(), "\n\n3 2", "\n" + std::string(100, '3'))), "expected a shorter word");
}

void SurferBinaryIsRead()
{
  CHECK(IsTheSample(Read(SurferBinary())));
  CHECK_THROWS_WITH(Read("DSBB" + LittleEndian<std::int16_t>({ 3, -2 })), "byte 6: ny -2, expected a positive integer");
  CHECK_THROWS_WITH(
    Read(SurferBinary() + "x"), "byte 80: more bytes after the last value, expected the end of the file");
  CHECK_THROWS_WITH(Read("DSBB" + LittleEndian<std::int16_t>({ 3, 2 }) + LittleEndian<double>({ 1, 1, 0, 1 })),
    "byte 40: x from 1 to 1 for 3 nodes, expected increasing values");
}

void Surfer7IsRead()
{
  CHECK(IsTheSample(Read(Surfer7())));
  CHECK(HasValues(Read(Surfer7(1)), { 1, 2, 3, 4, None, None })); // all from the blank value on
  CHECK(IsTheSample(Read(Surfer7() + Section("FLTI", "faults"))));
  CHECK_THROWS_WITH(Read(Surfer7(3)), "byte 8: version 3, expected 1 or 2");
  CHECK_THROWS_WITH(Read(Surfer7(2, 30.0)), "byte 89: a rotation, expected 0 as the format does not use it");
  CHECK_THROWS_WITH(Read(Section("DSRB", "xy")), "byte 0: a section DSRB of 2 bytes, expected 4");
  CHECK_THROWS_WITH(Read(Replace(Surfer7(), Section("NOTE", "other"), Section("GRID", "x"))),
    "byte 12: a section GRID of 1 bytes, expected 72");
  CHECK_THROWS_WITH(Read(Replace(Surfer7(), Section("NOTE", "other"), "NOTE" + LittleEndian<std::int32_t>(-1))),
    "byte 12: a section of -1 bytes, expected at least 0");
  CHECK_THROWS_WITH(Read(Surfer7().substr(0, 12)), "byte 12: end of file, expected a section GRID");
  const std::string header = Surfer7().substr(0, Surfer7().find("DATA"));
  CHECK_THROWS_WITH(Read(header + Section("DATA", LittleEndian<double>({ 1, 2 }))),
    "byte 105: a section DATA of 16 bytes, expected 6 values of 8 bytes");
}
}

int TestBinaryGrids(int, char*[])
{
  IrapBinaryIsRead();
  IrapBinaryIsChecked();
  HugeCountsCostNothing();
  StormIsRead();
  SurferBinaryIsRead();
  Surfer7IsRead();
  return Check::Result();
}
