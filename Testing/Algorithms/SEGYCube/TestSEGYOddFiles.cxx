// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that contradict themselves: they are read by what makes sense of them, with a warning, or by what the user says.

#include "Common/Errors.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <algorithm>
#include <array>
#include <random>

using namespace SEGYSample;

namespace
{
bool Warns(const SEGYCube& cube, const std::string& text)
{
  const bool warns = WarningText(cube).find(text) != std::string::npos;
  if (!warns)
  {
    std::cerr << "warnings: " << WarningText(cube) << '\n';
  }
  return warns;
}

bool IsAt(const Eigen::Vector2d& a, double x, double y)
{
  return (a - Eigen::Vector2d(x, y)).norm() < 1e-3;
}

/// A cube of many traces, so that a few do not count.
File LargeFile()
{
  File file;
  file.Traces.clear();
  for (int n = 0; n < 300; ++n)
  {
    file.Traces.push_back({ 10 + n / 30, 100 + n % 30 });
  }
  file.X = [](const Trace& t) { return 500000.0 + 12.5 * (t.Crossline - 100); };
  file.Y = [](const Trace& t) { return 6000000.0 + 25.0 * (t.Inline - 10); };
  return file;
}

// ---- Where traces begin, and how long they are -------------------------------------------------------------------
void TracesTellTheirLength()
{
  for (const int inHeader : { 4, 6, 7, 60000, 5 + 65 }) // the last one reads every second trace
  {
    File file;
    file.SamplesInHeader = inHeader;
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.Header.Samples, 5);
    CHECK(
      Warns(cube, std::to_string(inHeader) + " samples in the header (byte 3221): traces are read with 5, as they"));
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
  for (const int inTraces : { 3, 462, 5 + 65 }) // and not the header
  {
    File file;
    for (Trace& trace : file.Traces)
    {
      trace.Samples = inTraces;
    }
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(WarningText(cube), std::string());
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
}

void NumbersOfSamplesCanBeGiven()
{
  File file;
  file.SamplesInHeader = 9;
  for (Trace& trace : file.Traces)
  {
    trace.Samples = 77;
  }
  CHECK_THROWS_WITH(
    Read(file), "IgnoreIncompleteTrace to read all but the last, or NumberOfSamples where it is another");
  SEGYOptions options;
  options.Samples = 5;
  CHECK_EQUAL(CountWrong(file, Read(file, options)), 0);
  options.Samples = -1;
  CHECK_THROWS_WITH(Read(file, options), "NumberOfSamples -1, expected at least 1, or 0 to find it");
}

void CutFilesAreReadOnRequest()
{
  SEGYOptions options;
  options.IgnoreIncompleteTrace = true;
  for (const int inHeader : { 5, 8 })
  {
    for (const int missing : { 1, 20, 21, 259 })
    {
      File file;
      file.SamplesInHeader = inHeader;
      std::string bytes = Make(file);
      bytes.resize(bytes.size() - std::size_t(missing));
      CHECK_THROWS_WITH(
        ReadSEGYCube(Write(bytes), {}), "bytes into trace 12, expected whole traces of 260 bytes, with 5");
      const SEGYCube cube = ReadSEGYCube(Write(bytes), options);
      CHECK(Warns(cube, std::to_string(260 - missing) + " bytes into trace 12"));
      CHECK_EQUAL(cube.MissingTraces, 1);
      file.Traces.pop_back();
      CHECK_EQUAL(CountWrong(file, cube), 0);
    }
  }
}

void RubbishForTheNumberOfTextsIsNoticed()
{
  for (const int revision : { 0, 1, 2 })
  {
    for (const int rubbish : { 7, 16448, -1, -12851 })
    {
      File file;
      file.Revision = revision;
      file.ExtendedTextsInHeader = rubbish;
      const SEGYCube cube = Read(file);
      CHECK_EQUAL(cube.Header.ExtendedTexts, 0);
      CHECK_EQUAL(CountWrong(file, cube), 0);
      CHECK(revision == 0 ? cube.Warnings.empty() : Warns(cube, "(byte 3505)"));
    }
    File file;
    file.Revision = revision;
    file.ExtendedTexts = 3;
    CHECK_EQUAL(CountWrong(file, Read(file)), 0);
    file.ExtendedTextsInHeader = 2; // too few
    const SEGYCube cube = Read(file);
    CHECK_EQUAL(cube.Header.ExtendedTexts, 3);
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
}

/// Blanks where revision 2 has numbers of its own.
void RevisionsThatAreNoneAreIgnored()
{
  for (const char blank : { ' ', '\x40', '\xff' })
  {
    const File file;
    std::string bytes = Make(file);
    bytes.replace(3260, 340, std::string(340, blank));
    const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
    CHECK_EQUAL(cube.Header.Revision, 0);
    CHECK_EQUAL(CountWrong(file, cube), 0);
  }
}

void IntervalsThatDifferAreAWarning()
{
  File file;
  file.TraceInterval = 2000;
  const SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Sampling.Step, 4.0);
  CHECK(Warns(cube, "an interval of 4 ms in the header (byte 3217) and of 2 in the first trace (byte 117)"));
}

/// A file without a format code has no byte order but that of its small numbers.
void OrdersAreFoundWithoutAFormatCode()
{
  for (const ByteOrder order : { ByteOrder::BigEndian, ByteOrder::LittleEndian })
  {
    File file;
    file.Order = order;
    file.Format = SEGYFormat::IeeeFloat;
    std::string bytes = Make(file);
    bytes[3224] = bytes[3225] = '\0';
    SEGYOptions options;
    options.FormatCode = 5;
    CHECK_EQUAL(CountWrong(file, ReadSEGYCube(Write(bytes), options)), 0);
  }
}

// ---- Places ------------------------------------------------------------------------------------------------------
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
      areLines ? "(bytes 181 and 185) that are the line numbers, expected places; line numbers stand"
               : "(bytes 181 and 185) with the steps of line numbers, expected places"));
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
    CHECK(Warns(cube, "x and y of traces (bytes 181 and 185) that are floats by their bits, expected integers"));
    SEGYOptions options;
    options.PlaceFields = { 181, 185 };
    CHECK_THROWS_WITH(Read(file, options), "that are floats by their bits, expected integers");
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

