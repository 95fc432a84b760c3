// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// An input is a SEG-Y file behind two bytes, which say how much of its end is missing and which bytes have its lines.
// Its headers are read, and windows of its samples.

#include "Require.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Readers/SEGYCube/SEGYWindow.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

using namespace Fuzz;
using namespace SeismicHorizons;

namespace
{
/// A file in memory, which the reader opens by its name.
std::string FileName()
{
  return "/dev/shm/FuzzSEGYCube." + std::to_string(getpid());
}

CubeExtent Whole(const SEGYCube& cube)
{
  return { 0, cube.Lattice.Columns[0] - 1, 0, cube.Lattice.Columns[1] - 1, 0, cube.Sampling.Indices - 1 };
}

std::size_t CountCells(const CubeExtent& extent)
{
  return std::size_t(extent[1] - extent[0] + 1) * std::size_t(extent[3] - extent[2] + 1) *
    std::size_t(extent[5] - extent[4] + 1);
}

std::vector<float> ReadValues(const SEGYCube& cube, const CubeExtent& extent, SEGYWindow& window)
{
  std::vector<float> values(CountCells(extent), 1e9f);
  window = ReadSEGYWindow(cube, extent, values.data());
  Require(window.Columns.size() == CountCells({ extent[0], extent[1], extent[2], extent[3], 0, 0 }), "columns");
  return values;
}

void CheckCube(const SEGYCube& cube, std::size_t fileSize)
{
  const CubeExtent whole = Whole(cube);
  Require(cube.Lattice.Columns[0] > 0 && cube.Lattice.Columns[1] > 0 && cube.Sampling.Indices > 0, "an empty cube");
  Require(CountCells(whole) <= 16 * fileSize, "more cells than can be in the file");
  Require(cube.Lattice.Origin.allFinite() && cube.Lattice.ColumnStep.allFinite() && cube.Lattice.RowStep.allFinite(),
    "a lattice that is not finite");
  Require(cube.Traces.size() == CountCells({ whole[0], whole[1], whole[2], whole[3], 0, 0 }), "traces");
  Require(!Describe(cube, cube.Survey).empty(), "no description");
  SEGYWindow window;
  const std::vector<float> values = ReadValues(cube, whole, window);
  // A level in the middle is the same by itself.
  CubeExtent level = whole;
  level[4] = level[5] = whole[5] / 2;
  SEGYWindow windowOfLevel;
  const std::vector<float> ofLevel = ReadValues(cube, level, windowOfLevel);
  const float* const expected = values.data() + ofLevel.size() * std::size_t(level[4]);
  Require(std::memcmp(ofLevel.data(), expected, ofLevel.size() * sizeof(float)) == 0, "a level differs by itself");
  Require(window.Nulls == windowOfLevel.Nulls, "another number of samples that are not finite");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2)
  {
    return 0;
  }
  SeismicHorizons::Detail::NumberOfThreads() = 1;
  const std::string name = FileName();
  const std::size_t length = size - 2 - std::min<std::size_t>(size - 2, data[0] & 0x1f);
  std::ofstream(name, std::ios::binary).write(reinterpret_cast<const char*>(data + 2), std::streamsize(length));
  SEGYOptions options;
  if (data[1] & 1)
  {
    options.LineFields = { 1 + data[1] % 237, 5 + data[1] % 97 };
    options.PlaceFields = { 73, 77 };
  }
  std::string problem;
  try
  {
    CheckCube(ReadSEGYCube(name, options), length);
  }
  catch (const InputError& error)
  {
    problem = error.what();
  }
  Require(problem.empty() || problem.find("expected ") != std::string::npos,
    "an error without what was expected: " + problem);
  std::remove(name.c_str());
  return 0;
}
