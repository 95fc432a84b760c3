// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Likeness is the correlation of waveforms, cut out of traces around picks by cubic convolution (Keys 1981), and scaled
// to equal energy. Sums of products of integers do not depend on the order, and vectorize.
//
// Contacts correlate sums of waveforms.
//
// Picks of neighbouring columns are linked if each is the best of the other. Threads hold waveforms of two rows, and
// write the links that begin in their rows.

#include "ReflectionLinks.h"

#include "Common/Base/Parallel.h"

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

constexpr int VectorLanes = 8;

// Interpolation reads zeros beyond the half width.
constexpr int Margin = 2;

/// The place lies between the second and third of four samples (cubic convolution; Keys 1981).
std::array<float, 4> CubicWeights(float t)
{
  const float s = 1.0F - t;
  return { -0.5F * t * s * s, 1.0F + t * t * (1.5F * t - 2.5F), 1.0F + s * s * (1.5F * s - 2.5F), -0.5F * s * t * t };
}

/// Lanes let compilers vectorize the sum.
float Energy(const std::vector<float>& values)
{
  std::array<float, VectorLanes> sums = {};
  for (std::size_t n = 0; n < values.size(); n += VectorLanes)
  {
    for (std::size_t lane = 0; lane < VectorLanes; ++lane)
    {
      sums[lane] += values[n + lane] * values[n + lane];
    }
  }
  return ((sums[0] + sums[4]) + (sums[1] + sums[5])) + ((sums[2] + sums[6]) + (sums[3] + sums[7]));
}

class WaveformCutter
{
public:
  static constexpr std::int32_t Length = 32000; // of a waveform as a vector

  /// `halfWidth` is in samples before and after the pick.
  explicit WaveformCutter(int halfWidth)
    : HalfWidth(halfWidth)
    , ValuesPerWaveform((2 * halfWidth + 1 + VectorLanes - 1) / VectorLanes * VectorLanes)
    , Shape(this->ValuesPerWaveform, 0.0F)
  {
  }

  /// Values are padded by zeros to a multiple of 8.
  int Width() const { return this->ValuesPerWaveform; }

  /// Missing samples are 0.
  void SetTrace(const float* trace, int samples)
  {
    const int pad = this->HalfWidth + Margin;
    // The cut covers the padded width.
    const std::size_t size = samples + pad + Margin + this->ValuesPerWaveform;
    if (this->Padded.size() != size)
    {
      this->Padded.assign(size, 0.0F);
    }
    std::transform(
      trace, trace + samples, this->Padded.begin() + pad, [](float value) { return value == value ? value : 0.0F; });
  }

  void CutOut(PickDepth place, std::int16_t* waveform)
  {
    const auto weights = CubicWeights(float(place % DepthsPerSample) / float(DepthsPerSample));
    // Values lie between the second and third sample from here.
    const int first = place / DepthsPerSample + Margin - 1;
    assert(std::size_t(first + this->ValuesPerWaveform + 3) <= this->Padded.size());
    const float* const samples = this->Padded.data() + first;
    float* const shape = this->Shape.data();
    for (int n = 0; n < this->ValuesPerWaveform; ++n)
    {
      shape[n] = (weights[0] * samples[n] + weights[1] * samples[n + 1]) +
        (weights[2] * samples[n + 2] + weights[3] * samples[n + 3]);
    }
    std::fill(this->Shape.begin() + 2 * this->HalfWidth + 1, this->Shape.end(), 0.0F);
    const float energy = Energy(this->Shape);
    const float scale = energy > 0.0F ? float(Length) / std::sqrt(energy) : 0.0F;
    for (int n = 0; n < this->ValuesPerWaveform; ++n)
    {
      waveform[n] = std::int16_t(std::int32_t(scale * shape[n]));
    }
  }

private:
  int HalfWidth;
  int ValuesPerWaveform;
  std::vector<float> Padded; // between zeros
  std::vector<float> Shape;
};

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
    const std::int16_t* const first = rowA.WaveformOf(a);
    const std::int16_t* const second = rowB.WaveformOf(b);
    std::int32_t sum = 0;
    const int width = rowA.Cutter.Width();
    for (int n = 0; n < width; ++n)
    {
      sum += std::int32_t(first[n]) * std::int32_t(second[n]);
    }
    return sum;
  }

  static constexpr std::int32_t One = WaveformCutter::Length * WaveformCutter::Length;

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

// A weaker pick below this ratio is noise, or another reflection, beside the end of a strong one, as at a fault.
constexpr float SmallestStrengthRatio = 0.35F;

double ScoreOf(double correlation, PickDepth step)
{
  return correlation - ScorePerSample * InSamples(step);
}

struct Best
{
  PointId Pick = NoPoint;
  double Score = -std::numeric_limits<double>::infinity();
  std::int32_t Correlation = 0;
};

void Consider(Best& best, PointId pick, double score, std::int32_t correlation)
{
  if (score > best.Score)
  {
    best = { pick, score, correlation };
  }
}
}

class ReflectionLinks::RowLinker
{
public:
  RowLinker(ReflectionLinks& links, const TraceCube& cube, const LinkOptions& options)
    : Links(links)
    , Cube(cube)
    , LargestStep(options.LargestStep)
    , Row(options.HalfWidth)
    , NextRow(options.HalfWidth)
  {
  }

