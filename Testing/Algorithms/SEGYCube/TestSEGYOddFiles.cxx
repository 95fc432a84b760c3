// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Headers and traces that contradict each other: they are read by what makes sense of them, with a warning, or by what
// the user says.

#include "Common/Base/Errors.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <algorithm>
#include <array>

using namespace SEGYSample;

namespace
{
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

/// A cube that was cut between two traces has one line that ends too soon, the last of the file.
void FilesCutBetweenTracesAreTold()
{
  for (const bool isTransposed : { false, true })
  {
    File file;
    if (isTransposed)
    {
      std::stable_sort(file.Traces.begin(), file.Traces.end(),
        [](const Trace& a, const Trace& b) { return a.Crossline < b.Crossline; });
    }
    const std::size_t length = isTransposed ? 3 : 4;
    for (File cut = file; cut.Traces.size() > length + 1; cut.Traces.pop_back())
    {
      const std::size_t traces = cut.Traces.size();
      const std::size_t found = traces % length;
      const std::string line = isTransposed ? "crossline " + std::to_string(cut.Traces.back().Crossline)
                                            : "inline " + std::to_string(cut.Traces.back().Inline);
      const SEGYCube cube = Read(cut);
      CHECK_EQUAL(WarningText(cube),
        found == 0 ? std::string()
                   : std::to_string(traces) + " traces, expected " + std::to_string(traces + length - found) + ": " +
            line + " at the end of the file has " + std::to_string(found) + " of " + std::to_string(length) +
            "; was the file cut?");
    }
  }
  // A survey that is no rectangle may end as it does, and a line may miss its beginning.
  for (const std::vector<std::size_t>& missing : { std::vector<std::size_t>{ 0, 11 }, { 8 }, { 9 }, { 3 } })
  {
    File file;
    for (auto number = missing.rbegin(); number != missing.rend(); ++number)
    {
      file.Traces.erase(file.Traces.begin() + std::ptrdiff_t(*number));
    }
    CHECK_EQUAL(WarningText(Read(file)), std::string());
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
  CHECK(Warns(cube, "a sample interval of 4 ms in the header (byte 3217) and of 2 in the first trace (byte 117)"));
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
    CHECK(Warns(cube, "2 duplicate traces: "));
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
    Read(moved, options), "traces 7 and 14 at one position with delays of 0 and 8 ms (byte 109), expected");
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
  FilesCutBetweenTracesAreTold();
  RubbishForTheNumberOfTextsIsNoticed();
  RevisionsThatAreNoneAreIgnored();
  IntervalsThatDifferAreAWarning();
  OrdersAreFoundWithoutAFormatCode();
  DuplicatesFollowTheRule();
  DeadDuplicatesDoNotCount();
  DuplicatesAreNotEvaded();
  UnevenDelaysAreInterpolated();
  UnevenDelaysCanMoveToTheNearestStep();
  return Check::Result();
}
