// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays that follow from the places of points, for filters and views that need them as arrays: heights along the
// vertical axis, named as it, and where they are known the numbers of lines, Inline and Crossline.

#ifndef SeismicHorizonsDerivedArrays_h
#define SeismicHorizonsDerivedArrays_h

#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/VerticalAxis.h"

namespace SeismicHorizons
{
VerticalAxis ReadVerticalAxis(const ArrayTable& fieldData);

/// Returns those of whose name the horizon has no array. Heights are first, with the role of VerticalIndex.
ArrayTable MakeDerivedArrays(const Horizon& horizon);

/// Stages move points, so that the arrays are made anew.
void RemoveDerivedArrays(Horizon& horizon);
}

#endif
