// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons of a stack that cross, put in order column by column.
//
// The repair is isotonic regression: of all stacks in order it is the one nearest to the given heights by weighted
// squares, found by pooling adjacent violators (Barlow et al. 1972). Horizons that are pooled get one and the same
// height, to the bit. Where one of two horizons wins, it weighs infinitely more, so that a pool has the mean height of
// those of its horizons that weigh most.
//
//   policies downwards          weights       where all three cross, all have the height
//   Mean, Mean                  0, 0, 0       that is the mean of the three
//   UpperWins, UpperWins        0, -1, -2     of the first: a running minimum downwards, as erosion cuts
//   LowerWins, LowerWins        0, 1, 2       of the last: a running maximum upwards, as onlap ends
//   Mean, LowerWins             0, 0, 1       of the last
//   UpperWins, LowerWins        0, -1, 0      that is the mean of the first and the last
//
// The mean suits noise. Of an unconformity it makes nonsense: how deep horizons cross tells the two apart.

#ifndef SeismicHorizonsCrossings_h
#define SeismicHorizonsCrossings_h

#include "Common/Monitor.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// What is done where two neighbours of a stack cross.
enum class CrossingPolicy
{
  Mean, // both move to the mean of all that cross there
  UpperWins, // the lower one moves
  LowerWins, // the upper one moves
  Stop // an error; as Mean where the policies of other interfaces alone bring the two together
};

struct CrossingOptions
{
  /// What horizons are called in messages, by their numbers where there are none.
  std::vector<std::string> Names;
  /// For each interface, from the uppermost on; or one for all of them. Interface n is between horizons n and n + 1.
  std::vector<CrossingPolicy> Policies = { CrossingPolicy::Mean };
  /// Neighbours with less between them are pooled as those are that cross, in the unit of heights: at least 0.
  double MinimumThickness = 0.0;
  /// Whether the heights of the uppermost horizon are the least ones, as depths and times are.
  bool HeightsGrowDownwards = false;
  /// That of heights in messages.
  std::string Unit = "lattice units";
};

/// "Top", or "horizon 1".
std::string NameOf(std::size_t horizon, const CrossingOptions& options);

/// How two neighbours crossed before.
struct CrossedInterface
{
  std::int64_t Columns = 0;
  double Deepest = 0.0; // in the unit of heights

  void Add(const CrossedInterface& other);
};

/// How a horizon was moved.
struct MovedHorizon
{
  std::int64_t Columns = 0;
  double Farthest = 0.0; // in the unit of heights

  void Add(const MovedHorizon& other);
};

struct CrossingRepair
{
  std::vector<CrossedInterface> Interfaces;
  std::vector<MovedHorizon> Horizons;
};

/// The heights of horizons, the uppermost first, each with one per column of all. They are put in order: those that are
/// nan are not there.
using HeightStack = std::vector<std::vector<double>>;

/// Throws InputError when there are fewer than two horizons, with a wrong number of policies, and where horizons cross
/// that have to stop: "Top and Base cross in 13481 columns, by up to 2.1 lattice units, expected none: ...".
CrossingRepair RepairCrossings(
  HeightStack& heights, const CrossingOptions& options = CrossingOptions(), const Monitor& monitor = Monitor());

/// Puts the heights of one column in order, by the mean; those that are marked are one with the next one in any case.
void OrderColumn(
  std::vector<double>& heights, const std::vector<unsigned char>& isOneWithNext, bool heightsGrowDownwards);
}

#endif
