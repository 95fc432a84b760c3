// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGivenLines_h
#define SeismicHorizonsGivenLines_h

#include "Common/Horizon/NamedHorizon.h"

#include <vector>

class vtkDataObject;

namespace SeismicHorizons
{
/// The datasets of a second input, with names "fault 1" and so on for blocks. Throws InputError on other datasets than
/// polygonal ones.
std::vector<NamedHorizon> ListGivenLines(vtkDataObject* lines);
}

#endif
