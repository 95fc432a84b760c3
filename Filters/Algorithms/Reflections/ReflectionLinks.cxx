// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A thread holds the waveforms of two rows at a time, those between which it makes links. Each link is written by the
// row it begins in, to places of its own.

#include "ReflectionLinks.h"

#include "Common/Parallel.h"
#include "Waveforms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double ScorePerSample = 0.05;

// Of the strengths of two linked picks: the smaller one is at least that part of the other. Beside the end of a strong
// reflection, as at a fault, there is noise or a weaker one.
constexpr float SmallestStrengthRatio = 0.35F;

double ScoreOf(double correlation, Depth step)
{
  return correlation - ScorePerSample * InSamples(step);
}

/// The best partner of a pick so far.
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

// ---- One thread
// ------------------------------------------------------------------------------------------------------
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

  /// Makes the links that begin in these rows.
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
    const ColumnStep& step = NeighbourSteps[std::size_t(direction)];
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

  /// Finds for each pick of two columns the best one of the other.
  void FindBest(std::int64_t columnA, std::int64_t columnB, const RowWaveforms& other)
  {
    const ReflectionPicks& picks = this->Links.Picks;
    const PointId beginA = picks.Begin(columnA);
    PointId low = picks.Begin(columnB);
    const PointId beginB = low;
    this->OfA.assign(std::size_t(picks.End(columnA) - beginA), Best());
    this->OfB.assign(std::size_t(picks.End(columnB) - beginB), Best());
    for (PointId a = beginA; a < picks.End(columnA); ++a)
    {
      const Depth place = picks.PlaceOf(a);
      while (low < picks.End(columnB) && picks.PlaceOf(low) < place - this->LargestStep)
      {
        ++low;
      }
      for (PointId b = low; b < picks.End(columnB) && picks.PlaceOf(b) <= place + this->LargestStep; ++b)
      {
        const std::int32_t correlation = RowWaveforms::Correlate(this->Row, a, other, b);
        const double score = ScoreOf(double(correlation) / RowWaveforms::One, std::abs(picks.PlaceOf(b) - place));
        Consider(this->OfA[std::size_t(a - beginA)], b, score, correlation);
        Consider(this->OfB[std::size_t(b - beginB)], a, score, correlation);
      }
    }
  }

  void WriteMutual(std::int64_t columnA, std::int64_t columnB, int direction)
  {
    const ReflectionPicks& picks = this->Links.Picks;
    const PointId beginB = picks.Begin(columnB);
    PointId a = picks.Begin(columnA);
    for (const Best& best : this->OfA)
    {
      if (best.Pick != NoPoint && this->OfB[std::size_t(best.Pick - beginB)].Pick == a)
      {
        this->Links.Partners[this->Links.PlaceOf(a, direction)] = best.Pick;
        this->Links.Partners[this->Links.PlaceOf(best.Pick, direction) + 1] = a;
        this->Links.Correlations[std::size_t(direction)][std::size_t(a)] =
          std::int16_t(std::lround(double(best.Correlation) / RowWaveforms::One * LargestRounded));
      }
      ++a;
    }
  }

  ReflectionLinks& Links;
  const TraceCube& Cube;
  const Depth LargestStep;
  RowWaveforms Row;
  RowWaveforms NextRow;
  std::vector<Best> OfA;
  std::vector<Best> OfB;
};

// ---- All links
// -------------------------------------------------------------------------------------------------------
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
  constexpr std::int64_t rows = 16; // one more is read for each that many
  ParallelFor(picks.Columns[1], rows, monitor,
    [&](std::int64_t first, std::int64_t last) { RowLinker(*this, cube, options).Run(int(first), int(last)); });
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::Score(PointId pick, int direction) const
{
  const Depth step = this->Picks.PlaceOf(this->Next(pick, direction)) - this->Picks.PlaceOf(pick);
  return ScoreOf(this->Correlation(pick, direction), std::abs(step));
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ReflectionLinks::Size() const
{
  std::int64_t size = 0;
  for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
  {
    for (int direction = 0; direction < this->Directions(); ++direction)
    {
      size += this->Next(pick, direction) != NoPoint ? 1 : 0;
    }
  }
  return size;
}

//----------------------------------------------------------------------------------------------------------------------
double ReflectionLinks::MedianCorrelation() const
{
  constexpr int keys = 1 << 16;
  std::vector<std::int64_t> counts(keys, 0);
  std::int64_t total = 0;
  for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
  {
    for (int direction = 0; direction < this->Directions(); ++direction)
    {
      if (this->Next(pick, direction) != NoPoint)
      {
        ++counts[std::size_t(this->Rounded(pick, direction) + keys / 2)];
        ++total;
      }
    }
  }
  if (total == 0)
  {
    return 0.0;
  }
  int key = 0;
  for (std::int64_t rank = total / 2; rank >= counts[std::size_t(key)]; ++key)
  {
    rank -= counts[std::size_t(key)];
  }
  return (key - keys / 2) / LargestRounded;
}

//----------------------------------------------------------------------------------------------------------------------
bool ReflectionLinks::AreOfLikeStrength(PointId a, PointId b) const
{
  const float strengthA = StrengthOf(this->Picks.CoarseStrengthOf(a));
  const float strengthB = StrengthOf(this->Picks.CoarseStrengthOf(b));
  return std::min(strengthA, strengthB) >= SmallestStrengthRatio * std::max(strengthA, strengthB);
}

//----------------------------------------------------------------------------------------------------------------------
void ReflectionLinks::Drop(double smallestCorrelation)
{
  const auto smallest = std::int32_t(std::ceil(smallestCorrelation * LargestRounded));
  for (PointId pick = 0; pick < this->Picks.Size(); ++pick)
  {
    for (int direction = 0; direction < this->Directions(); ++direction)
    {
      PointId& next = this->Partners[this->PlaceOf(pick, direction)];
      if (next != NoPoint && (this->Rounded(pick, direction) < smallest || !this->AreOfLikeStrength(pick, next)))
      {
        this->Partners[this->PlaceOf(next, direction) + 1] = NoPoint;
        next = NoPoint;
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t ReflectionLinks::Rank(PointId pick, int direction) const
{
  constexpr double ranks = 1 << 16; // of 2e-5 each, from a score of 1 down to -0.31; what is below comes last
  constexpr double perRank = 2e-5;
  return std::int64_t(std::clamp((1.0 - this->Score(pick, direction)) / perRank, 0.0, ranks - 1.0));
}
}
