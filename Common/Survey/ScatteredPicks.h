// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks that stay at their places, as few do not define a lattice.

#ifndef SeismicHorizonsScatteredPicks_h
#define SeismicHorizonsScatteredPicks_h

#include "PickTable.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// The horizons are on no lattice: columns are finer than coordinates are. Throws InputError without x and y.
SurveyHorizons KeepPlaces(PickTable picks);
}

#endif