// ---- Duplicates --------------------------------------------------------------------------------------------------
File FileWithDuplicates()
{
  File file;
  file.Traces.push_back(file.Traces[6]);
  file.Traces.back().Extra = 10;
  file.Traces.push_back(file.Traces[6]);
  file.Traces.back().Extra = 2;
  return file;
}

void DuplicatesFollowTheRule()
{
  const File file = FileWithDuplicates();
  SEGYOptions options;
  options.LineFields = { 189, 193 };
  CHECK_THROWS_WITH(
    Read(file, options), "trace 13 at inline 12 (byte 189) and crossline 102 (byte 193), where there is");
  CHECK_THROWS_WITH(Read(file, options), "set DuplicatePolicy to read the first, the last or the mean of several");
  const std::array<DuplicateRule, 3> rules = { DuplicateRule::First, DuplicateRule::Last, DuplicateRule::Mean };
  const std::array<int, 3> extras = { 0, 2, 4 };
  for (std::size_t n = 0; n < rules.size(); ++n)
  {
    options.Duplicates = rules[n];
    options.LineFields = {}; // found
    const SEGYCube cube = Read(file, options);
    CHECK_EQUAL(cube.DuplicateTraces, 2);
    CHECK(Warns(cube, "2 traces at places of others: "));
    const Window window = ReadWindow(cube, Whole(cube));
    for (int k = 0; k < 5; ++k)
    {
      CHECK_EQUAL(window.At(2, 1, k), float(Value(12, 102, k) + extras[n]));
      CHECK_EQUAL(window.At(1, 1, k), float(Value(12, 101, k)));
    }
  }
  File moved = file;
  moved.Traces.back().Delay = 8;
  CHECK_THROWS_WITH(
    Read(moved, options), "traces 7 and 14 at one place with delays of 0 and 8 ms (byte 109), expected");
}

/// Neither what is dead nor what is zero has a part in the mean.
void DeadDuplicatesDoNotCount()
{
  for (const bool isDead : { true, false })
  {
    for (const bool isLast : { true, false })
    {
      File file;
      Trace other = file.Traces[6];
      other.Kind = isDead ? 2 : 1;
      other.IsZero = true;
      file.Traces.insert(isLast ? file.Traces.end() : file.Traces.begin(), other);
      SEGYOptions options;
      options.Duplicates = isDead ? DuplicateRule::Refuse : DuplicateRule::Mean;
      const SEGYCube cube = Read(file, options);
      CHECK_EQUAL(cube.DeadTraces, 0);
      CHECK_EQUAL(ReadWindow(cube, Whole(cube)).At(2, 1, 3), float(Value(12, 102, 3)));
    }
  }
}

