// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the hints FirstSight of a filter colour by (vtkSMHorizonDisplayHelper tells more), and from where to where.

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
  int Association = 0;
  std::array<double, 2> Ends = { 0.0, 0.0 };
  bool IsOfData = true; ///< from the least value to the largest
  bool IsCut = false; ///< some values are above
  bool IsDownwards = false; ///< the least value is on top
};

/// The hints of a producer for one of its ports, and the data that are there.
std::vector<vtkPVXMLElement*> ListHints(vtkSMSourceProxy* producer, int port);

/// Finds the range of what a hint colours by; false where it is not in the data, or has one value.
bool FindRange(vtkPVXMLElement* hint, vtkSMSourceProxy* producer, int port, ColorRange& range);

/// Gives colours a range that is not that of the data. ParaView leaves it alone then.
void SetRange(vtkSMProxy* table, const std::array<double, 2>& ends);

/// Widens a range that SetRange has set, and nobody else since.
void ExtendRange(vtkSMProxy* table, const ColorRange& range);

/// Gives the colours of a view ranges as the hints have them, where data have changed.
void RefreshRanges(vtkSMProxy* view);
}

#endif
