// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fault surfaces from fault sticks: lines that an interpreter picks down a fault, section by section. In files they
// have any order, different depths, and points anywhere. A sheet has the sticks of one fault in order along it, with
// places at common levels, so that neighbouring sticks can be joined level by level.

#ifndef SeismicHorizonsFaultSurfaces_h
#define SeismicHorizonsFaultSurfaces_h

#include "ColumnHeights.h"
#include "Common/Horizon/Types.h"
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
  std::size_t At(std::size_t stick, std::size_t level) const { return stick * this->Levels + level; }
  bool IsKnown(std::size_t place) const { return this->Known[place]; }
  SpacePoint& operator[](std::size_t place) { return this->Places[place]; }
  const SpacePoint& operator[](std::size_t place) const { return this->Places[place]; }
  void Set(std::size_t place, const SpacePoint& value)
  {
    this->Places[place] = value;
    this->Known[place] = true;
  }

  std::vector<std::array<std::size_t, 3>> ListTriangles() const;

private:
  std::string Fault;
  std::size_t Sticks;
  std::size_t Levels;
  std::vector<SpacePoint> Places;
  std::vector<bool> Known;
};

/// Sheets need two sticks. The given order stays if no shorter one is found; unnamed sticks are split at large
/// distances. `extend` continues both ends by one interval. Throws InputError for places that are not finite.
std::vector<FaultSheet> MakeFaultSheets(const std::vector<FaultStick>& sticks, bool extend);

/// Traces have places half a column apart and end half a column beyond the sheet or the horizon. Over missing columns
/// heights are interpolated down the fault.
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultSheet>& sheets);
}

#endif
