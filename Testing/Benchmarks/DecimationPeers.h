// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Methods of others that leave a number of vertices or triangles of a surface, timed.

#ifndef SeismicHorizonsDecimationPeers_h
#define SeismicHorizonsDecimationPeers_h

#include "DecimationErrors.h"

#include <cstddef>

namespace DecimationPeers
{
struct Result
{
  DecimationErrors::Mesh Mesh;
  double Seconds = 0.0;
};

Result RunGreedyTerrain(const DecimationErrors::Surface& surface, std::size_t triangles);
#ifdef SEISMICHORIZONS_HAS_MESHOPTIMIZER
Result RunMeshoptimizer(const DecimationErrors::Surface& surface, std::size_t triangles);
#endif
#ifdef SEISMICHORIZONS_HAS_CGAL
/// With a bounded normal change, no triangle near a collapsed edge turns by 90 degrees or more.
Result RunCgal(const DecimationErrors::Surface& surface, std::size_t vertices, bool isNormalChangeBounded);
#endif
}

#endif
