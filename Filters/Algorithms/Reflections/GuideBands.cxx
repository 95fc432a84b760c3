// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuideBands.h"

#include "Common/Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr int MostSweeps = 8;
constexpr std::size_t MostValues = std::size_t(1) << 24; // of rows in memory, if several
constexpr float CostOfStep = 0.01F; // without which paths would be long
constexpr float CostOfGap = 1.0F; // as for windows that are not alike

/// Traces of consecutive rows, with zeros for missing samples, and around each trace.
class RowTraces
{
public:
  RowTraces(const TraceCube& cube, int pad)
    : Cube(cube)
    , Pad(pad)
    , Length(std::size_t(cube.Size[2]) + 2 * std::size_t(pad))
    , RowSize(std::size_t(cube.Size[0]) * this->Length)
    , AtATime(std::max(1, int(std::min(MostValues / this->RowSize, std::size_t(cube.Size[1])))))
    , Values((std::size_t(this->AtATime) + 1) * this->RowSize, 0.0F)
  {
  }

  /// The number of rows.
  int Most() const { return this->AtATime; }

  /// The sample may be `pad` beyond the ends.
  const float* At(int slot, int i, int sample) const { return this->Trace(slot, i) + this->Pad + sample; }

  /// Rows from `first` on, to the right or left, fill slots from 1 on; slot 0 gets the last one of before.
  void Load(int first, int count, int step, int last)
  {
    if (last > 0)
    {
      std::copy_n(this->Trace(last, 0), this->RowSize, this->Begin(0, 0));
    }
    ParallelFor(count, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        std::vector<float> block;
        for (int n = int(begin); n < int(end); ++n)
        {
          ForEachTrace(this->Cube, first + step * n, block,
            [&](int i, const float* trace)
            {
              std::transform(trace, trace + this->Cube.Size[2], this->Begin(n + 1, i) + this->Pad,
                [](float value) { return value == value ? value : 0.0F; });
            });
        }
      });
  }

private:
  const float* Trace(int slot, int i) const
  {
    return this->Values.data() + std::size_t(slot) * this->RowSize + std::size_t(i) * this->Length;
  }
  float* Begin(int slot, int i) { return const_cast<float*>(this->Trace(slot, i)); }

  const TraceCube& Cube;
  const int Pad;
  const std::size_t Length;
  const std::size_t RowSize;
  const int AtATime;
  std::vector<float> Values; // slot by slot
};

/// The paths of one guide.
class RoughPaths
{
public:
  RoughPaths(const TraceCube& cube, const Guide& guide, const BandOptions& options)
    : Columns(cube.Size[0])
    , Samples(cube.Size[2])
    , Options(options)
    , Place(std::size_t(cube.Size[0]) * std::size_t(cube.Size[1]), 0.0F)
    , Cost(this->Place.size(), std::numeric_limits<float>::infinity())
    , Products(std::size_t(2 * options.LargestStep + 1))
    , Energies(this->Products.size())
  {
    for (const GuidePick& pick : guide.Picks)
    {
      const std::size_t column = this->ColumnAt(pick.I, pick.J);
      this->Place[column] = float(pick.Place);
      this->Cost[column] = 0.0F;
    }
  }

  /// The row before is `step` rows less. Returns whether a path changed.
  bool Update(const RowTraces& rows, int slot, int j, int step, bool hasBefore)
  {
    bool isChanged = false;
    for (int i = 0; i < this->Columns; ++i)
    {
      isChanged |= hasBefore && this->Reach(rows, slot - 1, i, j - step, slot, i, j);
      isChanged |= i > 0 && this->Reach(rows, slot, i - 1, j, slot, i, j);
    }
    for (int i = this->Columns - 2; i >= 0; --i)
    {
      isChanged |= this->Reach(rows, slot, i + 1, j, slot, i, j);
    }
    return isChanged;
  }

  std::vector<float> TakePlaces() { return std::move(this->Place); }

private:
  std::size_t ColumnAt(int i, int j) const { return std::size_t(i) + std::size_t(j) * std::size_t(this->Columns); }

  bool Reach(const RowTraces& rows, int fromSlot, int fromI, int fromJ, int slot, int i, int j)
  {
    const std::size_t from = this->ColumnAt(fromI, fromJ);
    const std::size_t to = this->ColumnAt(i, j);
    if (this->Cost[from] + CostOfStep >= this->Cost[to])
    {
      return false;
    }
    float place = this->Place[from];
    const float cost = this->Cost[from] + CostOfStep + this->Follow(rows, fromSlot, fromI, slot, i, place);
    if (cost >= this->Cost[to])
    {
      return false;
    }
    this->Place[to] = place;
    this->Cost[to] = cost;
    return true;
  }

