// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridPlacement_h
#define SeismicHorizonsGridPlacement_h

#include "HorizonGrid.h"
#include "SurveyHorizons.h"

namespace SeismicHorizons
{
/// The columns of a grid that have a z, as the one horizon of a survey.
SurveyHorizons PlaceGrid(HorizonGrid grid);
}

#endif
