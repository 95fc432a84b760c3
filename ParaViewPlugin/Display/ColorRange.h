// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colour arrays and ranges of FirstSight hints (see vtkSMHorizonDisplayHelper).

#ifndef ColorRange_h
#define ColorRange_h

#include <array>
#include <string>
#include <vector>

class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMSourceProxy;

namespace SeismicHorizons
{
struct ColorRange
{
  std::string Array;
  std::string Unit; ///< Where the name of the array has none.
  int Association = 0;
  std::array<double, 2> Ends = { 0.0, 0.0 };
  bool IsOfData = true; ///< The range includes all values.
  bool IsCut = false; ///< Some values are above the range.
  bool IsDownwards = false; ///< The least value is on top.
};

/// Returns the hints of a producer for a port that fit its data.
std::vector<vtkPVXMLElement*> ListHints(vtkSMSourceProxy* producer, int port);

/// Returns false if the array is missing or constant.
bool FindRange(vtkPVXMLElement* hint, vtkSMSourceProxy* producer, int port, ColorRange& range);

/// ParaView does not rescale such a range.
void SetRange(vtkSMProxy* table, const std::array<double, 2>& ends);

/// Widens a range only if it is still SetRange's.
void ExtendRange(vtkSMProxy* table, const ColorRange& range);

void RefreshRanges(vtkSMProxy* view);
}

#endif
