// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCrackData_h
#define SeismicHorizonsCrackData_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Cracks.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// Writes CrackOpenEnds and CrackLoops, or removes both from a horizon without faulted links.
void WriteCracks(const Cracks& cracks, Horizon& horizon);

/// Skips open ends without a loop point. Throws InputError on a malformed array.
std::vector<PointId> ReadPointsOfOpenEnds(const Horizon& horizon, PlanePoints columns, const Loops& boundary);

/// Adds triangles, marked in the new array Fault, to a complete mesh; `plane` has the columns of its points. Throws
/// InputError on malformed arrays, and if loops are missing.
void CloseMesh(const std::vector<PlanePoint>& plane, const Lattice& lattice, const Loops& boundary, Horizon& mesh,
  const Monitor& monitor);
}

#endif
