// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef ShownAxis_h
#define ShownAxis_h

#include "Common/Horizon/VerticalAxis.h"

#include <string>

class vtkFieldData;
class vtkPVDataInformation;

namespace SeismicHorizons
{
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
