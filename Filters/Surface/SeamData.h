// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSeamData_h
#define SeismicHorizonsSeamData_h

#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Algorithms/Surface/SurfaceJoin.h"

#include <vector>

namespace SeismicHorizons
{
/// Adds SeamRows and SeamGap, moves points to the lines of seams, and excludes points on the lower seam, which belong
/// to the part below, from counts. The surface has kept all `points` of the part.
void WriteSeams(const Horizon& points, const Lattice& lattice, const Surface& surface, const SeamRows& seams,
  const std::vector<PointId>& onLowerSeam, Horizon& mesh);

/// Throws InputError on a mesh without SeamRows.
SurfacePart ReadSurfacePart(const Horizon& mesh);

void WriteJoinedSurface(
  const std::vector<Horizon>& meshes, const Lattice& lattice, const JoinedSurface& joined, Horizon& output);
}

#endif
