// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsWindowSample_h
#define SeismicHorizonsWindowSample_h

#include "Readers/SEGYCube/SEGYWindow.h"
#include "SEGYSample.h"
#include "Tools/Check.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <unistd.h>

#include <string>
#include <vector>

namespace SEGYSample
{
/// Writes the bytes of a file into the folder of temporary files, and gives its name.
inline std::string Write(const std::string& bytes, const std::string& name = "sample")
{
  // Tests that run at the same time have the same folder.
  const std::string path = "SEGYCube_" + name + "_" + std::to_string(getpid()) + ".sgy";
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

inline SEGYCube Read(const File& file, const SEGYOptions& options = SEGYOptions(), const std::string& name = "sample")
{
  return ReadSEGYCube(Write(Make(file), name), options);
}

/// The number of the trace of a column.
inline std::int32_t TraceAt(const SEGYCube& cube, int i, int j)
{
  return cube.Traces[cube.Column(i, j)];
}

/// The samples of a window, and what is said of them.
struct Window
{
  CubeExtent Extent;
  std::vector<float> Values;
  SEGYWindow Marks;

  std::size_t Column(int i, int j) const
  {
    return std::size_t((j - this->Extent[2]) * (this->Extent[1] - this->Extent[0] + 1) + i - this->Extent[0]);
  }
  float At(int i, int j, int k) const
  {
    return this->Values[this->Marks.Columns.size() * std::size_t(k - this->Extent[4]) + this->Column(i, j)];
  }
  /// Whether there is a sample.
  bool IsThere(int i, int j, int k) const
  {
    const SampleRange& range = this->Marks.Columns[this->Column(i, j)];
    return range.First <= k && k < range.End;
  }
};

inline CubeExtent Whole(const SEGYCube& cube)
{
  return { 0, cube.Lattice.Columns[0] - 1, 0, cube.Lattice.Columns[1] - 1, 0, cube.Sampling.Indices - 1 };
}

/// How many samples are others where traces are read alone, and stay in the file: those that are not there are nan.
inline int CountOtherTraces(const SEGYCube& cube, const Window& window)
{
  const CubeExtent& extent = window.Extent;
  const SEGYTraces traces(std::make_shared<const SEGYCube>(cube), extent);
  const int levels = extent[5] - extent[4] + 1;
  int other = 0;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int first = extent[0]; first <= extent[1]; first += 3)
    {
      const int count = std::min(3, extent[1] + 1 - first);
      std::vector<float> samples(std::size_t(count) * std::size_t(levels), 0.0f);
      traces.Read(j - extent[2], first - extent[0], count, samples.data());
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        const int i = first + int(n) / levels;
        const int k = extent[4] + int(n) % levels;
        const float expected = window.At(i, j, k);
        const bool isThere = window.IsThere(i, j, k) && !std::isnan(expected);
        other += isThere ? samples[n] != expected : !std::isnan(samples[n]);
      }
    }
  }
  return other;
}

/// Reads a window; values that are not written would be nan.
inline Window ReadWindow(const SEGYCube& cube, const CubeExtent& extent, const Monitor& monitor = Monitor())
{
  Window window;
  window.Extent = extent;
  const std::size_t size = std::size_t(extent[1] - extent[0] + 1) * std::size_t(extent[3] - extent[2] + 1) *
    std::size_t(extent[5] - extent[4] + 1);
  window.Values.assign(size, std::numeric_limits<float>::quiet_NaN());
  window.Marks = ReadSEGYWindow(cube, extent, window.Values.data(), monitor);
  CHECK_EQUAL(CountOtherTraces(cube, window), 0);
  return window;
}

/// What should be in a window by the traces of a file, looked for one by one: the number of points that are wrong.
inline int CountWrong(const File& file, const SEGYCube& cube, const Window& window)
{
  const LineNumbering& lines = *cube.Lattice.Lines;
  int wrong = 0;
  for (int k = window.Extent[4]; k <= window.Extent[5]; ++k)
  {
    for (int j = window.Extent[2]; j <= window.Extent[3]; ++j)
    {
      for (int i = window.Extent[0]; i <= window.Extent[1]; ++i)
      {
        float expected = 0.0f;
        bool isThere = false;
        for (const Trace& trace : file.Traces)
        {
          const int sample = k - int(std::lround((trace.Delay - cube.Sampling.First) / cube.Sampling.Step));
          if (trace.Inline == lines.FirstInline + j * lines.InlineStep &&
            trace.Crossline == lines.FirstCrossline + i * lines.CrosslineStep && trace.Kind < 2 && !trace.IsZero &&
            sample >= 0 && sample < file.Samples)
          {
            isThere = true;
            expected = float(Value(trace.Inline, trace.Crossline, sample));
          }
        }
        wrong += window.At(i, j, k) != expected || window.IsThere(i, j, k) != isThere;
      }
    }
  }
  return wrong;
}

inline int CountWrong(const File& file, const SEGYCube& cube)
{
  return CountWrong(file, cube, ReadWindow(cube, Whole(cube)));
}

/// Whether a cube has a warning with that text; else prints those it has.
inline bool Warns(const SEGYCube& cube, const std::string& text)
{
  const bool warns = WarningText(cube).find(text) != std::string::npos;
  if (!warns)
  {
    std::cerr << "warnings: " << WarningText(cube) << '\n';
  }
  return warns;
}
}

#endif