/// Fields that count traces are no way around duplicates.
void DuplicatesAreNotEvaded()
{
  File file = LargeFile();
  file.Traces[50] = file.Traces[49];
  int number = 0;
  file.Change = [&number](const Trace&, Bytes& header)
  {
    header.Put(9, 4, 1 + number / 30);
    header.Put(13, 4, 1 + number++ % 30);
  };
  CHECK_THROWS_WITH(
    Read(file), "trace 51 at inline 11 (byte 189) and crossline 119 (byte 193), where there is another");
}

// ---- Delays ------------------------------------------------------------------------------------------------------
/// Samples are those of a straight line, on which interpolation is exact, at any part of a step.
void UnevenDelaysAreInterpolated()
{
  for (const int delay : { 1, 2, 3, -1, -6, 21 })
  {
    File file;
    file.Format = SEGYFormat::IeeeFloat;
    file.Samples = 8;
    file.Traces[5].Delay = delay;
    std::string bytes = Make(file);
    const std::size_t size = 240 + 8 * 4;
    for (int k = 0; k < 8; ++k)
    {
      Bytes sample(4, ByteOrder::BigEndian);
      sample.Put(1, 4, Bits(100.0 + 4.0 * k + delay, SEGYFormat::IeeeFloat)); // 100 more than the time
      bytes.replace(3600 + 5 * size + 240 + 4 * std::size_t(k), 4, sample.Text);
    }
    const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
    CHECK(Warns(cube, "1 traces with delays up to "));
    const Window window = ReadWindow(cube, Whole(cube));
    int samples = 0;
    for (int k = 0; k < cube.Sampling.Indices; ++k)
    {
      const double time = cube.Sampling.First + 4.0 * k;
      CHECK_EQUAL(time, 4.0 * std::round(time / 4.0)); // of most traces
      CHECK_EQUAL(window.IsThere(1, 1, k), time >= delay && time <= delay + 28);
      CHECK(!window.IsThere(1, 1, k) || std::abs(window.At(1, 1, k) - float(100.0 + time)) < 1e-4f);
      CHECK_EQUAL(window.IsThere(0, 0, k), time >= 0 && time <= 28);
      samples += window.IsThere(1, 1, k);
    }
    CHECK_EQUAL(samples, 7);
    CHECK_EQUAL(window.At(0, 0, int(std::lround(8.0 - cube.Sampling.First) / 4)), float(Value(10, 100, 2)));
  }
}

void UnevenDelaysCanMoveToTheNearestStep()
{
  File file;
  file.Traces[5].Delay = 3;
  SEGYOptions options;
  options.Delays = DelayRule::Nearest;
  const SEGYCube cube = Read(file, options);
  CHECK(Warns(cube, "1 traces with delays up to 1 ms off whole steps of 4 ms from 0 (byte 109): moved to the nearest"));
  CHECK_EQUAL(ReadWindow(cube, Whole(cube)).At(1, 1, 3), float(Value(12, 101, 2)));
  CHECK_EQUAL(CountWrong(file, cube), 0);
}
}

int TestSEGYOddFiles(int, char*[])
{
  TracesTellTheirLength();
  NumbersOfSamplesCanBeGiven();
  CutFilesAreReadOnRequest();
  RubbishForTheNumberOfTextsIsNoticed();
  RevisionsThatAreNoneAreIgnored();
  IntervalsThatDifferAreAWarning();
  OrdersAreFoundWithoutAFormatCode();
  LineNumbersAreNoPlaces();
  OtherPlacesAreAWarning();
  PlacesAreNoLineNumbers();
  FewWrongPlacesDoNotCount();
  FloatsAreNoPlaces();
  BentLinesKeepTheirPlaces();
  WhatIsMissingOnALineIsBetweenItsNeighbours();
  DuplicatesFollowTheRule();
  DeadDuplicatesDoNotCount();
  DuplicatesAreNotEvaded();
  UnevenDelaysAreInterpolated();
  UnevenDelaysCanMoveToTheNearestStep();
  return Check::Result();
}
