// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ViewContents_h
#define ViewContents_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkPVDataInformation;
class vtkSMProxy;
class vtkSMSourceProxy;

namespace SeismicHorizons
{
std::vector<vtkSMProxy*> ListRepresentations(vtkSMProxy* view);

/// Returns null if it is hidden or shows no data.
vtkPVDataInformation* FindShownData(vtkSMProxy* representation);

/// Returns the values of an array with one tuple, or none; values that differ between blocks are nan.
std::vector<double> ReadField(vtkPVDataInformation* data, const char* name, int count);

vtkSMSourceProxy* FindProducer(vtkSMProxy* representation);

/// True if `other` is made from `source`, directly or not.
bool LeadsTo(vtkSMProxy* source, vtkSMProxy* other);

/// Hides what the representation replaces: other results of the same horizon, and inputs or other outputs of a stage if
/// its hints say so. Returns what was hidden.
std::vector<vtkSmartPointer<vtkSMProxy>> HideOthers(vtkSMProxy* view, vtkSMProxy* representation);
}

#endif
