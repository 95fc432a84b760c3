// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Documentation/DataModel.md describes the points.

#ifndef SeismicHorizonsHorizonDataSet_h
#define SeismicHorizonsHorizonDataSet_h

#include "Common/Horizon/Horizon.h"
#include "LatticeFrame.h"
#include "LatticeHorizon.h"
#include "SurveyFrame.h"
#include "SurveyHorizons.h"

#include <cstddef>

namespace SeismicHorizons
{
/// Adds the lattice, its map to the world, line numbers and units.
void AddFrameFields(ArrayTable& data, const LatticeFrame& frame);

Horizon MakeHorizonPoints(LatticeHorizon horizon, const LatticeFrame& frame);

/// Frees the horizon in the survey.
Horizon TakeHorizonPoints(SurveyHorizons& survey, const FramedSurvey& framed, std::size_t number);
}

#endif
