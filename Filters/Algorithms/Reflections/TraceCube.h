// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Methods read traces by rows, whatever the order and type of samples in memory.

#ifndef SeismicHorizonsTraceCube_h
#define SeismicHorizonsTraceCube_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace SeismicHorizons
{
/// This number of traces is best read at a time.
constexpr int TracesPerBlock = 64;

struct TraceCube
{
  /// Columns are along i and j, samples along k.
  std::array<int, 3> Size = { 0, 0, 0 };
  /// Traces follow each other. Missing samples are NaN, and none is infinite. Threads may call it in parallel.
  std::function<void(int j, int first, int count, float* traces)> Read;
};

template <typename Work>
void ForEachTrace(const TraceCube& cube, int j, std::vector<float>& block, Work&& work)
{
  const int samples = cube.Size[2];
  block.resize(std::size_t(std::min(TracesPerBlock, cube.Size[0])) * std::size_t(samples));
  for (int first = 0; first < cube.Size[0]; first += TracesPerBlock)
  {
    const int count = std::min(TracesPerBlock, cube.Size[0] - first);
    cube.Read(j, first, count, block.data());
    for (int n = 0; n < count; ++n)
    {
      work(first + n, block.data() + std::size_t(n) * std::size_t(samples));
    }
  }
}

/// Has some rows of the cube.
inline TraceCube TakeRows(const TraceCube& cube, const std::vector<int>& rows)
{
  return { { cube.Size[0], int(rows.size()), cube.Size[2] },
    [cube, rows](int j, int first, int count, float* traces) { cube.Read(rows[j], first, count, traces); } };
}

/// Each trace is changed by change(trace, samples); each reading has a copy of `change` with its own buffers.
template <typename Change>
TraceCube ChangeTraces(const TraceCube& cube, const Change& change)
{
  return { cube.Size,
    [cube, change](int j, int first, int count, float* traces)
    {
      cube.Read(j, first, count, traces);
      Change own = change;
      for (int n = 0; n < count; ++n)
      {
        own(traces + std::ptrdiff_t(n) * cube.Size[2], cube.Size[2]);
      }
    } };
}

template <typename Sample>
float MakeFinite(Sample sample)
{
  const auto value = static_cast<float>(sample);
  return std::isfinite(value) ? value : std::numeric_limits<float>::quiet_NaN();
}

/// Strides are from sample to sample along i, j and k.
template <typename Sample>
struct StridedSamples
{
  const Sample* First = nullptr;
  std::array<std::ptrdiff_t, 3> Strides = { 1, 1, 1 };
  /// Samples are missing if their mark has a bit of the mask; null means no marks.
  const unsigned char* Marks = nullptr;
  unsigned char MissingMask = 0;

  float At(std::ptrdiff_t place) const
  {
    const bool isMarked = this->Marks && (this->Marks[place] & this->MissingMask) != 0;
    return isMarked ? std::numeric_limits<float>::quiet_NaN() : MakeFinite(this->First[place]);
  }
};

/// Unless samples of a trace follow each other, squares are turned in a buffer that the cache holds.
template <typename Sample>
void TurnTraces(const StridedSamples<Sample>& cube, std::ptrdiff_t start, int count, int samples, float* traces)
{
  if (cube.Strides[2] == 1 && !cube.Marks)
  {
    for (int trace = 0; trace < count; ++trace)
    {
      const Sample* const source = cube.First + start + trace * cube.Strides[0];
      std::transform(source, source + samples, traces + std::ptrdiff_t(trace) * samples, MakeFinite<Sample>);
    }
    return;
  }
  constexpr int side = 16;
  float square[side][side]; // by sample, then trace
  for (int trace = 0; trace < count; trace += side)
  {
    const int width = std::min(side, count - trace);
    for (int sample = 0; sample < samples; sample += side)
    {
      const int height = std::min(side, samples - sample);
      const std::ptrdiff_t corner = start + trace * cube.Strides[0] + sample * cube.Strides[2];
      for (int k = 0; k < height; ++k)
      {
        for (int i = 0; i < width; ++i)
        {
          square[k][i] = cube.At(corner + k * cube.Strides[2] + i * cube.Strides[0]);
        }
      }
      for (int i = 0; i < width; ++i)
      {
        float* const target = traces + std::ptrdiff_t(trace + i) * samples + sample;
        for (int k = 0; k < height; ++k)
        {
          target[k] = square[k][i];
        }
      }
    }
  }
}

/// The samples must outlive the cube.
template <typename Sample>
TraceCube MakeTraceCube(const std::array<int, 3>& size, const StridedSamples<Sample>& samples)
{
  return { size,
    [size, samples](int j, int first, int count, float* traces)
    {
      const std::ptrdiff_t start = first * samples.Strides[0] + j * samples.Strides[1];
      TurnTraces(samples, start, count, size[2], traces);
    } };
}
}

#endif