  void Run(int firstRow, int lastRow)
  {
    this->Row.Load(this->Cube, this->Links.Picks, firstRow);
    for (int j = firstRow; j < lastRow; ++j)
    {
      if (j + 1 < this->Cube.Size[1])
      {
        this->NextRow.Load(this->Cube, this->Links.Picks, j + 1);
      }
      for (int direction = 0; direction < this->Links.Directions(); ++direction)
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
    const ReflectionPicks& picks = this->Links.Picks;
    for (int i = firstColumn; i < lastColumn; ++i)
    {
      this->FindBest(picks.ColumnAt(i, j), picks.ColumnAt(i + step.I, j + step.J), other);
      this->WriteMutual(picks.ColumnAt(i, j), picks.ColumnAt(i + step.I, j + step.J), direction);
    }
  }

  void FindBest(std::int64_t columnA, std::int64_t columnB, const RowWaveforms& other)
  {
    const ReflectionPicks& picks = this->Links.Picks;
    const PointId beginA = picks.Begin(columnA);
    const PointId beginB = picks.Begin(columnB);
    this->OfA.assign(picks.End(columnA) - beginA, Best());
    this->OfB.assign(picks.End(columnB) - beginB, Best());
    picks.ForEachPair(columnA, columnB, this->LargestStep,
      [&](PointId a, PointId b)
      {
        const std::int32_t correlation = RowWaveforms::Correlate(this->Row, a, other, b);
        const PickDepth step = std::abs(picks.Places[b] - picks.Places[a]);
        const double score = ScoreOf(double(correlation) / RowWaveforms::One, step);
        Consider(this->OfA[a - beginA], b, score, correlation);
        Consider(this->OfB[b - beginB], a, score, correlation);
      });
  }

  void WriteMutual(std::int64_t columnA, std::int64_t columnB, int direction)
  {
    const ReflectionPicks& picks = this->Links.Picks;
    const PointId beginB = picks.Begin(columnB);
    PointId a = picks.Begin(columnA);
    for (const Best& best : this->OfA)
    {
      if (best.Pick != NoPoint && this->OfB[best.Pick - beginB].Pick == a)
      {
        this->Links.Partners[this->Links.PlaceOf(a, direction)] = best.Pick;
        this->Links.Partners[this->Links.PlaceOf(best.Pick, direction) + 1] = a;
        this->Links.Correlations[direction][a] =
          std::int16_t(std::lround(double(best.Correlation) / RowWaveforms::One * LargestRounded));
      }
      ++a;
    }
  }

  ReflectionLinks& Links;
  const TraceCube& Cube;
  const PickDepth LargestStep;
  RowWaveforms Row;
  RowWaveforms NextRow;
  std::vector<Best> OfA;
  std::vector<Best> OfB;
};

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
  constexpr std::int64_t rows = 16; // per additional row that is read
  ParallelFor(picks.Columns[1], rows, monitor,
    [&](std::int64_t first, std::int64_t last) { RowLinker(*this, cube, options).Run(int(first), int(last)); });
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::Score(PointId pick, int direction) const
{
  const PickDepth step = this->Picks.Places[this->Next(pick, direction)] - this->Picks.Places[pick];
  return ScoreOf(this->Correlation(pick, direction), std::abs(step));
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::MedianCorrelation() const
{
  constexpr int keys = 1 << 16;
  std::vector<std::int64_t> counts(keys, 0);
  std::int64_t total = 0;
  this->ForEach(
    [&](PointId pick, int direction)
    {
      ++counts[this->Rounded(pick, direction) + keys / 2];
      ++total;
    });
  if (total == 0)
  {
    return 0.0;
  }
  int key = 0;
  for (std::int64_t rank = total / 2; rank >= counts[key]; ++key)
  {
    rank -= counts[key];
  }
  return (key - keys / 2) / LargestRounded;
}

//----------------------------------------------------------------------------------------------------------------------
bool ReflectionLinks::AreOfLikeStrength(PointId a, PointId b) const
{
  const float strengthA = this->Picks.StrengthOf(a);
  const float strengthB = this->Picks.StrengthOf(b);
  return std::min(strengthA, strengthB) >= SmallestStrengthRatio * std::max(strengthA, strengthB);
}

//----------------------------------------------------------------------------------------------------------------------
void ReflectionLinks::Drop(double smallestCorrelation)
{
  const auto smallest = std::int32_t(std::ceil(smallestCorrelation * LargestRounded));
  this->ForEach(
    [&](PointId pick, int direction)
    {
      PointId& next = this->Partners[this->PlaceOf(pick, direction)];
      assert(this->Previous(next, direction) == pick);
      if (this->Rounded(pick, direction) < smallest || !this->AreOfLikeStrength(pick, next))
      {
        this->Partners[this->PlaceOf(next, direction) + 1] = NoPoint;
        next = NoPoint;
      }
    });
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
  return [contact = ContactWaveforms(cube, picks, halfWidth)](std::vector<Edge> pairs) mutable
  { return contact.Correlate(std::move(pairs)); };
}
}
