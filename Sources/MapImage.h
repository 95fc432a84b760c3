// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsMapImage_h
#define SeismicHorizonsMapImage_h

#include "Common/Horizon/DataArray.h"
#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/LatticeImage.h"
#include "Common/Survey/NullValues.h"

#include <string>

namespace SeismicHorizons
{
/// With values at points or in cells.
struct MapImage : LatticeImage
{
  ArrayTable CellData;
};

/// An empty `zArray` means the active scalars, or else the first array of one component, points before cells. Throws
/// InputError without an array, or unless the image is one level layer.
HorizonGrid MakeHorizonGrid(const MapImage& image, const std::string& zArray, const NullValues& nulls);
}

#endif
