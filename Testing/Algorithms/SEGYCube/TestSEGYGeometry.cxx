// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where traces belong: line numbers and places at any bytes, in any order, with gaps, turned and with delays.

#include "Common/Survey/ImageFrame.h"
#include "Common/Text/InputFile.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <random>

using namespace SEGYSample;

namespace
{
bool IsNear(const Eigen::Vector2d& a, double x, double y)
{
  return (a - Eigen::Vector2d(x, y)).norm() < 1e-6;
}

void LinesAreOnTheLattice()
{
  const File file;
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Lattice.Columns[0], 4);
  CHECK_EQUAL(cube.Lattice.Columns[1], 3);
  CHECK_EQUAL(cube.Lattice.Lines->FirstInline, 10.0);
  CHECK_EQUAL(cube.Lattice.Lines->InlineStep, 2.0);
  CHECK_EQUAL(cube.Lattice.Lines->FirstCrossline, 100.0);
  CHECK_EQUAL(cube.Lattice.Lines->CrosslineStep, 1.0);
  CHECK(IsNear(cube.Lattice.Origin, 500000.0, 6000000.0));
  CHECK(IsNear(cube.Lattice.ColumnStep, 25.0, 0.0));
  CHECK(IsNear(cube.Lattice.RowStep, 0.0, 100.0));
  CHECK(cube.LargestDistance < 1e-6);
  CHECK_EQUAL(cube.Sampling.Indices, 5);
  CHECK_EQUAL(cube.Sampling.Step, 4.0);
  CHECK_EQUAL(cube.Survey.HorizontalUnit, std::string("m"));
  CHECK_EQUAL(cube.Survey.VerticalUnit, std::string("ms"));
  CHECK_EQUAL(cube.Survey.VerticalDomain, std::string("time"));
  CHECK_EQUAL(CountWrong(file, cube), 0);
}

void OrdersDoNotMatter()
{
  File file;
  const auto byCrosslines = [](const Trace& a, const Trace& b)
  { return a.Crossline != b.Crossline ? a.Crossline < b.Crossline : a.Inline < b.Inline; };
  CHECK(!Read(file).IsCrosslineSorted);
  std::sort(file.Traces.begin(), file.Traces.end(), byCrosslines);
  CHECK(Read(file).IsCrosslineSorted);
  CHECK_EQUAL(CountWrong(file, Read(file)), 0);
  std::reverse(file.Traces.begin(), file.Traces.end());
  CHECK_EQUAL(CountWrong(file, Read(file)), 0);
  std::shuffle(file.Traces.begin(), file.Traces.end(), std::mt19937(7));
  CHECK_EQUAL(CountWrong(file, Read(file)), 0);
}

void FieldsAreFound()
{
  for (const FieldPair& bytes : { FieldPair{ 189, 193 }, { 9, 21 }, { 5, 21 }, { 9, 13 }, { 17, 13 }, { 221, 225 } })
  {
    for (const FieldPair& places : { FieldPair{ 181, 185 }, { 73, 77 }, { 81, 85 } })
    {
      File file;
      file.InlineByte = bytes.First;
      file.CrosslineByte = bytes.Second;
      file.XByte = places.First;
      file.YByte = places.Second;
      const SEGYCube cube = Read(file);
      CHECK_EQUAL(cube.LineFields.First, bytes.First);
      CHECK_EQUAL(cube.LineFields.Second, bytes.Second);
      CHECK_EQUAL(cube.PlaceFields.First, places.First);
      CHECK_EQUAL(cube.PlaceFields.Second, places.Second);
      CHECK_EQUAL(CountWrong(file, cube), 0);
      CHECK(IsNear(cube.Lattice.RowStep, 0.0, 100.0));
    }
  }
}

/// Any bytes, even such that overlap other fields.
void FieldsCanBeGiven()
{
  File file;
  file.InlineByte = 43;
  file.CrosslineByte = 57;
  file.XByte = 205;
  file.YByte = 213;
  CHECK_THROWS_WITH(Read(file), "no line numbers that make a grid of 12 traces; expected one trace for each inline");
  SEGYOptions options;
  options.LineFields = { 43, 57 };
  CHECK_EQUAL(CountWrong(file, Read(file, options)), 0);
  CHECK_EQUAL(Read(file, options).PlaceFields.First, NoField);
  options.PlaceFields = { 205, 213 };
  CHECK(IsNear(Read(file, options).Lattice.Origin, 500000.0, 6000000.0));
  // The other way round the lattice is turned over, and all is in its place.
  options.LineFields = { 57, 43 };
  const SEGYCube turned = Read(file, options);
  CHECK_EQUAL(turned.Lattice.Columns[0], 3);
  CHECK(IsNear(turned.Lattice.ColumnStep, 0.0, 100.0));
  CHECK_EQUAL(TraceAt(turned, 2, 1), 9);
}

