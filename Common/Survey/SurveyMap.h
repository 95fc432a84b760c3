// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyMap_h
#define SeismicHorizonsSurveyMap_h

#include "Common/Base/Monitor.h"
#include "PickTable.h"
#include "PlacementOptions.h"
#include "PlaneFit.h"
#include "SurveyLattice.h"

namespace SeismicHorizons
{
/// Fits picks with line numbers and places. If all are on a line, the step across is as long as the step along it.
/// Throws InputError if that is impossible, too.
PlaneMap FitPlaces(const PickPlaces& picks, const LineNumbering& lines, const Monitor& monitor);

/// Line numbers serve as coordinates.
PlaneMap LinesAsPlaces(const LineNumbering& lines);

/// Gives the numbers of a matrix their places. Throws InputError without an origin and steps.
void PlaceRows(PickTable& picks, const PlacementOptions& options);

SurveyLattice FindSurveyMap(const PickPlaces& picks, const PlacementOptions& options, const Monitor& monitor);
}

#endif
