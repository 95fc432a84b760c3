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

/// Throws InputError where there is no lattice.
SurveyMap FindSurveyMap(const PickTable& picks, const PlacementOptions& options, const Monitor& monitor);
}

#endif
