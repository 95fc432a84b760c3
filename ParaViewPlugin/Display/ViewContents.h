// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ViewContents_h
#define ViewContents_h

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

/// True if two stages have made points or triangles of one horizon, which would cover each other. Horizons of one file
/// differ in their bounds.
bool AreSiblings(vtkSMProxy* representation, vtkSMProxy* other);
}

#endif
