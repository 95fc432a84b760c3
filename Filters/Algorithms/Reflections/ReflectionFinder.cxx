// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds picks (thesis, 2.2.1) in three passes: the threshold of samples, if Middle and a percentile; reflections, weak
// or strong; the threshold of strengths, and the picks above it.
//
// Percentiles are exact without a copy: bits of positive floats sort like their values, so numbers are counted by their
// upper 16 bits, and then, in the bin found, by their lower 16.

#include "ReflectionFinder.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Base/Parameters.h"

#include <cassert>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// ---- A trace -------------------------------------------------------------------------------------------------------

/// Samples from First to before End have one sign.
struct SampleRun
{
  int First = 0;
  int End = 0;
  float Sign = 1.0F;
  float Mean = 0.0F;

  int Size() const { return this->End - this->First; }
};

class TraceScan
{
public:
  TraceScan(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found)
    : Trace(trace)
    , Samples(samples)
    , Rules(rules)
    , Least(std::max(rules.SampleThreshold, std::numeric_limits<float>::denorm_min()))
    , Found(found)
  {
  }

  void Scan()
  {
    int sample = 0;
    while (sample < this->Samples)
    {
      const float value = this->Trace[sample];
      if (value >= this->Least)
      {
        sample = this->Take(sample, 1.0F);
      }
      else if (-value >= this->Least)
      {
        sample = this->Take(sample, -1.0F);
      }
      else
      {
        ++sample;
      }
    }
  }

private:
  /// Returns the end of the run.
  int Take(int first, float sign)
  {
    SampleRun run{ first, first, sign, 0.0F };
    double sum = 0.0;
    while (run.End < this->Samples && sign * this->Trace[run.End] >= this->Least)
    {
      sum += this->Trace[run.End++];
    }
    const auto unwanted = sign > 0.0F ? ReflectionPolarity::Negative : ReflectionPolarity::Positive;
    if (this->Rules.Polarity != unwanted)
    {
      run.Mean = float(sum / run.Size());
      switch (this->Rules.Position)
      {
        case ReflectionPosition::Middle:
          this->AddMiddle(run);
          break;
        case ReflectionPosition::Peak:
          this->AddPeaks(run);
          break;
        default:
          this->AddCrossing(run);
      }
    }
    this->Before = run;
    return run.End;
  }

  void Add(const SampleRun& run, PickDepth place, float strength)
  {
    this->Found.push_back({ place, run.Size(), run.Mean, strength });
  }

  float LargestOf(const SampleRun& run) const
  {
    float largest = 0.0F;
    for (int sample = run.First; sample < run.End; ++sample)
    {
      largest = std::max(largest, run.Sign * this->Trace[sample]);
    }
    return largest;
  }

  void AddMiddle(const SampleRun& run)
  {
    this->Add(run, (run.First + run.End - 1) * (DepthsPerSample / 2), this->LargestOf(run));
  }

  void AddCrossing(const SampleRun& run)
  {
    const int last = this->Before.End - 1;
    const int between = run.First - this->Before.End;
    const bool isBeside = between == 0 || (between == 1 && this->Trace[this->Before.End] == 0.0F);
    if (this->Before.Size() == 0 || this->Before.Sign == run.Sign || !isBeside)
    {
      return;
    }
    const double above = std::abs(double(this->Trace[last]));
    const double below = std::abs(double(this->Trace[run.First]));
    const double offset = between == 1 ? 1.0 : above / (above + below);
    const PickDepth place = last * DepthsPerSample + PickDepth(std::floor(offset * DepthsPerSample + 0.5));
    const float strength = 0.5F * this->LargestOf(this->Before) + 0.5F * this->LargestOf(run);
    this->Found.push_back({ place, (this->Before.Size() + run.Size() + 1) / 2, run.Sign * strength, strength });
  }

  void AddPeaks(const SampleRun& run)
  {
    bool isRising = true;
    for (int first = run.First; first < run.End;)
    {
      const float strength = run.Sign * this->Trace[first];
      int end = first + 1;
      while (end < run.End && this->Trace[end] == this->Trace[first])
      {
        ++end;
      }
      const bool rises = end < run.End && run.Sign * this->Trace[end] > strength;
      if (isRising && !rises)
      {
        const PickDepth middle = (first + end - 1) * (DepthsPerSample / 2);
        this->Add(run, end == first + 1 ? middle + this->VertexOffset(first) : middle, strength);
      }
      isRising = rises;
      first = end;
    }
  }

