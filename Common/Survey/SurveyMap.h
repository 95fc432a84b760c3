// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyMap_h
#define SeismicHorizonsSurveyMap_h

#include "Common/Monitor.h"
#include "PickTable.h"
#include "PlacementOptions.h"
#include "PlaneFit.h"
#include "SurveyLattice.h"

#include <optional>

namespace SeismicHorizons
{
/// The columns of a survey, before it is known how many there are.
struct SurveyMap
{
  PlaneMap ToWorld; // from the index of a column to its place
  std::optional<LineNumbering> Lines; // of the same columns
};

/// The map through picks with line numbers and places, of which there is at least one. Only these are looked at. Where
/// all are on one line the step across is as long as that along it. Throws InputError where they do not even make that.
PlaneMap FitPlaces(const PickTable& picks, const LineNumbering& lines, const Monitor& monitor);

/// Columns stand where the numbers of their lines are.
PlaneMap LinesAsPlaces(const LineNumbering& lines);

/// Throws InputError where there is no lattice.
SurveyMap FindSurveyMap(const PickTable& picks, const PlacementOptions& options, const Monitor& monitor);
}

#endif
