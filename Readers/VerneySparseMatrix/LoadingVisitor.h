// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Takes the voxels of some horizons, one in each column, as a policy says.

#ifndef SeismicHorizonsLoadingVisitor_h
#define SeismicHorizonsLoadingVisitor_h

#include "SparseMatrixVisitor.h"
#include "SurfacePositions.h"

#include <utility>
#include <vector>

namespace SeismicHorizons
{
class LoadingVisitor : public SparseMatrixVisitor
{
public:
  /// Horizons are those of the keys; the values are the numbers of voxels to make room for.
  LoadingVisitor(const SparseMatrixCounts& horizons, DuplicatePolicy policy);

  void VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels) override;

  /// The horizons, by ascending surface ID. The visitor has none afterwards.
  std::vector<HorizonVoxels> TakeHorizons() { return std::move(this->Horizons); }

private:
  void Add(HorizonVoxels& horizon, int i, int j, const SparseMatrixVoxel& voxel) const;
  bool Prefers(const SparseMatrixVoxel& voxel, const HorizonVoxels& horizon) const;

  const DuplicatePolicy Policy;
  SurfacePositions Positions;
  std::vector<HorizonVoxels> Horizons;
};
}

#endif
