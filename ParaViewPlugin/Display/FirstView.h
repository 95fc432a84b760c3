// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FirstView_h
#define FirstView_h

class vtkSMProxy;

namespace SeismicHorizons
{
/// Ignores other outputs of the same source, and maps or points that it was made from.
bool ShowsOthers(vtkSMProxy* view, vtkSMProxy* representation);

/// Sets the direction of the camera, which has to be moved to the data, and exaggerates flat heights. Returns false
/// unless the data have a survey.
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation);

void RememberCamera(vtkSMProxy* view);

/// Returns true if the data are of a survey and not derived, and the camera is as RememberCamera left it.
bool MayFollow(vtkSMProxy* view, vtkSMProxy* representation);

/// Hides inputs or other outputs of a stage if its hints say so.
void HideOthers(vtkSMProxy* view, vtkSMProxy* representation);

void ForgetEmptyView(vtkSMProxy* view);
}

#endif
