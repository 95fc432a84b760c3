// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYTraces.h"

#include "Common/Text/FileErrors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <utility>

namespace SeismicHorizons
{
namespace
{
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
}

//----------------------------------------------------------------------------------------------------------------------
TileReader::TileReader(const SEGYCube& cube, const CubeExtent& extent)
  : Cube(cube)
  , Extent(extent)
  , Levels(std::size_t(extent[5] - extent[4] + 1))
  , File(cube.Name, cube.Header)
  , Samples(std::size_t(cube.Header.Samples))
{
}

//----------------------------------------------------------------------------------------------------------------------
void TileReader::Read(const TraceTile& tile, const Write& write)
{
  this->LoadTraces(tile);
  this->Column.resize(this->Levels);
  for (int j = tile.FirstJ; j <= tile.LastJ; ++j)
  {
    for (int i = tile.FirstI; i <= tile.LastI; ++i)
    {
      const SampleRange range = this->ConvertColumn(tile, i, j, this->Column.data());
      write(i, j, range, this->Column.data());
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void TileReader::LoadTraces(const TraceTile& tile)
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

//----------------------------------------------------------------------------------------------------------------------
void TileReader::ToSamples(const unsigned char* trace, std::vector<float>& samples) const
{
  const SEGYHeader& header = this->Cube.Header;
  ToFloats(trace + SEGYTraceHeaderSize, samples.size(), header.Format, header.Order, samples.data());
}

//----------------------------------------------------------------------------------------------------------------------
SampleCheck TileReader::AddDuplicates(std::size_t column, SampleCheck check)
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

//----------------------------------------------------------------------------------------------------------------------
SampleRange TileReader::ConvertColumn(const TraceTile& tile, int i, int j, float* levels)
{
  const std::int32_t slot =
    this->Slots[std::size_t(j - tile.FirstJ) * std::size_t(tile.Width()) + std::size_t(i - tile.FirstI)];
  std::fill_n(levels, this->Levels, 0.0f);
  if (slot < 0)
  {
    return {};
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
    return {};
  }
  this->Nulls += check.Nulls;
  const int delay = this->Cube.Delays.empty() ? 0 : this->Cube.Delays[cubeColumn];
  const float shift = this->Cube.Shifts.empty() ? 0.0f : this->Cube.Shifts[cubeColumn];
  const SampleRange range = { delay, delay + header.Samples - int(shift > 0.0f) };
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
  return range;
}

//----------------------------------------------------------------------------------------------------------------------
struct SEGYTraces::Readers
{
  std::shared_ptr<const SEGYCube> Cube;
  CubeExtent Extent;
  std::mutex Mutex;
  std::vector<std::unique_ptr<TileReader>> Idle;

  std::unique_ptr<TileReader> Open() const
  {
    return PrefixFileErrors(this->Cube->Name,
      [&]()
      {
        if (!(MakeFileStamp(this->Cube->Name) == this->Cube->Stamp))
        {
          throw InputError("changed since its headers were read, expected the same file: read it again");
        }
        return std::make_unique<TileReader>(*this->Cube, this->Extent);
      });
  }

  std::unique_ptr<TileReader> Take()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Idle.empty())
    {
      return this->Open();
    }
    std::unique_ptr<TileReader> reader = std::move(this->Idle.back());
    this->Idle.pop_back();
    return reader;
  }

  void Return(std::unique_ptr<TileReader> reader)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(std::move(reader));
  }
};

//----------------------------------------------------------------------------------------------------------------------
SEGYTraces::SEGYTraces(std::shared_ptr<const SEGYCube> cube, const CubeExtent& extent)
  : Shared(std::make_unique<Readers>())
{
  this->Shared->Cube = std::move(cube);
  this->Shared->Extent = extent;
}

//----------------------------------------------------------------------------------------------------------------------
SEGYTraces::~SEGYTraces() = default;

//----------------------------------------------------------------------------------------------------------------------
void SEGYTraces::Read(int j, int first, int count, float* traces) const
{
  const CubeExtent& extent = this->Shared->Extent;
  const int levels = extent[5] - extent[4] + 1;
  const int firstI = extent[0] + first;
  std::unique_ptr<TileReader> reader = this->Shared->Take();
  reader->Read({ firstI, firstI + count - 1, extent[2] + j, extent[2] + j },
    [&](int, int, const SampleRange& range, const float* samples)
    {
      for (int level = 0; level < levels; ++level)
      {
        const int k = extent[4] + level;
        *traces++ = range.First <= k && k < range.End ? samples[level] : std::numeric_limits<float>::quiet_NaN();
      }
    });
  this->Shared->Return(std::move(reader));
}
}
