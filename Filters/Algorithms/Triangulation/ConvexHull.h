// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The convex hull, which is an outline for points that have none (Andrew, "Another efficient algorithm for convex hulls
// in two dimensions", 1979).

#ifndef SeismicHorizonsConvexHull_h
#define SeismicHorizonsConvexHull_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The convex hull of the places as one loop, clockwise from the place of least x, then least y, with all places that
/// lie on its edges. Places on one line give a loop there and back. There must be at least one place, and no two the
/// same.
Loops FindConvexHull(const std::vector<PlanePoint>& places);
}

#endif