  /// The middle sample must be the largest of three.
  PickDepth VertexOffset(int sample) const
  {
    if (sample == 0 || sample + 1 == this->Samples)
    {
      return 0;
    }
    const double before = this->Trace[sample - 1];
    const double behind = this->Trace[sample + 1];
    const double bend = before - 2.0 * this->Trace[sample] + behind;
    const double offset = 0.5 * (before - behind) / bend * DepthsPerSample;
    if (!std::isfinite(offset)) // beside a missing sample
    {
      return 0;
    }
    // Despite rounding, the sample stays the nearest.
    constexpr double half = DepthsPerSample / 2;
    return PickDepth(std::clamp(std::floor(offset + 0.5), -half, half - 1.0));
  }

  const float* const Trace;
  const int Samples;
  const ReflectionRules& Rules;
  const float Least;
  SampleRun Before;
  std::vector<Reflection>& Found;
};

// ---- Percentiles ---------------------------------------------------------------------------------------------------

/// Counts by upper bits, or by lower bits among given upper bits.
class MagnitudeCounts
{
public:
  explicit MagnitudeCounts(std::optional<std::uint32_t> upper = std::nullopt)
    : Upper(upper)
  {
  }

  void Add(float magnitude)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &magnitude, sizeof(bits));
    if (!this->Upper)
    {
      ++this->Counts[bits >> 16];
    }
    else if (bits >> 16 == *this->Upper)
    {
      ++this->Counts[bits & 0xFFFFU];
    }
  }

  void Merge(const MagnitudeCounts& other)
  {
    std::transform(this->Counts.begin(), this->Counts.end(), other.Counts.begin(), this->Counts.begin(), std::plus<>());
  }

  std::int64_t Total() const { return std::accumulate(this->Counts.begin(), this->Counts.end(), std::int64_t(0)); }

  /// Returns the bits of the number with `rank` smaller numbers; `rank` becomes its rank among equal bits.
  std::uint32_t Find(std::int64_t& rank) const
  {
    assert(rank >= 0 && rank < this->Total());
    std::uint32_t key = 0;
    while (rank >= this->Counts[key])
    {
      rank -= this->Counts[key++];
    }
    return key;
  }

private:
  std::optional<std::uint32_t> Upper;
  std::vector<std::int64_t> Counts = std::vector<std::int64_t>(1 << 16, 0);
};

/// Returns the least number with at least `percentile` percent of smaller numbers, or the largest; 0 if there are none.
/// count(counts) is called twice.
template <typename Count>
float SelectPercentile(double percentile, Count&& count)
{
  MagnitudeCounts upperCounts;
  count(upperCounts);
  const std::int64_t total = upperCounts.Total();
  if (total == 0)
  {
    return 0.0F;
  }
  std::int64_t rank = std::min(total - 1, std::int64_t(std::ceil(percentile / 100.0 * double(total))));
  const std::uint32_t upper = upperCounts.Find(rank);
  MagnitudeCounts lowerCounts(upper);
  count(lowerCounts);
  const std::uint32_t bits = upper << 16 | lowerCounts.Find(rank);
  float magnitude = 0.0F;
  std::memcpy(&magnitude, &bits, sizeof(bits));
  return magnitude;
}

// ---- The cube ------------------------------------------------------------------------------------------------------

// Links between picks of one sign have 32 bits.
constexpr std::int64_t MostPicks = std::int64_t(1) << 30;

struct Found
{
  PickDepth Place = 0;
  std::int32_t Thickness = 0;
  float Strength = 0.0F; // with sign
};

struct RowReflections
{
  RawVector<Found> All;
  std::vector<std::int32_t> Ends; // by column, in All
  std::int64_t Samples = 0;
  std::int64_t LiveSamples = 0;
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
  if (std::int64_t(size[0]) * size[1] > std::numeric_limits<PointId>::max())
  {
    refuse("less than 2^31 traces");
  }
}

int SignOf(const Found& found)
{
  return std::signbit(found.Strength) ? 1 : 0;
}

bool IsWanted(const Found& found, float threshold)
{
  return std::abs(found.Strength) >= threshold;
}

