// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a view shows.

#ifndef ViewContents_h
#define ViewContents_h

#include <string>
#include <vector>

class vtkPVDataInformation;
class vtkSMProxy;

namespace SeismicHorizons
{
std::vector<vtkSMProxy*> ListRepresentations(vtkSMProxy* view);

/// What a representation shows; null where it is hidden, or shows no data.
vtkPVDataInformation* FindShownData(vtkSMProxy* representation);

/// The values of a field data array with one tuple; none where it is not there. Those that differ between blocks are
/// not numbers.
std::vector<double> ReadField(vtkPVDataInformation* data, const char* name, int count);

/// A title of an axis with so much space around it that the numbers of the axis stay apart from it.
std::string AxisTitle(const std::string& name);

/// The axes of a view; null where it has none.
vtkSMProxy* FindAxes(vtkSMProxy* view);
}

#endif
