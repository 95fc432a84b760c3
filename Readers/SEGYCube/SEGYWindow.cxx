// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The window is cut into tiles of columns. A thread reads the traces of a tile in the order of the file, many at a
// time, and then converts and writes them strip by strip, level by level. A strip lies along i, where a level is
// contiguous in memory. Tiles of crossline-sorted files are long along j, so that traces are contiguous in the file.

#include "SEGYWindow.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/RawVector.h"
#include "TraceTable.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
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

struct Tile
{
  int FirstI, LastI, FirstJ, LastJ;

  int Width() const { return this->LastI - this->FirstI + 1; }
  std::size_t Columns() const { return std::size_t(this->Width()) * std::size_t(this->LastJ - this->FirstJ + 1); }
};

std::vector<Tile> CutIntoTiles(const SEGYCube& cube, const CubeExtent& extent)
{
  const std::int64_t columns =
    std::max<std::int64_t>(StripWidth, std::min(MostTileColumns, std::int64_t(TileBytes / cube.Header.TraceSize())));
  const int width = extent[1] - extent[0] + 1;
  const int tileWidth = cube.IsCrosslineSorted ? NarrowStrip : int(std::min<std::int64_t>(width, columns));
  const int tileHeight = int(std::max<std::int64_t>(1, columns / tileWidth));
  std::vector<Tile> tiles;
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

struct SampleCheck
{
  bool AreZero = true;
  std::int64_t Nulls = 0;
};

/// Programs write 1e30 or more where there is no sample. These become nan.
SampleCheck CheckSamples(std::vector<float>& samples)
{
  constexpr std::int32_t leastNull = 0x7149bf17; // The bits of 0.999e30, as IBM floats round 1e30; nan has larger ones.
  std::int32_t anyBits = 0;
  std::int32_t nulls = 0;
  for (const float sample : samples)
  {
    std::int32_t bits;
    std::memcpy(&bits, &sample, sizeof(bits));
    anyBits |= bits & 0x7fffffff;
    nulls += (bits & 0x7fffffff) >= leastNull;
  }
  if (nulls > 0)
  {
    const auto isNull = [](float sample) { return !(std::fabs(sample) < 0.999e30f); };
    std::replace_if(samples.begin(), samples.end(), isNull, std::numeric_limits<float>::quiet_NaN());
  }
  return { anyBits == 0, std::int64_t(nulls) };
}

/// Interpolates at `shift` steps after each sample, by cubic polynomials with central differences as slopes (Catmull
/// and Rom, 1974). The last sample is lost.
void ShiftSamples(std::vector<float>& samples, float shift)
{
  if (samples.size() < 2)
  {
    return;
  }
  const std::vector<float> old = samples;
  const std::size_t last = old.size() - 1;
  for (std::size_t n = 0; n < last; ++n)
  {
    const float b = old[n];
    const float c = old[n + 1];
    const float a = n > 0 ? old[n - 1] : 2.0f * b - c;
    const float d = n + 2 <= last ? old[n + 2] : 2.0f * c - b;
    const float cubic = 3.0f * (b - c) + d - a;
    const float square = 2.0f * a - 5.0f * b + 4.0f * c - d;
    samples[n] = b + 0.5f * shift * (c - a + shift * (square + shift * cubic));
  }
}

class TileReader
{
public:
  std::int64_t Nulls = 0;

  TileReader(const SEGYCube& cube, const CubeExtent& extent, float* values, SEGYWindow& window)
    : Cube(cube)
    , Extent(extent)
    , Levels(std::size_t(extent[5] - extent[4] + 1))
    , Width(std::size_t(extent[1] - extent[0] + 1))
    , Height(std::size_t(extent[3] - extent[2] + 1))
    , Values(values)
    , Window(window)
    , File(cube.Name, cube.Header)
    , Samples(std::size_t(cube.Header.Samples))
    , Strip(StripWidth * this->Levels)
  {
  }

  void Read(const Tile& tile)
  {
    this->LoadTraces(tile);
    for (int j = tile.FirstJ; j <= tile.LastJ; ++j)
    {
      for (int i = tile.FirstI; i <= tile.LastI; i += StripWidth)
      {
        const int last = std::min(tile.LastI, i + StripWidth - 1);
        for (int column = i; column <= last; ++column)
        {
          this->ConvertColumn(tile, column, j, this->Strip.data() + std::size_t(column - i) * this->Levels);
        }
        this->WriteStrip(i, last, j);
      }
    }
  }

private:
  /// Adjacent traces of the file are read together.
  void LoadTraces(const Tile& tile)
  {
    struct TracePlace
    {
      std::int32_t Trace;
      std::size_t Column; // index in the tile
    };
    std::vector<TracePlace> places;
    this->Slots.assign(tile.Columns(), NoTrace);
    for (std::size_t column = 0; column < tile.Columns(); ++column)
    {
      const int i = tile.FirstI + int(column % std::size_t(tile.Width()));
      const int j = tile.FirstJ + int(column / std::size_t(tile.Width()));
      const std::int32_t trace = this->Cube.Traces[this->Cube.Column(i, j)];
      if (trace >= 0)
      {
        places.push_back({ trace, column });
      }
    }
    std::sort(places.begin(), places.end(), [](const TracePlace& a, const TracePlace& b) { return a.Trace < b.Trace; });
    const std::size_t size = this->Cube.Header.TraceSize();
    this->Bytes.resize(places.size() * size);
    for (std::size_t first = 0, next = 1; first < places.size(); first = next++)
    {
      while (next < places.size() && places[next].Trace == places[next - 1].Trace + 1)
      {
        ++next;
      }
      this->File.Read(places[first].Trace, (next - first) * size, this->Bytes.data() + first * size);
    }
    for (std::size_t slot = 0; slot < places.size(); ++slot)
    {
      this->Slots[places[slot].Column] = std::int32_t(slot);
    }
  }

  void ToSamples(const unsigned char* trace, std::vector<float>& samples) const
  {
    const SEGYHeader& header = this->Cube.Header;
    ToFloats(trace + SEGYTraceHeaderSize, samples.size(), header.Format, header.Order, samples.data());
  }

  /// Averages all traces of the column except zero traces.
  SampleCheck AddDuplicates(std::size_t column, SampleCheck check)
  {
    const std::vector<DuplicateTrace>& all = this->Cube.Duplicates;
    auto duplicate = std::lower_bound(
      all.begin(), all.end(), column, [](const DuplicateTrace& d, std::size_t c) { return d.Column < c; });
    if (duplicate == all.end() || duplicate->Column != column)
    {
      return check;
    }
    int count = check.AreZero ? 0 : 1;
    std::vector<unsigned char> bytes(this->Cube.Header.TraceSize());
    std::vector<float> samples(this->Samples.size());
    for (; duplicate != all.end() && duplicate->Column == column; ++duplicate)
    {
      this->File.Read(duplicate->Trace, bytes.size(), bytes.data());
      this->ToSamples(bytes.data(), samples);
      count += CheckSamples(samples).AreZero ? 0 : 1;
      std::transform(samples.begin(), samples.end(), this->Samples.begin(), this->Samples.begin(), std::plus<float>());
    }
    for (float& sample : this->Samples)
    {
      sample /= float(std::max(1, count));
    }
    return CheckSamples(this->Samples);
  }

  void ConvertColumn(const Tile& tile, int i, int j, float* levels)
  {
    const std::int32_t slot =
      this->Slots[std::size_t(j - tile.FirstJ) * std::size_t(tile.Width()) + std::size_t(i - tile.FirstI)];
    SampleRange& range = this->Window.Columns[this->OutputColumn(i, j)];
    range = SampleRange();
    std::fill_n(levels, this->Levels, 0.0f);
    if (slot < 0)
    {
      return;
    }
    const SEGYHeader& header = this->Cube.Header;
    const unsigned char* const trace = this->Bytes.data() + std::size_t(slot) * header.TraceSize();
    this->ToSamples(trace, this->Samples);
    SampleCheck check = CheckSamples(this->Samples);
    const std::size_t cubeColumn = this->Cube.Column(i, j);
    if (!this->Cube.Duplicates.empty())
    {
      check = this->AddDuplicates(cubeColumn, check);
    }
    if (check.AreZero)
    {
      return;
    }
    this->Nulls += check.Nulls;
    const int delay = this->Cube.Delays.empty() ? 0 : this->Cube.Delays[cubeColumn];
    const float shift = this->Cube.Shifts.empty() ? 0.0f : this->Cube.Shifts[cubeColumn];
    range = { delay, delay + header.Samples - int(shift > 0.0f) };
    if (shift > 0.0f)
    {
      ShiftSamples(this->Samples, shift);
    }
    const int first = std::max(delay, this->Extent[4]);
    const int end = std::min(range.End, this->Extent[5] + 1);
    if (first < end)
    {
      std::copy(&this->Samples[std::size_t(first - delay)], this->Samples.data() + (end - delay),
        levels + (first - this->Extent[4]));
    }
  }

  void WriteStrip(int firstI, int lastI, int j)
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

  std::size_t OutputColumn(int i, int j) const
  {
    return std::size_t(j - this->Extent[2]) * this->Width + std::size_t(i - this->Extent[0]);
  }

  const SEGYCube& Cube;
  const CubeExtent& Extent;
  const std::size_t Levels, Width, Height;
  float* const Values;
  SEGYWindow& Window;
  SEGYFile File;
  RawVector<unsigned char> Bytes; // traces of a tile
  std::vector<std::int32_t> Slots; // trace in Bytes per column, or NoTrace
  std::vector<float> Samples;
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
  const std::vector<Tile> tiles = CutIntoTiles(cube, extent);
  SEGYWindow window;
  window.Columns.resize(std::size_t(extent[1] - extent[0] + 1) * std::size_t(extent[3] - extent[2] + 1));
  std::atomic<std::int64_t> nulls(0);
  ParallelFor(std::int64_t(tiles.size()), 1, monitor,
    [&](std::int64_t first, std::int64_t last)
    {
      TileReader reader(cube, extent, values, window);
      for (std::int64_t tile = first; tile < last; ++tile)
      {
        reader.Read(tiles[std::size_t(tile)]);
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
