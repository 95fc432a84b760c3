// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Crossing horizons of a stack are put in order, column by column.
//
// The repair is isotonic regression by pooling adjacent violators (Barlow et al. 1972): of all ordered stacks it is the
// nearest by weighted squares. A winning horizon weighs infinitely more, so that a pool has the mean height of its
// horizons of the largest weight:
//
//   policies downwards          weights       height where all three cross
//   Mean, Mean                  0, 0, 0       the mean of the three
//   UpperWins, UpperWins        0, -1, -2     the first, as erosion cuts
//   LowerWins, LowerWins        0, 1, 2       the last, as onlap ends
//   Mean, LowerWins             0, 0, 1       the last
//   UpperWins, LowerWins        0, -1, 0      the mean of the first and the last

#ifndef SeismicHorizonsCrossings_h
#define SeismicHorizonsCrossings_h

#include "Common/Base/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// What happens where two neighbours cross.
enum class CrossingPolicy
{
  Mean, // both move to the mean of all that cross there
  UpperWins, // the lower one moves
  LowerWins, // the upper one moves
  Stop // an error; Mean where the policies of other interfaces bring the two together
};

struct CrossingOptions
{
  std::vector<std::string> Names; // of horizons in messages; may be empty
  /// One per interface, from the uppermost on, or one for all. Interface n is between horizons n and n + 1.
  std::vector<CrossingPolicy> Policies = { CrossingPolicy::Mean };
  /// Neighbours closer than this are pooled as if they crossed, in the unit of heights: at least 0.
  double MinimumThickness = 0.0;
  /// Whether the uppermost horizon has the least heights, as with depths and times.
  bool HeightsGrowDownwards = false;
  std::string Unit = "lattice units"; // of heights in messages
};

/// "Top", or "horizon 1".
std::string NameOf(std::size_t horizon, const CrossingOptions& options);

struct RepairFigures
{
  std::int64_t Columns = 0;
  double Largest = 0.0;

  void Add(const RepairFigures& other)
  {
    this->Columns += other.Columns;
    this->Largest = std::max(this->Largest, other.Largest);
  }
};

struct CrossingRepair
{
  std::vector<RepairFigures> Interfaces; // columns in which horizons crossed, and how far
  std::vector<RepairFigures> Horizons; // columns in which a horizon moved, and how far

  void Add(const CrossingRepair& other);
};

/// Heights by horizon, the uppermost first, then by column; nan where a horizon has none.
using HeightStack = std::vector<std::vector<double>>;

/// Holds for every stack.
inline bool HaveAll(const HeightStack& heights, std::size_t columns)
{
  return std::all_of(heights.begin(), heights.end(), [columns](const auto& each) { return each.size() == columns; });
}

/// Puts heights in order. Throws InputError on fewer than two horizons, a wrong number of policies, and crossings with
/// the policy Stop.
CrossingRepair RepairCrossings(
  HeightStack& heights, const CrossingOptions& options = CrossingOptions(), const Monitor& monitor = Monitor());

/// Puts the heights of one column in order, by the mean. Horizons that are marked get the height of the next one.
void OrderColumn(
  std::vector<double>& heights, const std::vector<unsigned char>& isOneWithNext, bool heightsGrowDownwards);
}

#endif
