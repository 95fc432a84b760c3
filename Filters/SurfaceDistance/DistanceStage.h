// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDistanceStage_h
#define SeismicHorizonsDistanceStage_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "DistanceTables.h"

#include <string>

namespace SeismicHorizons
{
struct DistanceStageOptions
{
  bool InWorldUnits = false; // the unit of distances of points
  double SamplesPerPoint = 2.0; // 0.01 to 1000
  int Seed = 1; // at least 0
  int Radius = 1; // columns, 1 to 32; of the boundary of a reference whose mesh has none
  bool IncludeFilledPoints = false; // in figures
};

struct MeasuredPair
{
  Horizon Reference; // a mesh
  Horizon Mesh;
  DistanceTables Rows;
};

/// A reference without triangles is meshed inside its loops, or inside a boundary with the parameters of the other mesh,
/// or with the radius and closed holes. Throws InputError if that fails, units differ, or a mesh cannot be measured.
MeasuredPair RunSurfaceDistance(const Horizon& reference, const Horizon& mesh, const std::string& name,
  const DistanceStageOptions& options, const Monitor& monitor);
}

#endif
