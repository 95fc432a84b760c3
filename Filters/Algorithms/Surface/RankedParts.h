// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a horizon on several processes. Each has successive bands and their rows, an even number of bands, so that the
// strips between processes are among the last, and the mesh is the same as on one process.
//
//     process 0   bands 0 1 2 3   strips 0 2   then 1 3     The strip between 3 and 4 needs band 4, which process 1
//     process 1   bands 4 5 6 7   strips 4 6   then 5 7     sends after its even strips.

#ifndef SeismicHorizonsRankedParts_h
#define SeismicHorizonsRankedParts_h

#include "BandMesher.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "PartRanks.h"
#include "PointRows.h"
#include "Surface.h"

#include <cstdint>
#include <unordered_set>

namespace SeismicHorizons
{
/// Meshes all bands and strips with other processes, which call HelpToMesh. Called on process 0, with the arguments of the
/// mesher.
void MeshOnRanks(BandMesher& mesher, const PointRows& rows, std::int32_t rowsOfBand, const SurfaceOptions& options,
  const SurfaceParameters& parameters, const Loops& boundary, const std::unordered_set<PointId>& shared,
  const PartRanks& ranks, const Monitor& monitor);

/// Waits for process 0. Returns once all bands are meshed, or after ReleaseHelpers.
void HelpToMesh(const PartRanks& ranks, const Monitor& monitor);

/// Called on process 0 after all work, also if it threw. Releases others if they were not called.
void ReleaseHelpers(const PartRanks& ranks);
}

#endif