/// Headers of real files have other fields that make grids, too: fuller ones, and such that are preferred.
void TheFullestUsualGridCounts()
{
  File file;
  file.XByte = 73; // the usual one would make a grid as well
  file.YByte = 77;
  std::string bytes = Make(file);
  const auto put = [&](int byte, auto&& number)
  {
    for (int trace = 0; trace < 12; ++trace)
    {
      Bytes field(4, ByteOrder::BigEndian);
      field.Put(1, 4, number(trace));
      bytes.replace(std::size_t(3600 + trace * 260 + byte - 1), 4, field.Text);
    }
  };
  const auto found = [&]() { return ReadSEGYCube(Write(bytes), {}).LineFields.First; };
  put(9, [](int trace) { return trace / 4; });
  put(21, [](int trace) { return trace % 4; });
  CHECK_EQUAL(found(), 189);
  put(193, [](int trace) { return trace < 11 ? 100 + trace % 4 : 107; }); // 12 of 24
  CHECK_EQUAL(found(), 9);
  put(21, [](int trace) { return trace; }); // a number for each trace is none of a line
  CHECK_EQUAL(found(), 189);
  put(193, [](int trace) { return trace < 11 ? 100 + trace % 4 : 102; }); // two at one place
  CHECK_THROWS_WITH(
    found(), "trace 12 at inline 14 (byte 189) and crossline 102 (byte 193), where there is another one");
  put(189, [](int trace) { return trace < 8 ? 10 : 12; }); // and more
  put(73, [](int) { return 0; }); // nor places
  CHECK_THROWS_WITH(
    found(), "bytes 189 and 193 span 2 x 4 with several traces at one position, bytes 9 and 21 span 3 x 12");
}

void GapsAndMissingTracesAreBlank()
{
  File file;
  for (Trace& trace : file.Traces)
  {
    trace.Inline = trace.Inline == 14 ? 20 : trace.Inline; // lines 14, 16 and 18 are missing
  }
  file.Traces.erase(file.Traces.begin() + 5);
  file.Traces[3].Kind = 2;
  file.Traces[6].IsZero = true;
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Lattice.Columns[1], 6);
  CHECK_EQUAL(cube.MissingTraces, 13);
  CHECK_EQUAL(cube.DeadTraces, 1);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  const Window window = ReadWindow(cube, Whole(cube));
  CHECK(!window.Marks.IsFull);
  CHECK(!window.IsThere(1, 1, 0)); // erased
  CHECK(!window.IsThere(3, 0, 0)); // dead
  CHECK(!window.IsThere(3, 1, 0)); // zeros only
  CHECK(window.IsThere(0, 5, 0));
  CHECK(ReadWindow(cube, { 0, 2, 0, 0, 0, 4 }).Marks.IsFull);
}

/// Some programs fill files up by traces of zeros, headers included.
void FillersAreLeftOut()
{
  File file;
  for (int n = 0; n < 5; ++n)
  {
    Trace filler;
    filler.Kind = 2;
    filler.IsZero = true;
    filler.Delay = 12;
    file.Traces.insert(file.Traces.begin(), filler);
  }
  file.X = [](const Trace& t) { return t.Inline == 0 ? 0.0 : 500000.0 + 25.0 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return t.Inline == 0 ? 0.0 : 6000000.0 + 50.0 * (t.Inline - 10); };
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Fillers, 5);
  CHECK_EQUAL(cube.MissingTraces, 0);
  CHECK(cube.Delays.empty());
  CHECK_EQUAL(CountWrong(file, cube), 0);
}

/// Columns without places, as of dead traces with lines, do not count for the map.
void PlacesOfZeroAreNone()
{
  File file;
  file.X = [](const Trace& t) { return t.Inline == 12 ? 0.0 : 500000.0 + 25.0 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return t.Inline == 12 ? 0.0 : 6000000.0 + 50.0 * (t.Inline - 10); };
  const SEGYCube cube = Read(file);
  CHECK(IsNear(cube.Lattice.Origin, 500000.0, 6000000.0));
  CHECK(cube.LargestDistance < 1e-6);
}

