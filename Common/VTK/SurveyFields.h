// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyFields_h
#define SeismicHorizonsSurveyFields_h

#include "Common/Survey/SurveyDescription.h"

class vtkFieldData;

namespace SeismicHorizons
{
/// Adds a text array for each member that is not empty.
void AddSurveyFields(const SurveyDescription& survey, vtkFieldData* data);

SurveyDescription ReadSurveyFields(vtkFieldData* data);
}

#endif
