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
#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct FaultSheet
{
  std::string Fault;
  std::size_t Sticks = 0;
  std::size_t Levels = 0;
  /// Places are stick by stick, without value where a stick does not reach a level.
  std::vector<std::optional<SpacePoint>> Places = std::vector<std::optional<SpacePoint>>(Sticks * Levels);

  std::size_t At(std::size_t stick, std::size_t level) const { return stick * this->Levels + level; }

  std::vector<std::array<std::size_t, 3>> ListTriangles() const;
};

/// Sheets need two sticks. The given order stays if no shorter one is found; unnamed sticks are split at large
/// distances. `extend` continues both ends by one interval. Throws InputError for places that are not finite.
std::vector<FaultSheet> MakeFaultSheets(const std::vector<FaultStick>& sticks, bool extend);

/// The name of a sheet, or "sticks 1" and so on.
std::string NameOf(const std::vector<FaultSheet>& sheets, std::size_t n);

/// Traces have places half a column apart and end half a column beyond the sheet or the horizon. Over missing columns
/// heights are interpolated down the fault.
std::vector<FaultPolyline> FindTraces(const ColumnHeights& heights, const std::vector<FaultSheet>& sheets);
}

#endif
