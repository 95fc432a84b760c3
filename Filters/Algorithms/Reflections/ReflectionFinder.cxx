// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each row gives a list of all its reflections first. When the threshold is known, those that reach it are counted by
// sign and column, and written to where they belong.

#include "ReflectionFinder.h"

#include "Common/Errors.h"
#include "Common/Parallel.h"
#include "Common/Parameters.h"
#include "MagnitudeSelection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// Of one sign: links between them are counted by 32 bits.
constexpr std::int64_t MostPicks = std::int64_t(1) << 30;

/// What is known of a reflection until the threshold is.
struct Found
{
  Depth Place = 0;
  std::int32_t Thickness = 0;
  float Strength = 0.0F; // with the sign of the reflection
};

struct RowReflections
{
  RawVector<Found> All;
  std::vector<std::int32_t> Ends; // of each column in that list
  std::int64_t Samples = 0;
};

void CheckSize(const std::array<int, 3>& size)
{
  const auto refuse = [&size](const std::string& expected)
  {
    throw InputError("a cube of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " traces of " +
      std::to_string(size[2]) + " samples, expected " + expected);
  };
  if (size[0] < 1 || size[1] < 1 || size[2] < 1)
  {
    refuse("at least one each way");
  }
  if (size[2] > MostSamples)
  {
    refuse("at most " + std::to_string(MostSamples) + " samples each");
  }
  if (std::int64_t(size[0]) * size[1] >= std::numeric_limits<PointId>::max())
  {
    refuse("less than 2^31 traces");
  }
}

class Finder
{
public:
  Finder(const TraceCube& cube, const ReflectionOptions& options)
    : Cube(cube)
    , Options(options)
    , Rows(std::size_t(cube.Size[1]))
  {
  }

  CubeReflections Find(const Monitor& monitor)
  {
    CubeReflections result;
    for (ReflectionPicks& picks : result.BySign)
    {
      picks.Columns = { this->Cube.Size[0], this->Cube.Size[1] };
      // Now, as memory of the rows goes back to the system only where nothing lies behind it.
      picks.Starts.assign(std::size_t(picks.Columns[0]) * std::size_t(picks.Columns[1]) + 1, 0);
    }
    const bool isMiddle = this->Options.Position == ReflectionPosition::Middle;
    result.Threshold = float(this->Options.AmplitudeThreshold);
    const bool isPercentile = this->Options.Threshold == ThresholdKind::Percentile;
    if (isPercentile && isMiddle)
    {
      result.Threshold = this->SelectSample(monitor.Step(0.0, 0.5));
    }
    result.Rules = { this->Options.Polarity, this->Options.Position, isMiddle ? result.Threshold : 0.0F };
    this->FindRows(result.Rules, monitor.Step(isPercentile && isMiddle ? 0.5 : 0.0, 0.9));
    for (const RowReflections& row : this->Rows)
    {
      result.Samples += row.Samples;
    }
    if (result.Samples == 0)
    {
      throw InputError("no amplitude: all samples of the cube are blanked or not finite, expected numbers");
    }
    if (isPercentile && !isMiddle)
    {
      result.Threshold = SelectPercentile(
        this->Options.AmplitudePercentile, [this](MagnitudeCounts& counts) { this->CountStrengths(counts); });
    }
    std::vector<double> energies;
    for (const std::size_t sign : { 0, 1 })
    {
      this->CountPicks(result.BySign[sign], sign == 1, result.Threshold, energies);
    }
    result.Period = FindPeriod(energies);
    this->Gather(result);
    return result;
  }

private:
  /// Rows that a thread takes at a time: enough samples to be worth it.
  std::int64_t Grain() const
  {
    constexpr std::int64_t samples = 1 << 18;
    return std::max<std::int64_t>(1, samples / (std::int64_t(this->Cube.Size[0]) * this->Cube.Size[2]));
  }

