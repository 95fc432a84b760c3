// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits a lattice to places with line numbers; a few may be wrong.

#ifndef SeismicHorizonsPlaceFit_h
#define SeismicHorizonsPlaceFit_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/PlaneFit.h"
#include "Common/Survey/SurveyLattice.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace SeismicHorizons
{
constexpr double MostStrays = 0.1; // fraction of all places

struct PlaceFit
{
  PlaneMap ToWorld; // Maps columns to world coordinates.
  double LargestDistance = 0.0; // In columns, without strays.
  std::int64_t Strays = 0;
  std::size_t FirstStray = 0;
};

/// Up to 10 % of strays are excluded. Picks need only line numbers and places. Throws InputError, which begins with
/// `what`, if the places are on no lattice.
PlaceFit FitLattice(const PickPlaces& picks, const LineNumbering& numbering, const std::string& what, double tolerance,
  const Monitor& monitor);

double LargestDistance(const PickPlaces& picks, const LineNumbering& numbering, const PlaneMap& map);

/// x and y may repeat the line numbers, in either order, multiplied by `scale`.
bool FollowsLines(const PlaneMap& map, const LineNumbering& numbering, double scale);
}

#endif
