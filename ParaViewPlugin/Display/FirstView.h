// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a view looks at the first data that come into it.

#ifndef FirstView_h
#define FirstView_h

class vtkSMProxy;

namespace SeismicHorizons
{
/// Looks obliquely at what has come into an empty view, and exaggerates its heights where it is flat; at a line of a
/// survey from its side. Nothing is done where something else is shown, or where what has come is not of a survey. The
/// camera gets its direction alone, and has to be moved to where the data are; false where nothing was done.
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation);

/// Hides in a view what led to a stage whose hints ask for that.
void HideInputs(vtkSMProxy* view, vtkSMProxy* representation);

/// Takes the exaggeration back once nothing is left in a view.
void ForgetEmptyView(vtkSMProxy* view);
}

#endif
