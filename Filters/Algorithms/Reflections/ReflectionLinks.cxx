// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Contacts correlate sums of waveforms.
//
// Picks of neighbouring columns are linked if each is the best of the other. Threads hold waveforms of two rows, and
// write the links that begin in their rows.

#include "ReflectionLinks.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Parallel.h"
#include "WaveformCutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// ---- Waveforms -----------------------------------------------------------------------------------------------------

class RowWaveforms
{
public:
  explicit RowWaveforms(int halfWidth)
    : Cutter(halfWidth)
  {
  }

  void Load(const TraceCube& cube, const ReflectionPicks& picks, int j)
  {
    const std::int64_t firstColumn = picks.ColumnAt(0, j);
    this->First = picks.Begin(firstColumn);
    const std::size_t size = picks.End(firstColumn + cube.Size[0] - 1) - this->First;
    this->Values.resize(size * this->Cutter.Width());
    std::int16_t* waveform = this->Values.data();
    ForEachTrace(cube, j, this->Block,
      [&](int i, const float* trace)
      {
        this->Cutter.SetTrace(trace, cube.Size[2]);
        for (PointId pick = picks.Begin(firstColumn + i); pick < picks.End(firstColumn + i); ++pick)
        {
          this->Cutter.CutOut(picks.Places[pick], waveform);
          waveform += this->Cutter.Width();
        }
      });
  }

  /// Returns the correlation, -1 to 1, times One.
  static std::int32_t Correlate(const RowWaveforms& rowA, PointId a, const RowWaveforms& rowB, PointId b)
  {
    return rowA.Cutter.Correlate(rowA.WaveformOf(a), rowB.WaveformOf(b));
  }

  static constexpr std::int32_t One = WaveformCutter::One;

private:
  const std::int16_t* WaveformOf(PointId pick) const
  {
    assert(pick >= this->First);
    return this->Values.data() + std::size_t(pick - this->First) * this->Cutter.Width();
  }

  WaveformCutter Cutter;
  PointId First = 0; // of the row
  std::vector<std::int16_t> Values;
  std::vector<float> Block;
};

// ---- Contacts ------------------------------------------------------------------------------------------------------

class ContactWaveforms
{
public:
  ContactWaveforms(const TraceCube& cube, const ReflectionPicks& picks, int halfWidth)
    : Cube(cube)
    , Picks(picks)
    , Cutter(halfWidth)
    , Trace(cube.Size[2])
    , Waveform(this->Cutter.Width())
  {
  }

