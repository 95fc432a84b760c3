// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef StageSelection_h
#define StageSelection_h

class pqServerManagerModel;
class vtkSMProxy;

namespace SeismicHorizons
{
/// Selects the output of a stage that is shown where the stage was selected, or an output that is not shown.
void SelectShown(vtkSMProxy* view, vtkSMProxy* representation);

/// Keeps sources selected that move in the pipeline browser, as they get a second input or lose it.
void KeepSelection(pqServerManagerModel* model);
}

#endif
