// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What surfaces of points in memory and by rows have in common.

#ifndef SeismicHorizonsSurfaceFigures_h
#define SeismicHorizonsSurfaceFigures_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/Lattice.h"
#include "Filters/Algorithms/Surface/Surface.h"
#include "Filters/Common/HeightUnit.h"
#include "SurfaceStage.h"

namespace SeismicHorizons
{
inline bool HasErrorTarget(const SurfaceStageOptions& options)
{
  return !options.MaximumNumberOfTriangles;
}

/// Without cuts. Throws InputError.
SurfaceOptions MakeSurfaceOptions(const SurfaceStageOptions& given, const ErrorLimit& limit);

void WriteDeviations(const Surface& surface, ArrayTable& figures);

void CloseIfWanted(const SurfaceStageOptions& given, const Lattice& lattice, const Reduction& vertices,
  const Monitor& monitor, Horizon& mesh);

void WriteParameters(const SurfaceParameters& chosen, const ErrorLimit& limit, ArrayTable& figures);
}

#endif
