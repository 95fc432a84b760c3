// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Windows of a cube of many tiles: any of them, in any order of the file, on any number of threads.

#include "Common/Base/Parallel.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"
#include "WindowSample.h"

#include <algorithm>
#include <cstring>
#include <random>

using namespace SEGYSample;

namespace
{
/// 60 inlines, 90 crosslines and 30 samples, some traces missing, dead or zero, some with delays.
File LargeFile()
{
  File file;
  file.Samples = 30;
  file.Traces.clear();
  std::mt19937 random(3);
  for (int inlineNumber = 1; inlineNumber <= 60; ++inlineNumber)
  {
    for (int crossline = 501; crossline <= 590; ++crossline)
    {
      Trace trace = { inlineNumber, crossline };
      trace.Kind = random() % 50 == 0 ? 2 : 1;
      trace.IsZero = random() % 50 == 0;
      trace.Delay = 4 * int(random() % 5);
      if (random() % 20 != 0)
      {
        file.Traces.push_back(trace);
      }
    }
  }
  return file;
}

bool AreSame(const Window& a, const Window& b)
{
  const auto same = [](const SampleRange& x, const SampleRange& y) { return x.First == y.First && x.End == y.End; };
  return a.Values.size() == b.Values.size() &&
    std::memcmp(a.Values.data(), b.Values.data(), a.Values.size() * sizeof(float)) == 0 &&
    std::equal(a.Marks.Columns.begin(), a.Marks.Columns.end(), b.Marks.Columns.begin(), b.Marks.Columns.end(), same);
}

/// The part of a window.
Window Cut(const Window& whole, const CubeExtent& extent)
{
  Window part;
  part.Extent = extent;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        part.Values.push_back(whole.At(i, j, k));
        if (k == extent[4])
        {
          part.Marks.Columns.push_back(whole.Marks.Columns[whole.Column(i, j)]);
        }
      }
    }
  }
  return part;
}

CubeExtent RandomExtent(const CubeExtent& whole, std::mt19937& random)
{
  CubeExtent extent;
  for (std::size_t axis = 0; axis < 6; axis += 2)
  {
    const int size = whole[axis + 1] + 1;
    extent[axis] = int(random() % unsigned(size));
    extent[axis + 1] = extent[axis] + int(random() % unsigned(size - extent[axis]));
  }
  return extent;
}

void WindowsArePartsOfTheWhole()
{
  File file = LargeFile();
  std::mt19937 random(5);
  for (int order = 0; order < 3; ++order)
  {
    const SEGYCube cube = Read(file, {}, "large");
    CHECK_EQUAL(cube.IsCrosslineSorted, order == 1);
    const Window whole = ReadWindow(cube, Whole(cube));
    if (order == 0)
    {
      CHECK_EQUAL(CountWrong(file, cube, Cut(whole, { 0, 20, 30, 40, 3, 12 })), 0);
    }
    for (int n = 0; n < 40; ++n)
    {
      const CubeExtent extent = RandomExtent(whole.Extent, random);
      CHECK(AreSame(ReadWindow(cube, extent), Cut(whole, extent)));
    }
    if (order == 0)
    {
      std::stable_sort(file.Traces.begin(), file.Traces.end(),
        [](const Trace& a, const Trace& b) { return a.Crossline < b.Crossline; });
    }
    else
    {
      std::shuffle(file.Traces.begin(), file.Traces.end(), random);
    }
  }
}

/// Also of a file sorted by crosslines, whose tiles are cut in another way.
void ThreadsAndOrdersDoNotMatter()
{
  File file = LargeFile();
  const SEGYCube byInlines = Read(file, {}, "inlines");
  std::stable_sort(
    file.Traces.begin(), file.Traces.end(), [](const Trace& a, const Trace& b) { return a.Crossline < b.Crossline; });
  const SEGYCube byCrosslines = Read(file, {}, "crosslines");
  int& threads = SeismicHorizons::Detail::NumberOfThreads();
  const int before = threads;
  threads = 1;
  const Window one = ReadWindow(byInlines, Whole(byInlines));
  for (const int number : { 1, 2, 3, 7 })
  {
    threads = number;
    CHECK(AreSame(ReadWindow(byInlines, Whole(byInlines)), one));
    CHECK(AreSame(ReadWindow(byCrosslines, Whole(byCrosslines)), one));
    const SEGYCube again = Read(file, {}, "again");
    CHECK(again.Traces == byCrosslines.Traces);
    CHECK(again.Delays == byCrosslines.Delays);
    CHECK(again.Lattice.Origin == byCrosslines.Lattice.Origin);
    CHECK(again.Lattice.RowStep == byCrosslines.Lattice.RowStep);
  }
  threads = before;
}

void WorkIsReportedAndStops()
{
  File file = LargeFile();
  const std::string name = Write(Make(file), "stops");
  CHECK_EQUAL(
    MonitorChecker::Check(4, [&](const Monitor& monitor) { ReadSEGYCube(name, {}, monitor); }), std::string());
  const SEGYCube cube = ReadSEGYCube(name, {});
  CHECK_EQUAL(
    MonitorChecker::Check(1, [&](const Monitor& monitor) { ReadWindow(cube, Whole(cube), monitor); }), std::string());
}
}

int TestSEGYWindows(int, char*[])
{
  WindowsArePartsOfTheWhole();
  ThreadsAndOrdersDoNotMatter();
  WorkIsReportedAndStops();
  return Check::Result();
}
