// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The input of the simplifications of the inside and of the triangulation.

#ifndef SeismicHorizonsBoundedHorizon_h
#define SeismicHorizonsBoundedHorizon_h

#include "LinkCuts.h"
#include "Types.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace SeismicHorizons
{
/// A horizon inside its boundary. The arrays have one entry per point.
struct BoundedHorizon
{
  std::vector<PlanePoint> Plane; // sub-voxels
  std::vector<double> Height; // lattice units
  std::vector<std::int32_t> Patch; // points of different patches are never merged
  std::vector<std::int64_t> Count; // how many points of the original horizon each one stands for; empty: one
  Loops Boundary;
  std::int32_t SubVoxelsPerColumn = 1;
  std::shared_ptr<const LinkCuts> Cuts; // points on two sides of these are never merged; null: there are none
};
}

#endif
