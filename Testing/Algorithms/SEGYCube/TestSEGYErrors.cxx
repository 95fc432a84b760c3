// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are none, cut off or damaged, and options that cannot be: each gives one error that says what was
// expected.

#include "Common/Base/Errors.h"
#include "Readers/SEGYCube/SEGYWindow.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <filesystem>

using namespace SEGYSample;

namespace
{
SEGYCube ReadBytes(const std::string& bytes, const SEGYOptions& options = SEGYOptions())
{
  return ReadSEGYCube(Write(bytes, "errors"), options);
}

void WhatIsNoSEGYIsRefused()
{
  CHECK_THROWS_WITH(ReadBytes(""), "a file of 0 bytes, expected SEG-Y, which begins with a header of 3600");
  CHECK_THROWS_WITH(ReadBytes("inline crossline z\n"), "a file of 19 bytes, expected SEG-Y");
  CHECK_THROWS_WITH(
    ReadBytes(std::string(9000, 'A')), "format code 16705 at byte 3225, expected 1 (IBM float), 2, 3, 7");
  CHECK_THROWS_WITH(ReadBytes(std::string(9000, '\0')), "format code 0 at byte 3225, expected 1 (IBM float)");
  CHECK_THROWS_WITH(ReadBytes("\x1f\x8b" + Make(File())), "a file compressed by gzip, expected uncompressed SEG-Y");
  CHECK_THROWS_WITH(ReadSEGYCube("no/such.sgy", {}), "no such file");
  CHECK_THROWS_WITH(ReadSEGYCube(".", {}), "a directory, expected a file");
  std::string bytes = Make(File());
  bytes[3225] = 4;
  CHECK_THROWS_WITH(ReadBytes(bytes), "format code 4 at byte 3225");
}

void WhatIsCutIsRefused()
{
  const std::string bytes = Make(File());
  CHECK_THROWS_WITH(ReadBytes(bytes.substr(0, 3599)), "a file of 3599 bytes, expected SEG-Y");
  CHECK_THROWS_WITH(ReadBytes(bytes.substr(0, 3600)),
    "a file of 3600 bytes, expected at least 3860 for the header and a "
    "trace of 5 samples (IBM float)");
  CHECK_THROWS_WITH(ReadBytes(bytes.substr(0, 3600 + 260 + 100)),
    "a file that ends 100 bytes into trace 2, expected whole "
    "traces of 260 bytes, with 5 samples (IBM float)");
}

/// Cut files of whole traces are cubes with missing ones; all others are refused. A line and a trace are no grid.
void EveryCutIsNoticed()
{
  const std::string bytes = Make(File());
  for (std::size_t length = 0; length < bytes.size(); length += length < 3500 || length > 4200 ? 13 : 1)
  {
    const bool isWhole = length > 3600 && (length - 3600) % 260 == 0;
    try
    {
      const SEGYCube cube = ReadBytes(bytes.substr(0, length));
      CHECK(isWhole);
      CHECK_EQUAL(cube.Header.Traces, std::int64_t(length - 3600) / 260);
    }
    catch (const InputError& error)
    {
      CHECK(!isWhole || length == 3600 + 5 * 260);
      CHECK(std::string(error.what()).find("expected ") != std::string::npos);
    }
  }
}

void NumbersThatCanNotBeAreRefused()
{
  File file;
  file.Samples = 0;
  CHECK_THROWS_WITH(Read(file), "0 samples in a trace, in the header (byte 3221) and in the first trace (byte 115)");
  file = File();
  file.Interval = 0;
  CHECK_THROWS_WITH(Read(file),
    "sample interval 0 in the header (byte 3217) and in the first trace (byte 117), "
    "expected more: set VerticalStep");
  SEGYOptions options;
  options.VerticalStep = 2.5;
  CHECK_EQUAL(Read(file, options).Sampling.Step, 2.5);
}

void TracesOfOtherLengthsAreRefused()
{
  File file;
  file.Traces[4].Samples = 6;
  CHECK_THROWS_WITH(Read(file), "trace 1 of 5 and trace 5 of 6 samples (byte 115), expected the same for all");
  file.Traces[4].Samples = 0; // as dead traces have
  CHECK_EQUAL(CountWrong(file, Read(file)), 0);
  for (Trace& trace : file.Traces)
  {
    trace.Samples = 462; // wrong, and of no use
  }
  CHECK_EQUAL(CountWrong(file, Read(file)), 0);
  file.SamplesInHeader = 7;
  CHECK_THROWS_WITH(Read(file), "the first trace says 462 samples: traces of different lengths are not read");
}

void GathersAreRefused()
{
  File file;
  for (std::size_t n = 0; n < file.Traces.size(); ++n)
  {
    file.Traces[n].Offset = 100 * int(n % 4);
  }
  CHECK_THROWS_WITH(Read(file),
    "offset 0 of trace 1 and 100 of trace 2 (byte 37), as in pre-stack data; expected one trace "
    "for each inline and crossline");
  SEGYOptions options;
  options.LineFields = { 189, 193 };
  CHECK_EQUAL(CountWrong(file, Read(file, options)), 0);
  file.Traces[3] = file.Traces[2];
  CHECK_THROWS_WITH(Read(file, options),
    "trace 4 at inline 10 (byte 189) and crossline 102 (byte 193), where there is "
    "another one, expected one trace for each inline and crossline");
  file.Traces.push_back(file.Traces.back());
  for (Trace& trace : file.Traces)
  {
    trace.Offset = 0;
  }
  CHECK_THROWS_WITH(Read(file), "with several traces at one position");
}

void LinesWithoutAGridAreRefused()
{
  File file;
  for (std::size_t n = 0; n < file.Traces.size(); ++n)
  {
    file.Traces[n].Inline = int(n * n * 7);
    file.Traces[n].Crossline = int(n * 31);
  }
  CHECK_THROWS_WITH(Read(file), "no line numbers that make a grid of 12 traces: bytes 189 and 193 span 122 x 12");
  SEGYOptions options;
  options.LineFields = { 189, 193 };
  CHECK_THROWS_WITH(Read(file, options),
    "122 inlines (byte 189) and 12 crosslines (byte 193) for 12 traces, expected a grid "
    "that is at least one sixteenth full");
  file.Traces[0].Delay = 32000;
  file.Traces[1].Delay = -32000;
  options.LineFields = { NoField, 193 };
  CHECK_THROWS_WITH(
    Read(file, options), "16005 vertical indices for 12 traces of 5 samples, expected at most 16 times");
  file = File();
  for (Trace& trace : file.Traces)
  {
    trace = { 0, 0, 2 };
  }
  CHECK_THROWS_WITH(Read(file), "no line numbers that make a grid of 12 traces");
  options.LineFields = { 189, 193 };
  CHECK_THROWS_WITH(Read(file, options), "12 traces, all dead and without line numbers, expected live");
}

void OptionsAreChecked()
{
  const auto check = [](auto&& change)
  {
    SEGYOptions options;
    change(options);
    CheckSEGYOptions(options);
  };
  CHECK_THROWS_WITH(check(
                      [](SEGYOptions& o) {
                        o.LineFields = { 9, 0 };
                      }),
    "InlineByte 9 with CrosslineByte 0, expected both, or 0 for both");
  CHECK_THROWS_WITH(check([](SEGYOptions& o) { o.LineFields = { 9, 238 }; }), "CrosslineByte 238, expected 1 to 237");
  CHECK_THROWS_WITH(check([](SEGYOptions& o) { o.PlaceFields = { -2, 9 }; }), "XByte -2, expected 1 to 237");
  CHECK_THROWS_WITH(check([](SEGYOptions& o) { o.PlaceFields = { -1, 9 }; }), "one of XByte and YByte is -1");
  CHECK_THROWS_WITH(check([](SEGYOptions& o) { o.Tolerance = 0.5; }), "LatticeTolerance 0.5, expected more than 0");
  CHECK_THROWS_WITH(check([](SEGYOptions& o) { o.VerticalStep = -1.0; }), "VerticalStep -1, expected at least 0");
  CHECK_THROWS_WITH(
    check([](SEGYOptions& o) { o.VerticalStep = std::nan(""); }), "VerticalStep nan, expected a finite");
}

void RangesAreOfLinesAndSamples()
{
  const SEGYCube cube = Read(File());
  const auto find = [&cube](const std::array<int, 2>& inlines, const std::array<int, 2>& crosslines,
                      const std::array<int, 2>& samples) {
    return FindExtent(cube, { inlines, crosslines, samples });
  };
  const std::array<int, 2> all = { 0, -1 };
  CHECK(find(all, all, all) == Whole(cube));
  CHECK((find({ 11, 13 }, { 101, 101 }, { 2, 3 }) == CubeExtent{ 1, 1, 1, 1, 2, 3 }));
  CHECK((find({ -5, 12 }, { 102, 900 }, { 4, 99 }) == CubeExtent{ 2, 3, 0, 1, 4, 4 }));
  CHECK_THROWS_WITH(find({ 11, 11 }, all, all),
    "InlineRange 11 to 11, expected some of the lines 10 to 14 in steps of 2, or 0 to -1 for all");
  CHECK_THROWS_WITH(find({ 14, 10 }, all, all), "InlineRange 14 to 10, expected some of the lines 10 to 14");
  CHECK_THROWS_WITH(find(all, { 104, 200 }, all), "CrosslineRange 104 to 200, expected some of the lines 100 to 103");
  for (const std::array<int, 2>& wrong : { std::array<int, 2>{ 5, -1 }, { -1, 3 }, { 3, 2 }, { 0, -2 } })
  {
    CHECK_THROWS_WITH(
      find(all, all, wrong), "expected a first vertical index from 0 to 4, and a last one that is not less");
  }
}

/// A file that gets shorter after its headers were read.
void AFileThatShrinksIsNoticed()
{
  const std::string bytes = Make(File());
  const std::string name = Write(bytes, "shrinks");
  const SEGYCube cube = ReadSEGYCube(name, {});
  std::filesystem::resize_file(name, bytes.size() - 300);
  CHECK_THROWS_WITH(ReadWindow(cube, Whole(cube)), " cannot be read, expected an unchanged file");
  std::filesystem::remove(name);
  CHECK_THROWS_WITH(ReadWindow(cube, Whole(cube)), "the file cannot be opened, expected a readable one");
}
}

int TestSEGYErrors(int, char*[])
{
  WhatIsNoSEGYIsRefused();
  WhatIsCutIsRefused();
  EveryCutIsNoticed();
  NumbersThatCanNotBeAreRefused();
  TracesOfOtherLengthsAreRefused();
  GathersAreRefused();
  LinesWithoutAGridAreRefused();
  OptionsAreChecked();
  RangesAreOfLinesAndSamples();
  AFileThatShrinksIsNoticed();
  return Check::Result();
}
