// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsUprightGrid_h
#define SeismicHorizonsUprightGrid_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"

namespace SeismicHorizons
{
/// Resamples bilinearly from the south-western corner of the lattice, so that all its grids share nodes. Line numbers
/// are lost. Throws InputError for a lattice that is nearly empty, and for a result without values.
HorizonGrid MakeUpright(const HorizonGrid& grid, const Monitor& monitor = Monitor());
}

#endif
