// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which fault ends at which. Faults are continued beyond their picks, up to the box or to the fault that they end at:
//
// - A fault that lies on one side of another one ends there.
// - Of two, one of which crosses the continuation of the other, that other one ends.
// - Of two that cross, the smaller one ends, and is a fault on each side.
//
// The user may say which one ends.

#ifndef SeismicHorizonsFaultNetwork_h
#define SeismicHorizonsFaultNetwork_h

#include "SealedModel.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct EndingRule
{
  std::string Minor; // ends at
  std::string Main;
};

struct FaultNetwork
{
  /// In order. Each has its region.
  std::vector<SealingFault> Faults;
  std::vector<std::size_t> Plates; // their numbers, by fault
  std::vector<double> Gaps; // up to the horizon that they end at, by fault; set by EndAtHorizons
  std::vector<std::string> Choices; // made without a rule, as "F2 ends at F1"
  std::vector<std::string> LeftOut; // parts of faults beyond those that they end at by a rule
  std::vector<std::string> Outside; // names of faults that are not in the box
};

/// Faults that reach less than `endDistance` columns beyond another one end there. Without rules, all choices are made; with
/// some, faults that cross must have one. Throws InputError for rules of unknown faults, rules that run in a circle,
/// crossings without a rule, and faults within a column of each other.
FaultNetwork MakeNetwork(const std::vector<FaultPlate>& plates, const Eigen::AlignedBox3d& box, double column,
  double endDistance, const std::vector<EndingRule>& rules);

constexpr double LoopTolerance = 0.25; // columns, of tip loops

/// Drops corners of a tip loop that are near the line between those that stay.
std::vector<Eigen::Vector2d> Straighten(const std::vector<Eigen::Vector2d>& loop, double tolerance);

/// Lets faults die out at the ends of their sticks, and half of the distance of these beyond, unless walls or the faults that
/// they end at are nearer than `endDistance` columns.
void EndAtTips(const SealingInput& input, double endDistance, FaultNetwork& network);

/// Faults that hardly reach above one of these horizons end there. Returns how many do.
std::size_t EndAtHorizons(const std::vector<std::size_t>& unconformities, const SealingInput& input,
  const Eigen::AlignedBox3d& box, FaultNetwork& network);
}

#endif
