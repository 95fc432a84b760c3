// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsVoxelExtent_h
#define SeismicHorizonsVoxelExtent_h

#include "SparseMatrixParser.h"

#include <array>

namespace SeismicHorizons
{
/// The first and last i, j and k of a box of voxels. One without voxels has a last index below its first.
using VoxelExtent = std::array<int, 6>;

constexpr VoxelExtent EmptyExtent = { 0, -1, 0, -1, 0, -1 };

/// The bounding box of a horizon.
VoxelExtent FindExtent(const HorizonVoxels& horizon);

/// The bounding box of two boxes.
VoxelExtent Unite(const VoxelExtent& a, const VoxelExtent& b);

/// All voxels of a lattice.
VoxelExtent WholeExtent(const SparseMatrixSize& size);
}

#endif
