// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The window is cut into tiles of columns. A thread reads the traces of a tile, and writes them strip by strip, level by
// level. A strip lies along i, where a level is contiguous in memory. Tiles of crossline-sorted files are long along j,
// so that traces are contiguous in the file.

#include "SEGYWindow.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/RawVector.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
/// First and last index.
using IndexRange = std::array<int, 2>;

/// The indices of the lines whose numbers are in a range.
IndexRange LinesWithin(const char* name, const std::array<int, 2>& range, double first, double step, int count)
{
  if (range[0] == 0 && range[1] == -1)
  {
    return { 0, count - 1 };
  }
  const double low = std::max(0.0, std::ceil((range[0] - first) / step));
  const double high = std::min(count - 1.0, std::floor((range[1] - first) / step));
  if (low > high)
  {
    std::ostringstream text;
    text.precision(10);
    text << name << ' ' << range[0] << " to " << range[1] << ", expected some of the lines " << first << " to "
         << first + step * (count - 1) << " in steps of " << step << ", or 0 to -1 for all";
    throw InputError(text.str());
  }
  return { int(low), int(high) };
}

IndexRange SamplesWithin(const std::array<int, 2>& range, int count)
{
  if (range[0] < 0 || range[0] >= count || range[1] < -1 || (range[1] >= 0 && range[1] < range[0]))
  {
    std::ostringstream text;
    text << "SampleRange " << range[0] << " to " << range[1] << ", expected a first vertical index from 0 to "
         << count - 1 << ", and a last one that is not less, or -1 for the end";
    throw InputError(text.str());
  }
  return { range[0], range[1] < 0 ? count - 1 : std::min(range[1], count - 1) };
}

constexpr std::size_t TileBytes = std::size_t(1) << 22;
constexpr std::int64_t MostTileColumns = 1024;
constexpr int StripWidth = 64; // columns
constexpr int NarrowStrip = 16; // A cache line.

std::vector<TraceTile> CutIntoTiles(const SEGYCube& cube, const CubeExtent& extent)
{
  const std::int64_t columns =
    std::max<std::int64_t>(StripWidth, std::min(MostTileColumns, std::int64_t(TileBytes / cube.Header.TraceSize())));
  const int width = extent[1] - extent[0] + 1;
  const int tileWidth = cube.IsCrosslineSorted ? NarrowStrip : int(std::min<std::int64_t>(width, columns));
  const int tileHeight = int(std::max<std::int64_t>(1, columns / tileWidth));
  std::vector<TraceTile> tiles;
  for (std::int64_t j = extent[2]; j <= extent[3]; j += tileHeight)
  {
    for (std::int64_t i = extent[0]; i <= extent[1]; i += tileWidth)
    {
      tiles.push_back({ int(i), int(std::min<std::int64_t>(extent[1], i + tileWidth - 1)), int(j),
        int(std::min<std::int64_t>(extent[3], j + tileHeight - 1)) });
    }
  }
  return tiles;
}

/// Writes columns level by level, in strips along i, where a level is contiguous.
class StripWriter
{
public:
  StripWriter(const CubeExtent& extent, float* values)
    : Extent(extent)
    , Levels(std::size_t(extent[5] - extent[4] + 1))
    , Width(std::size_t(extent[1] - extent[0] + 1))
    , Height(std::size_t(extent[3] - extent[2] + 1))
    , Values(values)
    , Strip(StripWidth * this->Levels)
  {
  }

  void Add(const TraceTile& tile, int i, int j, const float* levels)
  {
    const int inStrip = (i - tile.FirstI) % StripWidth;
    std::copy_n(levels, this->Levels, this->Strip.data() + std::size_t(inStrip) * this->Levels);
    if (inStrip + 1 == StripWidth || i == tile.LastI)
    {
      this->Write(i - inStrip, i, j);
    }
  }

