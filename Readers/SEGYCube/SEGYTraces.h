// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads traces of a cube from its file.

#ifndef SeismicHorizonsSEGYTraces_h
#define SeismicHorizonsSEGYTraces_h

#include "Common/Base/RawVector.h"
#include "SEGYCube.h"
#include "TraceTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// First and last i, j and k, as in VTK.
using CubeExtent = std::array<int, 6>;

/// Vertical indices with samples; empty if First equals End.
struct SampleRange
{
  int First = 0;
  int End = 0;
};

/// Columns of the cube.
struct TraceTile
{
  int FirstI, LastI, FirstJ, LastJ;

  int Width() const { return this->LastI - this->FirstI + 1; }
  std::size_t Columns() const { return std::size_t(this->Width()) * std::size_t(this->LastJ - this->FirstJ + 1); }
};

struct SampleCheck
{
  bool AreZero = true;
  std::int64_t Nulls = 0;
};

/// Reads the traces of a tile in the order of the file, many at a time. Each thread needs its own.
class TileReader
{
public:
  std::int64_t Nulls = 0; // samples of 1e30 or more, or nan, so far

  TileReader(const SEGYCube& cube, const CubeExtent& extent);

  /// Levels of the extent without a sample are 0, nulls nan; traces of zeros have no samples.
  using Write = std::function<void(int i, int j, const SampleRange& range, const float* levels)>;

  /// Calls write for each column, in order.
  void Read(const TraceTile& tile, const Write& write);

private:
  /// Adjacent traces of the file are read together.
  void LoadTraces(const TraceTile& tile);
  void ToSamples(const unsigned char* trace, std::vector<float>& samples) const;
  /// Averages all traces of the column except zero traces.
  SampleCheck AddDuplicates(std::size_t column, SampleCheck check);
  SampleRange ConvertColumn(const TraceTile& tile, int i, int j, float* levels);

  const SEGYCube& Cube;
  const CubeExtent Extent;
  const std::size_t Levels;
  SEGYFile File;
  RawVector<unsigned char> Bytes; // traces of a tile
  std::vector<std::int32_t> Slots; // trace in Bytes per column, or NoTrace
  std::vector<float> Samples;
  std::vector<float> Column;
};

/// Leaves samples in the file. Threads share readers.
class SEGYTraces
{
public:
  SEGYTraces(std::shared_ptr<const SEGYCube> cube, const CubeExtent& extent);
  ~SEGYTraces();

  /// Reads traces from column (first, j) of the extent on, one after another, within the extent along k; missing samples
  /// are nan. Threads may call it in parallel.
  void Read(int j, int first, int count, float* traces) const;

private:
  struct Readers;
  std::unique_ptr<Readers> Shared;
};
}

#endif
