// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyFields_h
#define SeismicHorizonsSurveyFields_h

#include "Common/Survey/SurveyDescription.h"

class vtkFieldData;

namespace SeismicHorizons
{
/// Adds an array of one text for each part of a description that is not empty.
void AddSurveyFields(const SurveyDescription& survey, vtkFieldData* data);

/// The description that such arrays give; empty where there is none.
SurveyDescription ReadSurveyFields(vtkFieldData* data);
}

#endif
