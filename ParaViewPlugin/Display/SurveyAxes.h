// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The axes of a view count the lines of the survey in place of x and y: inlines and crosslines where their numbers are
// known, columns and rows of the lattice otherwise. Only lines along x and y can be counted so.

#ifndef SurveyAxes_h
#define SurveyAxes_h

#include <string>

class vtkSMProxy;

namespace SeismicHorizons
{
/// Whether the axes of a view count lines.
bool HasSurveyAxes(vtkSMProxy* view);

/// Lets the axes of a view count the lines of the first data set shown that has a lattice. Where that can not be the
/// text says why, and is empty otherwise.
std::string ShowSurveyAxes(vtkSMProxy* view);

/// Gives a view its axes of x and y back, hidden.
void HideSurveyAxes(vtkSMProxy* view);
}

#endif
