// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes a large horizon in parts, so that the points of a few rows are in memory at a time.
//
//     ---+-----------+---     Bands of rows are meshed first, with open edges along the cuts between them. Triangles near
//        |  band     |        a cut are then replaced by those of a strip, whose other edges stay. So each edge is inside
//     ...|...........|...     a part when it is made, and the error is bounded as in a mesh that is made at once. Where
//        |  strip    |  cut   an edge that stays forces slivers, or an edge beside it crosses links to points outside the
//     ...|...........|...     strip too far away, triangles around are made anew.
//        |  band     |
//     ---+-----------+---     Bands depend on the lattice alone, so the mesh does not depend on where the points are.
//
// Bands are meshed side by side, then strips of even cuts, which have no triangle in common, then strips of odd cuts, and
// at last what is left beside two strips.

#ifndef SeismicHorizonsSurfaceParts_h
#define SeismicHorizonsSurfaceParts_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "PartAssembly.h"
#include "PointRows.h"
#include "Surface.h"

#include <cstdint>

namespace SeismicHorizons
{
/// A band has about so many columns: fewer leave more vertices along cuts, more take memory.
constexpr std::int64_t ColumnsOfBand = std::int64_t(1) << 22;

std::int32_t RowsOfBand(const PlaneBox& box);

/// Returns 0 for horizons that are meshed at once: small ones, those with a radius above 1, and meshes that are not
/// improved within an error.
std::int32_t RowsOfPart(const PlaneBox& box, const SurfaceOptions& options, int radius);

/// Fills the mesh and the figures of a surface with a boundary, but for targets.
void MakeInParts(const PointRows& rows, std::int32_t rowsOfPart, const SurfaceOptions& options, Surface& surface,
  const TakeTargets& take, const Monitor& monitor);
}

#endif
