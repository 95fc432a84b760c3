// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights of a view drawn larger than they are. All that is shown in a view has one factor, so that data sets lie on
// each other as they should, whatever filter or plugin they come from. It is the scale of the view's axes,
// which go on to tell true heights, and so part of state files and of undo.

#ifndef VerticalExaggeration_h
#define VerticalExaggeration_h

class vtkSMProxy;

namespace SeismicHorizons
{
/// The factor of a view: 1 as long as nobody has set another one.
double GetVerticalExaggeration(vtkSMProxy* view);

/// Gives a view a factor larger than 0, with all that is shown there, and its axes.
void SetVerticalExaggeration(vtkSMProxy* view, double factor);

/// Gives what has come into a view the factor of the view.
void ExaggerateRepresentation(vtkSMProxy* representation, vtkSMProxy* view);

/// A round factor by which what a view shows is about as high as a quarter of its width: 1 where it is not flatter than
/// 1 in 10, or shows nothing.
double SuggestVerticalExaggeration(vtkSMProxy* view);
}

#endif
