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
  const SEGYCube numbered = Read(file);
  CHECK_EQUAL(numbered.Lattice.Lines->FirstInline, 1.0);
  CHECK(Warns(numbered, "set InlineByte and CrosslineByte; bytes 197 and 205 make a grid"));
  file.X = [](const Trace& t) { return 500000.0 + (7919 * t.Crossline + 104729 * t.Inline) % 9973; };
  CHECK_THROWS_WITH(Read(file), "with numbers above 99999, as in coordinates");
  file.PlaceScalar = 1;
  file.X = [](const Trace& t) { return 12.0 * (t.Crossline - 99); };
  file.Y = [](const Trace& t) { return 30.0 * (t.Inline - 9); };
  const SEGYCube cube = Read(file); // small numbers may be both
  CHECK_EQUAL(cube.LineFields.First, 181);
  CHECK(Warns(cube,
    "line numbers at bytes 181 and 185, where the standard has x and y. Where line numbers are "
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
    CHECK(Warns(cube, "with x and y off the lattice of the others: placed by their line numbers"));
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

/// Midpoints anywhere in their bins, as of marine surveys without binning.
void IrregularMidpointsMakeTheLatticeOfLeastSquares()
{
  File file = LargeFile();
  std::mt19937 random(11);
  const auto anywhere = [&random]() { return double(random() % 1000) / 1000.0 - 0.5; };
  file.X = [&](const Trace& t) { return 500000.0 + 12.5 * (t.Crossline - 100 + anywhere()); };
  file.Y = [&](const Trace& t) { return 6000000.0 + 25.0 * (t.Inline - 10 + anywhere()); };
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.PlaceFields.First, 181);
  CHECK((cube.Lattice.Origin - Eigen::Vector2d(500000.0, 6000000.0)).norm() < 3.0);
  CHECK((cube.Lattice.ColumnStep - Eigen::Vector2d(12.5, 0.0)).norm() < 0.1);
  CHECK((cube.Lattice.RowStep - Eigen::Vector2d(0.0, 25.0)).norm() < 0.5);
  CHECK(cube.LargestDistance > 0.45 && cube.LargestDistance <= 0.55);
  CHECK(Warns(cube, "of a step off any lattice, 0.3"));
  CHECK(Warns(cube, "as with irregular midpoints: the lattice is a least-squares fit"));
  CHECK_EQUAL(CountWrong(file, cube), 0);
  // A pair on an exact lattice is better.
  file.Change = [](const Trace& trace, Bytes& header)
  {
    header.Put(73, 4, 40000000 + 1250 * (trace.Crossline - 100));
    header.Put(77, 4, 10000000 + 2500 * (trace.Inline - 10));
  };
  CHECK_EQUAL(Read(file).PlaceFields.First, 73);
  SEGYOptions options;
  options.PlaceFields = { 181, 185 };
  CHECK_EQUAL(Read(file, options).PlaceFields.First, 181);
}

/// Without line numbers the lattice is that of the places, as for picks.
void PlacesAloneMakeALattice()
{
  File file = LargeFile();
  file.InlineByte = file.CrosslineByte = 233; // no field that is looked at
  file.X = [](const Trace& t) { return 450000.0 + 20.0 * (t.Crossline - 100) - 15.0 * (t.Inline - 10); };
  file.Y = [](const Trace& t) { return 6700000.0 + 15.0 * (t.Crossline - 100) + 20.0 * (t.Inline - 10); };
  file.Traces.erase(file.Traces.begin() + 77);
  Trace filler = { 0, 0, 2 };
  file.Traces.push_back(filler);
  const auto x = file.X;
  const auto y = file.Y;
  file.X = [=](const Trace& t) { return t.Inline == 0 ? 0.0 : x(t); };
  file.Y = [=](const Trace& t) { return t.Inline == 0 ? 0.0 : y(t); };
  std::shuffle(file.Traces.begin(), file.Traces.end(), std::mt19937(7));
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Lattice.Columns[0], 30);
  CHECK_EQUAL(cube.Lattice.Columns[1], 10);
  CHECK_EQUAL(cube.MissingTraces, 1);
  CHECK_EQUAL(cube.Fillers, 1);
  CHECK(IsAt(cube.Lattice.Origin, 450000.0, 6700000.0));
  CHECK(IsAt(cube.Lattice.ColumnStep, 20.0, 15.0));
  CHECK(IsAt(cube.Lattice.RowStep, -15.0, 20.0));
  CHECK_EQUAL(cube.Lattice.Lines->FirstInline, 1.0);
  CHECK(Warns(cube, "inlines and crosslines are rows and columns of the lattice of x and y, from 1. Where line"));
  CHECK(Describe(cube, cube.Survey).find("10 inlines 1 to 10 in steps of 1 (by x and y)") != std::string::npos);
  for (std::size_t n = 0; n < file.Traces.size(); ++n)
  {
    const Trace& trace = file.Traces[n];
    CHECK(trace.Inline == 0 || TraceAt(cube, trace.Crossline - 100, trace.Inline - 10) == std::int32_t(n));
  }
  CHECK_EQUAL(TraceAt(cube, 17, 2), NoTrace); // the one that is erased
  File scattered = LargeFile();
  scattered.InlineByte = scattered.CrosslineByte = 233;
  std::mt19937 random(5);
  scattered.X = scattered.Y = [&random](const Trace&) { return 1e5 + double(random() % 1000000) / 100.0; };
  CHECK_THROWS_WITH(Read(scattered), "no line numbers that make a grid of 300 traces");
}