  /// Calls work(j, block) for all rows, on all threads; `block` is memory for traces.
  template <typename Work>
  void ForEachRow(const Monitor& monitor, Work&& work) const
  {
    ParallelFor(this->Cube.Size[1], this->Grain(), monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        std::vector<float> block;
        for (std::int64_t j = first; j < last; ++j)
        {
          work(int(j), block);
        }
      });
  }

  float SelectSample(const Monitor& monitor) const
  {
    double begin = 0.0;
    return SelectPercentile(this->Options.AmplitudePercentile,
      [&](MagnitudeCounts& counts)
      {
        this->CountSamples(counts, monitor.Step(begin, begin + 0.5));
        begin = 0.5;
      });
  }

  void CountSamples(MagnitudeCounts& counts, const Monitor& monitor) const
  {
    std::mutex mutex;
    const MagnitudeCounts none = counts;
    const float least =
      this->Options.Polarity == ReflectionPolarity::Positive ? 0.0F : std::numeric_limits<float>::lowest();
    const float most =
      this->Options.Polarity == ReflectionPolarity::Negative ? 0.0F : std::numeric_limits<float>::max();
    this->ForEachRow(monitor,
      [&](int j, std::vector<float>& block)
      {
        MagnitudeCounts part = none;
        ForEachTrace(this->Cube, j, block,
          [&](int, const float* trace)
          {
            for (int sample = 0; sample < this->Cube.Size[2]; ++sample)
            {
              const float value = trace[sample];
              if (value >= least && value <= most && value != 0.0F)
              {
                part.Add(std::abs(value));
              }
            }
          });
        const std::lock_guard<std::mutex> lock(mutex);
        counts.Merge(part);
      });
  }

  void CountStrengths(MagnitudeCounts& counts) const
  {
    for (const RowReflections& row : this->Rows)
    {
      for (const Found& found : row.All)
      {
        counts.Add(std::abs(found.Strength));
      }
    }
  }

  void FindRows(const ReflectionRules& rules, const Monitor& monitor)
  {
    const int samples = this->Cube.Size[2];
    this->ForEachRow(monitor,
      [&](int j, std::vector<float>& block)
      {
        RowReflections& row = this->Rows[std::size_t(j)];
        row.Ends.reserve(std::size_t(this->Cube.Size[0]));
        std::vector<Reflection> reflections;
        ForEachTrace(this->Cube, j, block,
          [&](int, const float* trace)
          {
            row.Samples += std::count_if(trace, trace + samples, [](float value) { return value == value; });
            FindReflections(trace, samples, rules, reflections);
            row.Ends.push_back(std::int32_t(reflections.size()));
          });
        row.All.resize(reflections.size());
        std::transform(reflections.begin(), reflections.end(), row.All.begin(),
          [](const Reflection& reflection) -> Found {
            return { reflection.Place, reflection.Thickness, std::copysign(reflection.Strength, reflection.Amplitude) };
          });
      });
  }

  static bool IsWanted(const Found& found, bool isNegative, float threshold)
  {
    return std::signbit(found.Strength) == isNegative && std::abs(found.Strength) >= threshold;
  }

  /// Finds where the picks of one sign that reach the threshold begin, and adds their energies by thickness.
  void CountPicks(ReflectionPicks& picks, bool isNegative, float threshold, std::vector<double>& energies) const
  {
    std::int64_t total = 0;
    std::size_t column = 0;
    for (const RowReflections& row : this->Rows)
    {
      std::int32_t next = 0;
      for (const std::int32_t end : row.Ends)
      {
        picks.Starts[column++] = PointId(total);
        for (; next < end; ++next)
        {
          const Found& found = row.All[std::size_t(next)];
          if (IsWanted(found, isNegative, threshold))
          {
            ++total;
            AddEnergy(found, energies);
          }
        }
      }
      if (total > MostPicks)
      {
        throw InputError(
          "more than 2^30 reflections of one sign, expected fewer: a higher threshold, or a part of the cube");
      }
    }
    picks.Starts[column] = PointId(total);
    picks.Places.resize(std::size_t(total));
    picks.Strengths.resize(std::size_t(total));
  }

  /// Puts the picks of both signs together, and frees the rows.
  void Gather(CubeReflections& result)
  {
    ParallelFor(std::int64_t(this->Rows.size()), this->Grain(),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t j = first; j < last; ++j)
        {
          const RowReflections row = std::exchange(this->Rows[std::size_t(j)], RowReflections());
          std::array<PointId, 2> next;
          for (const std::size_t sign : { 0, 1 })
          {
            next[sign] = result.BySign[sign].Begin(result.BySign[sign].ColumnAt(0, int(j)));
          }
          for (const Found& found : row.All)
          {
            const std::size_t sign = std::signbit(found.Strength) ? 1 : 0;
            if (IsWanted(found, sign == 1, result.Threshold))
            {
              const auto pick = std::size_t(next[sign]++);
              result.BySign[sign].Places[pick] = found.Place;
              result.BySign[sign].Strengths[pick] = CoarseStrength(std::abs(found.Strength));
            }
          }
        }
      });
  }

  static void AddEnergy(const Found& found, std::vector<double>& energies)
  {
    if (std::size_t(found.Thickness) >= energies.size())
    {
      energies.resize(std::size_t(found.Thickness) + 1, 0.0);
    }
    energies[std::size_t(found.Thickness)] += double(found.Strength) * double(found.Strength);
  }

  /// Half of the energy is in runs of at most half the period.
  static double FindPeriod(const std::vector<double>& energies)
  {
    const double half = 0.5 * std::accumulate(energies.begin(), energies.end(), 0.0);
    double before = 0.0;
    for (std::size_t thickness = 0; thickness < energies.size(); ++thickness)
    {
      const double energy = energies[thickness];
      if (before + energy >= half && energy > 0.0)
      {
        return 2.0 * (double(thickness) - 0.5 + (half - before) / energy);
      }
      before += energy;
    }
    return 0.0;
  }

  const TraceCube& Cube;
  const ReflectionOptions Options;
  std::vector<RowReflections> Rows;
};
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const ReflectionOptions& options)
{
  CheckAtLeast("AmplitudeThreshold", options.AmplitudeThreshold, 0.0, "");
  CheckWithin("AmplitudePercentile", options.AmplitudePercentile, 0.0, 100.0, " percent");
}

//----------------------------------------------------------------------------------------------------------------------
CubeReflections FindReflections(const TraceCube& cube, const ReflectionOptions& options, const Monitor& monitor)
{
  CheckOptions(options);
  CheckSize(cube.Size);
  return Finder(cube, options).Find(monitor);
}
}
