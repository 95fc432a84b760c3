// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickPlacement_h
#define SeismicHorizonsPickPlacement_h

#include "Common/Base/Monitor.h"
#include "PickTable.h"
#include "PlacementOptions.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// Frees the picks as it proceeds. Picks without z help to find the lattice, and are dropped. Throws InputError if
/// there is no lattice, or picks are off it.
SurveyHorizons PlacePicks(PickTable picks, const PlacementOptions& options, const Monitor& monitor = Monitor());
}

#endif
