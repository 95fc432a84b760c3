// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyFields_h
#define SeismicHorizonsSurveyFields_h

#include "Common/Horizon/DataArray.h"
#include "SurveyDescription.h"

namespace SeismicHorizons
{
/// Adds a text array for each member that is not empty.
void AddSurveyFields(const SurveyDescription& survey, ArrayTable& data);

SurveyDescription ReadSurveyFields(const ArrayTable& data);
}

#endif
