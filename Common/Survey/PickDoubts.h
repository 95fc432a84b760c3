// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What can be read, but is hardly meant.

#ifndef SeismicHorizonsPickDoubts_h
#define SeismicHorizonsPickDoubts_h

#include "SurveyHorizons.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A warning of a usual number for no value, such as -999, or one that several picks have, as z farther from all others
/// of some picks than these are from each other; one that is not usual is at least half as far from them as 0 is. `picks`
/// are numbers of picks that are not gridded yet.
std::string FindNull(const std::vector<double>& z, const std::vector<std::int32_t>& picks);

/// Warnings: those that the horizons have already, and of more than a hundredth of picks in columns that have another
/// one, as where several horizons have no names.
std::vector<std::string> FindDoubts(const SurveyHorizons& horizons);
}

#endif
