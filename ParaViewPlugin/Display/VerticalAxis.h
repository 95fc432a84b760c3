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
  bool IsTime = false;
  double Step = 0.0; ///< Of one vertical index; 0 if it is unknown.
};

/// How an array is called on the screen: thickness and throw have the unit of z in their names.
struct ShownArray
{
  std::string Name;
  double Factor = 1.0; ///< From the array's figures.
};

/// Returns the array's own name unless it is a thickness or throw, and the unit known.
ShownArray ShowInUnit(const std::string& array, const VerticalAxis& axis);

VerticalAxis ReadVerticalAxis(vtkFieldData* data);

/// The name is also empty if blocks differ.
VerticalAxis ReadVerticalAxis(vtkPVDataInformation* data);
}

#endif
