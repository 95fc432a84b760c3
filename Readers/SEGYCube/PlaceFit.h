// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lattice of places whose line numbers are known, a few of which may be wrong.

#ifndef SeismicHorizonsPlaceFit_h
#define SeismicHorizonsPlaceFit_h

#include "Common/Monitor.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/PlaneFit.h"
#include "Common/Survey/SurveyLattice.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace SeismicHorizons
{
struct PlaceFit
{
  PlaneMap ToWorld; // from columns
  double LargestDistance = 0.0; // of a place to its column, in columns, but for strays
  std::int64_t Strays = 0; // places farther off
  std::size_t FirstStray = 0;
};

/// The lattice of places, by least squares without up to a tenth of strays. Only line numbers and places are looked at.
/// Throws InputError, whose text begins with `what`, where they are on none.
PlaceFit FitLattice(const PickTable& picks, const LineNumbering& numbering, const std::string& what, double tolerance,
  const Monitor& monitor);

/// How far a place is from its column at most, in columns.
double LargestDistance(const PickTable& picks, const LineNumbering& numbering, const PlaneMap& map);

/// Whether x and y go by the steps of the line numbers, in either order, or by a part of them, `scale`: they may be
/// numbers of lines as well.
bool FollowsLines(const PlaneMap& map, const LineNumbering& numbering, double scale);
}

#endif