void AddEnergy(const Found& found, std::vector<double>& energies)
{
  assert(found.Thickness > 0);
  if (std::size_t(found.Thickness) >= energies.size())
  {
    energies.resize(found.Thickness + 1, 0.0);
  }
  energies[found.Thickness] += double(found.Strength) * double(found.Strength);
}

/// Half of the energy lies in runs up to half the period.
double FindPeriod(const std::vector<double>& energies)
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

class Finder
{
public:
  Finder(const TraceCube& cube, const ReflectionOptions& options, const TraceLimits& limits)
    : Cube(cube)
    , Options(options)
    , Limits(limits)
    , Rows(cube.Size[1])
  {
  }

  CubeReflections Find(const Monitor& monitor)
  {
    CubeReflections result;
    for (ReflectionPicks& picks : result.BySign)
    {
      picks.Columns = { this->Cube.Size[0], this->Cube.Size[1] };
      // Allocated here, as rows return their memory only if nothing lies behind it.
      picks.Starts.assign(std::size_t(picks.Columns[0]) * std::size_t(picks.Columns[1]) + 1, 0);
    }
    const bool isMiddle = this->Options.Position == ReflectionPosition::Middle;
    const bool isPercentile =
      this->Options.Threshold == ThresholdKind::Percentile && this->Options.AmplitudePercentile > 0.0;
    if (this->Options.Threshold == ThresholdKind::Amplitude)
    {
      result.Threshold = float(this->Options.AmplitudeThreshold);
    }
    if (isPercentile)
    {
      result.Threshold = this->SelectSample(monitor.Step(0.0, 0.5));
    }
    result.Rules = { this->Options.Polarity, this->Options.Position, isMiddle ? result.Threshold : 0.0F };
    this->FindRows(result.Rules, monitor.Step(isPercentile ? 0.5 : 0.0, 0.9));
    for (const RowReflections& row : this->Rows)
    {
      result.Samples += row.Samples;
      result.LiveSamples += row.LiveSamples;
    }
    if (result.Samples == 0)
    {
      throw InputError("no amplitude: all samples of the cube are blanked or not finite, expected numbers");
    }
    result.Period = FindPeriod(this->CountPicks(result));
    this->Gather(result);
    return result;
  }

private:
  std::int64_t Grain() const
  {
    constexpr std::int64_t samples = 1 << 18;
    return std::max<std::int64_t>(1, samples / (std::int64_t(this->Cube.Size[0]) * this->Cube.Size[2]));
  }

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

  void FindRows(const ReflectionRules& rules, const Monitor& monitor)
  {
    const int samples = this->Cube.Size[2];
    this->ForEachRow(monitor,
      [&](int j, std::vector<float>& block)
      {
        RowReflections& row = this->Rows[j];
        row.Ends.reserve(this->Cube.Size[0]);
        std::vector<Reflection> reflections;
        ForEachTrace(this->Cube, j, block,
          [&](int i, const float* trace)
          {
            const std::size_t first = reflections.size();
            row.Samples += std::count_if(trace, trace + samples, [](float value) { return value == value; });
            FindReflections(trace, samples, rules, reflections);
            const std::int64_t column = i + std::int64_t(this->Cube.Size[0]) * j;
            row.LiveSamples += this->CountLive(trace, column);
            LeaveOutBeyond(this->Limits, column, first, reflections);
            row.Ends.push_back(std::int32_t(reflections.size()));
          });
        row.All.resize(reflections.size());
        std::transform(reflections.begin(), reflections.end(), row.All.begin(),
          [](const Reflection& reflection) -> Found {
            return { reflection.Place, reflection.Thickness, std::copysign(reflection.Strength, reflection.Amplitude) };
          });
      });
  }

  std::int64_t CountLive(const float* trace, std::int64_t column) const
  {
    double first = 0.0;
    double last = this->Cube.Size[2] - 1;
    if (!this->Limits.AreNone()) // nan stays nan, as the first argument
    {
      first = std::ceil(std::max(this->Limits.First[column], first));
      last = std::floor(std::min(this->Limits.Last[column], last));
    }
    if (!(first <= last))
    {
      return 0;
    }
    const auto isLive = [](float value) { return value == value && value != 0.0F; };
    const float* const begin = std::find_if(trace + std::int64_t(first), trace + std::int64_t(last) + 1, isLive);
    const float* end = trace + std::int64_t(last) + 1;
    while (end > begin && !isLive(end[-1]))
    {
      --end;
    }
    return end - begin;
  }

