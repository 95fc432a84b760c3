// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsUprightGrid_h
#define SeismicHorizonsUprightGrid_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

namespace SeismicHorizons
{
/// The grid on a lattice along the axes with the same steps, which begins at the south-western corner of what the
/// lattice covers, so that all grids of one lattice come to the same nodes. Values are bilinear between the four
/// columns around a node; a node has none where one of those that count has none. Lines of the survey are lost. Linear
/// in the nodes. Throws InputError on a lattice that fills a tiny part of its extent only, and where no node gets a
/// value.
HorizonGrid MakeUpright(const HorizonGrid& grid, const Monitor& monitor = Monitor());
}

#endif
