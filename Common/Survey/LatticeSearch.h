// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the lattice that points of the plane stand on, in any order and with holes, from their places alone.
//
// The steps to the nearest neighbour, and to the nearest one off that line, are found by vote in a small window. From
// there the lattice grows: the points up to some columns away are numbered by it, a map is fitted through them by least
// squares, and the distance doubles. So the error of the steps, which counts as often as there are columns, never gets
// near half a column. Time is linear in the points.

#ifndef SeismicHorizonsLatticeSearch_h
#define SeismicHorizonsLatticeSearch_h

#include "Common/Monitor.h"
#include "PlaneFit.h"

#include <vector>

namespace SeismicHorizons
{
/// The map from columns to places, fitted through all points. Column (0, 0) is one of those near the points; the step
/// along i is the one that is nearer to the direction of x, and that along j turns left of it. Throws InputError where
/// there are less than three points, where all are on one line, or where they stand on no lattice.
PlaneMap FindLattice(const std::vector<double>& x, const std::vector<double>& y, const Monitor& monitor = Monitor());
}

#endif
