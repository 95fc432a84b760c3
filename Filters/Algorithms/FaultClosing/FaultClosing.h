// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles between the cutoffs of cracks, so that the mesh of a faulted horizon is closed there.

#ifndef SeismicHorizonsFaultClosing_h
#define SeismicHorizonsFaultClosing_h

#include "Common/Cracks.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"
#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// The constrained Delaunay triangles, in plan, that close cracks: three points each, counter-clockwise seen from +z on
/// the lattice. `plane` holds the places of the points of the loops, and of others. Where loops are simplified the
/// points of open ends stay, and loops keep their order. Throws InputError on open ends between points of no loop, on
/// numbers of loops that are not there, and where cracks are not closed. Takes time and memory for the points of
/// cracks, and looks at each point of the loops.
RawVector<PointId> CloseFaults(const std::vector<PlanePoint>& plane, const Loops& boundary, const Cracks& cracks,
  const Monitor& monitor = Monitor());
}

#endif
