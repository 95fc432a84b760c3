// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the lattice of points in the plane, in any order and with holes.
//
// In a small window the steps to the nearest neighbour, and to the nearest one off that line, are found by vote. Then a
// map is fitted by least squares to the points within some columns, and the distance doubles. So the accumulated error
// of the steps stays below half a column. Time is linear in the points.

#ifndef SeismicHorizonsLatticeSearch_h
#define SeismicHorizonsLatticeSearch_h

#include "Common/Base/Monitor.h"
#include "PlaneFit.h"

#include <vector>

namespace SeismicHorizons
{
/// The step along i is nearer to x, and the step along j turns left of it. Throws InputError for less than three
/// points, points on a line, and points off any lattice.
PlaneMap FindLattice(const std::vector<double>& x, const std::vector<double>& y, const Monitor& monitor = Monitor());
}

#endif
