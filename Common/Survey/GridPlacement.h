// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridPlacement_h
#define SeismicHorizonsGridPlacement_h

#include "HorizonGrid.h"
#include "NullValues.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// Nodes without z, or with one of `nulls`, are dropped.
SurveyHorizons PlaceGrid(HorizonGrid grid, const NullValues& nulls = NullValues());
}

#endif
