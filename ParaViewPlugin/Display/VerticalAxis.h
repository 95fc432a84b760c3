// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What z of horizons is called in legends and at axes.

#ifndef VerticalAxis_h
#define VerticalAxis_h

#include <string>

class vtkFieldData;
class vtkPVDataInformation;

namespace SeismicHorizons
{
/// The vertical axis as a reader of maps knows it: "Depth (m)", "Time (ms)" or "Elevation (m)", larger downwards or
/// upwards; "Depth" or "Height" without a unit.
struct VerticalAxis
{
  std::string Name; ///< empty where nothing tells which way is down
  std::string Unit; ///< empty where it is not known
  bool IsDownwards = true; ///< counts -z
};

VerticalAxis ReadVerticalAxis(vtkFieldData* data);

/// The same from what a client knows of data; an empty name also where blocks differ.
VerticalAxis ReadVerticalAxis(vtkPVDataInformation* data);
}

#endif
