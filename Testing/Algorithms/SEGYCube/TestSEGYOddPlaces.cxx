// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// x and y that are none, contradict each other, or are wrong for a few traces; and those of lines that are bent.

#include "Common/Base/Errors.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <algorithm>
#include <array>
#include <random>

using namespace SEGYSample;

namespace
{
bool IsAt(const Eigen::Vector2d& a, double x, double y)
{
  return (a - Eigen::Vector2d(x, y)).norm() < 1e-3;
}

/// A pair of fields that repeats the line numbers is no place where another one has some.
void LineNumbersAreNoPlaces()
{
  using Numbers = std::array<int, 2>;
  const std::array<std::function<Numbers(const Trace&)>, 4> repetitions = { [](const Trace& t) {
                                                                             return Numbers{ t.Inline, t.Crossline };
                                                                           },
    [](const Trace& t) {
      return Numbers{ t.Crossline, t.Inline };
    },
    [](const Trace& t) {
      return Numbers{ 100 * t.Inline, 100 * t.Crossline };
    },
    [](const Trace& t) {
      return Numbers{ t.Inline - 9, t.Crossline - 99 };
    } }; // counted from the first
  for (std::size_t kind = 0; kind < repetitions.size(); ++kind)
  {
    File file;
    file.XByte = 73;
    file.YByte = 77;
    file.Change = [&](const Trace& trace, Bytes& header)
    {
      header.Put(181, 4, repetitions[kind](trace)[0]);
      header.Put(185, 4, repetitions[kind](trace)[1]);
    };
    SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.PlaceFields.First, 73);
    CHECK(IsAt(cube.Lattice.RowStep, 0.0, 100.0));
    CHECK_EQUAL(WarningText(cube), std::string());
    file.X = file.Y = [](const Trace&) { return 0.0; };
    cube = Read(file);
    const bool areLines = kind < 3;
    CHECK_EQUAL(cube.PlaceFields.First, areLines ? NoField : 181);
    CHECK(Warns(cube,
      areLines ? "(bytes 181 and 185) that equal the line numbers, expected coordinates; line numbers stand"
               : "(bytes 181 and 185) with the steps of line numbers, expected coordinates"));
  }
}

void OtherPlacesAreAWarning()
{
  File file;
  file.Change = [](const Trace& trace, Bytes& header)
  {
    header.Put(73, 4, 80000000 + 5000 * (trace.Crossline - 100));
    header.Put(77, 4, 10000000 + 5000 * (trace.Inline - 10));
  };
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.PlaceFields.First, 181);
  CHECK(Warns(cube, "(bytes 73 and 77) on another lattice, up to "));
  file.Change = [](const Trace& trace, Bytes& header) { header.Put(73, 4, trace.Inline * trace.Crossline % 17); };
  CHECK(Read(file).Warnings.empty()); // no lattice
}

/// Coordinates along the axes make a grid as line numbers do.
void PlacesAreNoLineNumbers()
{
  File file;
  file.InlineByte = 197;
  file.CrosslineByte = 205;
  CHECK_THROWS_WITH(Read(file), "bytes 181 and 185 span 4 x 3 with numbers above 99999, as of x and y");
  CHECK_THROWS_WITH(Read(file), "set InlineByte and CrosslineByte; bytes 197 and 205 make a grid");
  file.PlaceScalar = 1;
  file.X = [](const Trace& t) { return 12.0 * (t.Crossline - 99); };
  file.Y = [](const Trace& t) { return 30.0 * (t.Inline - 9); };
  const SEGYCube cube = Read(file); // small numbers may be both
  CHECK_EQUAL(cube.LineFields.First, 181);
  CHECK(Warns(cube,
    "line numbers at bytes 181 and 185, where x and y are by the standard. Where line numbers are "
    "elsewhere, set InlineByte and CrosslineByte; bytes 197 and 205 make a grid"));
}

void FewWrongPlacesDoNotCount()
{
  for (const int wrong : { 1, 3, 25 })
  {
    File file = LargeFile();
    const auto isWrong = [wrong](const Trace& t)
    { return 101 * (30 * (t.Inline - 10) + t.Crossline - 100) % 300 < wrong; }; // anywhere
    const auto right = file.X;
    file.X = [=](const Trace& t) { return isWrong(t) ? 20000000.0 - 977.0 * t.Crossline : right(t); };
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.StrayPlaces, std::int64_t(wrong));
    CHECK(IsAt(cube.Lattice.Origin, 500000.0, 6000000.0));
    CHECK(IsAt(cube.Lattice.ColumnStep, 12.5, 0.0));
    CHECK(IsAt(cube.Lattice.RowStep, 0.0, 25.0));
    CHECK(cube.LargestDistance < 1e-6);
    CHECK(Warns(cube, "with x and y off the lattice of all others: put on it by their line numbers"));
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
}

