// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyMap_h
#define SeismicHorizonsSurveyMap_h

#include "Common/Monitor.h"
#include "PickTable.h"
#include "PlacementOptions.h"
#include "PlaneFit.h"
#include "SurveyLattice.h"

namespace SeismicHorizons
{
/// The map through picks with line numbers and places, of which there is at least one. Only these are looked at. Where
/// all are on one line the step across is as long as that along it. Throws InputError where they do not even make that.
PlaneMap FitPlaces(const PickTable& picks, const LineNumbering& lines, const Monitor& monitor);

/// Columns stand where the numbers of their lines are.
PlaneMap LinesAsPlaces(const LineNumbering& lines);

/// The lattice of picks, before it is known how many columns it has. Throws InputError where there is no lattice.
SurveyLattice FindSurveyMap(const PickTable& picks, const PlacementOptions& options, const Monitor& monitor);
}

#endif