  /// Returns energies by thickness.
  std::vector<double> CountPicks(CubeReflections& result) const
  {
    std::vector<std::vector<double>> energies(this->Rows.size());
    ParallelFor(std::int64_t(this->Rows.size()), this->Grain(),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t j = first; j < last; ++j)
        {
          this->CountRow(this->Rows[j], result.BySign[0].ColumnAt(0, int(j)), result, energies[j]);
        }
      });
    for (ReflectionPicks& picks : result.BySign)
    {
      std::int64_t total = 0;
      for (PointId& start : picks.Starts)
      {
        total += std::exchange(start, PointId(total));
        if (total > MostPicks)
        {
          throw InputError(
            "more than 2^30 reflections of one sign, expected fewer: a higher threshold, or a part of the cube");
        }
      }
      picks.Places.resize(total);
      picks.Strengths.resize(total);
    }
    std::vector<double> all;
    for (const std::vector<double>& row : energies)
    {
      all.resize(std::max(all.size(), row.size()), 0.0);
      std::transform(row.begin(), row.end(), all.begin(), all.begin(), std::plus<>());
    }
    return all;
  }

  static void CountRow(
    const RowReflections& row, std::int64_t column, CubeReflections& result, std::vector<double>& energies)
  {
    std::int32_t next = 0;
    for (const std::int32_t end : row.Ends)
    {
      for (; next < end; ++next)
      {
        const int sign = SignOf(row.All[next]);
        if (IsWanted(row.All[next], result.Threshold))
        {
          ++result.BySign[sign].Starts[column];
          AddEnergy(row.All[next], energies);
        }
      }
      ++column;
    }
  }

  void Gather(CubeReflections& result)
  {
    ParallelFor(std::int64_t(this->Rows.size()), this->Grain(),
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t j = first; j < last; ++j)
        {
          const RowReflections row = std::exchange(this->Rows[j], RowReflections());
          const std::int64_t column = result.BySign[0].ColumnAt(0, int(j));
          std::array<PointId, 2> next = { result.BySign[0].Begin(column), result.BySign[1].Begin(column) };
          for (const Found& found : row.All)
          {
            const int sign = SignOf(found);
            if (IsWanted(found, result.Threshold))
            {
              const PointId pick = next[sign]++;
              result.BySign[sign].Places[pick] = found.Place;
              result.BySign[sign].Strengths[pick] = CoarseStrength(std::abs(found.Strength));
            }
          }
          assert(next[0] == result.BySign[0].End(column + this->Cube.Size[0] - 1));
          assert(next[1] == result.BySign[1].End(column + this->Cube.Size[0] - 1));
        }
      });
  }

  const TraceCube& Cube;
  const ReflectionOptions Options;
  const TraceLimits& Limits;
  std::vector<RowReflections> Rows;
};
}

//----------------------------------------------------------------------------------------------------------------------
void FindReflections(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found)
{
  TraceScan(trace, samples, rules, found).Scan();
}

//----------------------------------------------------------------------------------------------------------------------
void LeaveOutBeyond(
  const TraceLimits& limits, std::int64_t column, std::size_t first, std::vector<Reflection>& reflections)
{
  reflections.erase(std::remove_if(reflections.begin() + std::ptrdiff_t(first), reflections.end(),
                      [&](const Reflection& one) { return !limits.Contain(column, one.Place); }),
    reflections.end());
}

//----------------------------------------------------------------------------------------------------------------------
void CheckOptions(const ReflectionOptions& options)
{
  CheckAtLeast("AmplitudeThreshold", options.AmplitudeThreshold, 0.0, "");
  CheckWithin("AmplitudePercentile", options.AmplitudePercentile, 0.0, 100.0, " percent");
}

//----------------------------------------------------------------------------------------------------------------------
CubeReflections FindReflections(
  const TraceCube& cube, const ReflectionOptions& options, const Monitor& monitor, const TraceLimits& limits)
{
  CheckOptions(options);
  CheckSize(cube.Size);
  return Finder(cube, options, limits).Find(monitor);
}
}
