// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Noise makes waveforms of one event unlike, and other events may be alike by chance, but not over a patch of columns and
// three periods up and down. A logistic regression on generated cubes gave the weights; agreement of growths with other
// rules, or from fewer picks, says less.

#include "GuideConfidence.h"

#include "ReflectionLinks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>

namespace SeismicHorizons
{
namespace
{
constexpr int PatchReach = 2; // columns to each side

constexpr double Constant = -2.3;
constexpr double WeightOfSquare = 7.4; // of the mean likeness
constexpr double WeightOfPart = 2.1; // automatic joining found the same

double MeanLikeness(
  const ReflectionPicks& picks, const std::vector<Candidate>& surface, std::int32_t column, PickDepth half)
{
  const PickDepth place = picks.Places[surface[column].Pick];
  const int i = picks.IOf(column);
  const int j = picks.JOf(column);
  double sum = 0.0;
  int count = 0;
  for (int y = std::max(0, j - PatchReach); y <= std::min(picks.Columns[1] - 1, j + PatchReach); ++y)
  {
    for (int x = std::max(0, i - PatchReach); x <= std::min(picks.Columns[0] - 1, i + PatchReach); ++x)
    {
      const Candidate& other = surface[picks.ColumnAt(x, y)];
      if (other.Pick != NoPoint && std::abs(picks.Places[other.Pick] - place) <= half)
      {
        sum += double(other.Likeness);
        ++count;
      }
    }
  }
  return std::max(0.0, sum / count);
}

class SurfaceBlocks
{
public:
  SurfaceBlocks(const ReflectionPicks& picks, PickDepth half, const GuidedSurface& surface)
    : Picks(picks)
    , Half(half)
    , Surface(surface)
    , Numbers(picks.Starts.size() - 1, None)
  {
    for (std::size_t n = 0; n < surface.Picks.size(); ++n)
    {
      this->Columns.push_back(picks.ColumnOf(surface.Picks[n].Pick));
      this->Numbers[this->Columns.back()] = std::int32_t(n);
    }
  }

  std::vector<std::int32_t> FindNearestGiven() const
  {
    std::vector<std::int32_t> values(this->Columns.size(), None);
    std::vector<std::int32_t> front;
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      if (this->Surface.Picks[n].Origin == PickOrigin::Guide)
      {
        values[n] = this->Surface.Picks[n].Seed;
        front.push_back(std::int32_t(n));
      }
    }
    return this->Spread(std::move(values), std::move(front));
  }

  std::vector<std::int32_t> FindBlocks() const
  {
    std::vector<std::int32_t> blocks(this->Columns.size(), None);
    std::vector<std::int32_t> sizes;
    for (std::size_t n = 0; n < blocks.size(); ++n)
    {
      if (blocks[n] == None)
      {
        blocks[n] = std::int32_t(sizes.size());
        blocks = this->Spread(std::move(blocks), { std::int32_t(n) });
        sizes.push_back(0);
      }
      ++sizes[blocks[n]];
    }
    std::vector<std::int32_t> order(sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return sizes[a] > sizes[b]; });
    std::vector<std::int32_t> ranks(sizes.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank)
    {
      ranks[order[rank]] = std::int32_t(rank) + 1;
    }
    std::transform(blocks.begin(), blocks.end(), blocks.begin(), [&](std::int32_t block) { return ranks[block]; });
    return blocks;
  }

private:
  static constexpr std::int32_t None = -1;

  /// Returns the values of all picks after they spread from the first ones, breadth first. None is free.
  std::vector<std::int32_t> Spread(std::vector<std::int32_t> values, std::vector<std::int32_t> front) const
  {
    for (std::size_t n = 0; n < front.size(); ++n)
    {
      const std::int32_t number = front[n];
      ForEachNeighbour(this->Picks, this->Columns[number], ColumnConnectivity::Four,
        [&](std::int64_t column)
        {
          const std::int32_t next = this->Numbers[column];
          if (next != None && values[next] == None && std::abs(this->Place(next) - this->Place(number)) <= this->Half)
          {
            values[next] = values[number];
            front.push_back(next);
          }
        });
    }
    return values;
  }

  PickDepth Place(std::int32_t number) const { return this->Picks.Places[this->Surface.Picks[number].Pick]; }

  const ReflectionPicks& Picks;
  const PickDepth Half;
  const GuidedSurface& Surface;
  std::vector<std::int32_t> Columns; // of picks
  std::vector<std::int32_t> Numbers; // of picks, by column
};
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<float> MeasureConfidence(
  const ReflectionPicks& picks, const std::vector<Candidate>& surface, PickDepth quarter)
{
  std::vector<float> confidence(surface.size(), 0.0F);
  for (std::size_t column = 0; column < surface.size(); ++column)
  {
    if (surface[column].Pick != NoPoint)
    {
      const double likeness = MeanLikeness(picks, surface, std::int32_t(column), 2 * quarter);
      const double odds =
        Constant + WeightOfSquare * likeness * likeness + (surface[column].IsPart ? WeightOfPart : 0.0);
      confidence[column] = float(1.0 / (1.0 + std::exp(-odds)));
    }
  }
  return confidence;
}

//----------------------------------------------------------------------------------------------------------------------
void FindBlocks(const ReflectionPicks& picks, PickDepth quarter, GuidedSurface& surface)
{
  const SurfaceBlocks blocks(picks, 2 * quarter, surface);
  const std::vector<std::int32_t> numbers = blocks.FindBlocks();
  const std::vector<std::int32_t> nearest = blocks.FindNearestGiven();
  for (std::size_t n = 0; n < surface.Picks.size(); ++n)
  {
    surface.Picks[n].Block = numbers[n];
    surface.Picks[n].Seed = nearest[n];
  }
}
}
