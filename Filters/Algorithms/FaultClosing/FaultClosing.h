// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates cracks between their cutoffs, so that the mesh of a faulted horizon is closed there.

#ifndef SeismicHorizonsFaultClosing_h
#define SeismicHorizonsFaultClosing_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "Common/Horizon/Cracks.h"
#include "Common/Horizon/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Returns constrained Delaunay triangles, counter-clockwise from +z. Simplified loops must keep their order and points
/// of open ends. Throws InputError if open ends or loops do not fit, or cracks are not closed.
RawVector<PointId> CloseFaults(const std::vector<PlanePoint>& plane, const Loops& boundary, const Cracks& cracks,
  const Monitor& monitor = Monitor());
}

#endif
