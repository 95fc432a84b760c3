// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How flat the points of a cell are (Flatness.h). Each weighs as much as it stands for.

#ifndef SeismicHorizonsCellFlatness_h
#define SeismicHorizonsCellFlatness_h

#include "CellLeaves.h"
#include "Common/Types.h"

namespace SeismicHorizons
{
/// The flatness (thesis eq. 4.5) of some points, at least one: from 0, which is a plane, to 1/3. Wrong by 1e-6 at most.
double FlatnessOf(const CellLeaves& leaves, const PointId* first, const PointId* last);

/// Whether it is at most `threshold`, up to rounding.
bool AreFlat(const CellLeaves& leaves, const PointId* first, const PointId* last, double threshold);
}

#endif