/// Codes of byte 89, which are often wrong.
void AnglesAreNoLengths()
{
  const auto unitOf = [](int code, double x, double y, double step)
  {
    File file;
    file.X = [=](const Trace& t) { return x + step * (t.Crossline - 100); };
    file.Y = [=](const Trace& t) { return y + step * (t.Inline - 10); };
    file.PlaceScalar = -10000;
    file.Change = [code](const Trace&, Bytes& header) { header.Put(89, 2, code); };
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.PlaceFields.First, 181);
    CHECK_EQUAL(cube.Survey.HorizontalUnit != "m", WarningText(cube).find("byte 89 is ") != std::string::npos);
    return cube.Survey.HorizontalUnit;
  };
  CHECK_EQUAL(unitOf(0, 12000.0, 18000.0, 25.0), std::string("m"));
  CHECK_EQUAL(unitOf(1, 12000.0, 18000.0, 25.0), std::string("m"));
  CHECK_EQUAL(unitOf(2, 12000.0, 198000.0, 0.5), std::string("arcsec"));
  CHECK_EQUAL(unitOf(3, 4.5, 61.25, 0.005), std::string("degrees"));
  CHECK_EQUAL(unitOf(4, 43000.0, 121500.0, 0.5), std::string("DDDMMSS"));
  CHECK_EQUAL(unitOf(3, 12000.0, 18000.0, 25.0), std::string("m")); // no degrees
}

/// Only the user knows that an interval of 10000 is 10 m.
void TheVerticalUnitIsSaid()
{
  File file;
  file.Interval = 10000;
  const SEGYCube cube = Read(file);
  CHECK(Describe(cube, cube.Survey).find("in steps of 10 ms, taken as time; set VerticalUnit for depth") !=
    std::string::npos);
  SurveyDescription depth = cube.Survey;
  depth.VerticalUnit = "m";
  depth.VerticalDomain = "depth";
  CHECK(Describe(cube, depth).find("5 vertical indices from 0 in steps of 10 m") != std::string::npos);
  CHECK(Describe(cube, depth).find("taken as time") == std::string::npos);
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
    CHECK(Warns(
      cube, "line numbers stand for x and y; the second output has the traces of the line at their true positions"));
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
  CHECK(Warns(cube, "1 traces far from both neighbours in x and y (bytes 181 and 185): moved between them"));
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
  IrregularMidpointsMakeTheLatticeOfLeastSquares();
  PlacesAloneMakeALattice();
  AnglesAreNoLengths();
  TheVerticalUnitIsSaid();
  BentLinesKeepTheirPlaces();
  WhatIsMissingOnALineIsBetweenItsNeighbours();
  return Check::Result();
}
