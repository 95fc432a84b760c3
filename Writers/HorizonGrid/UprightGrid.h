// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsUprightGrid_h
#define SeismicHorizonsUprightGrid_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

namespace SeismicHorizons
{
/// Resamples a grid onto the axes from the south-western corner of the lattice, so that all grids of a lattice share
/// nodes. Values are bilinear; a node is null if a column with a weight is. Line numbers are lost. Throws InputError
/// for a lattice that fills a tiny fraction of its extent, and for a result without values.
HorizonGrid MakeUpright(const HorizonGrid& grid, const Monitor& monitor = Monitor());
}

#endif
