// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHeightArray_h
#define SeismicHorizonsHeightArray_h

#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/VerticalAxis.h"

namespace SeismicHorizons
{
VerticalAxis ReadVerticalAxis(const ArrayTable& fieldData);

/// Returns the heights of points along the axis, named as the axis, for filters and views that need them as an array.
DataArray MakeHeights(const Horizon& horizon, const VerticalAxis& axis);

/// Removes the array of MakeHeights: stages move points, so that it is made anew.
void RemoveHeights(Horizon& horizon);
}

#endif
