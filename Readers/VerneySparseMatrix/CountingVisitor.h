// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a scan of a file finds out: how many voxels each horizon has, and how real z goes with the vertical index.

#ifndef SeismicHorizonsCountingVisitor_h
#define SeismicHorizonsCountingVisitor_h

#include "SparseMatrixVisitor.h"
#include "SurfacePositions.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
/// Fits a line through pairs of vertical index and real z, by least squares.
class VerticalFitter
{
public:
  void Add(const SparseMatrixVoxel& voxel);
  SparseMatrixVerticalFit Fit() const;

private:
  std::int64_t Count = 0;
  SparseMatrixVoxel First;
  double SumK = 0.0;
  double SumZ = 0.0;
  double SumKK = 0.0;
  double SumKZ = 0.0;
};

class CountingVisitor : public SparseMatrixVisitor
{
public:
  void VisitColumn(int i, int j, const std::vector<SparseMatrixVoxel>& voxels) override;

  SparseMatrixCounts Counts() const { return SparseMatrixCounts(this->CountsById.begin(), this->CountsById.end()); }
  SparseMatrixVerticalFit VerticalFit() const { return this->Fitter.Fit(); }

private:
  VerticalFitter Fitter;
  SurfacePositions Positions;
  std::vector<std::pair<int, std::int64_t>> CountsById; // in the order in which IDs came first
};
}

#endif
