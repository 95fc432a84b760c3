// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brings picks onto the columns of the lattice of their survey.

#ifndef SeismicHorizonsPickPlacement_h
#define SeismicHorizonsPickPlacement_h

#include "Common/Monitor.h"
#include "PickTable.h"
#include "PlacementOptions.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// One horizon for each name, in their order; with DuplicatePolicy::Sheets one for each sheet, those of a name one
/// after the other. Takes the picks, whose memory is freed on the way. The lattice is found through all of them, also
/// those without z, which are left out after that. Throws InputError where there is no lattice, and where picks are off
/// it.
SurveyHorizons PlacePicks(PickTable picks, const PlacementOptions& options, const Monitor& monitor = Monitor());
}

#endif
