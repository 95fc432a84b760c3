// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All functions throw InputError on a horizon that breaks the data model (Documentation/DataModel.md).

#ifndef SeismicHorizonsHorizonData_h
#define SeismicHorizonsHorizonData_h

#include "Common/Horizon/BoundedHorizon.h"
#include "Common/Horizon/Lattice.h"
#include "Common/Horizon/Types.h"
#include "LatticePoints.h"

#include <array>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
Lattice ReadLattice(const Horizon& horizon);

/// columns along i and j, and vertical indices
std::array<int, 3> ReadLatticeDimensions(const Horizon& horizon);

/// Unlike ReadLattice, this does not check the matrix.
Eigen::Matrix4d ReadLatticeMap(const Horizon& horizon);

/// All lines must be closed polylines, and there must be one.
Loops ReadBoundary(const Horizon& horizon);

/// Throws InputError on a simplified mesh, whose dropped points cannot be measured.
void RequireAllPoints(const Horizon& horizon);

std::vector<std::int32_t> ReadPatches(const Horizon& horizon);

/// Original points per point; empty if each represents one.
std::vector<std::int64_t> ReadCounts(const Horizon& horizon);

/// Throws InputError on polygons other than triangles.
std::vector<std::array<PointId, 3>> ReadTriangles(const Horizon& mesh);

/// As ReadTriangles, without triangles that close faults.
std::vector<std::array<PointId, 3>> ReadOpenTriangles(const Horizon& mesh);

/// Places are columns, or sub-voxels after merging. Heights and counts stay empty.
BoundedHorizon ReadPatchesAndBoundary(const LatticePoints& points);

/// Places are sub-voxels. If no point was merged, they refer to the array Column, which must outlive them.
BoundedHorizon ReadBoundedHorizon(LatticePoints points);
}

#endif
