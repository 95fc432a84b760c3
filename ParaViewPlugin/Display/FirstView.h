// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The camera looks at what comes first in the direction that suits it, and from then on belongs to the user.

#ifndef FirstView_h
#define FirstView_h

class vtkSMProxy;

namespace SeismicHorizons
{
/// Ignores other outputs of the same source, and maps or points that it was made from.
bool ShowsOthers(vtkSMProxy* view, vtkSMProxy* representation);

/// Whether what comes sets the camera.
bool IsFirst(vtkSMProxy* view, vtkSMProxy* representation);

/// Whether the data are of a survey and not derived, and nobody has moved the camera since it was set.
bool MayFollow(vtkSMProxy* view, vtkSMProxy* representation);

/// Sets the direction of the camera, which has to be moved to the data, and exaggerates flat heights. Returns false
/// unless the data have a survey.
bool SetFirstView(vtkSMProxy* view, vtkSMProxy* representation);

/// Says that nobody has moved the camera.
void MarkCamera(vtkSMProxy* view);
}

#endif