void TurnedAndMirroredSurveysAreInTheirPlace()
{
  for (const double side : { 1.0, -1.0 })
  {
    File file;
    const double c = 0.8;
    const double s = 0.6;
    file.X = [=](const Trace& t)
    { return 450000.0 + 25.0 * c * (t.Crossline - 100) - 12.5 * s * side * (t.Inline - 10); };
    file.Y = [=](const Trace& t)
    { return 6700000.0 + 25.0 * s * (t.Crossline - 100) + 12.5 * c * side * (t.Inline - 10); };
    const SEGYCube cube = Read(file);
    CHECK(IsNear(cube.Lattice.Origin, 450000.0, 6700000.0));
    CHECK(IsNear(cube.Lattice.ColumnStep, 20.0, 15.0));
    CHECK(IsNear(cube.Lattice.RowStep, -15.0 * side, 20.0 * side));
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
}

void ScalarsDivideAndMultiply()
{
  for (const int scalar : { -1000, -100, -1, 0, 1, 5, 25 })
  {
    File file;
    file.PlaceScalar = scalar;
    file.X = [](const Trace& t) { return 2000.0 + 25.0 * (t.Crossline - 100); };
    file.Y = [](const Trace& t) { return 60000.0 + 50.0 * (t.Inline - 10); };
    const SEGYCube cube = Read(file);
    CHECK(IsNear(cube.Lattice.Origin, 2000.0, 60000.0));
    CHECK(IsNear(cube.Lattice.ColumnStep, 25.0, 0.0));
  }
}

void PlacesOffTheLatticeAreNotUsed()
{
  File file;
  file.X = [](const Trace& t) { return 500000.0 + 25.0 * (t.Crossline - 100) + (t.Crossline == 102 ? 40.0 : 0.0); };
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.PlaceFields.First, NoField);
  CHECK(WarningText(cube).find("x and y of traces (bytes 181 and 185) up to ") == 0);
  CHECK(WarningText(cube).find("line numbers stand for x and y") != std::string::npos);
  CHECK(IsNear(cube.Lattice.Origin, 100.0, 10.0));
  CHECK(IsNear(cube.Lattice.RowStep, 0.0, 2.0));
  CHECK_EQUAL(cube.Survey.HorizontalUnit, std::string());
  SEGYOptions options;
  options.PlaceFields = { 181, 185 };
  CHECK_THROWS_WITH(Read(file, options), "columns away from their columns, expected at most 0.25");
  options.PlaceFields = { 73, 77 };
  CHECK_THROWS_WITH(Read(file, options), "x and y of traces (bytes 73 and 77) that are all 0, expected coordinates");
  options.PlaceFields = { NoField, NoField };
  CHECK(Read(file, options).Warnings.empty());
}

void DelaysMoveTraces()
{
  File file;
  for (Trace& trace : file.Traces)
  {
    trace.Delay = 100;
  }
  SEGYCube cube = Read(file);
  CHECK(cube.Delays.empty());
  CHECK_EQUAL(cube.Sampling.First, 100.0);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  file.Traces[0].Delay = 108;
  file.Traces[7].Delay = 88;
  cube = Read(file);
  CHECK_EQUAL(cube.Sampling.First, 88.0);
  CHECK_EQUAL(cube.Sampling.Indices, 10);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  for (int first = 0; first < 10; ++first) // windows that begin and end within traces, and outside of them
  {
    for (int last = first; last < 10; ++last)
    {
      CHECK_EQUAL(CountWrong(file, cube, ReadWindow(cube, { 0, 3, 0, 2, first, last })), 0);
    }
  }
  file.Traces[7].Delay = 90;
  CHECK(!Read(file).Warnings.empty());
  file.Traces[7].Kind = 2; // dead ones do not count
  CHECK(Read(file).Warnings.empty());
  CHECK_EQUAL(Read(file).Sampling.First, 100.0);
}

