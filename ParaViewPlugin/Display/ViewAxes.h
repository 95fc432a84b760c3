// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All data in a view share one exaggeration, so that they fit each other whatever their source. It is the scale of the
// view's axes, which show true heights, and so belongs to state files and undo.
//
// Survey axes run along the lines of the survey and count inlines and crosslines or, without numbers, columns and rows.

#ifndef ViewAxes_h
#define ViewAxes_h

#include <string>

class vtkSMProxy;

namespace SeismicHorizons
{
double GetVerticalExaggeration(vtkSMProxy* view);

/// The factor must be positive.
void SetVerticalExaggeration(vtkSMProxy* view, double factor);

void ExaggerateRepresentation(vtkSMProxy* representation, vtkSMProxy* view);

/// Returns a round factor that makes data about as high as a quarter of their width, or 1 if they are neither flatter
/// than 1 in 10 nor higher than a half of their width.
double SuggestVerticalExaggeration(vtkSMProxy* view);

bool HasSurveyAxes(vtkSMProxy* view);

/// Uses the first visible data set with a lattice. Returns the reason for a failure, or an empty text.
std::string ShowSurveyAxes(vtkSMProxy* view);

void RefreshSurveyAxes(vtkSMProxy* view);

/// Restores axes of x and y, hidden.
void HideSurveyAxes(vtkSMProxy* view);

/// The vertical axis gets the name of the legend of heights, and counts as it does: time and depth downwards. Data with
/// different units leave it unnamed.
void NameVerticalAxis(vtkSMProxy* view);
}

#endif