  double Correlate(std::vector<Edge> pairs)
  {
    constexpr std::size_t enough = 64;
    std::sort(pairs.begin(), pairs.end(),
      [](const Edge& a, const Edge& b) { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
    std::vector<std::int32_t> from(this->Waveform.size(), 0);
    std::vector<std::int32_t> to(this->Waveform.size(), 0);
    const std::size_t step = std::max<std::size_t>(1, pairs.size() / enough);
    for (std::size_t n = 0; n < pairs.size(); n += step)
    {
      this->AddWaveform(pairs[n].From, from);
      this->AddWaveform(pairs[n].To, to);
    }
    const auto product = [](const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b)
    { return double(std::inner_product(a.begin(), a.end(), b.begin(), std::int64_t(0), std::plus<>(), Multiply)); };
    const double norm = std::sqrt(product(from, from) * product(to, to));
    return norm > 0.0 ? product(from, to) / norm : 0.0;
  }

private:
  static std::int64_t Multiply(std::int64_t x, std::int64_t y) { return x * y; }

  void AddWaveform(PointId pick, std::vector<std::int32_t>& sum)
  {
    const std::int32_t column = this->Picks.ColumnOf(pick);
    this->Cube.Read(this->Picks.JOf(column), this->Picks.IOf(column), 1, this->Trace.data());
    this->Cutter.SetTrace(this->Trace.data(), this->Cube.Size[2]);
    this->Cutter.CutOut(this->Picks.Places[pick], this->Waveform.data());
    std::transform(sum.begin(), sum.end(), this->Waveform.begin(), sum.begin(), std::plus<>());
  }

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  WaveformCutter Cutter;
  std::vector<float> Trace;
  std::vector<std::int16_t> Waveform;
};

// ---- Links ---------------------------------------------------------------------------------------------------------

constexpr double ScorePerSample = 0.05;

constexpr float SmallestStrengthRatio = 0.35F;

struct Best
{
  PointId Pick = NoPoint;
  double Score = -std::numeric_limits<double>::infinity();
  std::int32_t Correlation = 0;
};

std::int16_t RoundCorrelation(const Best& best, double largest)
{
  return std::int16_t(std::lround(double(best.Correlation) / RowWaveforms::One * largest));
}

void Consider(Best& best, PointId pick, double score, std::int32_t correlation)
{
  if (score > best.Score)
  {
    best = { pick, score, correlation };
  }
}

/// Calls write(a, bestOfA, b, bestOfB, direction) with matches of the picks of two columns, from the first ones on.
template <typename Write>
class RowLinker
{
public:
  RowLinker(const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options, const Write& write)
    : Cube(cube)
    , Picks(picks)
    , Directions(int(options.Connectivity) / 2)
    , LargestStep(options.LargestStep)
    , WriteMatches(write)
    , Row(options.HalfWidth)
    , NextRow(options.HalfWidth)
  {
  }

  void Run(int firstRow, int lastRow)
  {
    this->Row.Load(this->Cube, this->Picks, firstRow);
    for (int j = firstRow; j < lastRow; ++j)
    {
      if (j + 1 < this->Cube.Size[1])
      {
        this->NextRow.Load(this->Cube, this->Picks, j + 1);
      }
      for (int direction = 0; direction < this->Directions; ++direction)
      {
        this->LinkRow(j, direction);
      }
      std::swap(this->Row, this->NextRow);
    }
  }

private:
  void LinkRow(int j, int direction)
  {
    const ColumnStep& step = TraceSteps[direction];
    if (j + step.J >= this->Cube.Size[1])
    {
      return;
    }
    const RowWaveforms& other = step.J == 0 ? this->Row : this->NextRow;
    const int firstColumn = std::max(0, -step.I);
    const int lastColumn = this->Cube.Size[0] - std::max(0, step.I);
    const ReflectionPicks& picks = this->Picks;
    for (int i = firstColumn; i < lastColumn; ++i)
    {
      this->FindBest(picks.ColumnAt(i, j), picks.ColumnAt(i + step.I, j + step.J), other);
      this->WriteMatches(picks.Begin(picks.ColumnAt(i, j)), this->OfA,
        picks.Begin(picks.ColumnAt(i + step.I, j + step.J)), this->OfB, direction);
    }
  }

  void FindBest(std::int64_t columnA, std::int64_t columnB, const RowWaveforms& other)
  {
    const ReflectionPicks& picks = this->Picks;
    const PointId beginA = picks.Begin(columnA);
    const PointId beginB = picks.Begin(columnB);
    this->OfA.assign(picks.End(columnA) - beginA, Best());
    this->OfB.assign(picks.End(columnB) - beginB, Best());
    picks.ForEachPair(columnA, columnB, this->LargestStep,
      [&](PointId a, PointId b)
      {
        const std::int32_t correlation = RowWaveforms::Correlate(this->Row, a, other, b);
        const PickDepth step = std::abs(picks.Places[b] - picks.Places[a]);
        const double score = LinkScore(double(correlation) / RowWaveforms::One, step);
        Consider(this->OfA[a - beginA], b, score, correlation);
        Consider(this->OfB[b - beginB], a, score, correlation);
      });
  }

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  const int Directions;
  const PickDepth LargestStep;
  const Write& WriteMatches;
  RowWaveforms Row;
  RowWaveforms NextRow;
  std::vector<Best> OfA;
  std::vector<Best> OfB;
};

struct CorrelationCounts
{
  static constexpr int Keys = 1 << 16;

  void Add(const CorrelationCounts& other)
  {
    std::transform(other.Counts.begin(), other.Counts.end(), this->Counts.begin(), this->Counts.begin(), std::plus<>());
  }

  std::vector<std::int64_t> Counts = std::vector<std::int64_t>(Keys, 0);
};

template <typename Write>
void LinkRows(const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options, const Monitor& monitor,
  const Write& write)
{
  constexpr std::int64_t rows = 16; // per additional row that is read
  ParallelFor(picks.Columns[1], rows, monitor,
    [&](std::int64_t first, std::int64_t last)
    { RowLinker<Write>(cube, picks, options, write).Run(int(first), int(last)); });
}
}

//----------------------------------------------------------------------------------------------------------------------
ReflectionLinks::ReflectionLinks(
  const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options, const Monitor& monitor)
  : Picks(picks)
{
  const std::size_t directions = std::size_t(options.Connectivity) / 2;
  const std::size_t size = picks.Places.size();
  this->Partners.assign(2 * directions * size, NoPoint);
  this->Correlations.resize(directions);
  for (RawVector<std::int16_t>& correlations : this->Correlations)
  {
    correlations.resize(size);
  }
  LinkRows(cube, picks, options, monitor,
    [this](PointId a, const std::vector<Best>& ofA, PointId b, const std::vector<Best>& ofB, int direction)
    {
      for (const Best& best : ofA)
      {
        if (best.Pick != NoPoint && ofB[best.Pick - b].Pick == a)
        {
          this->Partners[this->PlaceOf(a, direction)] = best.Pick;
          this->Partners[this->PlaceOf(best.Pick, direction) + 1] = a;
          this->Correlations[direction][a] = RoundCorrelation(best, LargestRounded);
        }
        ++a;
      }
    });
}

//----------------------------------------------------------------------------------------------------------------------
GrowthLinks::GrowthLinks(
  const TraceCube& cube, const ReflectionPicks& picks, const LinkOptions& options, const Monitor& monitor)
{
  assert(options.Connectivity == ColumnConnectivity::Eight);
  const std::size_t size = Neighbours * picks.Places.size();
  this->Partners.assign(size, NoPoint);
  this->Correlations.resize(size);
  const auto write = [this](PointId pick, const std::vector<Best>& matches, std::size_t neighbour)
  {
    for (const Best& best : matches)
    {
      const std::size_t link = Neighbours * std::size_t(pick++) + neighbour;
      this->Partners[link] = best.Pick;
      this->Correlations[link] = RoundCorrelation(best, LargestRounded);
    }
  };
  LinkRows(cube, picks, options, monitor,
    [&write](PointId a, const std::vector<Best>& ofA, PointId b, const std::vector<Best>& ofB, int direction)
    {
      write(a, ofA, 2 * std::size_t(direction));
      write(b, ofB, 2 * std::size_t(direction) + 1);
    });
}

//----------------------------------------------------------------------------------------------------------------------
double LinkScore(double correlation, PickDepth step)
{
  return correlation - ScorePerSample * InSamples(step);
}

//----------------------------------------------------------------------------------------------------------------------
bool AreOfLikeStrength(const ReflectionPicks& picks, PointId a, PointId b)
{
  const float strengthA = picks.StrengthOf(a);
  const float strengthB = picks.StrengthOf(b);
  return std::min(strengthA, strengthB) >= SmallestStrengthRatio * std::max(strengthA, strengthB);
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::Score(PointId pick, int direction) const
{
  const PickDepth step = this->Picks.Places[this->Next(pick, direction)] - this->Picks.Places[pick];
  return LinkScore(this->Correlation(pick, direction), std::abs(step));
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::MedianCorrelation() const
{
  constexpr std::int64_t picksPerChunk = 1 << 20; // far more than keys
  const CorrelationCounts all = AddUpChunks<CorrelationCounts>(this->Size(), picksPerChunk, Monitor(),
    [this](CorrelationCounts& part, std::int64_t first, std::int64_t last)
    {
      this->ForEach(PointId(first), PointId(last),
        [&](PointId pick, int direction)
        { ++part.Counts[this->Rounded(pick, direction) + CorrelationCounts::Keys / 2]; });
    });
  const std::vector<std::int64_t>& counts = all.Counts;
  const std::int64_t total = std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
  if (total == 0)
  {
    return 0.0;
  }
  int key = 0;
  for (std::int64_t rank = total / 2; rank >= counts[key]; ++key)
  {
    rank -= counts[key];
  }
  return (key - CorrelationCounts::Keys / 2) / LargestRounded;
}

//----------------------------------------------------------------------------------------------------------------------
void ReflectionLinks::Drop(double smallestCorrelation)
{
  const auto smallest = std::int32_t(std::ceil(smallestCorrelation * LargestRounded));
  const auto drop = [&](PointId pick, int direction)
  {
    PointId& next = this->Partners[this->PlaceOf(pick, direction)];
    assert(this->Previous(next, direction) == pick); // so no other thread writes it
    if (this->Rounded(pick, direction) < smallest || !AreOfLikeStrength(this->Picks, pick, next))
    {
      this->Partners[this->PlaceOf(next, direction) + 1] = NoPoint;
      next = NoPoint;
    }
  };
  ParallelFor(this->Size(), Grain,
    [&](std::int64_t first, std::int64_t last) { this->ForEach(PointId(first), PointId(last), drop); });
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ReflectionLinks::Rank(PointId pick, int direction) const
{
  constexpr double ranks = 1 << 16; // 2e-5 per rank, from score 1 to -0.31; the rest is last
  constexpr double perRank = 2e-5;
  return std::int64_t(std::clamp((1.0 - this->Score(pick, direction)) / perRank, 0.0, ranks - 1.0));
}
//----------------------------------------------------------------------------------------------------------------------
ContactCorrelation MakeContactCorrelation(const TraceCube& cube, const ReflectionPicks& picks, int halfWidth)
{
  return [&cube, &picks, halfWidth](std::vector<Edge> pairs)
  { return ContactWaveforms(cube, picks, halfWidth).Correlate(std::move(pairs)); };
}
}