  /// Moves the place to the window that is most alike. Returns the cost.
  float Follow(const RowTraces& rows, int fromSlot, int fromI, int slot, int i, float& place)
  {
    const int half = this->Options.HalfWidth;
    const int step = this->Options.LargestStep;
    const int first = std::clamp(int(std::lround(place)), 0, this->Samples - 1) - half;
    const float* const from = rows.At(fromSlot, fromI, first);
    const float* const to = rows.At(slot, i, first - step);
    const std::size_t shifts = this->Products.size();
    std::fill(this->Products.begin(), this->Products.end(), 0.0F);
    std::fill(this->Energies.begin(), this->Energies.end(), 0.0F);
    float energy = 0.0F;
    for (int n = 0; n <= 2 * half; ++n)
    {
      energy += from[n] * from[n];
      for (std::size_t shift = 0; shift < shifts; ++shift)
      {
        const float value = to[std::size_t(n) + shift];
        this->Products[shift] += from[n] * value;
        this->Energies[shift] += value * value;
      }
    }
    float best = 0.0F;
    std::size_t found = std::size_t(step);
    for (std::size_t shift = 0; shift < shifts; ++shift)
    {
      const float norm = std::sqrt(energy * this->Energies[shift]);
      const float likeness = norm > 0.0F ? this->Products[shift] / norm : 0.0F;
      if (likeness > best)
      {
        best = likeness;
        found = shift;
      }
    }
    if (best > 0.0F)
    {
      const float middle = from[half];
      place = float(this->Extreme(rows, slot, i, first + half + int(found) - step, middle < 0.0F ? -1.0F : 1.0F));
    }
    return CostOfGap * (1.0F - best);
  }

  /// Paths stay on peaks, as shifts of whole samples would add up.
  int Extreme(const RowTraces& rows, int slot, int i, int sample, float sign) const
  {
    const float* const trace = rows.At(slot, i, 0);
    const int first = std::max(0, sample - 1);
    const int last = std::min(this->Samples - 1, sample + 1);
    return int(
      std::max_element(trace + first, trace + last + 1, [sign](float a, float b) { return sign * a < sign * b; }) -
      trace);
  }

  const int Columns;
  const int Samples;
  const BandOptions Options;
  std::vector<float> Place; // by column
  std::vector<float> Cost;
  std::vector<float> Products; // by shift
  std::vector<float> Energies;
};

/// Returns whether a path changed.
bool Sweep(
  const TraceCube& cube, bool isUpwards, std::vector<RoughPaths>& paths, RowTraces& rows, const Monitor& monitor)
{
  const int all = cube.Size[1];
  const int step = isUpwards ? -1 : 1;
  std::vector<unsigned char> isChanged(paths.size(), 0);
  int last = 0;
  for (int done = 0; done < all; done += rows.Most())
  {
    monitor.Progress(double(done) / all);
    const int count = std::min(rows.Most(), all - done);
    const int first = isUpwards ? all - 1 - done : done;
    rows.Load(first, count, step, last);
    last = count;
    ParallelFor(std::int64_t(paths.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
        {
          for (int row = 0; row < count; ++row)
          {
            const bool isNew = paths[n].Update(rows, row + 1, first + step * row, step, done + row > 0);
            isChanged[n] |= isNew ? 1 : 0;
          }
        }
      });
  }
  return std::find(isChanged.begin(), isChanged.end(), 1) != isChanged.end();
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<int> ChooseRows(int rows, int step, const std::vector<Guide>& guides)
{
  constexpr int anyPrime = 7919;
  std::vector<int> chosen;
  for (int first = 0; first < rows; first += step)
  {
    chosen.push_back(first + int(std::int64_t(first) / step * anyPrime % std::min(step, rows - first)));
  }
  for (const Guide& guide : guides)
  {
    for (const GuidePick& pick : guide.Picks)
    {
      chosen[std::size_t(pick.J / step)] = pick.J;
    }
  }
  return chosen;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::vector<float>> FollowRoughly(
  const TraceCube& cube, const std::vector<Guide>& guides, const BandOptions& options, const Monitor& monitor)
{
  std::vector<RoughPaths> paths;
  for (const Guide& guide : guides)
  {
    paths.emplace_back(cube, guide, options);
  }
  RowTraces rows(cube, options.HalfWidth + options.LargestStep);
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    const Monitor step = monitor.Step(double(sweep) / MostSweeps, double(sweep + 1) / MostSweeps);
    if (!Sweep(cube, sweep % 2 == 1, paths, rows, step) && sweep > 0)
    {
      break;
    }
  }
  std::vector<std::vector<float>> places;
  for (RoughPaths& path : paths)
  {
    places.push_back(path.TakePlaces());
  }
  return places;
}
}
