// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef VerticalAxis_h
#define VerticalAxis_h

#include <string>

class vtkFieldData;
class vtkPVDataInformation;

namespace SeismicHorizons
{
/// Name is such as "Depth (m)", "Time (ms)" or "Elevation (m)", "Depth" or "Height" without a unit, and empty if the
/// direction of z is unknown.
struct VerticalAxis
{
  std::string Name;
  std::string Unit;
  bool IsDownwards = true; ///< The axis counts -z.
};

VerticalAxis ReadVerticalAxis(vtkFieldData* data);

/// The name is also empty if blocks differ.
VerticalAxis ReadVerticalAxis(vtkPVDataInformation* data);
}

#endif
