// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All data in a view share one exaggeration, so that they fit each other whatever their source. It is the scale of the
// view's axes, which show true heights, and so belongs to state files and undo.

#ifndef VerticalExaggeration_h
#define VerticalExaggeration_h

class vtkSMProxy;

namespace SeismicHorizons
{
double GetVerticalExaggeration(vtkSMProxy* view);

/// The factor must be positive.
void SetVerticalExaggeration(vtkSMProxy* view, double factor);

void ExaggerateRepresentation(vtkSMProxy* representation, vtkSMProxy* view);

/// Returns a round factor that makes data about as high as a quarter of their width, or 1 unless they are flatter than
/// 1 in 10.
double SuggestVerticalExaggeration(vtkSMProxy* view);
}

#endif
