// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the faults of a generated horizon was found.

#ifndef SeismicHorizonsFaultScore_h
#define SeismicHorizonsFaultScore_h

#include "Filters/Algorithms/Faults/FaultLines.h"
#include "Generator/FaultGenerator.h"

#include <array>
#include <cstdint>

namespace SeismicHorizons
{
struct FaultScore
{
  /// Throws from 1, 2, 4 and 8 vertical indices on.
  static constexpr std::array<double, 4> ClassBegins = { 1.0, 2.0, 4.0, 8.0 };

  std::array<std::int64_t, 4> Torn = {}; // links of each class
  std::array<std::int64_t, 4> Found = {}; // of these, or one within reach
  std::int64_t False = 0; // links more than a column off all that are torn, beyond the gap
  std::int64_t Columns = 0;

  void Add(const FaultScore& other);

  double FoundPercent(std::size_t throwClass) const;
  double FalsePerThousand() const { return 1000.0 * double(this->False) / double(this->Columns); }
};

/// `reach` is how far from a torn link in a gap one that was found may be, in columns; `reachOfAll` how far from any.
FaultScore ScoreFaults(const FaultedHorizon& horizon, const FaultLines& found, int reach, int reachOfAll = 0);
}

#endif
