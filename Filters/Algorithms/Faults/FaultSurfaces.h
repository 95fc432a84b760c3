// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of faults from fault sticks: lines that an interpreter picks down a fault, section by section. In files they
// stand in any order, begin and end at different depths, and their points are anywhere along them. A sheet has the
// sticks of one fault in the order in which they stand along it, each with places at the same levels, so that sticks
// beside each other can be joined level by level.

#ifndef SeismicHorizonsFaultSurfaces_h
#define SeismicHorizonsFaultSurfaces_h

#include "ColumnHeights.h"
#include "Common/Types.h"
#include "FaultLines.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class FaultSheet
{
public:
  FaultSheet(std::string fault, std::size_t sticks, std::size_t levels)
    : Fault(std::move(fault))
    , Sticks(sticks)
    , Levels(levels)
    , Places(sticks * levels)
    , Known(sticks * levels, false)
  {
  }

  const std::string& Name() const { return this->Fault; }
  std::size_t NumberOfSticks() const { return this->Sticks; }
  std::size_t NumberOfLevels() const { return this->Levels; }
  /// The number of a place.
  std::size_t At(std::size_t stick, std::size_t level) const { return stick * this->Levels + level; }
  bool IsKnown(std::size_t place) const { return this->Known[place]; }
  SpacePoint& operator[](std::size_t place) { return this->Places[place]; }
  const SpacePoint& operator[](std::size_t place) const { return this->Places[place]; }
  void Set(std::size_t place, const SpacePoint& value)
  {
    this->Places[place] = value;
    this->Known[place] = true;
  }

  /// Between sticks that follow each other and levels that do.
  std::vector<std::array<std::size_t, 3>> ListTriangles() const;

private:
  std::string Fault;
  std::size_t Sticks;
  std::size_t Levels;
  std::vector<SpacePoint> Places;
  std::vector<bool> Known;
};

/// A sheet for each fault that has at least two sticks, in the order of the first of these. Sticks are sorted along the
/// fault by the shortest way from stick to stick, which is theirs if no shorter one is found. Where they have no name,
/// it ends wherever two are much farther apart than most. Levels are along the mean direction of the sticks: those of
/// all their points, to a hundredth of the sheet. A single stick that ends short between two longer ones is continued
/// as these are. `extend` continues the sheet at either end by as much as is between the last two sticks. Throws
/// InputError on a place that is not finite.
std::vector<FaultSheet> MakeFaultSheets(const std::vector<FaultStick>& sticks, bool extend);

/// The lines along which sheets, in columns and vertical indices, pass through the horizon, by places half a column
/// apart; a line ends half a column beyond the end of the sheet or of the horizon. Over gaps in the horizon heights
/// continue evenly down the fault.
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultSheet>& sheets);
}

#endif
