// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What has to be true of the results of the stages. Each check ends the program when something is not.

#ifndef SeismicHorizonsStageProperties_h
#define SeismicHorizonsStageProperties_h

#include "Common/Base/Parallel.h"
#include "Common/Horizon/BoundedHorizon.h"
#include "Filters/Algorithms/Boundary/ExteriorBoundary.h"
#include "Filters/Algorithms/BoundarySimplification/BoundarySimplification.h"
#include "Filters/Algorithms/SurfaceDistance/SurfaceDistance.h"
#include "Filters/Algorithms/Triangulation/Triangulation.h"
#include "Require.h"
#include "Tools/Patches.h"

#include <string>

namespace Fuzz
{
void CheckBoundary(const Patches::Columns& columns, const SeismicHorizons::ExteriorBoundary& boundary,
  const SeismicHorizons::BoundaryOptions& options);

/// There is no surface where a horizon is cut.
void CheckCuts(const SeismicHorizons::BoundedHorizon& horizon, const std::string& name);

/// The triangulation of a horizon is right, and the same with either search and wherever the horizon lies.
SeismicHorizons::Triangulation CheckedMesh(const SeismicHorizons::BoundedHorizon& horizon, const std::string& name);

/// A mesh that need not be Delaunay.
void CheckAnyMesh(const SeismicHorizons::BoundedHorizon& horizon,
  const SeismicHorizons::RawVector<SeismicHorizons::PointId>& triangles);

void CheckSimplifiedBoundary(const SeismicHorizons::BoundedHorizon& horizon,
  const SeismicHorizons::BoundarySimplification& result, const SeismicHorizons::BoundarySimplificationOptions& options);

void CheckReduction(const SeismicHorizons::BoundedHorizon& horizon, const SeismicHorizons::Reduction& result);

void CheckDistance(const SeismicHorizons::SurfaceDistance& distance);

/// The same places, distances and figures to the bit.
bool IsSame(const SeismicHorizons::SurfaceDistance& a, const SeismicHorizons::SurfaceDistance& b);

/// What `work` gives on one thread. On three it must be the same, as isSame(a, b) tells.
template <typename Work, typename Same>
auto OnAnyThreads(Work&& work, Same&& isSame, const std::string& name)
{
  SeismicHorizons::Detail::NumberOfThreads() = 3;
  const auto onThree = work();
  SeismicHorizons::Detail::NumberOfThreads() = 1;
  auto onOne = work();
  Require(isSame(onOne, onThree), name + ": the number of threads matters");
  return onOne;
}
}

#endif
