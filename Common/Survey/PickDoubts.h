// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What can be read, but is hardly meant.

#ifndef SeismicHorizonsPickDoubts_h
#define SeismicHorizonsPickDoubts_h

#include "SurveyHorizons.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Warnings: picks that were left out, by their numbers; more than a hundredth of picks in columns that have another one, as where several horizons have no names;
/// and a usual number for no value, such as -999, as z far from all others of its horizon.
std::vector<std::string> FindDoubts(const SurveyHorizons& horizons);
}

#endif
