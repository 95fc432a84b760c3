// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Axes of a view run along the lines of the survey and count inlines and crosslines or, without numbers, columns and
// rows.

#ifndef SurveyAxes_h
#define SurveyAxes_h

#include <string>

class vtkSMProxy;

namespace SeismicHorizons
{
bool HasSurveyAxes(vtkSMProxy* view);

/// Uses the first visible data set with a lattice. Returns the reason for a failure, or an empty text.
std::string ShowSurveyAxes(vtkSMProxy* view);

void RefreshSurveyAxes(vtkSMProxy* view);

/// Restores axes of x and y, hidden.
void HideSurveyAxes(vtkSMProxy* view);
}

#endif
