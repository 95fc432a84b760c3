// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsImageGrid_h
#define SeismicHorizonsImageGrid_h

#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/NullValues.h"

#include <string>

class vtkImageData;

namespace SeismicHorizons
{
/// An empty `zArray` means the active scalars, or else the first array of one component, points before cells. Throws
/// InputError without an array, or unless the image is one level layer.
HorizonGrid MakeHorizonGrid(vtkImageData* image, const std::string& zArray, const NullValues& nulls);
}

#endif
