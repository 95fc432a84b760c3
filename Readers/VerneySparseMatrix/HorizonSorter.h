// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonSorter_h
#define SeismicHorizonsHorizonSorter_h

#include "SparseMatrixParser.h"
#include "SurfacePositions.h"

#include <vector>

namespace SeismicHorizons
{
/// Deals the voxels of columns out to their horizons, and leaves one in each column of a horizon.
class HorizonSorter
{
public:
  explicit HorizonSorter(DuplicatePolicy policy)
    : Policy(policy)
  {
  }

  /// Adds a voxel of column (i, j). All voxels of a column come one after the other.
  void Add(int i, int j, const SparseMatrixVoxel& voxel);

  /// The horizons, in the order in which their first voxels came.
  std::vector<HorizonVoxels> Take() { return std::move(this->Horizons); }

private:
  HorizonVoxels& HorizonOf(int surfaceId);
  bool Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const;

  const DuplicatePolicy Policy;
  SurfacePositions Positions;
  std::vector<HorizonVoxels> Horizons;
};
}

#endif
