// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The contours that are drawn on horizons (see vtkHorizonRepresentation), from the side of the window.

#ifndef ContourInterval_h
#define ContourInterval_h

class vtkPVDataInformation;
class vtkSMProxy;

namespace SeismicHorizons
{
/// Returns the interval of another horizon with the same axis, if it suits this one, or a round one that gives about
/// twelve contours on one horizon; 0 if the data are no horizons.
double SuggestContourInterval(vtkSMProxy* representation, vtkPVDataInformation* data);

/// Legends say at which interval contours are drawn, and of how many columns one is shown.
void DescribeContours(vtkSMProxy* view);
}

#endif
