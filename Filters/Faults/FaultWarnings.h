// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Names given lines that have no effect on a horizon, with the likely cause.

#ifndef SeismicHorizonsFaultWarnings_h
#define SeismicHorizonsFaultWarnings_h

#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Filters/Algorithms/Faults/FaultSurfaces.h"
#include "Filters/Common/LatticePoints.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class FaultWarnings
{
public:
  explicit FaultWarnings(const LatticePoints& points);

  /// Sheets are on the lattice. Names faults of which sticks are in no sheet, and sheets without traces. `traces` are their
  /// numbers.
  void AddSticks(const std::vector<FaultStick>& sticks, const std::vector<FaultSheet>& sheets,
    const std::vector<std::size_t>& traces, bool areExtended);

  /// Names lines of which at least half is beside the horizon, on the map.
  void AddLines(const std::vector<FaultStick>& lines, const std::vector<FaultPolyline>& onMap);

  std::vector<std::string> Warnings;
  /// Why nothing is cut, where nothing is; empty if unknown.
  std::string Cause;

private:
  bool IsBeside(double x, double y) const;
  /// Of the length of a line, seen from above.
  double PartInside(const FaultPolyline& line) const;
  std::string CauseOf(const FaultSheet& sheet) const;

  const LatticePoints& Points;
  PlanePoint Least, Most; // columns
  double Lowest = 0.0, Highest = 0.0; // lattice units
};
}

#endif