void LinesAreCubesOfOneLine()
{
  for (const bool isInline : { true, false })
  {
    File file;
    file.Traces.clear();
    for (int n = 0; n < 9; ++n)
    {
      const int number = 30 + (n < 5 ? n : n + 2);
      file.Traces.push_back(isInline ? Trace{ 7, number } : Trace{ number, 7 });
    }
    file.X = [](const Trace& t) { return 1000.0 + 30.0 * (t.Inline + t.Crossline); };
    file.Y = [](const Trace& t) { return 9000.0 + 40.0 * (t.Inline + t.Crossline); };
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.Lattice.Columns[isInline ? 0 : 1], 11);
    CHECK_EQUAL(cube.Lattice.Columns[isInline ? 1 : 0], 1);
    CHECK(IsNear(isInline ? cube.Lattice.ColumnStep : cube.Lattice.RowStep, 30.0, 40.0));
    CHECK(IsNear(
      isInline ? cube.Lattice.RowStep : cube.Lattice.ColumnStep, isInline ? -40.0 : 40.0, isInline ? 30.0 : -30.0));
    CHECK_EQUAL(CountWrong(file, cube), 0);
    SEGYOptions options;
    options.LineFields = isInline ? FieldPair{ NoField, 193 } : FieldPair{ 189, NoField };
    CHECK_EQUAL(Read(file, options).Traces.size(), 11u);
    CHECK(IsNear(isInline ? Read(file, options).Lattice.ColumnStep : Read(file, options).Lattice.RowStep, 30.0, 40.0));
  }
}

void ASingleTraceIsACube()
{
  File file;
  file.Traces.resize(1);
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Traces.size(), 1u);
  CHECK_EQUAL(CountWrong(file, cube), 0);
}

/// The lattice is that of the picks of horizons.
void ShearedImagesTellHowFarTheyAreOff()
{
  const LatticeMatrix straight = { 3, 4, 0, 100, -4, 3, 0, 200, 0, 0, -4, -8, 0, 0, 0, 1 };
  ImageFrame frame = MakeCubeFrame(straight, { 10, 20 });
  CHECK_EQUAL(frame.Deviation, 0.0);
  CHECK(frame.Origin == Eigen::Vector3d(100, 200, -8));
  CHECK(frame.Spacing == Eigen::Vector3d(5, 5, 4));
  CHECK(frame.Direction.col(0).isApprox(Eigen::Vector3d(0.6, -0.8, 0)));
  CHECK(frame.Direction.col(1).isApprox(Eigen::Vector3d(0.8, 0.6, 0)));
  CHECK(frame.Direction.col(2) == Eigen::Vector3d(0, 0, -1));
  for (const double side : { 1.0, -1.0 })
  {
    const LatticeMatrix sheared = { 10, 1, 0, 0, 0, side * 10, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1 };
    frame = MakeCubeFrame(sheared, { 11, 21 });
    CHECK(frame.Direction.col(0).dot(frame.Direction.col(1)) < 1e-15);
    CHECK_EQUAL(frame.Direction(2, 2), 1.0);
    double largest = 0.0;
    Eigen::Matrix2d steps;
    steps << 10, 1, 0, side * 10;
    for (int j = 0; j < 21; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        const Eigen::Vector3d point =
          frame.Origin + frame.Direction * frame.Spacing.cwiseProduct(Eigen::Vector3d(i, j, 0));
        const Eigen::Vector2d place = steps * Eigen::Vector2d(i, j);
        largest = std::max(largest, (steps.inverse() * (point.head<2>() - place)).norm());
        CHECK(i != 5 || j != 10 || (point.head<2>() - place).norm() < 1e-12); // the middle
      }
    }
    CHECK(std::abs(largest - frame.Deviation) < 1e-12);
    CHECK(largest > 0.1 && largest < 1.5);
  }
}
}

int TestSEGYGeometry(int, char*[])
{
  LinesAreOnTheLattice();
  OrdersDoNotMatter();
  FieldsAreFound();
  FieldsCanBeGiven();
  TheFullestUsualGridCounts();
  GapsAndMissingTracesAreBlank();
  FillersAreLeftOut();
  PlacesOfZeroAreNone();
  TurnedAndMirroredSurveysAreInTheirPlace();
  ScalarsDivideAndMultiply();
  PlacesOffTheLatticeAreNotUsed();
  DelaysMoveTraces();
  LinesAreCubesOfOneLine();
  ASingleTraceIsACube();
  ShearedImagesTellHowFarTheyAreOff();
  return Check::Result();
}
