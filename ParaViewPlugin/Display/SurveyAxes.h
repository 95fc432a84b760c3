// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The axes of a view run along the lines of the survey, however it is turned, and count them in place of x and y:
// inlines and crosslines where their numbers are known, columns and rows of the lattice otherwise.

#ifndef SurveyAxes_h
#define SurveyAxes_h

#include <string>

class vtkSMProxy;

namespace SeismicHorizons
{
/// Whether the axes of a view count lines.
bool HasSurveyAxes(vtkSMProxy* view);

/// Lets the axes of a view count the lines of the first data set shown that has a lattice. Where that cannot be the
/// text says why, and is empty otherwise.
std::string ShowSurveyAxes(vtkSMProxy* view);

/// Lets axes that count lines follow what is shown now, and its vertical exaggeration.
void RefreshSurveyAxes(vtkSMProxy* view);

/// Gives a view its axes of x and y back, hidden.
void HideSurveyAxes(vtkSMProxy* view);
}

#endif
