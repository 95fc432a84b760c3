// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGivenLines_h
#define SeismicHorizonsGivenLines_h

#include "Common/Horizon/NamedHorizon.h"
#include "Filters/Algorithms/Faults/FaultLines.h"

#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
/// The datasets of a second input, with names "fault 1" and so on for blocks. Throws InputError on other datasets than
/// polygonal ones.
std::vector<NamedHorizon> ListGivenLines(vtkDataObject* lines);

/// Sticks without a name in different datasets belong to different faults. Throws InputError as ListGivenLines.
std::vector<FaultStick> ReadGivenLines(vtkDataObject* lines);
}

#endif