  std::size_t OutputColumn(int i, int j) const
  {
    return std::size_t(j - this->Extent[2]) * this->Width + std::size_t(i - this->Extent[0]);
  }

private:
  void Write(int firstI, int lastI, int j)
  {
    const auto width = std::size_t(lastI - firstI + 1);
    float* output = this->Values + this->OutputColumn(firstI, j);
    for (std::size_t level = 0; level < this->Levels; ++level, output += this->Width * this->Height)
    {
      const float* sample = this->Strip.data() + level;
      for (std::size_t column = 0; column < width; ++column, sample += this->Levels)
      {
        output[column] = *sample;
      }
    }
  }

  const CubeExtent& Extent;
  const std::size_t Levels, Width, Height;
  float* const Values;
  RawVector<float> Strip; // column by column
};
}

//----------------------------------------------------------------------------------------------------------------------
CubeExtent FindExtent(const SEGYCube& cube, const SEGYRanges& ranges)
{
  const SurveyLattice& lattice = cube.Lattice;
  const LineNumbering& lines = *lattice.Lines;
  const IndexRange i =
    LinesWithin("CrosslineRange", ranges.Crosslines, lines.FirstCrossline, lines.CrosslineStep, lattice.Columns[0]);
  const IndexRange j =
    LinesWithin("InlineRange", ranges.Inlines, lines.FirstInline, lines.InlineStep, lattice.Columns[1]);
  const IndexRange k = SamplesWithin(ranges.Samples, cube.Sampling.Indices);
  return { i[0], i[1], j[0], j[1], k[0], k[1] };
}

//----------------------------------------------------------------------------------------------------------------------
SEGYWindow ReadSEGYWindow(const SEGYCube& cube, const CubeExtent& extent, float* values, const Monitor& monitor)
{
  const std::vector<TraceTile> tiles = CutIntoTiles(cube, extent);
  SEGYWindow window;
  window.Columns.resize(std::size_t(extent[1] - extent[0] + 1) * std::size_t(extent[3] - extent[2] + 1));
  std::atomic<std::int64_t> nulls(0);
  ParallelFor(std::int64_t(tiles.size()), 1, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      TileReader reader(cube, extent);
      StripWriter writer(extent, values);
      for (std::int64_t n = first; n < last; ++n)
      {
        const TraceTile& tile = tiles[std::size_t(n)];
        reader.Read(tile,
          [&](int i, int j, const SampleRange& range, const float* levels)
          {
            window.Columns[writer.OutputColumn(i, j)] = range;
            writer.Add(tile, i, j, levels);
          });
      }
      nulls += reader.Nulls;
    });
  window.Nulls = nulls;
  window.IsFull = nulls == 0 &&
    std::all_of(window.Columns.begin(), window.Columns.end(),
      [&](const SampleRange& range) { return range.First <= extent[4] && range.End > extent[5]; });
  return window;
}

//----------------------------------------------------------------------------------------------------------------------
float FindStrongAmplitude(const SEGYCube& cube)
{
  constexpr std::size_t traces = 200; // Sufficient for a range of colours.
  constexpr double part = 0.98;
  std::vector<std::size_t> columns;
  for (std::size_t column = 0; column < cube.Traces.size(); ++column)
  {
    if (cube.Traces[column] >= 0)
    {
      columns.push_back(column);
    }
  }
  const std::size_t width = std::size_t(cube.Lattice.Columns[0]);
  const std::size_t count = std::min(traces, columns.size());
  std::vector<float> sizes, samples(std::size_t(cube.Sampling.Indices));
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t column = columns[n * columns.size() / count];
    const int i = int(column % width), j = int(column / width);
    ReadSEGYWindow(cube, { i, i, j, j, 0, int(samples.size()) - 1 }, samples.data());
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(sizes),
      [](float sample) { return std::isfinite(sample) && sample != 0.0f; });
  }
  const auto strong = sizes.begin() + std::ptrdiff_t(part * double(sizes.size()));
  std::nth_element(sizes.begin(), strong, sizes.end(), [](float a, float b) { return std::fabs(a) < std::fabs(b); });
  return sizes.empty() ? 0.0f : std::fabs(*strong);
}
}
