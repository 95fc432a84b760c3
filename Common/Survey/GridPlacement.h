// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridPlacement_h
#define SeismicHorizonsGridPlacement_h

#include "HorizonGrid.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// Nodes without z are dropped.
SurveyHorizons PlaceGrid(HorizonGrid grid);
}

#endif
