// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnNames_h
#define SeismicHorizonsColumnNames_h

#include "Common/Survey/SurveyDescription.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// In quotes, on one line.
std::string Quoted(std::string text);

/// The names of the columns of x, y and z, with their units and, for z, its direction.
std::vector<std::string> PlaceNames(const SurveyDescription& survey);
}

#endif
