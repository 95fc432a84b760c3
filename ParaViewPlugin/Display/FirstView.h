// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a view looks at the first data that come into it.

#ifndef FirstView_h
#define FirstView_h

class vtkSMProxy;

namespace SeismicHorizons
{
/// Whether a view shows data besides those of one representation, other outputs of the same source, and a map or points
/// that these were made of.
bool ShowsOthers(vtkSMProxy* view, vtkSMProxy* representation);

/// Looks obliquely at what has come into an empty view, and exaggerates its heights where it is flat; at a line of a
/// survey from its side. The camera gets its direction alone, and has to be moved to where the data are. False where
/// nothing was done, as the data are not of a survey.
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation);

/// Remembers how a view looks at what it shows.
void RememberCamera(vtkSMProxy* view);

/// Whether what has come into a view is of a survey and not made of anything else, and the camera as RememberCamera
/// left it: it may follow then.
bool MayFollow(vtkSMProxy* view, vtkSMProxy* representation);

/// Hides in a view what led to a stage, or its other outputs, where its hints ask for that.
void HideOthers(vtkSMProxy* view, vtkSMProxy* representation);

/// Writes the unit of z at the vertical axis of a view, where all that is shown has the same.
void NameVerticalAxis(vtkSMProxy* view);

/// Takes the exaggeration back once nothing is left in a view.
void ForgetEmptyView(vtkSMProxy* view);
}

#endif