void FloatsAreNoPlaces()
{
  for (const SEGYFormat format : { SEGYFormat::IeeeFloat, SEGYFormat::IbmFloat })
  {
    File file;
    file.XByte = file.YByte = 201; // nothing at the usual bytes
    file.Change = [format](const Trace& trace, Bytes& header)
    {
      header.Put(181, 4, Bits(500000.0 + 25.0 * (trace.Crossline - 100), format));
      header.Put(185, 4, Bits(6000000.0 + 50.0 * (trace.Inline - 10), format));
    };
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.PlaceFields.First, NoField);
    CHECK(Warns(cube, "x and y of traces (bytes 181 and 185) have the bits of floats, expected integers"));
    SEGYOptions options;
    options.PlaceFields = { 181, 185 };
    CHECK_THROWS_WITH(Read(file, options), "have the bits of floats, expected integers");
  }
}

File BentLine()
{
  File file;
  file.Traces.clear();
  for (int n = 0; n < 40; ++n)
  {
    file.Traces.push_back({ 7, 100 + n });
  }
  file.X = [](const Trace& t) { return 1000.0 + 10.0 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return 9000.0 + 10.0 * std::max(0, t.Crossline - 120); };
  return file;
}

void BentLinesKeepTheirPlaces()
{
  for (const FieldPair& given : { FieldPair{ 0, 0 }, { 181, 185 } })
  {
    const File file = BentLine();
    SEGYOptions options;
    options.PlaceFields = given;
    const SEGYCube cube = Read(file, options);
    CHECK_EQUAL(cube.PlaceFields.First, NoField);
    CHECK(Warns(cube, "line numbers stand for x and y; the second output has the traces of the line where they are"));
    if (!CHECK_EQUAL(cube.Places.size(), 40u))
    {
      continue;
    }
    for (std::size_t n = 0; n < file.Traces.size(); ++n)
    {
      CHECK(IsAt(cube.Places[n], file.X(file.Traces[n]), file.Y(file.Traces[n])));
    }
  }
  CHECK(Read(File()).Places.empty());
  SEGYOptions none;
  none.PlaceFields = { NoField, NoField };
  CHECK(Read(BentLine(), none).Places.empty());
}

void WhatIsMissingOnALineIsBetweenItsNeighbours()
{
  File file = BentLine();
  const auto x = file.X;
  const auto y = file.Y;
  file.X = [=](const Trace& t) { return t.Crossline == 110 ? 5e6 : t.Crossline == 115 ? 0.0 : x(t); };
  file.Y = [=](const Trace& t) { return t.Crossline == 110 ? -3.0 : t.Crossline == 115 ? 0.0 : y(t); };
  const Trace first = file.Traces.front();
  const Trace erased = file.Traces[5];
  file.Traces.erase(file.Traces.begin() + 5);
  const SEGYCube cube = Read(file);
  if (CHECK_EQUAL(cube.Places.size(), 40u))
  {
    CHECK(IsAt(cube.Places[0], x(first), y(first)));
    CHECK(IsAt(cube.Places[5], x(erased), y(erased)));
    CHECK(IsAt(cube.Places[10], 1100.0, 9000.0));
    CHECK(IsAt(cube.Places[15], 1150.0, 9000.0));
  }
  CHECK(Warns(cube, "1 traces far from both neighbours by x and y (bytes 181 and 185): put between them"));
  // Places anywhere are no line.
  file.X = [](const Trace& t) { return double(std::mt19937(unsigned(t.Crossline))() % 1000); };
  file.Y = [](const Trace& t) { return double(std::mt19937(unsigned(7 * t.Crossline))() % 1000); };
  CHECK(Read(file).Places.empty());
}
}

int TestSEGYOddPlaces(int, char*[])
{
  LineNumbersAreNoPlaces();
  OtherPlacesAreAWarning();
  PlacesAreNoLineNumbers();
  FewWrongPlacesDoNotCount();
  FloatsAreNoPlaces();
  BentLinesKeepTheirPlaces();
  WhatIsMissingOnALineIsBetweenItsNeighbours();
  return Check::Result();
}
